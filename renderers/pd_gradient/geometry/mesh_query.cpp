// Implements the search for intersecting triangles with clusters of sixteen.

#include "renderers/pd_gradient/geometry/mesh_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace asperity {
namespace {

constexpr std::size_t kLanes = kClusterSize;
// With a wider margin lists are made less often, and contain more pairs that do not intersect. A list is begun and made during
// motions of these fractions of the margin, and is valid for the rest of it. If one tick moves further, lists would become invalid
// before they are whole.
constexpr double kMarginOfRadius = 0.03;
constexpr double kBeginning = 0.5;
constexpr double kMaking = 0.35;
constexpr double kMostInATick = 0.25;
constexpr std::size_t kAllWork = std::numeric_limits<std::size_t>::max();

TriangleClusters clusters_of(const ClusteredMesh& mesh) {
  return {.clusters = mesh.clusters().data(),
          .count = mesh.clusters().size(),
          .boxes = mesh.boxes().data()};
}

}  // namespace

MeshQuery::MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
                     std::size_t maximum_pairs)
    : MeshQuery(std::move(a), std::move(b), maximum_pairs, instruction_sets_here().back()) {}

MeshQuery::MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
                     std::size_t maximum_pairs, InstructionSet set)
    : a_(std::move(a)),
      b_(std::move(b)),
      loops_(&triangle_loops_of(set)),
      pairs_(maximum_pairs),
      margin_m_(kMarginOfRadius * std::min(a_->radius_m(), b_->radius_m())),
      listed_{.pairs = NearPairs(maximum_pairs)},
      next_{.pairs = NearPairs(maximum_pairs)} {}

// No point of A moves further: the norm of the change of a rotation by θ is √8·sin(θ/2), and a point at a distance r
// moves by at most 2·r·sin(θ/2).
double MeshQuery::way_m(const Pose& from, const Pose& to) const noexcept {
  const glm::dvec3 centre_m = (to.rotation - from.rotation) * a_->centre_m();
  double squares = 0.0;
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 change = to.rotation[column] - from.rotation[column];
    squares += glm::dot(change, change);
  }
  return glm::length(centre_m + to.position_m - from.position_m) +
         a_->radius_m() * std::sqrt(0.5 * squares);
}

bool MeshQuery::is_whole(const List& list) const noexcept {
  return list.searched == kLanes * a_->clusters().size() * b_->clusters().size();
}

void MeshQuery::begin(List& list, const Pose& X_BA, double margin_m) noexcept {
  list.searched = 0;
  list.work = 0;
  list.due_work = 0.0;
  list.pairs.begin(X_BA, margin_m);
}

// Searches the next clusters for pairs within the margin.
void MeshQuery::search(List& list, std::size_t most_work) noexcept {
  ClusterPose pose = cluster_pose(*a_, *b_, list.pairs.pose());
  pose.tolerance_m += static_cast<float>(list.pairs.margin_m());
  struct Found {
    const MeshPair& meshes;
    NearPairs& pairs;
  };
  const MeshPair meshes = this->meshes();
  Found found{.meshes = meshes, .pairs = list.pairs};
  const auto take = [](void* to, std::uint32_t a, std::uint32_t b) noexcept {
    const Found& into = *static_cast<Found*>(to);
    into.pairs.add(into.meshes, {.a = a, .b = b});
  };
  SearchPart part{.first = list.searched, .most_work = most_work};
  loops_->find_candidates(clusters_of(*a_), clusters_of(*b_), pose, part, take, &found);
  list.pairs.add_last(meshes);
  list.searched = part.next;
  list.work += part.work;
}

// Whether listed_ has all pairs that intersect at this pose; continues or begins the next list.
bool MeshQuery::has_list_for(const Pose& X_BA, double moved_m) noexcept {
  listed_.pairs.move(moved_m);
  next_.pairs.move(moved_m);
  if (is_listing_) {
    next_.due_work += moved_m / (kMaking * margin_m_) * static_cast<double>(listed_.work);
    const double left = next_.due_work - static_cast<double>(next_.work);
    if (left > 0.0) search(next_, static_cast<std::size_t>(std::ceil(left)));
    if (is_whole(next_)) {
      is_listing_ = false;
      is_from_list_ = false;
      std::swap(listed_, next_);
    }
  }
  if (!is_whole(listed_) || listed_.pairs.is_overfull()) return false;
  const double way_m = this->way_m(listed_.pairs.pose(), X_BA);
  if (!is_listing_ && way_m >= kBeginning * margin_m_) {
    begin(next_, X_BA, margin_m_);
    is_listing_ = true;
  }
  return way_m < listed_.pairs.margin_m();
}

// All at once; with a margin if the list can be used again. Where so many pairs are near that a list has no room for them, it is not
// made again before A has moved.
void MeshQuery::search_all(const Pose& X_BA, bool is_slow) noexcept {
  is_listing_ = false;
  const bool is_crowded = crowded_pose_ && way_m(*crowded_pose_, X_BA) < kBeginning * margin_m_;
  if (is_slow && !is_crowded) {
    begin(listed_, X_BA, margin_m_);
    search(listed_, kAllWork);
    crowded_pose_.reset();
    if (listed_.pairs.is_overfull()) crowded_pose_ = X_BA;
  }
  if (!is_slow || crowded_pose_) {
    begin(listed_, X_BA, 0.0);
    search(listed_, kAllWork);
  }
  count_ = listed_.pairs.intersecting(pairs_);
  if (listed_.pairs.is_overfull()) count_ = listed_.pairs.count();
}

std::span<const TrianglePair> MeshQuery::find(const Pose& X_BA) noexcept {
  const double moved_m =
      last_pose_ ? way_m(*last_pose_, X_BA) : std::numeric_limits<double>::infinity();
  last_pose_ = X_BA;
  const bool is_slow = moved_m < kMostInATick * margin_m_;
  if (is_slow && has_list_for(X_BA, moved_m)) {
    ++listed_calls_;
    // Its pairs are tested while it is made, so that no call tests all of them.
    if (is_listing_) next_.pairs.renew(meshes(), X_BA);
    const bool has_changed = listed_.pairs.renew(meshes(), X_BA);
    if (has_changed || !is_from_list_) count_ = listed_.pairs.intersecting(pairs_);
    is_from_list_ = true;
  } else {
    search_all(X_BA, is_slow);
    is_from_list_ = false;
  }
  return std::span(pairs_).first(std::min(count_, pairs_.size()));
}

}  // namespace asperity
