// Takes suggested parameters by relief and material, then the given ones, and assets by their roles.

#include "app/records/other_model.h"

#include <cstddef>

namespace asperity {

bool feel_alike(const ForceModel& one, const ForceModel& other) noexcept {
  return one.declaration.needs_bodies == other.declaration.needs_bodies;
}

ParameterValues OtherModel::suggested_by(const RendererInputs& inputs) {
  if (!model().suggested_by || !inputs.height_field) return {};
  const std::lock_guard lock(mutex_);
  const auto [known, is_new] = suggestions_.try_emplace(
      {inputs.height_field, inputs.material.stiffness_N_per_m, inputs.material.friction});
  if (is_new) known->second = model().suggested_by(*inputs.height_field, inputs.material);
  return known->second;
}

RendererInputs OtherModel::inputs_for(const RecordedAttempt& recorded, int position,
                                      StimulusBuilder& builder) {
  const auto at = static_cast<std::size_t>(position - 1);
  const PreparedStimulus& felt = recorded.surfaces.at(at).stimulus;
  RendererInputs inputs = felt.inputs;
  if (model().declaration.id != felt.model->declaration.id) {
    inputs.parameters = suggested_by(inputs);
  }
  for (const auto& [name, value] : settings_.parameters) inputs.parameters[name] = value;
  const auto& of_texture = recorded.trial.presentations.at(at).stimulus.declared_assets;
  for (const AssetDeclaration& asset : model().declaration.assets) {
    if (const auto given = settings_.assets.find(asset.role); given != settings_.assets.end()) {
      inputs.assets[asset.role] = given->second;
      inputs.asset_names[asset.role] = settings_.asset_names.at(asset.role);
    } else if (const auto file = of_texture.find(asset.role); file != of_texture.end()) {
      inputs.assets[asset.role] = builder.asset(file->second).content;
      inputs.asset_names[asset.role] = file->second;
    }
  }
  return inputs;
}

}  // namespace asperity
