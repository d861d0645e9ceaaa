// asperity models: the force models, their declared parameters and their conformance.

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
#include "app/cli/options/model_option.h"
#include "app/cli/options/parameter_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_files.h"
#include "renderers/conformance/conformance.h"
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
    json["meaning"] = parameter.meaning.english();
    parameters.push_back(std::move(json));
    if (is_shared(parameter.name)) shared.push_back(parameter.name);
  }
  nlohmann::ordered_json assets = nlohmann::ordered_json::array();
  for (const AssetDeclaration& asset : model.assets) {
    assets.push_back({{"role", asset.role}, {"meaning", asset.meaning.english()}});
  }
  nlohmann::ordered_json plugin{};
  if (force.plugin) plugin = {{"file", force.plugin->file}, {"sha256", force.plugin->sha256}};
  return {{"id", model.id},
          {"version", model.version},
          {"summary", model.summary.english()},
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
          {"moves_by_itself_with", json_of_condition(force.moves_by_itself_with)},
          {"plugin", plugin}};
}

void print_model(const ForceModel& force) {
  const ModelDeclaration& model = force.declaration;
  std::cout << model.id << "  (version " << model.version << ")\n  " << model.summary.english()
            << "\n  " << model.source
            << "\n  conservative without friction: " << condition_text(force.conservative_with)
            << '\n';
  if (force.plugin) {
    std::cout << "  plug-in " << force.plugin->file << ", SHA-256 " << force.plugin->sha256 << '\n';
  }
  for (const AssetDeclaration& asset : model.assets) {
    std::cout << "  needs the asset " << asset.role << ": " << asset.meaning.english() << '\n';
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

/// As printed and in JSON.
const char* result_name(Conformance result) {
  switch (result) {
    case Conformance::met:
      return "met";
    case Conformance::violated:
      return "violated";
    case Conformance::not_applicable:
      return "n/a";
  }
  return "";
}

struct ModelConformance {
  const ForceModel* model = nullptr;
  std::vector<ConformanceCheck> checks{};
};

nlohmann::ordered_json json_of_conformance(const std::vector<ModelConformance>& found) {
  nlohmann::ordered_json document{{"format", "asperity.conformance/1"},
                                  {"models", nlohmann::ordered_json::array()}};
  for (const auto& [model, checks] : found) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ConformanceCheck& check : checks) {
      rows.push_back({{"name", check.name},
                      {"result", check.result == Conformance::not_applicable
                                     ? nlohmann::ordered_json()
                                     : nlohmann::ordered_json(result_name(check.result))},
                      {"measured", check.measured},
                      {"required", check.required}});
    }
    document["models"].push_back({{"id", model->declaration.id},
                                  {"version", model->declaration.version},
                                  {"conformant", is_conformant(checks)},
                                  {"checks", rows}});
  }
  return document;
}

void print_conformance(const ModelConformance& found) {
  std::cout << found.model->declaration.id << "  (version " << found.model->declaration.version
            << ")\n";
  Table table{{"check", "result", "measured", "required"}, {}};
  for (const ConformanceCheck& check : found.checks) {
    table.rows.push_back(
        {std::string(check.name), result_name(check.result), check.measured, check.required});
  }
  std::cout << aligned(table) << '\n';
}

/// The exit status: 1 if a model violates a check.
int report_conformance(const std::vector<const ForceModel*>& models, bool json) {
  std::vector<ModelConformance> found{};
  std::string violating{};
  for (const ForceModel* const model : models) {
    found.push_back({model, conformance_of(*model)});
    if (!json) print_conformance(found.back());
    if (is_conformant(found.back().checks)) continue;
    violating += (violating.empty() ? "" : ", ") + model->declaration.id;
  }
  if (json) std::cout << json_of_conformance(found).dump(2) << '\n';
  if (violating.empty()) return 0;
  say("asperity: checks of the conformance suite are violated by " + violating +
      "; correct the model, see docs/models/conformance.md");
  return 1;
}

}  // namespace

void add_models(CLI::App& program, Job& job) {
  struct Options {
    bool json = false;
    bool conformance = false;
    std::optional<std::string> model{};
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("models", "List the force models and their parameters.");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->add_flag("--conformance", options->conformance,
                    "Run the conformance suite, and print its table for each model, with --plugin "
                    "for those of plug-ins only");
  command->add_option("--model", options->model, "Only this force model");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] {
      const ModelRegistry registry = models_with_unchecked(options->plugins);
      const bool only_plugins = options->conformance && !options->plugins.empty();
      std::vector<const ForceModel*> models{};
      if (options->model) {
        models.push_back(&model_named(registry, *options->model));
      } else {
        for (const ForceModel& model : registry.models()) {
          if (!only_plugins || model.plugin) models.push_back(&model);
        }
      }
      if (options->conformance) return report_conformance(models, options->json);
      if (options->json) {
        nlohmann::ordered_json document{{"format", "asperity.models/1"},
                                        {"models", nlohmann::ordered_json::array()}};
        for (const ForceModel* const model : models) {
          document["models"].push_back(json_of_model(*model));
        }
        std::cout << document.dump(2) << '\n';
      } else {
        for (const ForceModel* const model : models) print_model(*model);
        std::cout << "Friction and resonance, of all models that have these parameters\n"
                  << described(shared_parameters());
      }
      return 0;
    });
  });
}

}  // namespace asperity
