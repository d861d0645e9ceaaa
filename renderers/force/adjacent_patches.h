// Declares a renderer of several surfaces as patches of one workspace.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderers/force/border_wall.h"
#include "renderers/force/force_model.h"
#include "renderers/force/surface_contact.h"

namespace asperity {

/// Presentation::id of surfaces side by side, and in the records that of the flat surface between them; those of the
/// surfaces are 1, 2, …
inline constexpr std::uint64_t kSideBySide = 1000;

/// A surface, and its patch of a workspace: `inputs.patch`.
struct AdjacentPatch {
  const ForceModel* model = nullptr;
  RendererInputs inputs{};
};

/// The inputs of a surface that continues beyond the border of its patch without a change of its force. Its texture has
/// the same place in the workspace.
RendererInputs without_border(RendererInputs inputs);

/// Renders the surfaces of patches that lie side by side on a flat surface.
///
/// Model: F = g(p)·[Σᵢ wᵢ(p)·Fᵢ + (1 − Σᵢ wᵢ(p))·F₀], the penetration in the same way without g. Fᵢ is the force of
/// patch i without a border, F₀ that of a flat surface of `material`, and g the border of the workspace; a wall at this
/// border (border_wall.h) belongs to the contact with all surfaces together. Of each friction
/// parameter the flat surface has the value that all patches share, otherwise the default, so that it does not depend on
/// the order of the patches. The weight wᵢ is 1 inside patch i, at a distance of at least `blend_m` from its sides, and decreases to 0 at the sides as a smoothstep; it stays 1 at a
/// side on the border of the workspace, and beyond. The patches must not overlap, so that at most one weight is above 0.
///
/// Every patch has a separate renderer. It is reset when the probe enters the patch, and called while its weight is above
/// 0. RenderedTick::part is the number of that patch, from 1, and 0 elsewhere.
///
/// Friction of one law continues from one surface to the next: the patch takes over the contact of the flat surface where
/// the probe enters the patch, and the flat surface that of the patch where the weight of the patch falls below 1. A
/// contact between surfaces of different laws starts over.
///
/// Step: while the probe crosses a side with speed v, the blend changes the force by at most 1.5·|Fᵢ − F₀|·v·T/blend_m
/// in a tick of T: 7 mN for |Fᵢ − F₀| = 50 mN, v = 0.2 m/s, T = 1 ms and blend_m = 2 mm.
///
/// Units and frame: as ForceRenderer; patches and workspace in the device's frame, in one plane.
///
/// Errors: std::invalid_argument where there is no patch, for a blend that is not positive or wider than half a patch, for
/// patches that overlap, extend beyond the workspace or lie in another plane, and for inputs that a model refuses.
///
/// Real-time: as ForceRenderer.
class AdjacentPatches final : public ForceRenderer {
 public:
  AdjacentPatches(std::span<const AdjacentPatch> patches, const SurfacePatch& workspace,
                  const Material& material, double blend_m);

  void reset(const ProbeState& first) noexcept override;
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override;

  /// The renderer of a patch, by its index, for ForceRenderer::limits.
  const ForceRenderer& renderer_of(std::size_t patch) const { return *patches_.at(patch).renderer; }

 private:
  struct Patch {
    std::unique_ptr<ForceRenderer> renderer{};
    glm::dvec2 lowest_m{0.0};  ///< corner, device frame
    glm::dvec2 highest_m{0.0};
    glm::dvec2 blends_below{0.0};  ///< 1 for a side that blends, 0 for one on the border, by axis
    glm::dvec2 blends_above{0.0};
  };

  double weight_of(const Patch& patch, const glm::dvec3& position_m) const noexcept;

  std::vector<Patch> patches_{};
  SurfaceContact flat_;
  BorderWall wall_{};
  double blend_m_ = 0.0;
  std::size_t entered_ = 0;  ///< the number of the patch that was called in the last tick; 0: none
  bool flat_has_weight_ = true;  ///< in the last tick
};

}  // namespace asperity
