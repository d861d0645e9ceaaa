// Implements the clustering of a mesh.

#include "renderers/pd_gradient/geometry/clustered_mesh.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "renderers/pd_gradient/loops/instruction_set.h"

namespace asperity {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr std::size_t kLanes = kClusterSize;

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

}  // namespace

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
  for (const Corners& corners : corners_m_) {
    CornersFromCentre& from_centre_m = corners_from_centre_m_.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 place_m = corners[corner] - centre_m_;
      from_centre_m[corner] = {static_cast<float>(place_m.x), static_cast<float>(place_m.y),
                               static_cast<float>(place_m.z)};
    }
  }

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
    const CornersFromCentre& corners_m = corners_from_centre_m(triangle);
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

std::size_t ClusteredMesh::bytes() const noexcept {
  return std::as_bytes(clusters()).size() + std::as_bytes(boxes()).size() +
         std::as_bytes(std::span(corners_m_)).size() +
         std::as_bytes(std::span(corners_from_centre_m_)).size();
}

ClusterPose cluster_pose(const ClusteredMesh& a, const ClusteredMesh& b,
                         const Pose& X_BA) noexcept {
  ClusterPose pose{};
  const glm::dvec3 shift_m = X_BA * a.centre_m() - b.centre_m();  // between the centres
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose.turn[static_cast<std::size_t>(3 * row + column)] =
          static_cast<float>(X_BA.rotation[column][row]);
    }
    pose.shift_m[static_cast<std::size_t>(row)] = static_cast<float>(shift_m[row]);
  }
  pose.tolerance_m = kRoundingOfRadius * static_cast<float>(a.radius_m() + b.radius_m());
  return pose;
}

}  // namespace asperity
