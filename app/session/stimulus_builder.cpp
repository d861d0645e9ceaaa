// Caches files, bodies and matched forces by checksums, and fills in the parameters of the model.

#include "app/session/stimulus_builder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrase.h"
#include "app/study_files/parameter_json.h"
#include "app/words/phrase_of_error.h"
#include "renderers/built_in_models.h"
#include "renderers/force/layers.h"
#include "renderers/force/path_clock.h"
#include "renderers/offline/force_matching.h"
#include "renderers/proxy/body_surface.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {

namespace {

TextureForcePath path_of(const EqualForce& request) {
  TextureForcePath path{};
  path.low_Hz = request.band_low_Hz;
  path.high_Hz = request.band_high_Hz;
  return path;
}

bool is_common_role(std::string_view role) {
  return std::find(kCommonAssetRoles.begin(), kCommonAssetRoles.end(), role) !=
         kCommonAssetRoles.end();
}

/// As a name; empty where there is none.
std::string content_of(const PreparedStimulus& stimulus, std::string_view role) {
  return asset_sha256(stimulus.assets, role).value_or("");
}

/// Everything that the solution of a matching problem depends on, as a name.
std::string key_of(const PreparedStimulus& stimulus, const EqualForce& request,
                   const ForceModel* reference, const ParameterValues& reference_parameters,
                   const std::vector<AssetRow>& assets) {
  const RendererInputs& inputs = stimulus.inputs;
  const TextureForcePath path = path_of(request);
  nlohmann::ordered_json problem{
      {"model", stimulus.model->declaration.id},
      {"version", stimulus.model->declaration.version},
      {"parameters", json_text_of(without_unused_layers(inputs.parameters))},
      {"reference", reference == nullptr ? "" : reference->declaration.id},
      {"reference_version", reference == nullptr ? "" : reference->declaration.version},
      {"reference_parameters", json_text_of(without_unused_layers(reference_parameters))},
      {"rms_N", request.rms_N.value_or(0.0)},
      {"stiffness_N_per_m", inputs.material.stiffness_N_per_m},
      {"friction", inputs.material.friction},
      {"motion_scale", inputs.patch.motion_scale},
      {"centre_m", {inputs.patch.centre_m.x, inputs.patch.centre_m.y, inputs.patch.centre_m.z}},
      {"height_field", content_of(stimulus, kHeightFieldRole)},
      {"path",
       {path.speed_m_per_s, path.duration_s, path.dropped_s, path.rate_Hz, path.mean_normal_force_N,
        path.low_Hz, path.high_Hz}}};
  for (const AssetRow& asset : assets) {
    // A height field has its key above, which every stored solution has; bodies are not matched.
    if (!is_common_role(asset.role)) problem["assets"][asset.role] = asset.sha256;
  }
  if (reference != nullptr && reference->plugin) {
    problem["reference_plugin"] = reference->plugin->sha256;
  }
  return sha256_of(problem.dump());
}

/// Multiplies the amplitude, and so removes the texture force to which it was matched. Errors: PhrasedError for a product
/// that the model does not allow.
void scale_amplitude(const StimulusDescription& description, PreparedStimulus& prepared) {
  if (!description.relative_amplitude || *description.relative_amplitude == 1.0) return;
  const ModelDeclaration& model = prepared.model->declaration;
  if (!model.amplitude_parameter) {
    throw PhrasedError(phrase("SessionSetup",
                              "the stimulus \"%1\" has a relative amplitude, but its force model "
                              "\"%2\" has no amplitude; use a model that has one")
                           .with(description.name, model.id));
  }
  ParameterValue& amplitude = prepared.inputs.parameters.at(*model.amplitude_parameter);
  amplitude = std::get<double>(amplitude) * *description.relative_amplitude;
  for (const Parameter& declared : model.parameters) {
    if (declared.name != *model.amplitude_parameter) continue;
    if (const auto complaint = complaint_about(declared, amplitude)) {
      throw PhrasedError(
          phrase("SessionSetup",
                 "the stimulus \"%1\" at a relative amplitude of %2: %3 Narrow the "
                 "range of the relative amplitude.")
              .with(description.name, number_text(*description.relative_amplitude), *complaint));
    }
  }
  prepared.matched_texture_force_N.reset();
}

/// The recipe of a shape's mesh, as a text that does not change between versions.
std::string recipe_of(const BodyDescription& body, BodyRole role, const std::string& field_sha256) {
  nlohmann::ordered_json recipe{{"format", "asperity.shaped_body/1"}, {"role", text_of(role)}};
  struct Sizes {
    nlohmann::ordered_json& recipe;
    void operator()(const PlateShape& plate) const { box("plate", plate.size_m); }
    void operator()(const BoxShape& shape) const { box("box", shape.size_m); }
    void operator()(const CylinderShape& cylinder) const {
      recipe["shape"] = "cylinder";
      recipe["diameter_m"] = cylinder.diameter_m;
      recipe["length_m"] = cylinder.length_m;
    }
    void operator()(const SphereShape& sphere) const {
      recipe["shape"] = "sphere";
      recipe["diameter_m"] = sphere.diameter_m;
    }
    void box(const char* shape, const glm::dvec3& size_m) const {
      recipe["shape"] = shape;
      recipe["size_m"] = {size_m.x, size_m.y, size_m.z};
    }
  };
  std::visit(Sizes{recipe}, body.shape.value());
  recipe["axis"] = text_of(body.axis);
  recipe["height_field_sha256"] =
      field_sha256.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(field_sha256);
  return recipe.dump();
}

}  // namespace

