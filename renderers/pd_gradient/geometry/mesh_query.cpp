// Implements the search for intersecting triangles with clusters of sixteen.

#include "renderers/pd_gradient/geometry/mesh_query.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace asperity {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr std::size_t kLanes = kClusterSize;
// The rounding error of a position in single precision, with a margin for the products of the test.
constexpr float kRoundingOfRadius = 4e-6F;
// With a wider margin lists are made less often, and contain more pairs that do not intersect.
constexpr double kMarginOfRadius = 0.03;
constexpr double kSoftMargin = 0.3;  // of the margin: there the next list is begun
// A list is made in about this number of calls, if it takes as much work as the last one.
constexpr std::size_t kCallsOfAList = 16;
constexpr std::size_t kWorkOfFirstList = 256;  // in comparisons with sixteen triangles

glm::dvec3 middle_of(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

/// Splits `order` at the median of the longest axis until at most sixteen elements are left; all clusters but one are
/// full.
void cluster(std::span<std::uint32_t> order, const std::vector<glm::dvec3>& middles) {
  if (order.size() <= kLanes) return;
  glm::dvec3 low = middles[order[0]];
  glm::dvec3 high = low;
  for (const std::uint32_t triangle : order) {
    low = glm::min(low, middles[triangle]);
    high = glm::max(high, middles[triangle]);
  }
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t clusters = (order.size() + kLanes - 1) / kLanes;
  const std::size_t half = (clusters / 2) * kLanes;
  // Ties are broken by index: the clusters are the same with every standard library.
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t first, std::uint32_t second) {
                     return std::pair(middles[first][axis], first) <
                            std::pair(middles[second][axis], second);
                   });
  cluster(order.first(half), middles);
  cluster(order.subspan(half), middles);
}

/// Sets the planes perpendicular to the mean normal that enclose a cluster's triangles.
void set_slab(TriangleCluster& cluster) {
  const auto corner = [&cluster](std::size_t which, std::size_t lane) {
    return glm::dvec3(cluster.corners[which][0][lane], cluster.corners[which][1][lane],
                      cluster.corners[which][2][lane]);
  };
  glm::dvec3 normal(0.0);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if ((cluster.used >> lane & 1U) == 0) continue;
    normal += glm::cross(corner(1, lane) - corner(0, lane), corner(2, lane) - corner(0, lane));
  }
  const double length = glm::length(normal);
  normal = length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {  // unused lanes repeat others
    for (std::size_t which = 0; which < 3; ++which) {
      low = std::min(low, glm::dot(normal, corner(which, lane)));
      high = std::max(high, glm::dot(normal, corner(which, lane)));
    }
  }
  for (int axis = 0; axis < 3; ++axis) cluster.slab_normal[axis] = static_cast<float>(normal[axis]);
  cluster.slab_low_m = static_cast<float>(low);
  cluster.slab_high_m = static_cast<float>(high);
}

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

