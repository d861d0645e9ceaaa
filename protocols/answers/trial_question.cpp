// Dispatch from a question to its form: each function calls the overload for the form and its answer.

#include "protocols/answers/trial_question.h"

#include <stdexcept>
#include <type_traits>

namespace asperity {

namespace {

/// Whether an answer belongs to a form: there is an `items_of` for the two.
template <typename Form, typename Given>
constexpr bool belongs_to() {
  return requires(const TrialQuestion& question, const Form& form, const Given& given) {
    items_of(question, form, given);
  };
}

/// How many of the answers belong to a form.
template <typename Form, typename... Given>
constexpr int answers_of(const std::variant<Given...>*) {
  return (0 + ... + (belongs_to<Form, Given>() ? 1 : 0));
}
template <typename... Form>
constexpr bool has_one_answer_each(const std::variant<Form...>*) {
  return (... && (answers_of<Form>(static_cast<const Answer*>(nullptr)) == 1));
}
static_assert(has_one_answer_each(static_cast<const AnswerForm*>(nullptr)),
              "each form of answer needs one type in `Answer` and an overload of items_of");

}  // namespace

std::string_view name_of(const AnswerForm& form) {
  return std::visit([](const auto& each) { return each.kName; }, form);
}

bool has_options(const AnswerForm& form) noexcept {
  return std::holds_alternative<ChoiceForm>(form) || std::holds_alternative<AssignmentForm>(form);
}

int items_of(const AnswerForm& form, int surfaces) {
  return std::visit([surfaces](const auto& each) { return items_of(each, surfaces); }, form);
}

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const Answer& answer) {
  return std::visit(
      [&question](const auto& form, const auto& given) -> std::vector<AnsweredItem> {
        using Form = std::decay_t<decltype(form)>;
        using Given = std::decay_t<decltype(given)>;
        if constexpr (belongs_to<Form, Given>()) {
          return items_of(question, form, given);
        } else {
          throw std::logic_error(
              "the question " + question.name +
              " has an answer of another form; answer it in the form of the question");
        }
      },
      question.form, answer);
}

std::string label_of(const TrialQuestion& question, const std::string& stored) {
  return std::visit([&](const auto& form) { return label_of(question, form, stored); },
                    question.form);
}

std::vector<std::string> problems_with(const TrialQuestion& question, const AnsweredItem& stored) {
  return std::visit([&](const auto& form) { return problems_with(question, form, stored); },
                    question.form);
}

}  // namespace asperity