StimulusBuilder::StimulusBuilder(const ModelRegistry& models, std::filesystem::path study_folder,
                                 KeptHeightFields* kept)
    : models_(models), study_folder_(std::move(study_folder)), kept_(kept) {}

void StimulusBuilder::compute_on(std::shared_ptr<const Compute> compute) {
  computed_ = computed_on(std::move(compute), models_);
}

LoadedHeightField StimulusBuilder::height_field(const std::string& study_path) {
  const std::lock_guard lock(fields_mutex_);
  const auto found = fields_.find(study_path);
  if (found != fields_.end()) return found->second;
  const std::filesystem::path png = study_folder_ / study_path;
  return fields_.emplace(study_path, kept_ != nullptr ? kept_->load(png) : load_height_field(png))
      .first->second;
}

std::shared_ptr<const HeightField> StimulusBuilder::height_field_without_long_wavelengths(
    const std::string& study_path, double gaussian_wavelength_m) {
  const LoadedHeightField whole = height_field(study_path);
  const std::lock_guard lock(fields_mutex_);
  std::shared_ptr<const HeightField>& filtered = filtered_[{study_path, gaussian_wavelength_m}];
  if (filtered == nullptr) {
    filtered = std::make_shared<const HeightField>(
        without_long_wavelengths(*whole.field, gaussian_wavelength_m));
  }
  return filtered;
}

LoadedAsset StimulusBuilder::asset(const std::string& study_path) {
  const std::lock_guard lock(assets_mutex_);
  LoadedAsset& known = assets_[study_path];
  if (known.content == nullptr) {
    std::string content = read_file(study_folder_ / study_path);
    known.sha256 = sha256_of(content);
    known.content = std::make_shared<const std::string>(std::move(content));
  }
  return known;
}

LoadedTexturedMesh StimulusBuilder::mesh(const std::string& study_path) {
  const std::lock_guard lock(bodies_mutex_);
  const auto found = meshes_.find(study_path);
  if (found != meshes_.end()) return found->second;
  return meshes_.emplace(study_path, load_textured_mesh(study_folder_ / study_path)).first->second;
}

LoadedBody StimulusBuilder::body(const BodyDescription& description, BodyRole role) {
  if (description.mesh) {
    const LoadedTexturedMesh loaded = mesh(*description.mesh);
    return {std::shared_ptr<const TexturedMesh>(loaded.stored, &loaded.stored->mesh),
            loaded.sha256};
  }
  LoadedHeightField field{};
  if (description.height_field) field = height_field(*description.height_field);
  LoadedBody made{};
  made.sha256 = sha256_of(recipe_of(description, role, field.sha256));
  const std::lock_guard lock(bodies_mutex_);
  std::shared_ptr<const TexturedMesh>& known = bodies_[made.sha256];
  if (known == nullptr) {
    known = std::make_shared<const TexturedMesh>(placed(
        turned(body_mesh(description.shape.value(), field.field.get()), description.axis), role));
  }
  made.mesh = known;
  return made;
}

