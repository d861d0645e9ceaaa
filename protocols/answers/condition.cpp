// Evaluates conditions on answers, and states them in signs and in words.

#include "protocols/answers/condition.h"

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/overloaded.h"
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

Phrase range_text(const std::optional<double>& minimum, const std::optional<double>& maximum) {
  if (minimum && maximum) {
    return phrase("Protocols", "%1 to %2").with(number_text(*minimum), number_text(*maximum));
  }
  if (minimum) return phrase("Protocols", "%1 or more").with(number_text(*minimum));
  if (maximum) return phrase("Protocols", "%1 or less").with(number_text(*maximum));
  return {};
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
                                 return answer + " was " +
                                        range_text(within.minimum, within.maximum).english();
                               }},
                    condition.test);
}

}  // namespace asperity
