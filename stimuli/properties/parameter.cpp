// Implements the checks of values against their declarations.

#include "stimuli/properties/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrase_lists.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

Phrase with_unit(const Parameter& parameter, double number) {
  const Phrase shown = number_of_file(number_text(number));
  if (parameter.unit == "1" || parameter.unit.empty()) return shown;
  return Phrase("%1%2").with(shown, Phrase(kUnitOfNumber, (' ' + parameter.unit).c_str()));
}

std::optional<Phrase> problem_of_choice(const Parameter& parameter, const ParameterValue& value) {
  const auto* chosen = std::get_if<std::string>(&value);
  if (chosen != nullptr && std::find(parameter.choices.begin(), parameter.choices.end(), *chosen) !=
                               parameter.choices.end()) {
    return std::nullopt;
  }
  const std::string given =
      chosen != nullptr ? "\"" + *chosen + "\"" : number_text(std::get<double>(value));
  return phrase("Protocols", "%1 is %2; it must be %3")
      .with(parameter.name, given,
            joined_by_or({parameter.choices.begin(), parameter.choices.end()}));
}

}  // namespace

Parameter number_parameter(std::string name, std::string unit, double minimum, double maximum,
                           double default_value, Phrase meaning) {
  return {.name = std::move(name),
          .unit = std::move(unit),
          .minimum = minimum,
          .maximum = maximum,
          .default_value = default_value,
          .meaning = std::move(meaning)};
}

Parameter integer_parameter(std::string name, double minimum, double maximum, double default_value,
                            Phrase meaning) {
  Parameter parameter =
      number_parameter(std::move(name), "1", minimum, maximum, default_value, std::move(meaning));
  parameter.kind = ParameterKind::integer;
  return parameter;
}

Parameter choice_parameter(std::string name, std::vector<std::string> choices, Phrase meaning) {
  return {.name = std::move(name),
          .kind = ParameterKind::choice,
          .unit = "1",
          .choices = choices,
          .default_value = choices.front(),
          .meaning = std::move(meaning)};
}

std::optional<Phrase> problem_of_value(const Parameter& parameter, const ParameterValue& value) {
  if (parameter.kind == ParameterKind::choice) return problem_of_choice(parameter, value);

  const auto* number = std::get_if<double>(&value);
  // In this form the condition rejects NaN, for which all comparisons are false.
  const auto lies_within = [&parameter](double one) {
    return one >= parameter.minimum && one <= parameter.maximum;
  };
  if (number != nullptr && lies_within(*number) &&
      (parameter.kind != ParameterKind::integer || *number == std::floor(*number))) {
    return std::nullopt;
  }
  const Phrase right = (parameter.kind == ParameterKind::integer
                            ? phrase("Protocols", "a whole number from %1 to %2")
                            : phrase("Protocols", "a number from %1 to %2"))
                           .with(number_of_file(number_text(parameter.minimum)),
                                 with_unit(parameter, parameter.maximum));
  if (number == nullptr) {
    const std::string& text = std::get<std::string>(value);
    double quoted = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), quoted);
    const bool is_quoted_number = read.ec == std::errc() && read.ptr == text.data() + text.size();
    const Phrase sentence =
        is_quoted_number
            ? phrase("Protocols", "%1 is %2; it must be written without quotation marks, as %3")
            : phrase("Protocols", "%1 is %2; it must be %3");
    return sentence.with(parameter.name, '"' + text + '"', right);
  }
  return phrase("Protocols", "%1 is %2; it must be %3%4")
      .with(parameter.name, with_unit(parameter, *number), right,
            meant_in_other_unit(*number, parameter.unit, lies_within));
}

std::optional<Phrase> complaint_about(const Parameter& parameter, const ParameterValue& value) {
  const std::optional<Phrase> problem = problem_of_value(parameter, value);
  return problem ? std::optional(problem->as_sentence()) : std::nullopt;
}

ParameterValues complete_values(const ModelDeclaration& declaration, const ParameterValues& given) {
  return complete_values(declaration.id, declaration.parameters, given);
}

ParameterValues complete_values(std::string_view of, const std::vector<Parameter>& parameters,
                                const ParameterValues& given) {
  const std::string who(of);
  for (const auto& [name, value] : given) {
    const auto named = [&name](const Parameter& parameter) { return parameter.name == name; };
    if (std::none_of(parameters.begin(), parameters.end(), named)) {
      std::vector<std::string> names;
      for (const Parameter& parameter : parameters) names.push_back(parameter.name);
      throw std::invalid_argument(
          who + " has no parameter \"" + name + "\"; " +
          (names.empty() ? "remove it."
                         : "use " + joined_by_or({names.begin(), names.end()}).english() + "."));
    }
  }
  ParameterValues values;
  for (const Parameter& parameter : parameters) {
    const auto found = given.find(parameter.name);
    const ParameterValue& value = found == given.end() ? parameter.default_value : found->second;
    if (const auto complaint = complaint_about(parameter, value)) {
      throw PhrasedRefusal(Phrase("%1: %2").with(who, *complaint));
    }
    values.emplace(parameter.name, value);
  }
  return values;
}

double number_of(const ParameterValues& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end() || !std::holds_alternative<double>(found->second)) {
    throw std::invalid_argument("The parameter " + std::string(name) +
                                " has no number; set it to a number.");
  }
  return std::get<double>(found->second);
}

const std::string& choice_of(const ParameterValues& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end() || !std::holds_alternative<std::string>(found->second)) {
    throw std::invalid_argument("The parameter " + std::string(name) +
                                " has no choice; set it to one of its choices.");
  }
  return std::get<std::string>(found->second);
}

}  // namespace asperity
