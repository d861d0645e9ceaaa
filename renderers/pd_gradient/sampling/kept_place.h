// Declares the heights of both bodies around a contact, and which requests they can answer.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"

namespace asperity {

constexpr int rounded_up(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

/// The shape of all lattices of one window size. A lattice has the window in its middle, with axes u, v and n.
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

KeptLattice kept_lattice(const SamplingGrid& window, const MaximumLaw& law);

struct BodyHeights {
  std::vector<float> height_m{};
  std::vector<float> most_m{};
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
  int covered = 0;
  int folded = 0;
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

/// nullopt for a place of other bodies, or one that is too far from the current poses. Does not read triangles. Real-time:
/// does not allocate, lock or throw.
std::optional<PlaceFit> fit_of(const KeptPlace& place, const KeptLattice& lattice,
                               const PackedPatch& a, const PackedPatch& b,
                               const ContactFrame& frame) noexcept;

/// The positions in A's heights for the window whose first sample is at (column, row) of B's lattice, with A turned
/// about the window's middle by `turn_rad`. In cells.
KeptPlaces places_in_a(const Pose& X_LM, const KeptLattice& lattice, const glm::dvec2& first,
                       double turn_rad) noexcept;

/// A's heights are measured against n: a point at (x, y, −a) is now at a' against n.
KeptLift lift_of_a(const Pose& X_LM, const KeptLattice& lattice) noexcept;

}  // namespace asperity
