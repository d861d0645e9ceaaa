// Implements the query of a body after the point has moved far enough.

#include "renderers/pd_gradient/contact/held_point.h"

#include <glm/geometric.hpp>

namespace asperity {

bool HeldPoint::is_in(const TexturedBody& body, const glm::dvec3& point_m) noexcept {
  constexpr double kSure = 0.999;  // margin for rounding errors
  if (!known_ || !(glm::distance(point_m, known_->point_m) < kSure * known_->there.clear_m)) {
    known_ = {.point_m = point_m, .there = body.whereabouts(point_m)};
    ++visits_;
  }
  return known_->there.is_inside;
}

}  // namespace asperity
