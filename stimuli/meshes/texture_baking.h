// Declares the conversion of a mesh's detail to the haptic texture of a simpler mesh.

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
  /// Texels per shortest wavelength of the original, which is two edges, each with the length of an edge in an
  /// equilateral triangle of the same area.
  double samples_per_wavelength = 8.0;
  /// The texture is coarser if it would exceed this number.
  std::size_t most_texels = std::size_t{1} << 25;
  /// The number of points of the original at which the error is measured.
  std::size_t error_samples = 200'000;
};

/// The result of a baking, in numbers.
struct BakeReport {
  std::size_t samples = 0;  ///< ray origins: texels with a separate displacement
  std::size_t missed = 0;   ///< of these, rays without a hit, filled from their neighbours
  double samples_per_wavelength = 0.0;  ///< of the coarsest face
  double finest_pitch_m = 0.0;
  double coarsest_pitch_m = 0.0;
  /// Faces on which an interpolated normal points inward, at a fold that is smaller than a face.
  std::size_t folded_faces = 0;
  GeometricError plain{};     ///< of the simplified mesh alone
  GeometricError textured{};  ///< with its texture
};

/// A warning about a texture that makes the mesh worse than without it; nullopt if there is no problem.
std::optional<std::string> warning_of(const BakeReport& report);

struct BakedMesh {
  TexturedMesh mesh{};
  BakeReport report{};
};

/// Displaces `simplified` to the surface of `original`.
///
/// From every texel of every face a ray is traced in both directions along the interpolated normal. The nearer
/// intersection with a front of the original is used, up to twice the local distance of the two surfaces. Each face has
/// a separate patch of the atlas, a right triangle with n = 2ᵏ texels along each side; n is chosen from the triangles
/// of the original under the face, by the finer ones. An edge's texels are computed once for both its faces, with the n
/// of the coarser one, and the finer one interpolates linearly between them; the texel beyond a hypotenuse is set so
/// that its cell is planar. The displacement along an edge is therefore the same on both sides within one step of the
/// atlas.
///
/// Both meshes are closed and have the same frame. The result depends on the meshes and settings, not on `workers`.
///
/// Errors: std::invalid_argument for meshes without triangles.
BakedMesh bake_texture(const TriangleMesh& original, const TriangleMesh& simplified,
                       const BakeSettings& settings, const Workers& workers);

}  // namespace asperity
