// The detail of a mesh as the haptic texture of a simpler one.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "stimuli/meshes/mesh_error.h"
#include "stimuli/meshes/side_by_side.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

struct BakeSettings {
  /// Texels per shortest wavelength of the original: two edges, each as long as in a triangle with equal
  /// sides and the area of those that are there.
  double samples_per_wavelength = 8.0;
  /// The texture gets coarser where it would take more.
  std::size_t most_texels = std::size_t{1} << 25;
  /// Points of the original at which the error is measured.
  std::size_t error_samples = 200'000;
};

/// What came of it.
struct BakeReport {
  std::size_t samples = 0;  ///< rays' origins: texels that hold a displacement of their own
  std::size_t missed = 0;   ///< of these, where the ray met nothing and neighbours were continued
  double samples_per_wavelength = 0.0;  ///< reached by the coarsest face
  double finest_pitch_m = 0.0;
  double coarsest_pitch_m = 0.0;
  /// Faces on which an interpolated normal points inward, at a fold finer than a face.
  std::size_t folded_faces = 0;
  GeometricError plain{};     ///< of the simplified mesh alone
  GeometricError textured{};  ///< with its texture
};

/// What has to be said of a texture that makes the mesh worse than it is without; nothing otherwise.
std::optional<std::string> warning_of(const BakeReport& report);

struct BakedMesh {
  TexturedMesh mesh{};
  BakeReport report{};
};

/// Displaces `simplified` to where `original` lies.
///
/// From every texel of every face a ray goes both ways along the interpolated normal. The nearer
/// meeting with a front of the original counts, up to twice as far as the two surfaces lie apart
/// thereabouts. Each face has a patch of the atlas of its own, a right triangle with n = 2ᵏ texels along each
/// side; n follows from the triangles of the original that the face lies over, the finer ones of them. An edge's texels are
/// computed once for both its faces, with the n of the coarser one, and the finer one reads straight
/// lines between them; the texel beyond a hypotenuse is set so that its cell is flat. So the
/// displacement along an edge is the same on both sides within one step of the atlas.
///
/// Both meshes are closed and lie in the same frame. The result depends on the meshes and settings,
/// not on `workers`.
///
/// Errors: std::invalid_argument for meshes without triangles.
BakedMesh bake_texture(const TriangleMesh& original, const TriangleMesh& simplified,
                       const BakeSettings& settings, const Workers& workers);

}  // namespace asperity
