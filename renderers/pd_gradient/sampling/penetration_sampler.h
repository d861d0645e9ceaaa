// Declares the fast evaluation of a contact: each surface is sampled once for all configurations.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/sampling/packed_surface.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// The triangles of a packed body that take part in a contact.
struct PackedPatch {
  const PackedSurface& surface;
  std::span<const std::uint32_t> triangles{};  ///< of the surface, without duplicates
  Pose pose{};
  /// Parts of the surface at a greater distance from the frame's origin along n may be left out; by default, the patch
  /// contains everything that can be sampled.
  double half_height_m = 0.2;
  /// The cosine between face normal and n from which faces sink and are finally left out (sunk_m). 0: none.
  double leaning_cosine = 0.0;
};

struct SamplerSettings {
  SamplingGrid grid{};
  /// The step of the hard maximum has to be a whole number of cells of the grid.
  MaximumLaw law{};
  /// The greatest number of triangles of a patch.
  std::size_t most_triangles = 0;
  InstructionSet instructions = InstructionSet::sse2;
};

/// Computes δ and ∇δ as reference_penetration does, at a small fraction of its cost.
///
/// Only the motion of A relative to B matters, and it is small, so that the configurations are derived from one
/// sampling. Hard maximum:
///
///   ± u, ± v      A's samples, shifted by some cells: exact, with an apron around A's window
///   ± θu, ± θv    h_A ± θ·v and h_A ∓ θ·u: the maxima of rows and of columns are sufficient. Tilting
///                 also shifts a point at height z by θ·z, which adds −z·∂δ/∂v and z·∂δ/∂u with z of
///                 the deepest point
///   ± θn          A's samples, interpolated between four, to first order in θ
///
/// Smooth maximum: weighted means over the samples, with slopes of A from five samples in each direction. Samples with
/// a weight below 2⁻³⁰ of the deepest one's are left out.
///
/// Errors relative to the reference on the same grid, from rounding: δ to 10 nm, ∂δ/∂u and ∂δ/∂v of the hard maximum to
/// 10⁻⁴. The following are of first order only: the levers of tilts, to 3 % of their RMS, and that of turning, where
/// interpolation lowers peaks, to 5 to 10 % at 8 samples per wavelength. The slopes of the smooth maximum are those
/// through the samples, not those between two texels. Neither is further from the true value than the reference is
/// (bench/penetration_depth --accuracy). Samples at the border of a surface may count as covered or not. `folded`
/// includes the apron, and every sheet except the first.
///
/// All instruction sets give the same bits.
///
/// The surfaces have to lie within approximately 0.2 m of the frame's origin along n; a missing surface is
/// distinguished from a distant one by its height.
///
/// Errors: the constructor throws std::invalid_argument for an invalid grid; a number of samples that is not a multiple
/// of 32 times the step in cells (of 16 for the smooth maximum); a step that is not 1 to 8 whole cells; τ or S that is
/// not positive.
///
/// Real-time: `evaluate` does not allocate, lock or throw; it takes microseconds (bench/penetration_depth). An object
/// may be used by one thread only.
class PenetrationSampler final {
 public:
  explicit PenetrationSampler(const SamplerSettings& settings);

  /// nullopt if no sample is covered by both, or if a pose is not finite.
  std::optional<Penetration> evaluate(const PackedPatch& a, const PackedPatch& b,
                                      const ContactFrame& frame) noexcept;

  const SamplingGrid& grid() const noexcept { return grid_; }
  /// Of the heights and the triangles of a window.
  std::size_t bytes() const noexcept;

 private:
  // The heights of one body over the window.
  struct Field {
    std::vector<float> height_m{};
    FieldSamples samples{};
  };

  Field field_with_apron(int apron) const;
  void prepare_steps(const HardMaximum& law);
  void prepare_turn();
  std::optional<Penetration> hard_maximum() noexcept;
  std::optional<Penetration> smooth_maximum(const SmoothMaximum& law) noexcept;
  int sample(const PackedPatch& patch, const ContactFrame& frame, double outwards, Field& field);
  static FieldSamples samples_of(Field& field) noexcept;
  glm::dvec3 deepest_m(int row, int column) const noexcept;
  bool at_border(int row, int column) const noexcept;
  float height_m(const Field& field, int row, int column) const noexcept;

  SamplingGrid grid_{};
  MaximumLaw law_{};
  int step_cells_ = 0;  // of the hard maximum
  DifferenceSteps steps_{};
  const SampleLoops* loops_ = nullptr;
  Field a_{};
  Field b_{};
  std::vector<SampledTriangle> triangles_{};
  std::vector<float> room_{};
  std::vector<float> row_most_m_{};
  std::vector<float> column_most_m_{};
  std::vector<std::int32_t> turn_cells_{};  // forth, then back
  std::vector<float> turn_weights_{};       // forth, then back
};

}  // namespace asperity
