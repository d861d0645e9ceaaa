// Implements the grouping of triangle pairs and the frames of the regions.

#include "renderers/pd_gradient/geometry/contact_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr double kSmallestDirection = 0.05;       // relative to n of equal normals
constexpr double kWidthStep = 1.189207115002721;  // 2^(1/4)
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A point on a line and its position along it.
struct PointOnLine {
  double along = 0.0;
  glm::dvec3 place_m{0.0};
};

/// The intersection of a triangle with the line in which another's plane cuts its own.
struct Interval {
  PointOnLine low{.along = std::numeric_limits<double>::infinity()};
  PointOnLine high{.along = -std::numeric_limits<double>::infinity()};
};

/// The two edges that cross a plane, by the corners below it: bit i is corner i, and edge i goes to the next corner.
constexpr std::array<std::array<std::uint8_t, 2>, 8> kCrossingEdges{
    {{}, {0, 2}, {0, 1}, {1, 2}, {1, 2}, {0, 1}, {0, 2}, {}}};

// With a table and without branches: which corners are below is not predictable.
Interval cut(const Corners& corners, const glm::dvec3& normal, const glm::dvec3& on_plane,
             const glm::dvec3& along) noexcept {
  double heights[3];
  unsigned below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    heights[i] = glm::dot(normal, corners[i] - on_plane);
    below |= (heights[i] < 0.0 ? 1U : 0U) << i;
  }
  if (below == 0 || below == 7) return {};
  const auto crossing = [&](std::size_t i) -> PointOnLine {
    const std::size_t j = (i + 1) % 3;
    const double share = heights[i] / (heights[i] - heights[j]);
    const glm::dvec3 place_m = corners[i] + share * (corners[j] - corners[i]);
    return {.along = glm::dot(place_m, along), .place_m = place_m};
  };
  const PointOnLine first = crossing(kCrossingEdges[below][0]);
  const PointOnLine second = crossing(kCrossingEdges[below][1]);
  return {.low = second.along < first.along ? second : first,
          .high = second.along > first.along ? second : first};
}

/// Applies to a third vector the rotation that takes one unit vector to another, about their common normal.
glm::dvec3 turned_along(const glm::dvec3& from, const glm::dvec3& to,
                        const glm::dvec3& vector) noexcept {
  const glm::dvec3 axis = glm::cross(from, to);
  const double cosine = glm::dot(from, to);
  if (cosine < -0.999) return vector;  // opposite: any axis is valid; u is made orthogonal below
  return vector * cosine + glm::cross(axis, vector) +
         axis * (glm::dot(axis, vector) / (1.0 + cosine));
}

glm::dvec3 across(const glm::dvec3& n, const glm::dvec3& wanted) noexcept {
  return glm::normalize(wanted - n * glm::dot(n, wanted));
}

/// The axes for a new direction: u along the axis of B that is most perpendicular to it, the first one in the case of
/// ties within rounding.
ContactFrame first_frame(const glm::dvec3& origin_m, const glm::dvec3& n,
                         const glm::dmat3& rotation_b) noexcept {
  constexpr double kRounding = 1e-6;
  const glm::dvec3 size = glm::abs(glm::transpose(rotation_b) * n);
  const double least = std::min({size.x, size.y, size.z}) + kRounding;
  const glm::dvec3 axis = size.x <= least   ? glm::dvec3(1.0, 0.0, 0.0)
                          : size.y <= least ? glm::dvec3(0.0, 1.0, 0.0)
                                            : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 u = across(n, rotation_b * axis);
  return {.origin_m = origin_m, .u = u, .v = glm::cross(n, u), .n = n};
}

