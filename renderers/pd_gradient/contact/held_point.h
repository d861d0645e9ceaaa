// Whether a point is inside a body, without visiting all of its faces each time.

#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/contact/textured_body.h"

namespace asperity {

/// Remembers whether a point was inside a body's hull, and within how far from there no face is: until
/// it has moved further, the answer is the same.
///
/// What it answers is what TexturedBody::whereabouts answers, whatever was asked before.
///
/// Real-time: `is_in` does not allocate, lock or throw. One object serves one thread, and one body.
class HeldPoint final {
 public:
  /// In the mesh's own axes.
  bool is_in(const TexturedBody& body, const glm::dvec3& point_m) noexcept;

  /// How often all faces were visited.
  std::uint64_t visits() const noexcept { return visits_; }

 private:
  struct Known {
    glm::dvec3 point_m{0.0};
    Whereabouts there{};
  };
  std::optional<Known> known_{};
  std::uint64_t visits_ = 0;
};

}  // namespace asperity
