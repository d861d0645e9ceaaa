// Declares the geometry of one contact between two textured surfaces: the frame, the grid and the two patches.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The pose of a frame in another, in monogram notation: X_AB is the pose of frame B in frame A, and takes a point p with
/// the coordinates p_BP to p_AP = rotation·p_BP + position. Frames: W the world, A and B the meshes of the two bodies, L the
/// lattice of kept heights (CachedPenetration). A pose without another name is that of a body in the world, X_WA or X_WB.
struct Pose {
  glm::dmat3 rotation{1.0};
  glm::dvec3 position_m{0.0};
};

/// X_AC, the pose of C in A.
Pose operator*(const Pose& X_AB, const Pose& X_BC) noexcept;
/// p_AP, the point P in A.
glm::dvec3 operator*(const Pose& X_AB, const glm::dvec3& p_BP_m) noexcept;
/// X_BA, the pose of A in B.
Pose inverse(const Pose& X_AB) noexcept;

/// The axes of one contact, in the world. u, v and n are orthonormal and right-handed; n points from surface B towards
/// surface A, the direction in which A separates from B. The window of samples is centred on the origin, and torques
/// are about it.
struct ContactFrame {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 u{1.0, 0.0, 0.0};
  glm::dvec3 v{0.0, 1.0, 0.0};
  glm::dvec3 n{0.0, 0.0, 1.0};

  glm::dvec3 to_frame(const glm::dvec3& world) const noexcept;  ///< of a direction
  glm::dvec3 to_world(const glm::dvec3& frame) const noexcept;  ///< of a direction
};

/// A square window perpendicular to n, sampled at the centres of samples × samples equal cells.
struct SamplingGrid {
  double width_m = 0.0;
  int samples = 0;

  double spacing_m() const noexcept { return width_m / samples; }
  /// The coordinate of column or row i along u or v, from the window's centre.
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

/// Steeper faces are walls, which are not part of a height field along n, and are left out: |cosine| of the angle
/// between the face's normal and n, 88.9°.
inline constexpr double kSteepest_cosine = 0.02;

/// The amount by which a face is lowered for its inclination, by the cosine of the angle between its normal and n, in a
/// window of this width: zero if the cosine is `leaning_cosine` or more, half the window's width at three quarters of
/// that, and infinity at half of it, where the face is left out.
double sunk_m(double cosine, double leaning_cosine, double window_m) noexcept;

/// Throw std::invalid_argument with the problem: axes that are not orthonormal and right-handed to 1e-9; a window
/// without width or with fewer than two samples; a mesh whose lists do not match each other, an atlas without a texel
/// or with a number of values other than rows × columns, a number that is not finite; a pose that is not finite; a
/// triangle that the mesh does not have.
void require_sound(const ContactFrame& frame);
void require_sound(const SamplingGrid& grid);
void require_sound(const TexturedMesh& mesh);
void require_sound(const ContactPatch& patch);

}  // namespace asperity