TriangleClusters clusters_of(const ClusteredMesh& mesh) {
  return {.clusters = mesh.clusters().data(),
          .count = mesh.clusters().size(),
          .boxes = mesh.boxes().data()};
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

ClusteredMesh::ClusteredMesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("the mesh has no triangles; at least one is needed");
  }
  std::vector<glm::dvec3> middles{};
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    Corners corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (triangle[corner] >= mesh.vertices_m.size()) {
        throw std::invalid_argument(
            "triangle " + std::to_string(corners_m_.size()) + " of the mesh refers to vertex " +
            std::to_string(triangle[corner]) + "; it must be less than the number of vertices, " +
            std::to_string(mesh.vertices_m.size()));
      }
      corners[corner] = mesh.vertices_m[triangle[corner]];
      low = glm::min(low, corners[corner]);
      high = glm::max(high, corners[corner]);
    }
    corners_m_.push_back(corners);
    middles.push_back(middle_of(corners));
  }
  centre_m_ = 0.5 * (low + high);
  radius_m_ = 0.5 * glm::length(high - low);

  std::vector<std::uint32_t> order(corners_m_.size());
  std::iota(order.begin(), order.end(), 0U);
  cluster(order, middles);

  constexpr float kFar = std::numeric_limits<float>::max();
  clusters_.resize((order.size() + kLanes - 1) / kLanes);
  boxes_.resize((clusters_.size() + kLanes - 1) / kLanes);
  for (ClusterBoxes& boxes : boxes_) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill(std::begin(boxes.low[axis]), std::end(boxes.low[axis]), kFar);
      std::fill(std::begin(boxes.high[axis]), std::end(boxes.high[axis]), -kFar);
    }
  }
  for (std::size_t place = 0; place < clusters_.size() * kLanes; ++place) {
    TriangleCluster& cluster = clusters_[place / kLanes];
    ClusterBoxes& boxes = boxes_[place / kLanes / kLanes];
    const std::size_t box = place / kLanes % kLanes;
    const std::size_t lane = place % kLanes;
    const bool is_used = place < order.size();
    const std::uint32_t triangle = order[std::min(place, order.size() - 1)];
    cluster.triangles[lane] = triangle;
    if (is_used) cluster.used |= 1U << lane;
    const std::array<std::array<float, 3>, 3> corners_m = corners_from_centre_m(triangle);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float lowest = kFar;
      float highest = -kFar;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const float place_m = corners_m[corner][axis];
        cluster.corners[corner][axis][lane] = place_m;
        lowest = std::min(lowest, place_m);
        highest = std::max(highest, place_m);
      }
      cluster.low[axis][lane] = is_used ? lowest : kFar;
      cluster.high[axis][lane] = is_used ? highest : -kFar;
      if (!is_used) continue;
      boxes.low[axis][box] = std::min(boxes.low[axis][box], lowest);
      boxes.high[axis][box] = std::max(boxes.high[axis][box], highest);
    }
  }
  for (TriangleCluster& cluster : clusters_) set_slab(cluster);
  loops_ = &triangle_loops_of(instruction_sets_here().back());
}

MeshQuery::MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
                     std::size_t maximum_pairs)
    : MeshQuery(std::move(a), std::move(b), maximum_pairs, instruction_sets_here().back()) {}

std::array<std::array<float, 3>, 3> ClusteredMesh::corners_from_centre_m(
    std::uint32_t triangle) const noexcept {
  std::array<std::array<float, 3>, 3> corners{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const glm::dvec3 place_m = corners_m_[triangle][corner] - centre_m_;
    corners[corner] = {static_cast<float>(place_m.x), static_cast<float>(place_m.y),
                       static_cast<float>(place_m.z)};
  }
  return corners;
}

MeshQuery::MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
                     std::size_t maximum_pairs, InstructionSet set)
    : a_(std::move(a)),
      b_(std::move(b)),
      loops_(&triangle_loops_of(set)),
      pairs_(maximum_pairs),
      margin_m_(kMarginOfRadius * std::min(a_->radius_m(), b_->radius_m())),
      work_of_list_(kWorkOfFirstList) {
  for (NearPairs* list : {&listed_, &next_}) {
    list->batches.assign((maximum_pairs + kLanes - 1) / kLanes, PairBatch{});
  }
}

void MeshQuery::NearPairs::add(const MeshQuery& query, std::uint32_t a, std::uint32_t b) noexcept {
  const std::size_t at = count++;
  if (is_overfull()) return;
  PairBatch& batch = batches[at / kLanes];
  const std::size_t lane = at % kLanes;
  const auto corners_a = query.a_->corners_from_centre_m(a);
  const auto corners_b = query.b_->corners_from_centre_m(b);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      batch.a[corner][axis][lane] = corners_a[corner][axis];
      batch.b[corner][axis][lane] = corners_b[corner][axis];
    }
  }
  batch.triangles_a[lane] = a;
  batch.triangles_b[lane] = b;
}

SlabBox ClusteredMesh::slab_box(const Box& box) const noexcept {
  SlabBox slabs{};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& axis = box.axes[i];
    const double along_m = glm::dot(axis, box.centre_m - centre_m_);
    slabs.slabs[i] = {
        {static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)},
        static_cast<float>(along_m - box.half_m[i]),
        static_cast<float>(along_m + box.half_m[i])};
    slabs.facing[i] = static_cast<float>(box.facing[static_cast<int>(i)]);
  }
  return slabs;
}

