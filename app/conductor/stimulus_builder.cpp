#include "app/conductor/stimulus_builder.h"

#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "renderers/offline/force_matching.h"
#include "results_schema/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

TextureForcePath path_of(const EqualForce& request) {
  TextureForcePath path{};
  path.low_Hz = request.band_low_Hz;
  path.high_Hz = request.band_high_Hz;
  return path;
}

nlohmann::ordered_json json_of(const ParameterValues& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : values) {
    if (const double* number = std::get_if<double>(&value)) {
      json[name] = *number;
    } else {
      json[name] = std::get<std::string>(value);
    }
  }
  return json;
}

/// Everything that the solution of a matching problem depends on, as a name.
std::string key_of(const PreparedStimulus& stimulus, const EqualForce& request) {
  const RendererInputs& inputs = stimulus.inputs;
  nlohmann::ordered_json problem{
      {"model", stimulus.model->declaration.id},
      {"version", stimulus.model->declaration.version},
      {"parameters", json_of(inputs.parameters)},
      {"stiffness_N_per_m", inputs.material.stiffness_N_per_m},
      {"friction", inputs.material.friction},
      {"motion_scale", inputs.patch.motion_scale},
      {"height_field", stimulus.height_field_sha256.value_or("")},
      {"to_model", request.to_model},
      {"rms_N", request.rms_N.value_or(0.0)},
      {"low_Hz", request.band_low_Hz},
      {"high_Hz", request.band_high_Hz},
  };
  return sha256_of(problem.dump());
}

}  // namespace

StimulusBuilder::StimulusBuilder(const ModelRegistry& models, std::filesystem::path study_folder)
    : models_(models), study_folder_(std::move(study_folder)) {}

LoadedHeightField StimulusBuilder::height_field(const std::string& study_path) {
  const std::lock_guard lock(mutex_);
  const auto found = fields_.find(study_path);
  if (found != fields_.end()) return found->second;
  return fields_.emplace(study_path, load_height_field(study_folder_ / study_path)).first->second;
}

PreparedStimulus StimulusBuilder::prepare(const PlannedPresentation& presentation, Study& study) {
  const StimulusDescription& description = presentation.stimulus;
  PreparedStimulus prepared{};
  prepared.model = models_.find(description.model);
  if (prepared.model == nullptr) {
    throw std::runtime_error("the stimulus \"" + description.name + "\" wants the force model \"" +
                             description.model + "\", which this program does not have");
  }
  RendererInputs& inputs = prepared.inputs;
  inputs.material = description.material;
  inputs.patch = description.patch;
  if (description.height_field) {
    LoadedHeightField loaded = height_field(*description.height_field);
    inputs.height_field = std::move(loaded.field);
    prepared.height_field_sha256 = std::move(loaded.sha256);
    if (prepared.model->suggested_by) {
      inputs.parameters = prepared.model->suggested_by(*inputs.height_field, inputs.material);
    }
  }
  for (const auto& [name, value] : description.parameters) inputs.parameters[name] = value;
  inputs.parameters = complete_values(prepared.model->declaration, inputs.parameters);
  if (presentation.equal_force) match(prepared, *presentation.equal_force, study);
  return prepared;
}

double StimulusBuilder::target_rms_N(const EqualForce& request,
                                     const RendererInputs& inputs) const {
  if (request.rms_N) return *request.rms_N;
  const ForceModel* reference = models_.find(request.to_model);
  if (reference == nullptr) {
    throw std::runtime_error("equal force is asked for with the model \"" + request.to_model +
                             "\", which this program does not have");
  }
  RendererInputs plain = inputs;
  plain.parameters = complete_values(reference->declaration, {});
  return texture_force_rms_N(*reference, plain, path_of(request));
}

void StimulusBuilder::match(PreparedStimulus& prepared, const EqualForce& request, Study& study) {
  const std::string key = key_of(prepared, request);
  // One problem at a time: sessions that run in parallel wait for the first to solve it.
  const std::lock_guard lock(mutex_);
  std::string& known = solutions_[key];
  if (known.empty()) {
    if (const auto stored = study.solution(key)) {
      known = *stored;
    } else {
      const double target_N = target_rms_N(request, prepared.inputs);
      nlohmann::ordered_json solution{{"model", prepared.model->declaration.id},
                                      {"target_rms_N", target_N}};
      if (prepared.model->declaration.id != request.to_model || request.rms_N) {
        const SolvedAmplitude solved =
            solve_amplitude(*prepared.model, prepared.inputs, target_N, path_of(request));
        solution["parameter"] = solved.parameter;
        solution["value"] = solved.value;
        solution["texture_force_rms_N"] = solved.texture_force_rms_N;
      }
      known = solution.dump();
      study.remember_solution(key, known);
    }
  }
  const nlohmann::json solution = nlohmann::json::parse(known);
  if (solution.contains("parameter")) {
    prepared.inputs.parameters[solution["parameter"].get<std::string>()] =
        solution["value"].get<double>();
  }
  prepared.matched_texture_force_N = solution["target_rms_N"].get<double>();
}

}  // namespace asperity
