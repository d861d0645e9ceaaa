// Where two textured surfaces meet: the frame, the grid and the two patches of one contact.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// Where a body is: a point p of its mesh stands at rotation·p + position in the world.
struct Pose {
  glm::dmat3 rotation{1.0};
  glm::dvec3 position_m{0.0};
};

/// The axes of one contact, in the world. u, v and n are orthonormal and right-handed; n points from
/// surface B towards surface A, the way in which A leaves B. The window of samples is centred on the
/// origin, and torques are about it.
struct ContactFrame {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 u{1.0, 0.0, 0.0};
  glm::dvec3 v{0.0, 1.0, 0.0};
  glm::dvec3 n{0.0, 0.0, 1.0};

  glm::dvec3 to_frame(const glm::dvec3& world) const noexcept;  ///< of a direction
  glm::dvec3 to_world(const glm::dvec3& frame) const noexcept;  ///< of a direction
};

/// A square window across n, sampled at the centres of samples × samples equal cells.
struct SamplingGrid {
  double width_m = 0.0;
  int samples = 0;

  double spacing_m() const noexcept { return width_m / samples; }
  /// Where column or row i stands along u or v, from the window's centre.
  double place_m(int i) const noexcept { return (i - 0.5 * (samples - 1)) * spacing_m(); }
  bool is_outermost(int row, int column) const noexcept {
    return row == 0 || column == 0 || row == samples - 1 || column == samples - 1;
  }
};

/// The triangles of a body that take part in a contact.
struct ContactPatch {
  const TexturedMesh& mesh;
  std::span<const std::uint32_t> triangles{};
  Pose pose{};
};

/// A face that turns further away from n than this is a wall, no part of a height field along n,
/// and is left out: |cosine| of the angle between its plane's normal and n, 88.9°.
inline constexpr double kSteepest_cosine = 0.02;

/// How much lower than it is a face counts, by the cosine of the angle between its normal and n, in a window
/// that is so wide: by nothing where the cosine is `leaning_cosine` or more, by half the window's width
/// at three quarters of that, and infinitely at half of it, where it is left out.
double sunk_m(double cosine, double leaning_cosine, double window_m) noexcept;

/// Throw std::invalid_argument with what is wrong: axes that are not orthonormal and right-handed to
/// 1e-9; a window without width or with fewer than two samples; a mesh whose lists do not fit each
/// other, an atlas without a texel or with other than rows × columns values, a number that is not
/// finite; a pose that is not; a triangle that the mesh does not have.
void require_sound(const ContactFrame& frame);
void require_sound(const SamplingGrid& grid);
void require_sound(const TexturedMesh& mesh);
void require_sound(const ContactPatch& patch);

}  // namespace asperity
