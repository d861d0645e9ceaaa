// Declares a single stroke of the offline roughness experiment: a model, a tip, a hand, and a texture with a given
// spacing.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "renderers/force/force_model.h"
#include "renderers/offline/drag.h"
#include "renderers/offline/offset_surface.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// A texture with a variable spacing: a synthetic surface with the parameter `spacing_m`, or a relief that is stretched
/// along the surface, with unchanged heights, until its dominant wavelength equals the spacing.
struct SpacedTexture {
  std::string kind = "sinusoid";                ///< of synthetic_surface.h
  ParameterValues values{};                     ///< without the spacing
  std::uint64_t seed = 1;                       ///< of a dithered lattice
  std::shared_ptr<const HeightField> relief{};  ///< instead of a kind
};

/// A texture with a fixed spacing, laid out for a stroke along x.
struct TextureAtSpacing {
  std::shared_ptr<const HeightField> field{};
  Tiling tiling = Tiling::repeat;
  double spacing_m = 0.0;
  double repeats_after_m = 0.0;
  double line_m = 0.0;  ///< y of the stroke on the field
};

/// For a kind: eight spacings (at least sixteen for cones, which are dithered) that repeat without a seam, with a sample every
/// 64th of a spacing, or every 30 µm if that is less, up to 2048 samples a side. The stroke passes over the middle; for
/// cones over the tops of a row, except where they are shifted aside, or, with an `angle_rad`, over one row after the other.
///
/// Errors: std::invalid_argument for an unknown kind or one without a spacing, values that its declaration does not
/// permit, cones whose `angle_rad` does not have a ratio of whole numbers up to 64 as its tangent, and a relief without a
/// dominant wavelength.
TextureAtSpacing texture_at_spacing(const SpacedTexture& texture, double spacing_m);

/// The texture repeated along x until it is at least kRecordedWidth_m wide: the relief from which the files of a model are
/// computed (ForceModel::files_of_relief).
HeightField recorded_relief(const TextureAtSpacing& texture);
inline constexpr double kRecordedWidth_m = 0.05;

/// A tool that the hand turns to and fro about an axis normal to the surface, at a distance from its tip.
struct Turning {
  double amplitude_rad = 0.2;  ///< to either side; at most π
  double radius_m = 0.02;      ///< of the arc of the tip
};

/// The parameters of a stroke, without the texture.
struct RoughnessStroke {
  const ForceModel* model = nullptr;
  ParameterValues parameters{};  ///< as given; missing ones are chosen by `dragged`
  Material material{.stiffness_N_per_m = 1000.0, .friction = 0.0};
  RigidTip tip{};                              ///< of a model of bodies
  std::shared_ptr<const TexturedMesh> tool{};  ///< instead of the tip
  HandModel hand{};
  DragMode mode = DragMode::constant_height;
  double force_N = 0.5;
  double speed_m_per_s = 0.1;
  decltype(RendererInputs::assets) assets{};  ///< the given files of the model
  decltype(RendererInputs::asset_names) asset_names{};
  std::uint64_t seed = 1;  ///< of a model that draws random numbers
  /// Instead of a straight stroke. `speed_m_per_s` is then the greatest speed of the tip.
  std::optional<Turning> turning{};
  /// Of a point model: the body that is stroked, instead of a plane (BodyGuide).
  std::shared_ptr<const BodySurface> body{};
};

/// Simulates the stroke over the texture.
///
/// A model of a point is rendered as in sessions, with the texture as height field. A model that derives its parameters
/// from a sample (`suggested_by`) derives them from the texture, and `wavelength_m` is the spacing. Files of the model that
/// are not given are those that the texture suggests (`files_of_relief` of recorded_relief). For a model of
/// bodies, a tip of a simple form is rendered as an offset surface (make_tip_renderer), and a tool's mesh as in
/// sessions with `coupling = none`, on a plate with the texture that is as long as the stroke. Their `step_m`, unless
/// given, is a fortieth of the spacing and at most 0.1 mm: a longer step removes fine textures.
///
/// A turning tool starts in the middle of its arc, on the line of the texture; the directions of a model with bodies are
/// those of the surface, and a tip of a simple form requires a texture that is constant across the line. On a body the stroke
/// follows its upper side, from one end to the other.
///
/// nullopt if stopped by `stop`. Errors: std::invalid_argument in the cases of the model, of the guide and of `drag`, for an
/// amplitude of turning that is not above 0 and at most π, for a body and a model of bodies, and for a body and turning.
std::optional<DragResult> dragged(const RoughnessStroke& stroke, const TextureAtSpacing& texture,
                                  const std::stop_token& stop = {});

/// The inputs of the renderer of a stroke; for a model with bodies without the bodies.
RendererInputs stroked_inputs(const RoughnessStroke& stroke, const TextureAtSpacing& texture);

/// The renderer that `dragged` uses, for an inspection of its forces.
std::unique_ptr<ForceRenderer> stroked_renderer(const RoughnessStroke& stroke,
                                                const TextureAtSpacing& texture);

/// The quantities that can be varied.
enum class VariedQuantity { probe_diameter, applied_force, exploratory_speed, turning };
const char* text_of(VariedQuantity varied) noexcept;
/// Whether a model's texture can depend on the quantity, by its declaration and the given parameters. Speed and the amplitude
/// of turning always have an effect: they determine the temporal frequency of the texture and the part of it that is touched.
///
/// Errors: std::invalid_argument for parameters that the model does not have.
bool depends_on(const ForceModel& model, const ParameterValues& given, VariedQuantity varied);

}  // namespace asperity