std::shared_ptr<const BodySurface> StimulusBuilder::surface_of(const LoadedBody& body) {
  const std::lock_guard lock(bodies_mutex_);
  std::shared_ptr<const BodySurface>& known = surfaces_[body.sha256];
  if (known == nullptr) known = std::make_shared<const BodySurface>(*body.mesh);
  return known;
}

void StimulusBuilder::require_body(const BodyDescription& description) {
  if (description.mesh) {
    mesh(*description.mesh);
    return;
  }
  LoadedHeightField field{};
  if (description.height_field) field = height_field(*description.height_field);
  require_body_mesh(description.shape.value(), field.field.get());
}

ParameterValues StimulusBuilder::parameters_for(const ForceModel& model,
                                                const PreparedStimulus& stimulus,
                                                const ParameterValues& given) {
  const RendererInputs& inputs = stimulus.inputs;
  ParameterValues values{};
  if (inputs.height_field && model.suggested_by) {
    // A suggestion takes the spectrum of the whole sample; every attempt asks for the same few.
    const std::string key = model.declaration.id + ' ' + content_of(stimulus, kHeightFieldRole) +
                            ' ' + text_of_number(inputs.material.stiffness_N_per_m) + ' ' +
                            text_of_number(inputs.material.friction);
    const std::lock_guard lock(suggestions_mutex_);
    auto found = suggestions_.find(key);
    if (found == suggestions_.end()) {
      found = suggestions_.emplace(key, model.suggested_by(*inputs.height_field, inputs.material))
                  .first;
    }
    for (const auto& [name, value] : found->second) values[name] = value;
  }
  for (const auto& [name, value] : given) values[name] = value;
  const bool is_stated = values.contains(kDeviceStep);
  values = complete_values(model.declaration, values);
  if (is_stated || position_step_m_ == 0.0 || !measures_path(values)) return values;
  values[kDeviceStep] = position_step_m_;
  return complete_values(model.declaration, values);
}

PreparedStimulus StimulusBuilder::prepare(const PlannedPresentation& presentation, Study* study) {
  PreparedStimulus prepared = of_own_amplitude(presentation.stimulus);
  if (presentation.equal_force) match(prepared, presentation, study);
  scale_amplitude(presentation.stimulus, prepared);
  return prepared;
}

bool StimulusBuilder::can_make(const StimulusDescription& description) const {
  return !study_folder_.empty() || assets_of(description).empty();
}

PreparedStimulus StimulusBuilder::unmatched(const StimulusDescription& description) {
  PreparedStimulus prepared = of_own_amplitude(description);
  scale_amplitude(description, prepared);
  return prepared;
}

PreparedStimulus StimulusBuilder::of_own_amplitude(const StimulusDescription& description) {
  PreparedStimulus prepared = without_parameters(description);
  prepared.inputs.parameters = parameters_for(*prepared.model, prepared, description.parameters);
  return prepared;
}

PreparedStimulus StimulusBuilder::without_parameters(const StimulusDescription& description) {
  PreparedStimulus prepared{};
  prepared.model = models().find(description.model);
  if (prepared.model == nullptr) {
    throw PhrasedError(phrase("SessionSetup",
                              "the stimulus \"%1\" needs the force model \"%2\", which this "
                              "program does not have; load its plug-in, or use one that \"asperity "
                              "models\" lists")
                           .with(description.name, description.model));
  }
  RendererInputs& inputs = prepared.inputs;
  inputs.material = description.material;
  inputs.patch = description.patch;
  if (const auto& plugin = prepared.model->plugin) {
    prepared.assets.push_back({std::string(kPluginRole), plugin->sha256});
  }
  const auto took = [&prepared](std::string_view role, std::string sha256) {
    prepared.assets.push_back({std::string(role), std::move(sha256)});
  };
  if (description.height_field) {
    LoadedHeightField loaded = height_field(*description.height_field);
    inputs.height_field = std::move(loaded.field);
    took(kHeightFieldRole, std::move(loaded.sha256));
  }
  const ModelDeclaration& declaration = prepared.model->declaration;
  if (declaration.needs_bodies) {
    const auto prepare_body = [this, &took](const std::optional<BodyDescription>& body,
                                            BodyRole role, std::string_view asset_role,
                                            std::shared_ptr<const TexturedMesh>& mesh) {
      if (!body) return;
      LoadedBody loaded = this->body(*body, role);
      mesh = std::move(loaded.mesh);
      took(asset_role, std::move(loaded.sha256));
    };
    prepare_body(description.surface, BodyRole::surface, kSurfaceRole, inputs.surface);
    prepare_body(description.tool, BodyRole::tool, kToolRole, inputs.tool);
  } else if (description.surface && !description.tool) {
    LoadedBody loaded = body(*description.surface, BodyRole::surface);
    inputs.body = surface_of(loaded);
    took(kSurfaceRole, std::move(loaded.sha256));
  }
  for (AssetRow& row : take_assets(declaration, description, inputs)) {
    prepared.assets.push_back(std::move(row));
  }
  return prepared;
}

