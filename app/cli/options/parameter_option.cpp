// Parses each assignment by the kind of the declared parameter, and lists parameters for help and errors.

#include "app/cli/options/parameter_option.h"

#include <algorithm>
#include <stdexcept>

#include "app/cli/command.h"
#include "results_schema/tables/table.h"

namespace asperity {

ParameterValues parameters_from(const std::vector<std::string>& assignments,
                                const std::vector<Parameter>& declared, const std::string& what) {
  ParameterValues values{};
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw WrongUsage("--param takes NAME=VALUE, not \"" + assignment + "\"");
    }
    const std::string name = assignment.substr(0, equals);
    const std::string text = assignment.substr(equals + 1);
    const auto parameter =
        std::find_if(declared.begin(), declared.end(),
                     [&name](const Parameter& candidate) { return candidate.name == name; });
    if (parameter == declared.end()) {
      std::string sentence = what + " has no parameter \"" + name + "\"; use one of:";
      for (const Parameter& candidate : declared) sentence += ' ' + candidate.name;
      throw std::runtime_error(sentence);
    }
    ParameterValue value = text;
    if (parameter->kind != ParameterKind::choice) {
      const std::optional<double> number = number_in(text);
      if (!number) {
        const bool has_unit = parameter->unit != "1" && !parameter->unit.empty();
        throw std::runtime_error(what + ": the parameter " + name + " takes a number" +
                                 (has_unit ? " in " + parameter->unit : "") + ", not \"" + text +
                                 '"');
      }
      value = *number;
    }
    if (const auto complaint = complaint_about(*parameter, value)) {
      throw std::runtime_error(what + ": " + complaint->english());
    }
    const auto [given, is_first] = values.emplace(name, value);
    if (!is_first && given->second != value) {
      throw std::runtime_error(what + ": the parameter " + name +
                               " is given twice with different values; give it once");
    }
  }
  return values;
}

std::string described(const std::vector<Parameter>& parameters) {
  std::string lines{};
  for (const Parameter& parameter : parameters) {
    lines += "    " + parameter.name + " = ";
    if (parameter.kind == ParameterKind::choice) {
      lines += std::get<std::string>(parameter.default_value) + "  [";
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        lines += (i > 0 ? "|" : "") + parameter.choices[i];
      }
    } else {
      lines += text_of_number(std::get<double>(parameter.default_value));
      if (parameter.unit != "1" && !parameter.unit.empty()) lines += ' ' + parameter.unit;
      lines +=
          "  [" + text_of_number(parameter.minimum) + " to " + text_of_number(parameter.maximum);
    }
    lines += "]  " + parameter.meaning.english() + '\n';
  }
  return lines;
}

}  // namespace asperity
