// Writes numbers and choices, and objects of them in the order of their names.

#include "app/study_files/parameter_json.h"

#include <nlohmann/json.hpp>

#include "results_schema/stored_json.h"

namespace asperity {

std::string json_text_of(const ParameterValue& value) {
  return std::visit([](const auto& one) { return nlohmann::json(one).dump(); }, value);
}

std::string json_text_of(const ParameterValues& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : values) {
    std::visit([&own = json[name]](const auto& one) { own = one; }, value);
  }
  return json.dump();
}

ParameterValues parameter_values_in(const std::string& text) {
  const nlohmann::json json = stored_json(text, "presentation.parameters_json");
  ParameterValues values{};
  for (const auto& [name, value] : json.items()) {
    if (value.is_number()) {
      values[name] = value.get<double>();
    } else {
      values[name] = value.get<std::string>();
    }
  }
  return values;
}

}  // namespace asperity
