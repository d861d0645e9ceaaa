// The condition under which a question is asked or a screen is shown.

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"

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

/// A condition on the answer to an earlier question: of the questionnaire, or of the same trial. A question that was left
/// empty, or was not asked itself, meets no condition: what depends on it is not asked or shown.
struct AnswerCondition {
  std::string question{};  ///< by its name
  std::variant<AnswerIsOneOf, AnswerIncludes, AnswerWithin> test{};

  bool operator==(const AnswerCondition&) const = default;
};

/// The answer to a question, as stored: the options of a multiple choice in their order, otherwise one value; none where
/// the question was left empty.
using FormAnswer = std::vector<std::string>;

/// `answer`: that of the condition's question; empty also where it was not asked.
bool is_met(const AnswerCondition& condition, const FormAnswer& answer);

/// "18 to 120", "18 or more"; empty without limits.
Phrase range_text(const std::optional<double>& minimum, const std::optional<double>& maximum);
/// In signs: "pain = yes", "hand ∈ {left, right}", "symptoms ∋ pain", "18 ≤ age ≤ 30".
std::string signs_of(const AnswerCondition& condition);
/// In English, after "if": "the answer to "pain" was "yes"".
std::string clause_of(const AnswerCondition& condition);

}  // namespace asperity
