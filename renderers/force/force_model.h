// A force model by name, and the list of those that there are.

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderers/force/force_renderer.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// What a model is given to build one renderer.
struct RendererInputs {
  ParameterValues parameters{};  ///< as given; the registry completes and checks them
  Material material{};
  SurfacePatch patch{};
  /// Shared, because presentations of the same texture outlive each other in any order.
  std::shared_ptr<const HeightField> height_field{};
  /// Shared likewise. What the hand holds, its tip the origin of the mesh's own frame, which turns
  /// with the device; and what it touches, its own frame with its origin in `patch.centre_m`.
  std::shared_ptr<const TexturedMesh> tool{};
  std::shared_ptr<const TexturedMesh> surface{};
  std::uint64_t seed = 0;  ///< of a model that draws random numbers
};

/// A declaration and the way to make renderers of it.
struct ForceModel {
  ModelDeclaration declaration{};
  /// Receives complete, checked parameters. Throws std::invalid_argument for inputs that contradict
  /// each other.
  std::function<std::unique_ptr<ForceRenderer>(const RendererInputs&)> make{};
  /// The parameters that a sample of texture suggests, for a model that takes them from the
  /// sample's statistics (a sinusoid's amplitude and wavelength). Empty for a model that needs
  /// none.
  std::function<ParameterValues(const HeightField&, const Material&)> suggested_by{};
  /// The parameter values with which the force without friction is conservative: a hand that returns in contact to where
  /// it was has gained no energy. Empty: whatever the values. Nothing: with no values, so that a hand can be given energy
  /// on one way around and loses it on the other.
  std::optional<ParameterValues> conservative_with{};
};

/// "always", "never", "with lateral_gradient_gain=1, law=corrected"
std::string conservative_text(const ForceModel& model);

/// One renderer of a model, from parameters as given: they are completed and checked here.
///
/// Errors: std::invalid_argument for a bad parameter, for a height field or a body that is needed
/// and missing, and for inputs that the model refuses.
std::unique_ptr<ForceRenderer> make_renderer(const ForceModel& model, const RendererInputs& inputs);

/// The force models that a program knows.
///
/// Errors: `add` throws std::invalid_argument for an id that is taken or not `[a-z][a-z0-9_]*`;
/// `make` for an unknown model, and as `make_renderer` does.
class ModelRegistry final {
 public:
  void add(ForceModel model);
  const std::vector<ForceModel>& models() const& noexcept { return models_; }
  const std::vector<ForceModel>& models() && = delete;  // a loop over a temporary's would dangle
  /// Null when there is no model of this name.
  const ForceModel* find(std::string_view id) const& noexcept;
  const ForceModel* find(std::string_view id) && = delete;
  std::unique_ptr<ForceRenderer> make(std::string_view id, const RendererInputs& inputs) const;

 private:
  std::vector<ForceModel> models_{};
};

/// The declarations of all models, against which a protocol is checked.
std::vector<ModelDeclaration> declarations_of(const ModelRegistry& models);

/// Texture and friction taken out of one stimulus: the same model as a plain plate, its amplitude
/// parameter and its Material's friction zero. The texture force is the difference to it.
RendererInputs without_texture(const ModelDeclaration& declaration, const RendererInputs& inputs);

}  // namespace asperity
