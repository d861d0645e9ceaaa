// Declares the cached test whether a point is inside a body, which rarely visits all faces.

#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/contact/textured_body.h"

namespace asperity {

/// Caches whether a point was inside a body's hull, and the radius around the point without faces: within this radius
/// the result is unchanged.
///
/// The result equals that of TexturedBody::whereabouts, independent of previous calls.
///
/// Real-time: `is_in` does not allocate, lock or throw. One object serves one thread, and one body.
class HeldPoint final {
 public:
  /// In the mesh's own axes.
  bool is_in(const TexturedBody& body, const glm::dvec3& point_m) noexcept;

  /// The number of complete visits of all faces.
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
