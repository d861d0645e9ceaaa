// Implements the test of near pairs and the storage of its verdicts.

#include "renderers/pd_gradient/geometry/near_pairs.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/geometric.hpp>

namespace asperity {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr std::size_t kLanes = kClusterSize;
// Added to each motion: a subtraction from a slack of at most 30 mm is rounded by less.
constexpr double kRounding_m = 1e-9;
constexpr float kMostSlack_m = 0.03F;

std::uint32_t bit_of(std::size_t lane) noexcept { return std::uint32_t{1} << lane; }

/// Whether there is a gap between the projections on `axis`.
bool separates(const glm::dvec3& axis, const Corners& a, const Corners& b) noexcept {
  const auto range = [&axis](const Corners& corners) {
    const double first = glm::dot(axis, corners[0]);
    const double second = glm::dot(axis, corners[1]);
    const double third = glm::dot(axis, corners[2]);
    return std::pair(std::min({first, second, third}), std::max({first, second, third}));
  };
  const auto [a_low, a_high] = range(a);
  const auto [b_low, b_high] = range(b);
  return a_high < b_low || b_high < a_low;
}

}  // namespace

bool triangles_intersect(const Corners& a, const Corners& b) noexcept {
  // Relative to a corner of A: the products below then preserve the small differences of two near triangles.
  const Corners p{glm::dvec3(0.0), a[1] - a[0], a[2] - a[0]};
  const Corners q{b[0] - a[0], b[1] - a[0], b[2] - a[0]};
  const Corners p_edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const Corners q_edges{q[1] - q[0], q[2] - q[1], q[0] - q[2]};
  const glm::dvec3 p_normal = glm::cross(p_edges[0], p_edges[1]);
  const glm::dvec3 q_normal = glm::cross(q_edges[0], q_edges[1]);
  if (separates(p_normal, p, q) || separates(q_normal, p, q)) return false;
  for (const glm::dvec3& edge : p_edges) {
    for (const glm::dvec3& other : q_edges) {
      if (separates(glm::cross(edge, other), p, q)) return false;
    }
    if (separates(glm::cross(p_normal, edge), p, q)) return false;
  }
  for (const glm::dvec3& edge : q_edges) {
    if (separates(glm::cross(q_normal, edge), p, q)) return false;
  }
  return true;
}

NearPairs::NearPairs(std::size_t most) : pairs_(most), verdicts_((most + kLanes - 1) / kLanes) {}

void NearPairs::begin(const Pose& X_BA, double margin_m) noexcept {
  X_BA_ = X_BA;
  margin_m_ = margin_m;
  way_since_begin_m_ = 0.0;
  way_m_ = 0.0;
  count_ = 0;
  tested_count_ = 0;
}

void NearPairs::move(double way_m) noexcept {
  way_m_ += way_m;
  way_since_begin_m_ += way_m;
}

// Adds a pair to those that are tested together.
void NearPairs::put(const MeshPair& meshes, const TrianglePair& pair, std::size_t place) noexcept {
  const std::size_t lane = tested_count_++;
  const auto& corners_a = meshes.a.corners_from_centre_m(pair.a);
  const auto& corners_b = meshes.b.corners_from_centre_m(pair.b);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      tested_.a[corner][axis][lane] = corners_a[corner][axis];
      tested_.b[corner][axis][lane] = corners_b[corner][axis];
    }
  }
  tested_pairs_[lane] = pair;
  tested_places_[lane] = place;
}

// Pairs that are too close to touching for single precision are decided in double precision.
void NearPairs::judge(const MeshPair& meshes, const Pose& X_BA, PairVerdicts& verdicts) noexcept {
  meshes.loops.judge_pairs(tested_, cluster_pose(meshes.a, meshes.b, X_BA), verdicts);
  for (std::size_t i = 0; i < tested_count_; ++i) {
    if ((verdicts.together & verdicts.unsure & bit_of(i)) == 0) continue;
    Corners corners_m = meshes.a.corners_m(tested_pairs_[i].a);
    for (glm::dvec3& corner_m : corners_m) corner_m = X_BA * corner_m;
    if (!triangles_intersect(corners_m, meshes.b.corners_m(tested_pairs_[i].b))) {
      verdicts.together &= ~bit_of(i);
    }
  }
}

// Returns whether the verdict has changed.
bool NearPairs::set(std::size_t place, const PairVerdicts& verdicts, std::size_t lane) noexcept {
  Verdicts& own = verdicts_[place / kLanes];
  const std::uint32_t before = own.together;
  const std::uint32_t bit = bit_of(place % kLanes);
  own.together = (verdicts.together & bit_of(lane)) != 0 ? before | bit : before & ~bit;
  own.slack_m[place % kLanes] = std::min(verdicts.slack_m[lane], kMostSlack_m);
  return own.together != before;
}

void NearPairs::add(const MeshPair& meshes, const TrianglePair& pair) noexcept {
  put(meshes, pair, 0);
  if (tested_count_ == kLanes) add_last(meshes);
}

void NearPairs::add_last(const MeshPair& meshes) noexcept {
  if (tested_count_ == 0) return;
  PairVerdicts verdicts;
  judge(meshes, X_BA_, verdicts);
  const auto margin_m = static_cast<float>(margin_m_);
  const auto way_m = static_cast<float>(way_since_begin_m_ + kRounding_m);
  for (std::size_t i = 0; i < tested_count_; ++i) {
    const bool is_together = (verdicts.together & bit_of(i)) != 0;
    if (!is_together && (margin_m_ == 0.0 || verdicts.slack_m[i] > margin_m)) continue;
    const std::size_t place = count_++;
    if (is_overfull()) continue;
    pairs_[place] = tested_pairs_[i];
    verdicts.slack_m[i] -= way_m;
    set(place, verdicts, i);
  }
  tested_count_ = 0;
}

bool NearPairs::renew(const MeshPair& meshes, const Pose& X_BA) noexcept {
  const auto way_m = static_cast<float>(way_m_ + kRounding_m);
  way_m_ = 0.0;
  bool has_changed = false;
  const auto judge_all = [&] {
    PairVerdicts verdicts;
    judge(meshes, X_BA, verdicts);
    for (std::size_t i = 0; i < tested_count_; ++i) {
      has_changed = set(tested_places_[i], verdicts, i) || has_changed;
    }
    tested_count_ = 0;
  };
  const std::size_t count = std::min(count_, pairs_.size());
  for (std::size_t first = 0; first < count; first += kLanes) {
    std::uint32_t used = meshes.loops.use_slack(verdicts_[first / kLanes].slack_m, way_m);
    if (count - first < kLanes) used &= bit_of(count - first) - 1;
    for (; used != 0; used &= used - 1) {
      const std::size_t place = first + static_cast<std::size_t>(std::countr_zero(used));
      put(meshes, pairs_[place], place);
      if (tested_count_ == kLanes) judge_all();
    }
  }
  if (tested_count_ > 0) judge_all();
  return has_changed;
}

std::size_t NearPairs::intersecting(std::span<TrianglePair> to) const noexcept {
  std::size_t found = 0;
  const std::size_t count = std::min(count_, pairs_.size());
  for (std::size_t first = 0; first < count; first += kLanes) {
    std::uint32_t together = verdicts_[first / kLanes].together;
    if (count - first < kLanes) together &= bit_of(count - first) - 1;
    for (; together != 0; together &= together - 1) {
      if (found < to.size()) {
        to[found] = pairs_[first + static_cast<std::size_t>(std::countr_zero(together))];
      }
      ++found;
    }
  }
  return found;
}

}  // namespace asperity
