// asperity models: the force models and their declared parameters.

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/parameter_option.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/force/layers.h"

namespace asperity {

namespace {

const char* kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "number";
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::choice:
      return "choice";
  }
  return "";
}

nlohmann::ordered_json json_of_value(const ParameterValue& value) {
  return std::visit([](const auto& one) { return nlohmann::ordered_json(one); }, value);
}

/// null for a condition that no values meet.
nlohmann::ordered_json json_of_condition(const std::optional<ParameterValues>& condition) {
  if (!condition) return nullptr;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : *condition) json[name] = json_of_value(value);
  return json;
}

/// The parameters of friction and resonance, layers that the point models share.
std::vector<Parameter> shared_parameters() {
  std::vector<Parameter> shared;
  add_layer_parameters(shared);
  return shared;
}

bool is_shared(const std::string& name) {
  static const std::vector<Parameter> kShared = shared_parameters();
  return std::any_of(kShared.begin(), kShared.end(),
                     [&](const Parameter& shared) { return shared.name == name; });
}

nlohmann::ordered_json json_of_model(const ForceModel& force) {
  const ModelDeclaration& model = force.declaration;
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  nlohmann::ordered_json shared = nlohmann::ordered_json::array();
  for (const Parameter& parameter : model.parameters) {
    const bool is_choice = parameter.kind == ParameterKind::choice;
    nlohmann::ordered_json json{{"name", parameter.name}, {"kind", kind_name(parameter.kind)}};
    json["unit"] = is_choice ? nlohmann::ordered_json() : nlohmann::ordered_json(parameter.unit);
    json["minimum"] =
        is_choice ? nlohmann::ordered_json() : nlohmann::ordered_json(parameter.minimum);
    json["maximum"] =
        is_choice ? nlohmann::ordered_json() : nlohmann::ordered_json(parameter.maximum);
    json["choices"] =
        is_choice ? nlohmann::ordered_json(parameter.choices) : nlohmann::ordered_json();
    json["default"] = json_of_value(parameter.default_value);
    json["meaning"] = parameter.meaning;
    parameters.push_back(std::move(json));
    if (is_shared(parameter.name)) shared.push_back(parameter.name);
  }
  nlohmann::ordered_json assets = nlohmann::ordered_json::array();
  for (const AssetDeclaration& asset : model.assets) {
    assets.push_back({{"role", asset.role}, {"meaning", asset.meaning}});
  }
  return {{"id", model.id},
          {"version", model.version},
          {"summary", model.summary},
          {"source", model.source},
          {"conservative_with", json_of_condition(force.conservative_with)},
          {"needs_height_field", model.needs_height_field},
          {"needs_bodies", model.needs_bodies},
          {"assets", assets},
          {"amplitude_parameter", model.amplitude_parameter
                                      ? nlohmann::ordered_json(*model.amplitude_parameter)
                                      : nlohmann::ordered_json()},
          {"parameters", parameters},
          {"layer_parameters", shared},
          {"is_potential", is_potential(force, {})},
          {"band_Hz", force.band_formula},
          {"moves_by_itself", moves_by_itself(force, {})},
          {"moves_by_itself_with", json_of_condition(force.moves_by_itself_with)}};
}

void print_model(const ForceModel& force) {
  const ModelDeclaration& model = force.declaration;
  std::cout << model.id << "  (version " << model.version << ")\n  " << model.summary << "\n  "
            << model.source
            << "\n  conservative without friction: " << condition_text(force.conservative_with)
            << '\n';
  for (const AssetDeclaration& asset : model.assets) {
    std::cout << "  needs the asset " << asset.role << ": " << asset.meaning << '\n';
  }
  std::cout << "  highest frequency of the texture in Hz: " << force.band_formula
            << "\n  moves by itself: " << condition_text(force.moves_by_itself_with) << '\n';
  std::vector<Parameter> own;
  std::copy_if(model.parameters.begin(), model.parameters.end(), std::back_inserter(own),
               [](const Parameter& parameter) { return !is_shared(parameter.name); });
  std::cout << described(own);
  std::string shared;
  for (const Parameter& parameter : model.parameters) {
    if (is_shared(parameter.name)) shared += (shared.empty() ? "" : ", ") + parameter.name;
  }
  if (shared.size() > 0) std::cout << "  friction and resonance, see below: " << shared << '\n';
  std::cout << '\n';
}

}  // namespace

void add_models(CLI::App& program, Job& job) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("models", "List the force models and their parameters.");
  command->add_flag("--json", *json, "Print one JSON document");
  command->callback([json, &job] {
    job = [json] {
      const ModelRegistry registry = built_in_models();
      if (*json) {
        nlohmann::ordered_json document{{"format", "asperity.models/1"},
                                        {"models", nlohmann::ordered_json::array()}};
        for (const ForceModel& model : registry.models()) {
          document["models"].push_back(json_of_model(model));
        }
        std::cout << document.dump(2) << '\n';
      } else {
        for (const ForceModel& model : registry.models()) print_model(model);
        std::cout << "Friction and resonance, of all models that have these parameters\n"
                  << described(shared_parameters());
      }
      return 0;
    };
  });
}

}  // namespace asperity
