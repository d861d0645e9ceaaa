// The greatest depth that the thickness of the bodies permits.

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderers/pd_gradient/contact/textured_contacts.h"

namespace asperity {

double TexturedContacts::most_depth_m(const TexturedContact& contact, const Pose& X_WA,
                                      const Pose& X_WB) const noexcept {
  constexpr double kBeyond = 1.01;  // so that the surface itself is met in spite of rounding
  const glm::dvec3& n = contact.frame.n;
  const double depth_m = contact.penetration.depth_m;
  const glm::dvec3 on_a_m = deepest_m(contact);
  const glm::dvec3 on_b_m = on_a_m + depth_m * n;
  const auto way_out = [depth_m](const TexturedBody& body, const Pose& pose,
                                 const glm::dvec3& from_m, const glm::dvec3& along) {
    const double texture_m = body.furthest_displacement_m();
    WayOut way = body.way_out(in_body(pose, from_m), glm::transpose(pose.rotation) * along,
                              kBeyond * depth_m + texture_m);
    // A thicker body does not limit the depth.
    way.way_m = std::min(depth_m, way.way_m + texture_m);
    return way;
  };
  // A line along the rim of a body does not meet it: no thickness.
  const auto thickness_m = [&](const TexturedBody& body, const Pose& pose, const glm::dvec3& from_m,
                               const glm::dvec3& along) {
    const double way_m = way_out(body, pose, from_m, along).way_m;
    if (way_m < depth_m) return way_m;
    const double all_m = 2.0 * body.hull_clusters()->radius_m() + depth_m;
    const WayOut way =
        body.way_out(in_body(pose, from_m), glm::transpose(pose.rotation) * along, all_m);
    return way.way_m < all_m ? depth_m : 0.0;
  };
  const double half_window_m =
      contact.is_kept ? depth_m
                      : std::min(depth_m, contact.half_extent_m + a_.furthest_displacement_m() +
                                              b_.furthest_displacement_m());
  // One short line decides for most contacts.
  if (half_window_m == depth_m && way_out(b_, X_WB, on_b_m, -n).way_m == depth_m) return depth_m;
  const double of_b_m = thickness_m(b_, X_WB, on_b_m, -n);
  const double of_a_m = thickness_m(a_, X_WA, on_a_m, n);
  const double median_m =
      std::max(std::min(of_a_m, of_b_m), std::min(std::max(of_a_m, of_b_m), half_window_m));
  if (median_m == depth_m) return depth_m;
  const WayOut out_of_b = way_out(b_, X_WB, on_a_m, n);
  const WayOut out_of_a = way_out(a_, X_WA, on_b_m, -n);
  if (out_of_a.is_inside == out_of_b.is_inside) return median_m;
  return std::min(median_m, out_of_b.is_inside ? out_of_b.way_m : out_of_a.way_m);
}

// If the deepest place is at a rim, the distance to the end of the body changes with every sample of its motion. Therefore
// a bound falls at once, while the previous contact fades, and rises at the rate at which doubtful depths are accepted.
double TexturedContacts::most_after_m(const TexturedContact& contact) const noexcept {
  for (const TexturedContact& last : before_) {
    if (last.id != contact.id || !is_felt(last) || !last.is_bounded || last.is_fading) continue;
    return last.penetration.depth_m + kReachGrowth_m_per_s * dt_s_;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace asperity
