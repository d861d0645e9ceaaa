// Contacts made by hand, without bodies.

#pragma once

#include <cstdint>

#include "renderers/pd_gradient/contact/textured_contact.h"

namespace asperity {

/// A contact on a plane z = 0 whose deepest place is at (x, 0), in a window of 4 mm around (0, 0).
inline TexturedContact contact_at(std::uint64_t id, double x_m, double depth_m = 0.1e-3) {
  TexturedContact contact{.id = id,
                          .width_m = 3e-3,
                          .grid = {.width_m = 4e-3, .samples = 64},
                          .penetration = {.depth_m = depth_m, .deepest_m = {x_m, 0.0, 0.0}},
                          .sampled_depth_m = depth_m,
                          .half_extent_m = 2e-3,
                          .filter_m = 0.1e-3,
                          .half_height_m = 2e-3};
  return contact;
}

/// A contact whose window is around its deepest place, far from that of others.
inline TexturedContact contact_around(std::uint64_t id, double x_m, double depth_m = 0.1e-3) {
  TexturedContact contact = contact_at(id, 0.0, depth_m);
  contact.frame.origin_m.x = x_m;
  contact.origin_in_a_m.x = x_m;
  return contact;
}

}  // namespace asperity
