// The offline roughness experiment's single stroke: a model, a tip, a hand, and a texture of some
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

/// A texture whose spacing can be chosen: a synthetic surface that has a `spacing_m`, or a relief of
/// anyone's that is stretched along the surface, heights kept, until its dominant wavelength is it.
struct SpacedTexture {
  std::string kind = "sinusoid";                ///< of synthetic_surface.h
  ParameterValues values{};                     ///< without the spacing
  std::uint64_t seed = 1;                       ///< of a dithered lattice
  std::shared_ptr<const HeightField> relief{};  ///< instead of a kind
};

/// One of them, laid out for a stroke along x.
struct TextureAtSpacing {
  std::shared_ptr<const HeightField> field{};
  Tiling tiling = Tiling::repeat;
  double spacing_m = 0.0;
  double repeats_after_m = 0.0;
  double line_m = 0.0;  ///< y of the stroke on the field
};

/// Of a kind: eight spacings (sixteen of cones, which are dithered) that repeat without a seam, with a
/// sample every 64th of a spacing, or every 30 µm where that is less, up to 2048 a side. The stroke goes
/// over the middle; of cones over the tops of a row, as far as they are not shifted aside.
///
/// Errors: std::invalid_argument for a kind that is not there or has no spacing, values that its
/// declaration refuses, a relief without a dominant wavelength.
TextureAtSpacing texture_at_spacing(const SpacedTexture& texture, double spacing_m);

/// What is dragged and how, but for the texture.
struct RoughnessStroke {
  const ForceModel* model = nullptr;
  ParameterValues parameters{};  ///< as given; what is left out is chosen as below
  Material material{.stiffness_N_per_m = 1000.0, .friction = 0.0};
  RigidTip tip{};                              ///< of a model of bodies
  std::shared_ptr<const TexturedMesh> tool{};  ///< instead of the tip
  HandModel hand{};
  DragMode mode = DragMode::constant_height;
  double force_N = 0.5;
  double speed_m_per_s = 0.1;
  std::uint64_t seed = 1;  ///< of a model that draws random numbers
};

/// Drags it over the texture.
///
/// A model of a point is rendered as in sessions, over the texture as height field; a model that takes
/// its parameters from a sample (`suggested_by`) takes them from the texture, and `wavelength_m` is the
/// spacing itself. A model of bodies has a tip of a simple form as an offset surface
/// (make_tip_renderer), a tool's mesh as in sessions with `coupling = none`, on a plate with the
/// texture that is as long as the stroke. Their `step_m`, unless given, is a fortieth of the spacing and
/// at most 0.1 mm: a longer one takes the fine textures away.
///
/// Nothing when it was asked to stop. Errors: std::invalid_argument as the model and `drag` have them.
std::optional<DragResult> dragged(const RoughnessStroke& stroke, const TextureAtSpacing& texture,
                                  const std::stop_token& stop = {});

/// The renderer that `dragged` drags, for whoever asks what its forces are.
std::unique_ptr<ForceRenderer> stroked_renderer(const RoughnessStroke& stroke,
                                                const TextureAtSpacing& texture);

/// What can be varied.
enum class VariedQuantity { probe_diameter, applied_force, exploratory_speed };
const char* text_of(VariedQuantity varied) noexcept;
/// Whether a model's texture can depend on it, by its declaration. Speed is never without effect: it
/// says how often a texture comes by.
bool depends_on(const ModelDeclaration& declaration, VariedQuantity varied) noexcept;

}  // namespace asperity
