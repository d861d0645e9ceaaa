// Evaluates conditions on answers, and checks them against the form of the question.

#include "protocols/answers/condition.h"

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/overloaded.h"
#include "protocols/answers/question.h"
#include "protocols/answers/stored_number.h"

namespace asperity {

namespace {

std::string quoted_text(const std::string& text) { return '"' + text + '"'; }

std::string plain_text(const AnswerValue& value) {
  const auto* const number = std::get_if<double>(&value);
  return number != nullptr ? number_text(*number) : std::get<std::string>(value);
}

std::string quoted_value(const AnswerValue& value) {
  return std::holds_alternative<double>(value) ? plain_text(value) : quoted_text(plain_text(value));
}

/// "use "yes" or "no"", of the options of a question.
std::string options_to_use(const Question& question) {
  const std::size_t count = question.options.size();
  if (count == 0) return "state the options of that question";
  std::string text = "use ";
  for (std::size_t i = 0; i < count; ++i) {
    text += (i == 0 ? "" : i + 1 == count ? " or " : ", ") + quoted_text(question.options[i].value);
  }
  return text;
}

std::string form_name(const Question& question) {
  return std::string(description_of(question.form));
}

/// "18 to 120", "18 or more"; empty without limits.
std::string range_of(const std::optional<double>& minimum, const std::optional<double>& maximum) {
  if (minimum && maximum) return number_text(*minimum) + " to " + number_text(*maximum);
  if (minimum) return number_text(*minimum) + " or more";
  if (maximum) return number_text(*maximum) + " or less";
  return {};
}

std::optional<std::string> problem_with_value(const AnswerValue& value, const Question& question) {
  if (question.is_answered_by<ChoiceForm>()) {
    const auto* const option = std::get_if<std::string>(&value);
    if (option != nullptr && question.option_of(*option)) return {};
    return quoted_value(value) + " is not an option of the question " + quoted_text(question.name) +
           "; " + options_to_use(question);
  }
  const auto* const number = std::get_if<double>(&value);
  if (number == nullptr) {
    return quoted_value(value) + " is not a number, and the question " +
           quoted_text(question.name) + " is answered by " + form_name(question) +
           "; state a number";
  }
  const NumberRange range = *numbers_of(question.form);
  if ((range.minimum && *number < *range.minimum) || (range.maximum && *number > *range.maximum)) {
    return number_text(*number) + " cannot be the answer to the question " +
           quoted_text(question.name) + "; use a number of " +
           range_of(range.minimum, range.maximum);
  }
  const auto* const on_scale = std::get_if<ScaleForm>(&question.form);
  if (on_scale == nullptr || on_scale->can_be_stored_as(number_text(*number))) return {};
  const ScaleForm& scale = *on_scale;
  return number_text(*number) + " is not a point of the scale of the question " +
         quoted_text(question.name) + "; the points are " +
         number_text(scale.value_at(1) - scale.value_at(0)) + " apart, from " +
         number_text(scale.minimum) + " to " + number_text(scale.maximum);
}

std::optional<std::string> problem_with_range(const AnswerWithin& within,
                                              const Question& question) {
  const std::optional<NumberRange> range = numbers_of(question.form);
  if (!range) {
    return "the question " + quoted_text(question.name) + " is answered by " + form_name(question) +
           ", and only a number or a scale has a range; " +
           (question.is_answered_by<ChoiceForm>()           ? "state \"is\" or \"in\""
            : question.is_answered_by<MultipleChoiceForm>() ? "state \"includes\""
                                                            : "refer to another question");
  }
  if (within.minimum && within.maximum && *within.minimum > *within.maximum) {
    return "no number is at least " + number_text(*within.minimum) + " and at most " +
           number_text(*within.maximum) + "; exchange the two";
  }
  const bool is_above = within.minimum && range->maximum && *within.minimum > *range->maximum;
  const bool is_below = within.maximum && range->minimum && *within.maximum < *range->minimum;
  if (!is_above && !is_below) return {};
  return "the answer to the question " + quoted_text(question.name) + " is " +
         range_of(range->minimum, range->maximum) + " and never " +
         range_of(within.minimum, within.maximum) + "; change the range";
}

}  // namespace

bool is_met(const AnswerCondition& condition, const FormAnswer& answer) {
  if (answer.empty()) return false;
  const std::string& first = answer.front();
  return std::visit(
      Overloaded{[&](const AnswerIsOneOf& one_of) {
                   return std::any_of(
                       one_of.values.begin(), one_of.values.end(), [&](const AnswerValue& value) {
                         const auto* const number = std::get_if<double>(&value);
                         return number != nullptr ? stored_number(first) == *number
                                                  : first == std::get<std::string>(value);
                       });
                 },
                 [&](const AnswerIncludes& includes) {
                   return std::find(answer.begin(), answer.end(), includes.option) != answer.end();
                 },
                 [&](const AnswerWithin& within) {
                   const std::optional<double> number = stored_number(first);
                   return number && (!within.minimum || *number >= *within.minimum) &&
                          (!within.maximum || *number <= *within.maximum);
                 }},
      condition.test);
}

std::optional<std::string> problem_with(const AnswerCondition& condition, const Question& question,
                                        std::size_t value) {
  return std::visit(
      Overloaded{[&](const AnswerIsOneOf& one_of) -> std::optional<std::string> {
                   if (question.is_answered_by<MultipleChoiceForm>()) {
                     return "several options of the question " + quoted_text(question.name) +
                            " may be chosen; state \"includes\" with one of them";
                   }
                   if (!question.is_answered_by<ChoiceForm>() && !numbers_of(question.form)) {
                     return "the question " + quoted_text(question.name) + " is answered by " +
                            form_name(question) +
                            ", which no condition can refer to; refer to another question";
                   }
                   return problem_with_value(one_of.values.at(value), question);
                 },
                 [&](const AnswerIncludes& includes) -> std::optional<std::string> {
                   if (!question.is_answered_by<MultipleChoiceForm>()) {
                     return "the question " + quoted_text(question.name) + " is answered by " +
                            form_name(question) +
                            ", and only a multiple choice includes options; " +
                            (question.is_answered_by<ChoiceForm>() || numbers_of(question.form)
                                 ? "state \"is\" or \"in\""
                                 : "refer to another question");
                   }
                   if (question.option_of(includes.option)) return {};
                   return quoted_text(includes.option) + " is not an option of the question " +
                          quoted_text(question.name) + "; " + options_to_use(question);
                 },
                 [&](const AnswerWithin& within) { return problem_with_range(within, question); }},
      condition.test);
}

std::string signs_of(const AnswerCondition& condition) {
  const std::string& name = condition.question;
  return std::visit(
      Overloaded{[&](const AnswerIsOneOf& one_of) {
                   if (one_of.values.size() == 1) {
                     return name + " = " + plain_text(one_of.values.front());
                   }
                   std::string text = name + " ∈ {";
                   for (std::size_t i = 0; i < one_of.values.size(); ++i) {
                     text += (i == 0 ? "" : ", ") + plain_text(one_of.values[i]);
                   }
                   return text + '}';
                 },
                 [&](const AnswerIncludes& includes) { return name + " ∋ " + includes.option; },
                 [&](const AnswerWithin& within) {
                   if (!within.minimum) return name + " ≤ " + number_text(*within.maximum);
                   if (!within.maximum) return name + " ≥ " + number_text(*within.minimum);
                   return number_text(*within.minimum) + " ≤ " + name + " ≤ " +
                          number_text(*within.maximum);
                 }},
      condition.test);
}

std::string clause_of(const AnswerCondition& condition) {
  const std::string answer = "the answer to " + quoted_text(condition.question);
  return std::visit(Overloaded{[&](const AnswerIsOneOf& one_of) {
                                 std::string text = answer + " was ";
                                 const std::size_t count = one_of.values.size();
                                 for (std::size_t i = 0; i < count; ++i) {
                                   text += (i == 0           ? ""
                                            : i + 1 == count ? " or "
                                                             : ", ") +
                                           quoted_value(one_of.values[i]);
                                 }
                                 return text;
                               },
                               [&](const AnswerIncludes& includes) {
                                 return answer + " included " + quoted_text(includes.option);
                               },
                               [&](const AnswerWithin& within) {
                                 return answer + " was " + range_of(within.minimum, within.maximum);
                               }},
                    condition.test);
}

}  // namespace asperity
