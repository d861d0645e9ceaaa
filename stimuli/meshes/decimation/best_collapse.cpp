// Implements the cost and the restrictions of collapses.
//
// Most of the time of a simplification is spent here. A vertex has about six collapses, of which only the cheapest one
// matters. They are therefore examined in order of the part of their cost that does not depend on samples, and each is
// abandoned as soon as it costs more than the best one before.

#include "stimuli/meshes/decimation/best_collapse.h"

#include <algorithm>
#include <numbers>

#include <glm/geometric.hpp>

namespace asperity::decimation {

void CollapseChoice::gather(std::uint32_t vertex) {
  ring_.clear();
  neighbours_.clear();
  const std::uint32_t first = surface_.half_of(vertex);
  std::uint32_t half = first;
  do {
    const std::uint32_t neighbour = surface_.to(half);
    neighbours_.push_back(neighbour);
    ring_.push_back({.half = half, .point = surface_.point(neighbour)});
    half = surface_.turned(half);
  } while (half != first);
  const glm::dvec3 point = surface_.point(vertex);
  const auto squared = [](const glm::dvec3& side) { return glm::dot(side, side); };
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    Neighbour& one = ring_[i];
    const glm::dvec3 next = ring_[after(i)].point;
    one.front = glm::cross(one.point - point, next - point);
    one.front_length = glm::length(one.front);
    one.squared_sides =
        squared(one.point - point) + squared(next - one.point) + squared(point - next);
  }
}

/// Whether the last face of the fan, which was `face`, may become what it is.
bool CollapseChoice::is_permitted(std::size_t kept, std::size_t face, Strictness strictness) const {
  constexpr double kSmallestCosine = 0.5;
  constexpr double kLeastLikeness = 0.1;  // the cosine of 84°
  // The roundness of a face is 1 for equal sides and 0 without area: the doubled area times 2√3 over the squared sides.
  constexpr double kPerRoundness = 1.0 / (2.0 * std::numbers::sqrt3);
  constexpr double kLeastRoundness = 0.05 * kPerRoundness;
  constexpr double kDegenerate = 1e-6 * kPerRoundness;  // a degenerate face had no orientation
  const Neighbour& old = ring_[face];
  const glm::dvec3& front = fan_.last_front();
  const double length = fan_.last_front_length();
  if (old.front_length > kDegenerate * old.squared_sides) {
    const bool is_strict = strictness == Strictness::turn_and_shape;
    const double least = is_strict ? kSmallestCosine : 0.0;
    if (glm::dot(old.front, front) <= least * old.front_length * length) return false;
    const double sides = fan_.last_squared_sides();
    if (is_strict && length < kLeastRoundness * sides &&
        length * old.squared_sides < old.front_length * sides) {
      return false;
    }
  }
  if (strictness == Strictness::flip_only) return true;
  // Rotations accumulate over collapses; the normals of the given mesh are constant.
  for (const std::size_t corner : {kept, face, after(face)}) {
    const glm::dvec3& normal = pasts_[neighbours_[corner]].normal;
    if (glm::dot(front, normal) <= kLeastLikeness * length) return false;
  }
  return true;
}

/// Whether all faces that remain are permitted; they are then in fan_.
bool CollapseChoice::raise_fan(std::size_t kept, const Permission& permission) {
  fan_.begin(ring_[kept].point);
  std::size_t before = after(kept);
  fan_.add(ring_[before].point);
  for (std::size_t at = after(before); at != kept; at = after(at)) {
    fan_.add(ring_[at].point);
    if (!is_permitted(kept, before, permission.strictness)) return false;
    before = at;
  }
  return true;
}

Collapse CollapseChoice::best_of(std::uint32_t vertex, const Permission& permission) {
  constexpr double kQuadricWeight = 0.1;
  constexpr double kEdgeWeight = 1e-6;
  gather(vertex);
  const VertexPast& past = pasts_[vertex];
  const glm::dvec3 point = surface_.point(vertex);
  candidates_.clear();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const glm::dvec3 along = ring_[i].point - point;
    const double squared_length = glm::dot(along, along);
    const double deviation = past.quadric.at(ring_[i].point) + pasts_[neighbours_[i]].deviation;
    candidates_.push_back({.least_cost = kQuadricWeight * std::max(0.0, deviation) +
                                         kEdgeWeight * squared_length * squared_length,
                           .neighbour = i});
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& one, const Candidate& other) {
              return one.least_cost != other.least_cost ? one.least_cost < other.least_cost
                                                        : one.neighbour < other.neighbour;
            });
  const double squared_furthest = permission.furthest * permission.furthest;
  Collapse best{};
  for (const Candidate& candidate : candidates_) {
    if (candidate.least_cost >= best.cost) break;
    if (!raise_fan(candidate.neighbour, permission)) continue;
    double cost = candidate.least_cost;
    for (const Sample& sample : past.samples) {
      const double squared = fan_.nearest(sample.place).squared_distance;
      cost += sample.area * squared;
      if (squared > squared_furthest || cost >= best.cost) {
        cost = best.cost;
        break;
      }
    }
    // The last check because it follows the edges of both vertices.
    if (cost < best.cost && surface_.can_collapse(ring_[candidate.neighbour].half, neighbours_)) {
      best = {.cost = cost, .half = ring_[candidate.neighbour].half};
    }
  }
  return best;
}

}  // namespace asperity::decimation
