// A question of the questionnaire or about the participant, and the condition under which it is asked.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "protocols/answers/scale_form.h"

namespace asperity {

/// A value that an answer can have: a number, or an option.
using AnswerValue = std::variant<double, std::string>;

/// The answer is one of these values.
struct AnswerIsOneOf {
  std::vector<AnswerValue> values{};
  bool operator==(const AnswerIsOneOf&) const = default;
};
/// This option is among those that were chosen.
struct AnswerIncludes {
  std::string option{};
  bool operator==(const AnswerIncludes&) const = default;
};
/// The answer is a number in this range, which has at least one end; both ends belong to it.
struct AnswerWithin {
  std::optional<double> minimum{};
  std::optional<double> maximum{};
  bool operator==(const AnswerWithin&) const = default;
};

/// A condition on the answer to an earlier question of the questionnaire. A question that was left empty, or was not
/// asked itself, meets no condition: what depends on it is not asked or shown.
struct AnswerCondition {
  std::string question{};  ///< by its name
  std::variant<AnswerIsOneOf, AnswerIncludes, AnswerWithin> test{};

  bool operator==(const AnswerCondition&) const = default;
};

/// A question of the questionnaire or about the participant; the questions of a trial are a TrialQuestion each.
struct Question {
  enum class Form {
    choice,           ///< one of the options
    multiple_choice,  ///< one or more of the options
    number,
    scale,
    text,
  };
  std::string name{};
  std::string prompt{};
  Form form = Form::choice;
  std::vector<std::string> options{};  ///< the stored values
  /// The text shown for each option if it differs from the stored value (another language); otherwise empty.
  std::vector<std::string> option_texts{};
  std::optional<double> minimum{};  ///< of a number
  std::optional<double> maximum{};  ///< of a number
  std::string unit{};               ///< of a number; may be empty
  ScaleForm scale{};                ///< of a scale
  bool optional = false;
  std::optional<AnswerCondition> condition{};  ///< asked only if it is met; absent: always asked

  const std::string& text_of_option(std::size_t i) const {
    return option_texts.empty() ? options.at(i) : option_texts.at(i);
  }
  bool has_options() const noexcept {
    return form == Form::choice || form == Form::multiple_choice;
  }
};

/// The answer to a question, as stored: the options of a multiple choice in their order, otherwise one value; none where
/// the question was left empty.
using FormAnswer = std::vector<std::string>;

/// `answer`: that of the condition's question; empty also where it was not asked.
bool is_met(const AnswerCondition& condition, const FormAnswer& answer);

/// What prevents an answer to the question from meeting the condition, as a clause with a remedy; nothing where some answer
/// meets it. `value`: of the values of AnswerIsOneOf, the one that is judged.
std::optional<std::string> problem_with(const AnswerCondition& condition, const Question& question,
                                        std::size_t value = 0);

/// In signs: "pain = yes", "hand ∈ {left, right}", "symptoms ∋ pain", "18 ≤ age ≤ 30".
std::string signs_of(const AnswerCondition& condition);
/// In English, after "if": "the answer to "pain" was "yes"".
std::string clause_of(const AnswerCondition& condition);

/// The number that an answer to the question is; nothing for an answer in words.
std::optional<double> number_of(const Question& question, const std::string& value);

/// What contradicts the question in a stored answer, as clauses of English for `verify`; empty when nothing does.
std::vector<std::string> problems_with(const Question& question, std::span<const std::string> answer);

}  // namespace asperity
