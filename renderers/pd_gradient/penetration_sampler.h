// The fast evaluation of a contact: each surface is sampled once, all configurations at a time.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderers/pd_gradient/instruction_set.h"
#include "renderers/pd_gradient/packed_surface.h"
#include "renderers/pd_gradient/penetration.h"

namespace asperity {

/// The triangles of a packed body that take part in a contact.
struct PackedPatch {
  const PackedSurface& surface;
  std::span<const std::uint32_t> triangles{};  ///< each once, all of them the surface's
  Pose pose{};
};

struct SamplerSettings {
  SamplingGrid grid{};
  /// The declared step, in cells of the grid: step_m = step_cells · spacing.
  int step_cells = 1;
  /// Of the larger of the patches that will come.
  std::size_t most_triangles = 0;
  InstructionSet instructions = InstructionSet::sse2;
};

/// δ and ∇δ of the hard maximum, as reference_penetration finds them, for little of its price.
///
/// Only the motion of A relative to B matters, and it is small, so that what moves is not sampled
/// anew:
///
///   ± u, ± v      A's samples, step_cells further on: exact, with an apron around A's window
///   ± θu, ± θv    h_A ± θ·v and h_A ∓ θ·u: the maxima of rows and of columns are enough. Tilting also
///                 moves what stands at height z along by θ·z, which adds −z·∂δ/∂v and z·∂δ/∂u with z
///                 of the deepest point
///   ± θn          A's samples between four, to first order in θ
///
/// Against the reference on the same grid and step, from rounding: δ to 10 nm, ∂δ/∂u and ∂δ/∂v to
/// 10⁻⁴. To first order only: the levers of tilts, to 2 % of their RMS, and that of turning, where
/// interpolation shaves peaks, to 5 to 10 % at 8 samples a wavelength; neither is further from the
/// truth than the reference is (bench/penetration_depth --accuracy). Samples at the border of what a
/// surface covers may fall to either side. `folded` counts the apron, and every sheet but the first.
///
/// Every instruction set gives the same bits.
///
/// Errors: the constructor throws std::invalid_argument for a grid that is none, a number of samples
/// that is no multiple of 32·step_cells, and a step below 1 or above 8 cells.
///
/// Real-time: `evaluate` does not allocate, lock or throw; it takes microseconds
/// (bench/penetration_depth). One object serves one thread.
class PenetrationSampler final {
 public:
  explicit PenetrationSampler(const SamplerSettings& settings);

  /// Nothing where no sample is covered by both, the surfaces are apart by more than half a metre, or
  /// a pose is not finite.
  std::optional<Penetration> evaluate(const PackedPatch& a, const PackedPatch& b,
                                      const ContactFrame& frame) noexcept;

  const SamplingGrid& grid() const noexcept { return grid_; }
  double step_m() const noexcept { return steps_.along_m; }

 private:
  // Heights of one body over the window.
  struct Field {
    std::vector<float> height_m{};
    HeightSamples samples{};
  };

  Field field_with_apron(int apron) const;
  void prepare_turn();
  int sample(const PackedPatch& patch, const ContactFrame& frame, double outwards, Field& field);
  bool at_border(int row, int column) const noexcept;
  float height_m(const Field& field, int row, int column) const noexcept;

  SamplingGrid grid_{};
  int step_cells_ = 1;
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