std::uint32_t ClusteredMesh::find_in_box(std::size_t cluster, const SlabBox& box) const noexcept {
  return loops_->find_in_box(clusters_[cluster], box,
                             kRoundingOfRadius * static_cast<float>(radius_m_));
}

ClusterPose MeshQuery::cluster_pose(const Pose& X_BA) const noexcept {
  ClusterPose pose{};
  const glm::dvec3 shift_m = X_BA * a_->centre_m() - b_->centre_m();  // between the centres
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose.turn[static_cast<std::size_t>(3 * row + column)] =
          static_cast<float>(X_BA.rotation[column][row]);
    }
    pose.shift_m[static_cast<std::size_t>(row)] = static_cast<float>(shift_m[row]);
  }
  pose.tolerance_m = kRoundingOfRadius * static_cast<float>(a_->radius_m() + b_->radius_m());
  return pose;
}

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

bool MeshQuery::is_whole(const NearPairs& list) const noexcept {
  return list.searched == a_->clusters().size() * b_->clusters().size();
}

// Searches the next clusters for pairs within the margin. Those at the contact need most of the work: the parts are equal in
// work, not in clusters.
void MeshQuery::continue_list() noexcept {
  ClusterPose pose = cluster_pose(next_.pose);
  pose.tolerance_m += static_cast<float>(margin_m_);
  struct Listing {
    const MeshQuery& query;
    NearPairs& list;
  } listing{*this, next_};
  const auto take = [](void* to, std::uint32_t a, std::uint32_t b, bool) noexcept {
    const Listing& into = *static_cast<Listing*>(to);
    into.list.add(into.query, a, b);
  };
  SearchPart part{.first = next_.searched, .most_work = work_of_list_ / kCallsOfAList + 1};
  loops_->find_pairs(clusters_of(*a_), clusters_of(*b_), pose, part, take, &listing);
  next_.searched = part.next;
  next_.work += part.work;
  if (!is_whole(next_)) return;
  is_listing_ = false;
  work_of_list_ = next_.work;
  std::swap(listed_, next_);
}

// The list that is valid at this pose, or nullptr; continues or begins the next one.
const MeshQuery::NearPairs* MeshQuery::list_for(const Pose& X_BA) noexcept {
  const bool is_slow = has_last_ && way_m(last_pose_, X_BA) * kCallsOfAList < margin_m_;
  last_pose_ = X_BA;
  has_last_ = true;
  if (!is_slow) {
    is_listing_ = false;
    return nullptr;
  }
  if (is_listing_) continue_list();
  const double used =
      is_whole(listed_) && !listed_.is_overfull() ? way_m(listed_.pose, X_BA) / margin_m_ : 1.0;
  if (!is_listing_ && !(used < kSoftMargin)) {
    next_.pose = X_BA;
    next_.searched = 0;
    next_.work = 0;
    next_.count = 0;
    is_listing_ = true;
  }
  return used < 1.0 ? &listed_ : nullptr;
}

std::span<const TrianglePair> MeshQuery::find(const Pose& X_BA) noexcept {
  struct Found {
    MeshQuery& query;
    const Pose& X_BA;
  } found{*this, X_BA};
  count_ = 0;
  const auto take = [](void* to, std::uint32_t a, std::uint32_t b, bool is_sure) noexcept {
    Found& into = *static_cast<Found*>(to);
    if (!is_sure) {
      Corners corners = into.query.a_->corners_m(a);
      for (glm::dvec3& corner : corners) corner = into.X_BA * corner;
      if (!triangles_intersect(corners, into.query.b_->corners_m(b))) return;
    }
    if (into.query.count_ < into.query.pairs_.size()) into.query.pairs_[into.query.count_] = {a, b};
    ++into.query.count_;
  };
  const ClusterPose pose = cluster_pose(X_BA);
  if (const NearPairs* list = list_for(X_BA)) {
    ++listed_calls_;
    loops_->test_pairs(list->batches.data(), list->count, pose, take, &found);
  } else {
    SearchPart all{};
    loops_->find_pairs(clusters_of(*a_), clusters_of(*b_), pose, all, take, &found);
  }
  return std::span(pairs_).first(std::min(count_, pairs_.size()));
}

}  // namespace asperity
