// Implements the registry of force models and the checks of their inputs.

#include "renderers/force/force_model.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "renderers/force/layers.h"
#include "renderers/force/point_on_body.h"
#include "renderers/force/resonance.h"
#include "stimuli/stimulus_description.h"

namespace asperity {
namespace {

bool is_an_id(std::string_view id) {
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  return !id.empty() && is_lower(id.front()) && std::all_of(id.begin(), id.end(), [&](char c) {
    return is_lower(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

void require_roles(const ModelDeclaration& declaration) {
  std::set<std::string_view> taken(kCommonAssetRoles.begin(), kCommonAssetRoles.end());
  taken.insert("plugin");  // of the shared library of a plug-in, where attempts are stored
  for (const AssetDeclaration& asset : declaration.assets) {
    if (!is_an_id(asset.role)) {
      throw std::invalid_argument("AssetDeclaration::role \"" + asset.role + "\" of the model " +
                                  declaration.id +
                                  " must be a lower-case letter followed by lower-case letters, "
                                  "digits and underscores");
    }
    if (!taken.insert(asset.role).second) {
      throw std::invalid_argument("AssetDeclaration::role \"" + asset.role + "\" of the model " +
                                  declaration.id + " is taken; choose another role");
    }
  }
}

bool holds(const std::optional<ParameterValues>& condition, const ParameterValues& complete) {
  return condition && std::all_of(condition->begin(), condition->end(), [&](const auto& required) {
           return complete.at(required.first) == required.second;
         });
}

bool layer_moves_by_itself(const ParameterValues& complete) {
  return std::ranges::any_of(
      shared_layers(), [&complete](const Layer& layer) { return layer.moves_by_itself(complete); });
}

// The end of an error message: an instruction that names the missing inputs.
std::string missing_bodies(const RendererInputs& inputs) {
  if (inputs.tool) return "give it the missing surface";
  if (inputs.surface) return "give it the missing tool";
  return "give it both";
}

}  // namespace

std::unique_ptr<ForceRenderer> make_renderer(const ForceModel& model,
                                             const RendererInputs& inputs) {
  if (model.declaration.needs_height_field && !inputs.height_field) {
    throw std::invalid_argument("the force model " + model.declaration.id +
                                " needs a height field; give it one");
  }
  if (model.declaration.needs_bodies && !(inputs.tool && inputs.surface)) {
    throw std::invalid_argument(
        "the force model " + model.declaration.id +
        " needs a tool and a surface, both as meshes with haptic textures; " +
        missing_bodies(inputs));
  }
  if (model.declaration.needs_bodies && inputs.body) {
    throw std::invalid_argument("the force model " + model.declaration.id +
                                " touches a surface with a tool; give it the body as its surface");
  }
  for (const AssetDeclaration& asset : model.declaration.assets) {
    const auto given = inputs.assets.find(asset.role);
    if (given != inputs.assets.end() && given->second) continue;
    throw std::invalid_argument("the force model " + model.declaration.id + " needs the asset \"" +
                                asset.role + "\" (" + asset.meaning.english() + "); give it one");
  }
  RendererInputs complete = inputs;
  complete.parameters = complete_values(model.declaration, inputs.parameters);
  if (complete.body) return std::make_unique<PointOnBody>(model, complete);
  return with_resonance(model.make(complete), complete);
}

std::string name_of_asset(const RendererInputs& inputs, const std::string& role) {
  const auto named = inputs.asset_names.find(role);
  return named == inputs.asset_names.end() ? role : named->second;
}

bool is_potential(const ForceModel& model, const ParameterValues& given) {
  const ParameterValues complete = complete_values(model.declaration, given);
  return holds(model.conservative_with, complete) && !layer_moves_by_itself(complete);
}

bool moves_by_itself(const ForceModel& model, const ParameterValues& given) {
  const ParameterValues complete = complete_values(model.declaration, given);
  return holds(model.moves_by_itself_with, complete) || layer_moves_by_itself(complete);
}

bool feels_applied_force(const ForceModel& model, const ParameterValues& given) {
  return model.declaration.feels_applied_force ||
         holds(model.feels_applied_force_with, complete_values(model.declaration, given));
}

double band_Hz(const ForceModel& model, const RendererInputs& inputs, double speed_m_per_s) {
  RendererInputs complete = inputs;
  complete.parameters = complete_values(model.declaration, inputs.parameters);
  const TextureBand band = model.band(complete);
  double highest_Hz = std::max(band.time_Hz, speed_m_per_s * band.per_m);
  for (const Layer& layer : shared_layers()) {
    highest_Hz = std::max(highest_Hz, layer.band_Hz(complete.parameters));
  }
  return highest_Hz;
}

TextureBand band_of_height_field(const RendererInputs& inputs) {
  return {.per_m = inputs.patch.motion_scale / (2.0 * inputs.height_field->grid().pitch_m)};
}

std::string condition_text(const std::optional<ParameterValues>& condition) {
  if (!condition) return "never";
  if (condition->empty()) return "always";
  std::string text{};
  for (const auto& [name, value] : *condition) {
    const double* const number = std::get_if<double>(&value);
    text += (text.empty() ? "with " : ", ") + name + '=' +
            (number == nullptr ? std::get<std::string>(value) : number_text(*number));
  }
  return text;
}

void ModelRegistry::add(ForceModel model) {
  const std::string& id = model.declaration.id;
  if (!is_an_id(id)) {
    throw std::invalid_argument("the id \"" + id +
                                "\" of its force model must be a lower-case letter followed by "
                                "lower-case letters, digits and underscores");
  }
  if (const ForceModel* const other = find(id)) {
    throw std::invalid_argument(
        "the id \"" + id + "\" of its force model is that of " +
        (other->plugin ? "the plug-in " + other->plugin->file : std::string("a built-in model")) +
        "; choose another id");
  }
  require_roles(model.declaration);
  models_.push_back(std::move(model));
}

void ModelRegistry::replace(ForceModel model) {
  const auto found = std::find_if(models_.begin(), models_.end(), [&](const ForceModel& other) {
    return other.declaration.id == model.declaration.id;
  });
  if (found == models_.end()) {
    throw std::invalid_argument("ModelRegistry: there is no model \"" + model.declaration.id +
                                "\" to replace");
  }
  *found = std::move(model);
}

const ForceModel* ModelRegistry::find(std::string_view id) const& noexcept {
  for (const ForceModel& model : models_) {
    if (model.declaration.id == id) return &model;
  }
  return nullptr;
}

std::unique_ptr<ForceRenderer> ModelRegistry::make(std::string_view id,
                                                   const RendererInputs& inputs) const {
  if (const ForceModel* model = find(id)) return make_renderer(*model, inputs);
  std::string known;
  for (const ForceModel& model : models_) {
    known += (known.empty() ? "" : ", ") + model.declaration.id;
  }
  throw std::invalid_argument("there is no force model \"" + std::string(id) +
                              "\"; choose one of: " + known);
}

void add_files_of_relief(RendererInputs& inputs, const ForceModel& model,
                         const HeightField& field) {
  if (!model.files_of_relief) return;
  for (auto& [role, content] : model.files_of_relief(field)) {
    inputs.assets[role] = std::make_shared<const std::string>(std::move(content));
    inputs.asset_names.erase(role);
  }
}

std::vector<ModelDeclaration> declarations_of(const ModelRegistry& models) {
  std::vector<ModelDeclaration> declarations{};
  for (const ForceModel& model : models.models()) declarations.push_back(model.declaration);
  return declarations;
}

RendererInputs without_texture(const ModelDeclaration& declaration, const RendererInputs& inputs) {
  RendererInputs plate = inputs;
  if (declaration.amplitude_parameter) plate.parameters[*declaration.amplitude_parameter] = 0.0;
  plate.material.friction = 0.0;
  return plate;
}

}  // namespace asperity
