// A stimulus by name: which model, which parameters, which texture, where.

#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/meshes/solid_body.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The roles of assets that every model knows. Other roles are declared by models (AssetDeclaration).
inline constexpr std::string_view kHeightFieldRole = "height_field";
inline constexpr std::string_view kSurfaceRole = "surface";
inline constexpr std::string_view kToolRole = "tool";
inline constexpr std::array kCommonAssetRoles{kHeightFieldRole, kSurfaceRole, kToolRole};

/// Everything that has to be known to build the renderer of one stimulus, and nothing of when or
/// why it is presented. Two equal descriptions, with files of equal content, are the same stimulus.
struct StimulusDescription {
  std::string name{};     ///< as the protocol calls it, e.g. "metal_height_map"
  std::string model{};    ///< ModelDeclaration::id
  std::string texture{};  ///< the protocol's name of the texture; empty where none is involved
  /// Path inside the study of the height field's PNG (its sidecar stands beside it).
  std::optional<std::string> height_field{};
  /// Of a model that needs bodies: what is touched, with the height field above where it is a shape
  /// without a texture of its own; and what the hand holds. Of a point model: `surface` alone, the body
  /// on which it renders the height field.
  std::optional<BodyDescription> surface{};
  std::optional<BodyDescription> tool{};
  /// Role → study-relative path: the texture's files for models that declare such roles.
  std::map<std::string, std::string, std::less<>> declared_assets{};
  ParameterValues parameters{};  ///< as given; defaults are the model's
  /// Multiplies the amplitude parameter of the model (ModelDeclaration::amplitude_parameter), whatever determines its
  /// value: the protocol, the sample, equal force or the default. Absent: 1.
  std::optional<double> relative_amplitude{};
  Material material{};
  SurfacePatch patch{};
};

/// A file from which a stimulus is made, and what it is for.
struct StimulusAsset {
  std::string role{};
  std::string path{};  ///< study-relative
  bool operator==(const StimulusAsset&) const = default;
};

/// All files from which a stimulus is made: the common roles in their order, then the declared ones by name. A body is
/// the file of its mesh or that of the relief on its shape; a smooth shape is made from no file.
std::vector<StimulusAsset> assets_of(const StimulusDescription& stimulus);

}  // namespace asperity
