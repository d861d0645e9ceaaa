// The plain evaluation of a contact, in double: slow, and what all faster ones are held against.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// Which faces of a body look at the other one.
enum class Facing { along_n, against_n };  // of B, of A

/// ∂h/∂q at one place of the window as the body moves by q = u, v, θu, θv, θn.
using HeightRates = std::array<double, 5>;

/// One body's surface over the window, row after row (rows along v).
struct SampledSurface {
  std::vector<double> height_m{};       ///< along n from the frame's origin; 0 where not covered
  std::vector<std::uint8_t> covered{};  ///< 1 where there is a surface
  std::vector<HeightRates> rates{};     ///< empty unless asked for
  int folded = 0;  ///< samples that more than one sheet covers: no height field along n there
};

/// Samples the faces of a patch that look along (or against) n. A sample's height is that of the
/// displaced point whose undisplaced point stands at the sample:
///
///   h = n·(Σ bᵢ pᵢ + d·Σ bᵢ nᵢ − origin)
///
/// so the part of a displacement across n is left out, as in the source. That costs at most d times
/// the sine between normal and n, times the texture's slope. Where sheets lie over each other the
/// outermost counts. A sample on a shared edge belongs to both faces: there are no cracks.
///
/// Throws std::invalid_argument as require_sound does.
SampledSurface sample_surface(const ContactPatch& patch, const ContactFrame& frame,
                              const SamplingGrid& grid, Facing facing);
SampledSurface sample_surface_and_rates(const ContactPatch& patch, const ContactFrame& frame,
                                        const SamplingGrid& grid, Facing facing);

/// δ and ∇δ of A on B. Hard maximum: A is moved and sampled anew for each of the ten differences; a
/// configuration in which nothing overlaps leaves a one-sided difference, two leave none (0).
/// Smooth maximum: the exact derivative of the sum over samples, while D stays as it is.
///
/// Nothing where no sample is covered by both. Throws std::invalid_argument as require_sound does,
/// and for a step or τ that is not positive.
std::optional<Penetration> reference_penetration(const ContactPatch& a, const ContactPatch& b,
                                                 const ContactFrame& frame,
                                                 const SamplingGrid& grid, const MaximumLaw& law);

}  // namespace asperity
