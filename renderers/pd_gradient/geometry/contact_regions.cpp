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

constexpr double kSmallestDirection = 0.05;       // relative to n of equal normals
constexpr double kWidthStep = 1.189207115002721;  // 2^(1/4)
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

PlacedBody placed_body(const Pose& pose) noexcept {
  PlacedBody body{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      body.turn[3 * row + column] = pose.rotation[column][row];
    }
    body.shift_m[row] = pose.position_m[row];
  }
  return body;
}

/// A vector of one lane of eight.
glm::dvec3 in_lane(const double (&vectors)[3][kSegmentLanes], std::size_t lane) noexcept {
  return {vectors[0][lane], vectors[1][lane], vectors[2][lane]};
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
}

void ContactRegions::Body::put(std::uint32_t triangle, SegmentTriangles& batch,
                               std::size_t lane) const noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      batch.corners[corner][axis][lane] = vertices_m[triangles[triangle][corner]][axis];
    }
    batch.normal[axis][lane] = normals[triangle][axis];
  }
}

ContactRegions::ContactRegions(const TriangleMesh& a, const TriangleMesh& b,
                               std::size_t maximum_pairs, std::size_t maximum_regions,
                               InstructionSet set)
    : loops_(&triangle_loops_of(set)),
      a_(a),
      b_(b),
      maximum_pairs_(maximum_pairs),
      maximum_regions_(maximum_regions) {
  const std::size_t batches = (maximum_pairs + kSegmentLanes - 1) / kSegmentLanes;
  triangles_a_.assign(batches, SegmentTriangles{});
  triangles_b_.assign(batches, SegmentTriangles{});
  segments_.assign(batches, Segments{});
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
  sum_of_root_.assign(joined_.size(), kNone);
  for (std::uint32_t pair = 0; pair < joined_.size(); ++pair) {
    const std::uint32_t root = root_of(pair);
    if (sum_of_root_[root] == kNone) {
      sum_of_root_[root] = static_cast<std::uint32_t>(sums_.size());
      sums_.push_back({.root = root});
    }
    Sum& sum = sums_[sum_of_root_[root]];
    const Segments& segments = segments_[pair / kSegmentLanes];
    const std::size_t lane = pair % kSegmentLanes;
    sum.length_m += segments.length_m[lane];
    sum.middles += in_lane(segments.middles_m2, lane);
    sum.normals_a += in_lane(segments.normals_a_m, lane);
    sum.normals_b += in_lane(segments.normals_b_m, lane);
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
  sum_of_root_.assign(joined_.size(), kNone);
  for (std::uint32_t i = 0; i < sums_.size(); ++i) sum_of_root_[sums_[i].root] = i;
  for (std::uint32_t pair = 0; pair < joined_.size(); ++pair) {
    const std::uint32_t region = sum_of_root_[root_of(pair)];
    const Segments& segments = segments_[pair / kSegmentLanes];
    const std::size_t lane = pair % kSegmentLanes;
    if (region == kNone || segments.length_m[lane] == 0.0) continue;
    const ContactFrame& frame = kept_[region].frame;
    double& extent_m = half_extents_m_[region];
    for (const auto& ends_m : segments.ends_m) {
      const glm::dvec3 way = in_lane(ends_m, lane) - frame.origin_m;
      extent_m =
          std::max({extent_m, std::abs(glm::dot(frame.u, way)), std::abs(glm::dot(frame.v, way))});
    }
  }
}

// The pairs and the batches of their triangles, in the frames of the bodies. Many are the same as in the previous tick.
void ContactRegions::set_pairs(std::span<const TrianglePair> pairs) noexcept {
  bool has_changed = pairs.size() != joined_.size();
  joined_.resize(pairs.size(), {.a = kNone, .b = kNone});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (joined_[i] == pairs[i]) continue;
    joined_[i] = pairs[i];
    a_.put(pairs[i].a, triangles_a_[i / kSegmentLanes], i % kSegmentLanes);
    b_.put(pairs[i].b, triangles_b_[i / kSegmentLanes], i % kSegmentLanes);
    has_changed = true;
  }
  if (!has_changed) return;
  parents_.resize(pairs.size());
  std::iota(parents_.begin(), parents_.end(), 0U);
  join_neighbours(pairs);
}

std::span<const ContactRegion> ContactRegions::update(std::span<const TrianglePair> pairs,
                                                      const Pose& a, const Pose& b) noexcept {
  std::swap(before_, kept_);
  kept_.clear();
  taken_.assign(before_.size(), false);
  set_pairs(pairs.first(std::min(pairs.size(), maximum_pairs_)));
  loops_->cut_pairs(triangles_a_.data(), triangles_b_.data(), joined_.size(), placed_body(a),
                    placed_body(b), segments_.data());
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
