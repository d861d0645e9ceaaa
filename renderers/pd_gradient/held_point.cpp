// The winding number of a hull around a point, and how long it stays what it is.

#include "renderers/pd_gradient/held_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace asperity {
namespace {

// Never more than how far the nearest face is.
double clearance_m(const TriangleMesh& mesh, const glm::dvec3& point_m) noexcept {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::dvec3 a = mesh.vertices_m[i] - point_m;
    const glm::dvec3 b = mesh.vertices_m[j] - point_m;
    const glm::dvec3 c = mesh.vertices_m[k] - point_m;
    const glm::dvec3 low_m = glm::min(a, glm::min(b, c));
    const glm::dvec3 high_m = glm::max(a, glm::max(b, c));
    double away_m = glm::length(glm::max(glm::dvec3(0.0), glm::max(low_m, -high_m)));
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = glm::length(area);
    if (length > 0.0) away_m = std::max(away_m, std::abs(glm::dot(area, a)) / length);
    nearest_m = std::min(nearest_m, away_m);
  }
  return nearest_m;
}

}  // namespace

bool HeldPoint::is_in(const TexturedBody& body, const glm::dvec3& point_m) noexcept {
  constexpr double kSure = 0.999;  // whatever rounding does
  if (!known_ || !(glm::distance(point_m, known_->point_m) < kSure * known_->clear_m)) {
    known_ = {.point_m = point_m,
              .clear_m = clearance_m(body.hull(), point_m),
              .is_in = body.holds(point_m)};
    ++visits_;
  }
  return known_->is_in;
}

}  // namespace asperity
