// Where a pointer is in a window's picture of the surface.

#pragma once

#include <glm/vec2.hpp>

namespace asperity {

struct PointerSample {
  glm::dvec2 position_m{0.0};  ///< on the surface, x to the right, y away
  double pressure = 0.0;       ///< of a tablet's pen, 0 (lifted) to 1
  bool is_held = false;        ///< the button of a mouse, which has no pressure
};

}  // namespace asperity
