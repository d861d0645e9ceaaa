// Implements the checks of values against their declarations.

#include "stimuli/properties/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

std::string with_unit(const Parameter& parameter, double number) {
  std::string text = number_text(number);
  if (parameter.unit != "1" && !parameter.unit.empty()) text += " " + parameter.unit;
  return text;
}

std::string list_of(const std::vector<std::string>& names, const std::string& conjunction) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " " + conjunction + " " : ", ";
    list += names[i];
  }
  return list;
}

std::optional<std::string> complaint_about_choice(const Parameter& parameter,
                                                  const ParameterValue& value) {
  const auto* chosen = std::get_if<std::string>(&value);
  if (chosen != nullptr && std::find(parameter.choices.begin(), parameter.choices.end(), *chosen) !=
                               parameter.choices.end()) {
    return std::nullopt;
  }
  const std::string given =
      chosen != nullptr ? "\"" + *chosen + "\"" : number_text(std::get<double>(value));
  return parameter.name + " is " + given + "; it must be " + list_of(parameter.choices, "or") + ".";
}

}  // namespace

Parameter number_parameter(std::string name, std::string unit, double minimum, double maximum,
                           double default_value, std::string meaning) {
  return {.name = std::move(name),
          .unit = std::move(unit),
          .minimum = minimum,
          .maximum = maximum,
          .default_value = default_value,
          .meaning = std::move(meaning)};
}

Parameter integer_parameter(std::string name, double minimum, double maximum, double default_value,
                            std::string meaning) {
  Parameter parameter =
      number_parameter(std::move(name), "1", minimum, maximum, default_value, std::move(meaning));
  parameter.kind = ParameterKind::integer;
  return parameter;
}

Parameter choice_parameter(std::string name, std::vector<std::string> choices,
                           std::string meaning) {
  return {.name = std::move(name),
          .kind = ParameterKind::choice,
          .unit = "1",
          .choices = choices,
          .default_value = choices.front(),
          .meaning = std::move(meaning)};
}

std::optional<std::string> complaint_about(const Parameter& parameter,
                                           const ParameterValue& value) {
  if (parameter.kind == ParameterKind::choice) return complaint_about_choice(parameter, value);

  const std::string right =
      (parameter.kind == ParameterKind::integer ? "a whole number from " : "a number from ") +
      number_text(parameter.minimum) + " to " + with_unit(parameter, parameter.maximum);
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr) {
    const std::string& text = std::get<std::string>(value);
    double quoted = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), quoted);
    const bool is_quoted_number = read.ec == std::errc() && read.ptr == text.data() + text.size();
    return parameter.name + " is \"" + text + "\"; it must be " +
           (is_quoted_number ? "written without quotation marks, as " : "") + right + ".";
  }
  const bool whole = parameter.kind != ParameterKind::integer || *number == std::floor(*number);
  // In this form the condition rejects NaN, for which all comparisons are false.
  const auto lies_within = [&parameter](double one) {
    return one >= parameter.minimum && one <= parameter.maximum;
  };
  if (whole && lies_within(*number)) return std::nullopt;
  return parameter.name + " is " + with_unit(parameter, *number) + "; it must be " + right +
         meant_in_other_unit(*number, parameter.unit, lies_within) + ".";
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
          (names.empty() ? "remove it." : "use " + list_of(names, "or") + "."));
    }
  }
  ParameterValues values;
  for (const Parameter& parameter : parameters) {
    const auto found = given.find(parameter.name);
    const ParameterValue& value = found == given.end() ? parameter.default_value : found->second;
    if (const auto complaint = complaint_about(parameter, value)) {
      throw std::invalid_argument(who + ": " + *complaint);
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
