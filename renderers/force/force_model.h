// Declares force models by name and their registry.

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/force/force_renderer.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

class BodySurface;
struct Compute;

/// The inputs from which a model builds one renderer.
struct RendererInputs {
  ParameterValues parameters{};  ///< as given; the registry completes and checks them
  Material material{};
  SurfacePatch patch{};
  /// Shared ownership: presentations of one texture end in any order.
  std::shared_ptr<const HeightField> height_field{};
  /// Shared ownership for the same reason. `tool` is the mesh that the hand holds: its frame has its origin at the tip
  /// and turns with the device. `surface` is the mesh that is touched: its frame has its origin at `patch.centre_m`.
  std::shared_ptr<const TexturedMesh> tool{};
  std::shared_ptr<const TexturedMesh> surface{};
  /// Of a point model: the body on which it acts, instead of the plane of the patch. The origin of its frame is
  /// `patch.centre_m`. Shared ownership for the same reason.
  std::shared_ptr<const BodySurface> body{};
  /// The content of the model's further files by the role under which the model declares each
  /// (AssetDeclaration), to the byte: the model decodes it, and refuses it if it is not what it should be.
  std::map<std::string, std::shared_ptr<const std::string>, std::less<>> assets{};
  /// The names of these files, by role, for messages. See name_of_asset.
  std::map<std::string, std::string, std::less<>> asset_names{};
  std::uint64_t seed = 0;  ///< of a model that draws random numbers
};

/// The highest frequency of a texture: of one that depends on the place, in waves per metre of the hand's path (the
/// patch's `motion_scale` included); of one that depends on the time, in hertz.
struct TextureBand {
  double per_m = 0.0;
  double time_Hz = 0.0;
};

/// The file from which a model was loaded.
struct PluginOrigin {
  std::string file{};    ///< its name without a folder
  std::string sha256{};  ///< of its content
};

/// Declares a model and makes its renderers.
struct ForceModel {
  ModelDeclaration declaration{};
  /// Takes complete, checked parameters. Throws std::invalid_argument for inputs that contradict each other.
  std::function<std::unique_ptr<ForceRenderer>(const RendererInputs&)> make{};
  /// The parameters that a texture sample suggests, for a model that takes them from the sample's statistics (for
  /// example a sinusoid's amplitude and wavelength). Empty for other models.
  std::function<ParameterValues(const HeightField&, const Material&)> suggested_by{};
  /// The content of the model's files for a relief, by role: what a probe that slides over it without friction would have
  /// recorded. Throws std::invalid_argument for a relief that is too narrow. Empty for a model without files.
  std::function<std::map<std::string, std::string>(const HeightField&)> files_of_relief{};
  /// The parameter values with which the force without friction is conservative: a closed path in contact changes the
  /// hand's energy by zero. An empty set: conservative for all values. nullopt: for no values; a closed path can then
  /// add energy in one direction and remove it in the other.
  std::optional<ParameterValues> conservative_with{};
  /// The parameter values with which the force on a probe that holds still keeps changing, in the same form: an empty set
  /// for all values, nullopt for none. A force that settles within 0.2 s does not move by itself.
  std::optional<ParameterValues> moves_by_itself_with{};
  /// The parameter values with which a model that declares `feels_applied_force = false` depends on the applied force
  /// nevertheless.
  std::optional<ParameterValues> feels_applied_force_with{};
  /// The band of the texture, from complete parameters. It does not include the harmonics of a force that is not
  /// proportional to the heights, nor the side lobes of noise that is held between its steps.
  std::function<TextureBand(const RendererInputs&)> band{};
  /// Where a probe is in the cycle of a grating, in cycles from −½ to ½ with a crest at 0, from complete parameters. Empty for a
  /// model without a cycle.
  std::function<double(const RendererInputs&, const glm::dvec3& position_m)> crest_phase{};
  /// The same as `band` in hertz as a formula of the parameters, with v the speed of the hand on the texture in m/s.
  std::string band_formula{};
  /// Of a model in a plug-in (renderers/plugin/); absent for a built-in model.
  std::optional<PluginOrigin> plugin{};
  /// The device on which its renderers evaluate contacts (computed_on); null for the processor.
  std::shared_ptr<const Compute> compute{};
};

/// The file of a role as messages name it: by its name, or by the role where the file has none.
std::string name_of_asset(const RendererInputs& inputs, const std::string& role);

/// Whether the force without friction is the gradient of a potential with the given parameters (the others have their
/// defaults): whether it is conservative.
bool is_potential(const ForceModel& model, const ParameterValues& given);

/// Whether the force on a probe that holds still keeps changing with the given parameters.
bool moves_by_itself(const ForceModel& model, const ParameterValues& given);

/// Whether the rendered texture depends on how hard the hand presses, with the given parameters.
bool feels_applied_force(const ForceModel& model, const ParameterValues& given);

/// The highest frequency of the texture force for a hand that moves at `speed_m_per_s`. A servo loop of at least twice
/// this rate renders the same force as a faster one. The parameters are completed and checked here.
double band_Hz(const ForceModel& model, const RendererInputs& inputs, double speed_m_per_s);

/// A condition on parameters as text: "always", "never", "with lateral_gradient_gain=1, law=corrected".
std::string condition_text(const std::optional<ParameterValues>& condition);

/// Makes one renderer of a model. The parameters are completed and checked here. A point model acts on the body of the
/// inputs, if there is one (point_on_body.h).
///
/// Errors: std::invalid_argument for a bad parameter, for a height field, a body or a declared asset
/// that is needed and missing, for a body that a model of two bodies cannot have, and for inputs that the model refuses.
std::unique_ptr<ForceRenderer> make_renderer(const ForceModel& model, const RendererInputs& inputs);

/// The registry of force models, in the order in which they were added.
///
/// Errors: `add` throws std::invalid_argument for an id, or the role of an asset, that is taken or not `[a-z][a-z0-9_]*`;
/// `make` for an unknown model, and as `make_renderer` does.
class ModelRegistry final {
 public:
  void add(ForceModel model);
  /// In place of the model with the same id; std::invalid_argument if there is none.
  void replace(ForceModel model);
  const std::vector<ForceModel>& models() const& noexcept { return models_; }
  const std::vector<ForceModel>& models() && = delete;  // a loop over a temporary would dangle
  /// Null if there is no model with this id.
  const ForceModel* find(std::string_view id) const& noexcept;
  const ForceModel* find(std::string_view id) && = delete;
  std::unique_ptr<ForceRenderer> make(std::string_view id, const RendererInputs& inputs) const;

 private:
  std::vector<ForceModel> models_{};
};

/// The band of a model that renders the heights of its height field: the finest wave has two samples.
TextureBand band_of_height_field(const RendererInputs& inputs);
inline constexpr const char* kBandOfHeightField = "v/(2*pitch of the height field)";

/// Adds the files of a model that a relief suggests (ForceModel::files_of_relief), if there are any.
void add_files_of_relief(RendererInputs& inputs, const ForceModel& model, const HeightField& field);

/// The declarations of all models, against which a protocol is checked.
std::vector<ModelDeclaration> declarations_of(const ModelRegistry& models);

/// The inputs of a stimulus without texture and friction: the model's amplitude parameter and the Material's friction
/// are zero, so that the model renders a plain plate. The texture force is the difference between the two.
RendererInputs without_texture(const ModelDeclaration& declaration, const RendererInputs& inputs);

}  // namespace asperity
