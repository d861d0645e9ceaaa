// Declares the heights of both bodies around a contact, and which requests they can answer.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"

namespace asperity {

constexpr int rounded_up(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

/// The shape of all lattices of one window size. A lattice has the window in its middle, with axes u, v and n. Lengths of
/// cells and samples are in cells, others in metres.
struct KeptLattice {
  SamplingGrid window{};
  SamplingGrid grid{};  ///< the window and `margin` samples around it
  int margin = 0;
  int stride = 0;  ///< floats from one row to the next
  int step_cells =
      0;  ///< around a sample: of the differences, or of the slopes of the smooth maximum
  int span_of_a = 0;  ///< columns of a bound of A's heights
  DifferenceSteps steps{};
  double most_away_m = 0.0;  ///< of a request from a lattice's middle
};

/// The lattice of a window with room for the motion within which its heights are used (fit_of).
KeptLattice kept_lattice(const SamplingGrid& window, const MaximumLaw& law);

struct BodyHeights {
  std::vector<float> height_m{};  ///< outwards, along the lattice's n for B and against it for A
  std::vector<float> most_m{};    ///< bounds of them (KeptHeights)
};

/// The kept heights of both bodies around one contact.
struct KeptPlace {
  bool is_whole = false;
  const PackedSurface* surface_a = nullptr;
  const PackedSurface* surface_b = nullptr;
  Pose X_AL{};  ///< of the lattice: axes u, v, n and the middle
  Pose X_BL{};
  double half_height_m = 0.0;  ///< of the box by which its triangles were selected
  double leaning_a = 0.0;      ///< the cosines of the patches
  double leaning_b = 0.0;
  BodyHeights a{};
  BodyHeights b{};
  int covered = 0;        ///< samples of the window in the middle that both bodies cover
  int folded = 0;         ///< samples of the lattice with several sheets of a body
  int deepest_block = 0;  ///< in the last result
  std::uint64_t last_used = 0;
};

/// The bytes of a place's heights, and a place with room for them.
std::size_t bytes_of_place(const KeptLattice& lattice) noexcept;
KeptPlace empty_place(const KeptLattice& lattice);

/// Heights as the loops read and write them.
KeptHeights kept_a(KeptPlace& place, const KeptLattice& lattice) noexcept;
KeptHeights kept_b(KeptPlace& place, const KeptLattice& lattice) noexcept;

/// The suitability of kept heights for a request.
struct PlaceFit {
  double strain = 0.0;  ///< 1: at the limits of motion
  Pose X_WL{};          ///< by B
  Pose X_LM{};          ///< M: the same lattice by A, which has moved relative to B
  int column = 0;       ///< of the window's first sample in B's lattice
  int row = 0;
};

/// nullopt for a place of other bodies, or one beyond the limits of motion: a quarter of the window along it, 0.03 rad of
/// tilt, 0.13 rad of rotation about n minus the step of the differences, 0.06 rad between the requested n and the kept one,
/// a change of 0.05 of the cosines from which faces sink (PackedPatch::leaning_cosine), and 0.75 of its half height for
/// either end of the box in which triangles are searched (PackedPatch::half_height_m, the same for both): what was outside
/// the box is not in the heights. Does not read triangles.
///
/// Real-time: as all functions below, does not allocate, lock or throw.
std::optional<PlaceFit> fit_of(const KeptPlace& place, const KeptLattice& lattice,
                               const PackedPatch& a, const PackedPatch& b,
                               const ContactFrame& frame) noexcept;

/// The positions in A's heights for the window whose first sample is at (column, row) of B's lattice, with A turned
/// about the window's middle by `turn_rad`. In cells.
KeptPositions places_in_a(const Pose& X_LM, const KeptLattice& lattice, const glm::dvec2& first,
                          double turn_rad) noexcept;

/// A's heights are measured against n: a point at (x, y, −a) is now at a' against n.
KeptLift lift_of_a(const Pose& X_LM, const KeptLattice& lattice) noexcept;

}  // namespace asperity