/// The frame of the previous tick, moved to a new origin and, with play, to a new direction.
ContactFrame led_frame(const ContactFrame& before, const glm::dvec3& origin_m,
                       const glm::dvec3& wanted_n) noexcept {
  const double cosine = std::clamp(glm::dot(before.n, wanted_n), -1.0, 1.0);
  const double angle_rad = std::atan2(glm::length(glm::cross(before.n, wanted_n)), cosine);
  glm::dvec3 n = before.n;
  if (angle_rad > ContactRegions::kPlay_rad) {
    // The direction on the great circle between the two at the distance of the play from the new one.
    const glm::dvec3 side = across(wanted_n, before.n);
    n = glm::normalize(std::cos(ContactRegions::kPlay_rad) * wanted_n +
                       std::sin(ContactRegions::kPlay_rad) * side);
  }
  const glm::dvec3 u = across(n, turned_along(before.n, n, before.u));
  return {.origin_m = origin_m, .u = u, .v = glm::cross(n, u), .n = n};
}

/// The smallest permitted width that contains `needed_m`.
double stepped_width_m(double needed_m) noexcept {
  constexpr double kUnit_m = 1e-3;
  const double steps = std::ceil(std::log(needed_m / kUnit_m) / std::log(kWidthStep));
  return kUnit_m * std::pow(kWidthStep, steps);
}

}  // namespace

ContactRegions::Body::Body(const TriangleMesh& mesh)
    : vertices_m(mesh.vertices_m), triangles(mesh.triangles) {
  for (const auto& corners : triangles) {
    for (const std::uint32_t corner : corners) {
      if (corner >= vertices_m.size()) {
        throw std::invalid_argument("triangle " + std::to_string(normals.size()) +
                                    " of the mesh refers to vertex " + std::to_string(corner) +
                                    "; it must be less than the number of vertices, " +
                                    std::to_string(vertices_m.size()));
      }
    }
    const glm::dvec3 area = glm::cross(vertices_m[corners[1]] - vertices_m[corners[0]],
                                       vertices_m[corners[2]] - vertices_m[corners[0]]);
    const double length = glm::length(area);
    normals.push_back(length > 0.0 ? area / length : glm::dvec3(0.0));
  }
  last_of_triangle.assign(triangles.size(), kNone);
  last_of_vertex.assign(vertices_m.size(), kNone);
  placed.resize(triangles.size());
}

// Most triangles belong to several pairs.
const ContactRegions::PlacedTriangle& ContactRegions::Body::at(std::uint32_t triangle,
                                                               const Pose& pose,
                                                               std::uint64_t update) noexcept {
  PlacedTriangle& found = placed[triangle];
  if (found.update == update) return found;
  found.update = update;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    found.corners_m[corner] =
        pose.rotation * vertices_m[triangles[triangle][corner]] + pose.position_m;
  }
  found.normal = pose.rotation * normals[triangle];
  return found;
}

ContactRegions::ContactRegions(const TriangleMesh& a, const TriangleMesh& b,
                               std::size_t maximum_pairs, std::size_t maximum_regions)
    : a_(a), b_(b), maximum_regions_(maximum_regions) {
  segments_.reserve(maximum_pairs);
  parents_.reserve(maximum_pairs);
  joined_.reserve(maximum_pairs);
  before_it_.resize(maximum_pairs);
  sum_of_root_.reserve(maximum_pairs);
  sums_.reserve(maximum_pairs);
  half_extents_m_.reserve(maximum_regions);
  kept_.reserve(maximum_regions);
  before_.reserve(maximum_regions);
  lasts_.reserve(maximum_regions);
  taken_.reserve(maximum_regions);
}

std::uint32_t ContactRegions::root_of(std::uint32_t pair) noexcept {
  while (parents_[pair] != pair) {
    parents_[pair] = parents_[parents_[pair]];
    pair = parents_[pair];
  }
  return pair;
}

void ContactRegions::join(std::uint32_t one, std::uint32_t other) noexcept {
  const std::uint32_t first = root_of(one);
  const std::uint32_t second = root_of(other);
  // The smaller index is kept: the result does not depend on the order of joining.
  parents_[std::max(first, second)] = std::min(first, second);
}

