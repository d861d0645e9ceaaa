// Stores each plug-in's declaration as JSON of an event, and compares it with the loaded builds.

#include "app/plugins/stored_plugins.h"

#include <exception>
#include <stdexcept>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNumber = "number";
constexpr const char* kInteger = "integer";
constexpr const char* kChoice = "choice";

const char* kind_of(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::number:
      return kNumber;
    case ParameterKind::integer:
      return kInteger;
    case ParameterKind::choice:
      return kChoice;
  }
  return kNumber;
}

Json json_of(const ModelDeclaration& declaration) {
  Json parameters = Json::array();
  for (const Parameter& parameter : declaration.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"kind", kind_of(parameter)},
                          {"unit", parameter.unit},
                          {"minimum", parameter.minimum},
                          {"maximum", parameter.maximum},
                          {"choices", parameter.choices},
                          {"default", std::visit([](const auto& one) { return Json(one); },
                                                 parameter.default_value)},
                          {"meaning", parameter.meaning.english()}});
  }
  return {{"summary", declaration.summary.english()},
          {"source", declaration.source},
          {"needs_height_field", declaration.needs_height_field},
          {"feels_applied_force", declaration.feels_applied_force},
          {"amplitude_parameter", declaration.amplitude_parameter.value_or("")},
          {"parameters", parameters}};
}

Parameter parameter_in(const Json& json) {
  Parameter parameter{};
  parameter.name = json.at("name").get<std::string>();
  const std::string kind = json.at("kind").get<std::string>();
  parameter.kind = kind == kChoice    ? ParameterKind::choice
                   : kind == kInteger ? ParameterKind::integer
                                      : ParameterKind::number;
  parameter.unit = json.at("unit").get<std::string>();
  parameter.minimum = json.at("minimum").get<double>();
  parameter.maximum = json.at("maximum").get<double>();
  parameter.choices = json.at("choices").get<std::vector<std::string>>();
  if (parameter.kind == ParameterKind::choice) {
    parameter.default_value = json.at("default").get<std::string>();
  } else {
    parameter.default_value = json.at("default").get<double>();
  }
  parameter.meaning = json.at("meaning").get<std::string>();
  return parameter;
}

/// A model that is declared and cannot be rendered.
ForceModel model_in(const Json& data) {
  const Json& stored = data.at("declaration");
  ForceModel model{};
  model.declaration.id = data.at("model").get<std::string>();
  model.declaration.version = data.at("version").get<std::string>();
  model.declaration.summary = stored.at("summary").get<std::string>();
  model.declaration.source = stored.at("source").get<std::string>();
  model.declaration.needs_height_field = stored.at("needs_height_field").get<bool>();
  model.declaration.feels_applied_force = stored.at("feels_applied_force").get<bool>();
  model.declaration.amplitude_parameter = stored.at("amplitude_parameter").get<std::string>();
  for (const Json& parameter : stored.at("parameters")) {
    model.declaration.parameters.push_back(parameter_in(parameter));
  }
  model.plugin = PluginOrigin{.file = data.at("file").get<std::string>(),
                              .sha256 = data.at("sha256").get<std::string>()};
  const std::string missing = "the force model " + model.declaration.id + " is the plug-in " +
                              model.plugin->file + " with the SHA-256 " + model.plugin->sha256 +
                              ", which is not loaded; load it with --plugin FILE";
  model.make = [missing](const RendererInputs&) -> std::unique_ptr<ForceRenderer> {
    throw std::invalid_argument(missing);
  };
  model.band = [missing](const RendererInputs&) -> TextureBand {
    throw std::invalid_argument(missing);
  };
  return model;
}

std::string attempts_text(std::int64_t attempts) {
  return std::to_string(attempts) + (attempts == 1 ? " attempt" : " attempts");
}

}  // namespace

std::vector<EventRow> plugin_events(const ModelRegistry& models, std::int64_t time_ns) {
  std::vector<EventRow> events{};
  for (const ForceModel& model : models.models()) {
    if (!model.plugin) continue;
    const Json data{{"model", model.declaration.id},
                    {"version", model.declaration.version},
                    {"sha256", model.plugin->sha256},
                    {"file", model.plugin->file},
                    {"declaration", json_of(model.declaration)}};
    events.push_back({.time_ns = time_ns,
                      .kind = kPluginEvent,
                      .text = model.declaration.id + ' ' + model.declaration.version,
                      .data_json = data.dump()});
  }
  return events;
}

ModelRegistry with_stored_plugins(ModelRegistry models, const Study& study) {
  std::vector<std::string> stored = study.event_data(kPluginEvent);
  for (auto data = stored.rbegin(); data != stored.rend(); ++data) {
    try {
      ForceModel model = model_in(Json::parse(*data));
      if (models.find(model.declaration.id) == nullptr) models.add(std::move(model));
    } catch (const std::exception&) {
      continue;  // damaged data: `plugin_problems` reports them
    }
  }
  return models;
}

ModelBuilds with_stored_builds(ModelBuilds builds, const Study& study) {
  std::vector<std::string> stored = study.event_data(kPluginEvent);
  for (auto data = stored.rbegin(); data != stored.rend(); ++data) {
    try {
      builds.add(model_in(Json::parse(*data)));
    } catch (const std::exception&) {
      continue;  // damaged data: `plugin_problems` reports them
    }
  }
  return builds;
}

std::vector<std::string> plugin_problems(const ModelBuilds& builds, const Study& study) {
  std::vector<std::string> problems{};
  for (const std::string& data : study.event_data(kPluginEvent)) {
    try {
      (void)model_in(Json::parse(data));
    } catch (const std::exception&) {
      problems.emplace_back(
          "the stored declaration of a plug-in (event \"plugin\") is damaged; protocols with its "
          "model can be read only with the plug-in: load it with --plugin FILE");
    }
  }
  for (const PluginUse& use : study.plugin_uses()) {
    if (builds.find(use.model, use.sha256) != nullptr) continue;
    const ForceModel* const model = builds.models().find(use.model);
    const std::string rendered = "the plug-in model " + use.model + ", version " +
                                 use.model_version + " (SHA-256 " + use.sha256 + "), rendered " +
                                 attempts_text(use.attempts);
    if (model == nullptr || !model->plugin) {
      problems.push_back(rendered + " and is not loaded; load it with --plugin FILE");
    } else {
      problems.push_back(rendered + ", and the loaded plug-in " + model->plugin->file +
                         " differs: version " + model->declaration.version + " (SHA-256 " +
                         model->plugin->sha256 + "); load the one that rendered the attempts");
    }
  }
  return problems;
}

}  // namespace asperity
