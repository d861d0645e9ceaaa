// Declares the reference evaluation of a contact, in double precision: slow, and the standard for the faster ones.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// The orientation of the faces that face the other body.
enum class Facing { along_n, against_n };  // of B, of A

/// ∂h/∂q at one position of the window for a motion of the body in q = u, v, θu, θv, θn.
using HeightRates = std::array<double, 5>;

/// One body's surface over the window, row by row (rows along v).
struct SampledSurface {
  std::vector<double> height_m{};       ///< along n from the frame's origin; 0 where not covered
  std::vector<std::uint8_t> covered{};  ///< 1 where there is a surface
  std::vector<HeightRates> rates{};     ///< empty unless requested
  int folded = 0;  ///< samples that several sheets cover: not a height field along n there
};

/// Samples the faces of a patch whose normals are along (or against) n. A sample's height is that of the displaced
/// point whose undisplaced point lies at the sample:
///
///   h = n·(Σ bᵢ pᵢ + d·Σ bᵢ nᵢ − origin)
///
/// The component of a displacement perpendicular to n is neglected, as in the source. The error is at most d times the
/// sine of the angle between normal and n, times the texture's slope. Of overlapping sheets the outermost is used. A
/// sample on a shared edge belongs to both faces, so that there are no gaps.
///
/// Throws std::invalid_argument in the cases of require_sound.
SampledSurface sample_surface(const ContactPatch& patch, const ContactFrame& frame,
                              const SamplingGrid& grid, Facing facing);
SampledSurface sample_surface_and_rates(const ContactPatch& patch, const ContactFrame& frame,
                                        const SamplingGrid& grid, Facing facing);

/// Computes δ and ∇δ of A on B. Hard maximum: A is moved and sampled anew for each of the ten differences. If one of
/// the two configurations has no overlap, the difference is one-sided; if both have none, it is 0. Smooth maximum: the
/// exact derivative of the sum over samples, with constant D.
///
/// nullopt if no sample is covered by both. Throws std::invalid_argument in the cases of require_sound, and for a step
/// or τ that is not positive.
std::optional<Penetration> reference_penetration(const ContactPatch& a, const ContactPatch& b,
                                                 const ContactFrame& frame,
                                                 const SamplingGrid& grid, const MaximumLaw& law);

}  // namespace asperity
