// A question of a trial, the forms in which it can be answered, and what an answer amounts to.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocols/answers/assignment_form.h"
#include "protocols/answers/choice_form.h"
#include "protocols/answers/line_form.h"
#include "protocols/answers/number_form.h"
#include "protocols/answers/scale_form.h"

namespace asperity {

/// How a question is answered. A form is a type with its parameters, in a file with its answer.
using AnswerForm = std::variant<ChoiceForm, AssignmentForm, NumberForm, ScaleForm, LineForm>;

/// What was answered: the alternative that belongs to the question's form.
using Answer = std::variant<ChosenOption, AssignedOptions, GivenNumber, ScalePoint, DrawnLength>;

/// One option of a question, in the order in which it is shown.
struct Option {
  std::string value{};  ///< stored as the response: an item, a texture, "tie", "cannot_tell"
  std::string
      label{};  ///< shown, never a name: a presentation's code, or the place of a picture or word from "1"
  std::optional<std::string> picture{};  ///< study-relative
  std::string text{};                    ///< of an option in words: what is shown
};

/// The value of the option that neither of two surfaces is preferred.
inline constexpr const char* kTieOption = "tie";
/// The value of the option of a participant who does not choose (`allow_cannot_tell`).
inline constexpr const char* kCannotTellOption = "cannot_tell";

/// A question of a trial.
struct TrialQuestion {
  std::string name{};  ///< stored with every response to it
  std::string prompt{};
  AnswerForm form{};
  std::vector<Option> options{};  ///< what a choice or an assignment offers; other forms have none
  /// The correct responses, one per item of the answer; empty where no response is correct or incorrect.
  std::vector<std::string> correct{};
};

/// One item of an answer: a row of the table `response`.
struct AnsweredItem {
  int item = 1;          ///< 1, or the position of the surface that an assignment's item belongs to
  std::string answer{};  ///< the value of an option, or a number as text
  std::optional<double> number{};
  std::optional<bool> correct{};
};

/// "choice", "assignment", "number", "scale", "line": as it is stored in the plan of a session.
std::string_view name_of(const AnswerForm& form);

/// Whether a participant chooses from TrialQuestion::options.
bool has_options(const AnswerForm& form) noexcept;

/// How many responses an answer to this form has when `surfaces` were felt.
int items_of(const AnswerForm& form, int surfaces);

/// The items of an answer, in order, marked as correct or incorrect where the question determines it.
///
/// Errors: std::logic_error for an answer of another form; std::out_of_range for an option that the
/// question does not have.
std::vector<AnsweredItem> items_of(const TrialQuestion& question, const Answer& answer);

/// A stored answer in short, without names: the label of the option, the number, or the point.
std::string label_of(const TrialQuestion& question, const std::string& stored);

/// What contradicts the question in one stored item, as clauses of English for `verify`; empty when
/// nothing does.
std::vector<std::string> problems_with(const TrialQuestion& question, const AnsweredItem& stored);

}  // namespace asperity