// Joins pairs of one triangle of `same` whose triangles of `other` share a corner. The pairs of a triangle are linked
// in a list, and each list is traversed once.
void ContactRegions::join_along(std::span<const TrianglePair> pairs, Side same,
                                Side other) noexcept {
  Body& held = *same.body;
  Body& along = *other.body;
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    std::uint32_t& last = held.last_of_triangle[pairs[i].*same.of_pair];
    before_it_[i] = last;
    last = i;
  }
  for (const TrianglePair& pair : pairs) {
    const std::uint32_t last = std::exchange(held.last_of_triangle[pair.*same.of_pair], kNone);
    if (last == kNone || before_it_[last] == kNone) continue;
    for (std::uint32_t i = last; i != kNone; i = before_it_[i]) {
      for (const std::uint32_t corner : along.triangles[pairs[i].*other.of_pair]) {
        const std::uint32_t met = std::exchange(along.last_of_vertex[corner], i);
        if (met != kNone) join(i, met);
      }
    }
    for (std::uint32_t i = last; i != kNone; i = before_it_[i]) {
      for (const std::uint32_t corner : along.triangles[pairs[i].*other.of_pair]) {
        along.last_of_vertex[corner] = kNone;
      }
    }
  }
}

// A curve continues from one pair to the next through an edge or a corner of one mesh, while the triangle of the other
// mesh is the same.
void ContactRegions::join_neighbours(std::span<const TrianglePair> pairs) noexcept {
  const Side a{.body = &a_, .of_pair = &TrianglePair::a};
  const Side b{.body = &b_, .of_pair = &TrianglePair::b};
  join_along(pairs, a, b);
  join_along(pairs, b, a);
}

void ContactRegions::add_up() noexcept {
  sums_.clear();
  sum_of_root_.assign(segments_.size(), kNone);
  for (std::uint32_t pair = 0; pair < segments_.size(); ++pair) {
    const std::uint32_t root = root_of(pair);
    if (sum_of_root_[root] == kNone) {
      sum_of_root_[root] = static_cast<std::uint32_t>(sums_.size());
      sums_.push_back({.root = root});
    }
    Sum& sum = sums_[sum_of_root_[root]];
    const Segment& segment = segments_[pair];
    sum.length_m += segment.length_m;
    sum.middles += segment.length_m * 0.5 * (segment.ends_m[0] + segment.ends_m[1]);
    sum.normals_a += segment.length_m * segment.normal_a;
    sum.normals_b += segment.length_m * segment.normal_b;
    ++sum.pairs;
  }
}

void ContactRegions::keep_longest() noexcept {
  const std::size_t all = sums_.size();
  std::erase_if(sums_, [](const Sum& sum) {
    return !(sum.length_m > 0.0) ||
           !(glm::length(sum.normals_b - sum.normals_a) > kSmallestDirection * 2.0 * sum.length_m);
  });
  std::sort(sums_.begin(), sums_.end(), [](const Sum& one, const Sum& other) {
    return std::pair(-one.length_m, one.root) < std::pair(-other.length_m, other.root);
  });
  if (sums_.size() > maximum_regions_) {
    sums_.erase(sums_.begin() + static_cast<std::ptrdiff_t>(maximum_regions_), sums_.end());
  }
  left_out_ = all - sums_.size();
}

const ContactRegion* ContactRegions::before(const glm::dvec3& origin_m) noexcept {
  std::size_t nearest = before_.size();
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const double distance_m = glm::distance(before_[i].frame.origin_m, origin_m);
    if (taken_[i] || distance_m > 0.5 * before_[i].width_m || distance_m >= nearest_m) continue;
    nearest = i;
    nearest_m = distance_m;
  }
  if (nearest == before_.size()) return nullptr;
  taken_[nearest] = true;
  return &before_[nearest];
}

