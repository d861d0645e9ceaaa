// Declares the arrangement of a trial: how its surfaces are presented to the hand.

#pragma once

#include <optional>
#include <vector>

namespace asperity {

/// How the surfaces of a trial are presented before its first question.
struct Arrangement {
  enum class Surfaces {
    sequential,    ///< one after the other, in the order of the trial
    side_by_side,  ///< all at once, as patches of one workspace
    on_request,    ///< one at a time, in any order that the participant chooses
  };
  /// A time drawn uniformly; of a fixed time both limits are equal.
  struct Interval {
    double shortest_s = 0.0;
    double longest_s = 0.0;
  };
  enum class Axis { x, y };

  Surfaces surfaces = Surfaces::sequential;
  /// Visits to each surface before a response is possible. In sequence the surfaces are presented that many times, in
  /// the order of the trial: A B, A B A B, …
  int minimum_visits = 1;
  /// Of each surface, those on request included; absent: no limit.
  std::optional<int> maximum_visits{};
  /// Between the last contact with a surface and the permission to touch the next; absent: in
  /// sequence `Block::pause_between_surfaces_s`, which begins when the surface has been removed, and otherwise no pause.
  std::optional<Interval> interval{};
  /// The end of every visit, the same for all surfaces: after a number of strokes or a contact time. Absent: the
  /// participant ends it, within the limits of the exploration.
  std::optional<int> strokes{};
  std::optional<double> contact_s{};
  /// Side by side: the flat surface between two patches, and the axis along which they lie.
  double gap_m = 0.006;
  Axis axis = Axis::x;
  /// Whether the place on the texture at which a surface begins (SurfacePatch::texture_origin_m) is drawn for every
  /// presentation.
  bool draws_phase = false;

  /// Whether surfaces can be felt once the question is asked.
  bool allows_revisits() const noexcept {
    switch (surfaces) {
      case Surfaces::sequential:
        return !maximum_visits || *maximum_visits > minimum_visits;
      case Surfaces::side_by_side:
        return false;
      case Surfaces::on_request:
        return true;
    }
    return false;
  }
  bool may_visit(int earlier_visits) const noexcept {
    return !maximum_visits || earlier_visits < *maximum_visits;
  }
};

/// Irrelevant quantities that vary at random between presentations, so that the task cannot be solved by them: each
/// presentation has one of the levels of each list, all equally probable and independent. An empty list: no variation.
struct Roving {
  std::vector<double> stiffness_N_per_m{};  ///< of the material
  std::vector<double> friction{};           ///< of the material
  std::vector<double> raised_m{};  ///< height of the surface's plane above that of the workspace

  bool is_empty() const noexcept {
    return stiffness_N_per_m.empty() && friction.empty() && raised_m.empty();
  }
};

/// The width inside a patch over which its force blends into that of the flat surface.
inline constexpr double kBlend_m = 0.002;

}  // namespace asperity