std::vector<AssetRow> StimulusBuilder::take_assets(const ModelDeclaration& model,
                                                   const StimulusDescription& description,
                                                   RendererInputs& inputs) {
  std::vector<AssetRow> rows{};
  for (const AssetDeclaration& declared : model.assets) {
    const auto path = description.declared_assets.find(declared.role);
    if (path == description.declared_assets.end()) continue;  // make_renderer refuses
    LoadedAsset loaded = asset(path->second);
    inputs.assets[declared.role] = std::move(loaded.content);
    inputs.asset_names[declared.role] = path->second;
    rows.push_back({declared.role, std::move(loaded.sha256)});
  }
  return rows;
}

void StimulusBuilder::match(PreparedStimulus& prepared, const PlannedPresentation& presentation,
                            Study* study) {
  const EqualForce& request = presentation.equal_force.value();
  // The path lies on a plane: so does the texture, also of a stimulus on a body.
  const std::shared_ptr<const BodySurface> body = std::exchange(prepared.inputs.body, nullptr);
  RendererInputs& inputs = prepared.inputs;
  // The position step of the device does not take part: the amplitude of a stimulus is the same on every device of a study.
  const bool has_step_of_device =
      measures_path(inputs.parameters) && !presentation.stimulus.parameters.contains(kDeviceStep);
  if (has_step_of_device) inputs.parameters[kDeviceStep] = 0.0;
  const ForceModel* reference = nullptr;
  std::vector<AssetRow> assets = prepared.assets;
  RendererInputs reference_inputs = inputs;
  reference_inputs.parameters.clear();
  if (!request.rms_N) {
    reference = models().find(request.to_model);
    if (reference == nullptr) {
      throw PhrasedError(phrase("SessionSetup",
                                "equal force is requested with the model \"%1\", which this "
                                "program does not have; use one that \"asperity models\" lists")
                             .with(request.to_model));
    }
    reference_inputs.parameters = parameters_for(*reference, prepared, {});
    if (measures_path(reference_inputs.parameters)) reference_inputs.parameters[kDeviceStep] = 0.0;
    for (AssetRow& row :
         take_assets(reference->declaration, presentation.stimulus, reference_inputs)) {
      assets.push_back(std::move(row));
    }
  }
  const std::string key = key_of(prepared, request, reference, reference_inputs.parameters, assets);
  // One problem at a time: sessions that run in parallel wait for the first to solve it.
  const std::lock_guard lock(matching_mutex_);
  std::string& known = solutions_[key];
  if (known.empty() && study != nullptr) known = study->solution(key).value_or(std::string());
  if (known.empty()) {
    const double target_N =
        request.rms_N ? *request.rms_N
                      : texture_force_rms_N(*reference, reference_inputs, path_of(request));
    nlohmann::ordered_json solution{{"model", prepared.model->declaration.id},
                                    {"target_rms_N", target_N}};
    // The reference itself keeps its strength; everything else is solved for.
    const bool is_reference =
        prepared.model == reference && inputs.parameters == reference_inputs.parameters;
    if (!is_reference) {
      const SolvedAmplitude solved =
          solve_amplitude(*prepared.model, inputs, target_N, path_of(request));
      solution["parameter"] = solved.parameter;
      solution["value"] = solved.value;
      solution["texture_force_rms_N"] = solved.texture_force_rms_N;
    }
    known = solution.dump();
    if (study != nullptr) study->remember_solution(key, known);
  }
  const nlohmann::json solution = nlohmann::json::parse(known);
  if (solution.contains("parameter")) {
    inputs.parameters[solution["parameter"].get<std::string>()] = solution["value"].get<double>();
  }
  prepared.matched_texture_force_N = solution["target_rms_N"].get<double>();
  if (has_step_of_device) inputs.parameters[kDeviceStep] = position_step_m_;
  inputs.body = body;
}

}  // namespace asperity
