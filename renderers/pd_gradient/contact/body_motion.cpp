// Composes the poses of both bodies before and now, in coordinates of B.

#include "renderers/pd_gradient/contact/body_motion.h"

#include <glm/matrix.hpp>

namespace asperity {

glm::dvec3 BodyMotion::way_m(const glm::dvec3& now_m) const noexcept {
  const glm::dvec3 before_m = X_WA_before * in_body(X_WA, now_m);
  return now_m - X_WB * in_body(X_WB_before, before_m);
}

glm::dvec3 BodyMotion::now_on_a_m(const glm::dvec3& before_m) const noexcept {
  return X_WA * in_body(X_WA_before, before_m);
}

ContactFrame BodyMotion::continued(const TexturedContact& last) const noexcept {
  const glm::dmat3 turned = X_WB.rotation * glm::transpose(X_WB_before.rotation);
  return {.origin_m = X_WA * last.origin_in_a_m,
          .u = turned * last.frame.u,
          .v = turned * last.frame.v,
          .n = turned * last.frame.n};
}

}  // namespace asperity
