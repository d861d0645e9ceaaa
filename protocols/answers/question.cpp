// Dispatch from a question to its form, and the verification that all forms have in common.

#include "protocols/answers/question.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "analysis/numbers/overloaded.h"
#include "protocols/answers/stored_number.h"

namespace asperity {

namespace {

/// Whether an answer belongs to a form: there is an `items_of` for the two.
template <typename Form, typename Given>
constexpr bool belongs_to() {
  return requires(const Question& question, const Form& form, const Given& given) {
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

std::vector<std::string> problems_with_item(const Question& question, const AnsweredItem& stored) {
  return std::visit(
      [&](const auto& form) -> std::vector<std::string> {
        using Form = std::decay_t<decltype(form)>;
        if constexpr (FormWithOptions<Form>) {
          return problems_with_option(question, stored);
        } else if constexpr (requires { form.can_be_stored_as(stored.answer); }) {
          if (form.can_be_stored_as(stored.answer) && stored_number(stored.answer) == stored.number)
            return {};
          return {"the response " + stored.answer + " is not " +
                  description_of(question.form).english() +
                  " that the question permits, or differs from the number stored with it; restore "
                  "the study from a copy"};
        } else {
          return {};
        }
      },
      question.form);
}

/// Whether an answer of this number of items is possible.
bool is_possible_count(const AnswerForm& form, std::size_t items, int surfaces) {
  if (std::holds_alternative<MultipleChoiceForm>(form)) return true;
  return items == static_cast<std::size_t>(items_of(form, surfaces));
}

}  // namespace

std::optional<std::size_t> Question::option_of(const std::string& value) const noexcept {
  const auto option = std::find_if(options.begin(), options.end(),
                                   [&value](const Option& each) { return each.value == value; });
  if (option == options.end()) return {};
  return static_cast<std::size_t>(option - options.begin());
}

std::string_view name_of(const AnswerForm& form) {
  return std::visit([](const auto& each) { return each.kName; }, form);
}

AnswerForm form_named(std::string_view name) {
  const auto named = [name]<typename... Form>(const std::variant<Form...>*) {
    AnswerForm found{};
    ((Form::kName == name ? void(found = Form{}) : void()), ...);
    return found;
  };
  return named(static_cast<const AnswerForm*>(nullptr));
}

Phrase description_of(const AnswerForm& form) {
  return std::visit(
      Overloaded{[](const ChoiceForm&) { return phrase("Protocols", "a choice of one option"); },
                 [](const MultipleChoiceForm&) { return phrase("Protocols", "a multiple choice"); },
                 [](const AssignmentForm&) { return phrase("Protocols", "an assignment"); },
                 [](const NumberForm&) { return phrase("Protocols", "a number"); },
                 [](const ScaleForm&) { return phrase("Protocols", "a point on a scale"); },
                 [](const LineForm&) { return phrase("Protocols", "the length of a line"); },
                 [](const TextForm&) { return phrase("Protocols", "free text"); }},
      form);
}

bool has_options(const AnswerForm& form) noexcept {
  return std::visit([](const auto& each) { return FormWithOptions<std::decay_t<decltype(each)>>; },
                    form);
}

bool is_seen(const AnswerForm& form) noexcept {
  return std::visit(
      []<class Form>(const Form&) {
        return requires { Form::kIsSeen; };
      },
      form);
}

std::optional<NumberRange> numbers_of(const AnswerForm& form) noexcept {
  return std::visit(
      [](const auto& each) -> std::optional<NumberRange> {
        if constexpr (requires { each.numbers(); }) return each.numbers();
        return {};
      },
      form);
}

int items_of(const AnswerForm& form, int surfaces) {
  return std::holds_alternative<AssignmentForm>(form) ? surfaces : 1;
}

std::vector<AnsweredItem> items_of(const Question&, const TextForm&, const WrittenText& answer) {
  return {{.answer = answer.text}};
}

std::vector<AnsweredItem> items_of(const Question& question, const Answer& answer) {
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

FormAnswer texts_of(std::span<const AnsweredItem> items) {
  FormAnswer texts{};
  for (const AnsweredItem& item : items) {
    if (!item.answer.empty()) texts.push_back(item.answer);
  }
  return texts;
}

std::string label_of(const Question& question, const std::string& stored) {
  if (has_options(question.form)) return label_of_option(question, stored);
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  return scale == nullptr ? stored : scale->label_of(stored);
}

std::vector<std::string> problems_with(const Question& question,
                                       std::span<const AnsweredItem> stored, int surfaces) {
  std::vector<std::string> problems{};
  if (texts_of(stored).empty()) {
    if (!question.optional) {
      problems.emplace_back("it was left empty, and the protocol requires an answer");
    }
    return problems;
  }
  if (!is_possible_count(question.form, stored.size(), surfaces)) {
    problems.push_back("its answer has " + std::to_string(stored.size()) +
                       (stored.size() == 1 ? " item, but " : " items, but ") +
                       description_of(question.form).english() + " has " +
                       std::to_string(items_of(question.form, surfaces)) +
                       "; restore the study from a copy");
  }
  if (question.is_answered_by<MultipleChoiceForm>()) {
    std::set<int> known{};
    for (const AnsweredItem& item : stored) {
      const std::optional<std::size_t> option = question.option_of(item.answer);
      const bool is_its_number = !option || item.item == static_cast<int>(*option) + 1;
      if (is_its_number && known.insert(item.item).second) continue;
      problems.push_back("item " + std::to_string(item.item) +
                         " is not the number of its option, or is stored twice; restore the study "
                         "from a copy");
    }
  }
  for (const AnsweredItem& item : stored) {
    for (const std::string& problem : problems_with_item(question, item)) {
      problems.push_back((stored.size() == 1 ? "" : "item " + std::to_string(item.item) + ": ") +
                         problem);
    }
  }
  return problems;
}

}  // namespace asperity
