// A question of a trial, of the questionnaire or about the participant, and what an answer to it amounts to.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocols/answers/condition.h"
#include "protocols/answers/line_form.h"
#include "protocols/answers/number_form.h"
#include "protocols/answers/option_forms.h"
#include "protocols/answers/scale_form.h"
#include "protocols/answers/text_form.h"

namespace asperity {

/// How a question is answered. A form is a type with its parameters, in a file with its answer.
using AnswerForm = std::variant<ChoiceForm, AssignmentForm, NumberForm, ScaleForm, LineForm,
                                MultipleChoiceForm, TextForm>;

/// What was answered: the alternative that belongs to the question's form.
using Answer = std::variant<ChosenOption, AssignedOptions, GivenNumber, ScalePoint, DrawnLength,
                            ChosenOptions, WrittenText>;

/// One option of a question, in the order in which it is shown.
struct Option {
  std::string value{};  ///< stored as the response: an item, a texture, "tie", "cannot_tell"
  /// Of a trial: shown, never a name: a presentation's code, or the place of a picture or word from "1".
  std::string label{};
  std::optional<std::string> picture{};  ///< study-relative
  std::string text{};                    ///< of an option in words: what is shown

  bool operator==(const Option&) const = default;
};

/// The value of the option that neither of two surfaces is preferred.
inline constexpr const char* kTieOption = "tie";
/// The value of the option of a participant who does not choose (`allow_cannot_tell`).
inline constexpr const char* kCannotTellOption = "cannot_tell";

/// A question, wherever it is asked.
struct Question {
  std::string name{};  ///< stored with every response to it
  std::string prompt{};
  AnswerForm form{};
  std::vector<Option> options{};  ///< of a form with options; other forms have none
  /// Of a trial: the correct responses, one per item of the answer; empty where no response is correct or incorrect.
  std::vector<std::string> correct{};
  /// Of a trial: it is asked in addition to the question of the kind of experiment, and no analysis uses its responses.
  bool is_additional = false;
  bool optional = false;                       ///< it may be left empty
  std::optional<AnswerCondition> condition{};  ///< asked only if it is met; absent: always asked

  template <class Form>
  bool is_answered_by() const noexcept {
    return std::holds_alternative<Form>(form);
  }
  /// The place of the option with a value.
  std::optional<std::size_t> option_of(const std::string& value) const noexcept;
};

/// One item of an answer: a row of the tables `response` and `session_answer`.
struct AnsweredItem {
  /// 1, or the position of the surface that an assignment's item belongs to, or the place of one of several options.
  int item = 1;
  std::string answer{};  ///< the value of an option, a number as text, or a text
  std::optional<double> number{};
  std::optional<bool> correct{};
};

/// "choice", "assignment", "number", "scale", "line", "multiple_choice", "text": as it is stored in the plan of a session.
std::string_view name_of(const AnswerForm& form);
/// The form of that name with its default parameters; a choice where there is none.
AnswerForm form_named(std::string_view name);
/// "a choice of one option", "a number": as an answer is described in a message: "answered by a number".
Phrase description_of(const AnswerForm& form);

/// Whether a participant chooses from Question::options.
bool has_options(const AnswerForm& form) noexcept;
/// Whether a participant has to see the page to answer, so that an eye mask is taken off: what is typed, or several options.
bool is_seen(const AnswerForm& form) noexcept;
/// Of the numbers with which a question can be answered; nothing where it is not answered by numbers.
std::optional<NumberRange> numbers_of(const AnswerForm& form) noexcept;

/// How many responses an answer to this form has at least when `surfaces` were felt.
int items_of(const AnswerForm& form, int surfaces);

/// The items of an answer, in order, marked as correct or incorrect where the question determines it.
///
/// Errors: std::logic_error for an answer of another form; std::out_of_range for an option that the
/// question does not have.
std::vector<AnsweredItem> items_of(const Question& question, const Answer& answer);

/// The answer of items, as conditions refer to it; empty where the question was left empty or not asked.
FormAnswer texts_of(std::span<const AnsweredItem> items);

/// A stored answer in short, without names: the label of the option, the number, or the point.
std::string label_of(const Question& question, const std::string& stored);

/// What contradicts the question in a stored answer, as clauses of English for `verify`; empty when nothing does. An
/// answer without items, or with one empty text, was left empty. `surfaces`: that were felt.
std::vector<std::string> problems_with(const Question& question,
                                       std::span<const AnsweredItem> stored, int surfaces = 0);

}  // namespace asperity
