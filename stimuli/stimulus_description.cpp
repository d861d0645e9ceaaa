// Lists height field, bodies and declared assets of a stimulus by their roles.

#include "stimuli/stimulus_description.h"

namespace asperity {

std::vector<StimulusAsset> assets_of(const StimulusDescription& stimulus) {
  std::vector<StimulusAsset> assets{};
  const auto add = [&assets](std::string_view role, const std::optional<std::string>& path) {
    if (path) assets.push_back({std::string(role), *path});
  };
  const auto add_body = [&add](std::string_view role, const std::optional<BodyDescription>& body) {
    if (body) add(role, body->mesh ? body->mesh : body->height_field);
  };
  add(kHeightFieldRole, stimulus.height_field);
  add_body(kSurfaceRole, stimulus.surface);
  add_body(kToolRole, stimulus.tool);
  for (const auto& [role, path] : stimulus.declared_assets) add(role, path);
  return assets;
}

}  // namespace asperity