// The half-extents of all kept regions, along u or v from their origins.
void ContactRegions::find_half_extents() noexcept {
  half_extents_m_.assign(kept_.size(), 0.0);
  // The regions are in the order of their sums; regions that were left out have none.
  sum_of_root_.assign(segments_.size(), kNone);
  for (std::uint32_t i = 0; i < sums_.size(); ++i) sum_of_root_[sums_[i].root] = i;
  for (std::uint32_t pair = 0; pair < segments_.size(); ++pair) {
    const std::uint32_t region = sum_of_root_[root_of(pair)];
    if (region == kNone || segments_[pair].length_m == 0.0) continue;
    const ContactFrame& frame = kept_[region].frame;
    double& extent_m = half_extents_m_[region];
    for (const glm::dvec3& end : segments_[pair].ends_m) {
      const glm::dvec3 way = end - frame.origin_m;
      extent_m =
          std::max({extent_m, std::abs(glm::dot(frame.u, way)), std::abs(glm::dot(frame.v, way))});
    }
  }
}

std::span<const ContactRegion> ContactRegions::update(std::span<const TrianglePair> pairs,
                                                      const Pose& a, const Pose& b) noexcept {
  pairs = pairs.first(std::min(pairs.size(), segments_.capacity()));
  std::swap(before_, kept_);
  kept_.clear();
  taken_.assign(before_.size(), false);
  segments_.clear();
  ++updates_;
  for (const TrianglePair& pair : pairs) {
    const PlacedTriangle& p = a_.at(pair.a, a, updates_);
    const PlacedTriangle& q = b_.at(pair.b, b, updates_);
    Segment segment{.normal_a = p.normal, .normal_b = q.normal};
    const glm::dvec3 along = glm::cross(p.normal, q.normal);
    const Interval of_p = cut(p.corners_m, q.normal, q.corners_m[0], along);
    const Interval of_q = cut(q.corners_m, p.normal, p.corners_m[0], along);
    const PointOnLine& low = of_p.low.along > of_q.low.along ? of_p.low : of_q.low;
    const PointOnLine& high = of_p.high.along < of_q.high.along ? of_p.high : of_q.high;
    if (low.along < high.along) {
      segment.ends_m[0] = low.place_m;
      segment.ends_m[1] = high.place_m;
      segment.length_m = glm::distance(low.place_m, high.place_m);
    }
    segments_.push_back(segment);
  }
  if (!std::equal(pairs.begin(), pairs.end(), joined_.begin(), joined_.end())) {
    joined_.assign(pairs.begin(), pairs.end());
    parents_.resize(pairs.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
    join_neighbours(pairs);
  }
  add_up();
  keep_longest();
  lasts_.clear();
  for (const Sum& sum : sums_) {
    const glm::dvec3 origin_m = sum.middles / sum.length_m;
    const glm::dvec3 n = glm::normalize(sum.normals_b - sum.normals_a);
    const ContactRegion* last = before(origin_m);
    lasts_.push_back(last);
    kept_.push_back({.id = last == nullptr ? next_id_++ : last->id,
                     .frame = last == nullptr ? first_frame(origin_m, n, b.rotation)
                                              : led_frame(last->frame, origin_m, n),
                     .pairs = sum.pairs});
    ContactRegion& region = kept_.back();
    region.upright_a = -glm::dot(sum.normals_a, region.frame.n) / sum.length_m;
    region.upright_b = glm::dot(sum.normals_b, region.frame.n) / sum.length_m;
  }
  find_half_extents();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    kept_[i].half_extent_m = std::max(half_extents_m_[i], 0.5 * kSmallestWidth_m);
    const double needed_m = stepped_width_m(2.0 * kept_[i].half_extent_m);
    const ContactRegion* last = lasts_[i];
    const bool fits = last != nullptr && needed_m <= last->width_m &&
                      last->width_m <= needed_m * kWidthStep * kWidthStep * 1.0001;
    kept_[i].width_m = fits ? last->width_m : needed_m;
  }
  return kept_;
}

}  // namespace asperity
