// Declares a low-resolution mesh with its haptic texture: the detail of the original as displacements.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// Stores displacements in an atlas of texels: `value * step_m`, row by row.
///
/// A texel's value is located at its centre, (column, row) in texels; between centres the displacement is bilinear.
struct DisplacementAtlas {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double step_m = 0.0;  ///< displacement of one count
  std::vector<std::int16_t> values{};
};

/// Stores a closed low-resolution mesh whose surface is displaced along its normals (a "haptic texture" [Otaduy 2004]).
///
/// The point with barycentric coordinates b of a triangle is Σ bᵢ pᵢ + d(Σ bᵢ tᵢ) Σ bᵢ nᵢ, with its corners pᵢ, their
/// normals nᵢ (unit length; the sum is not normalised) and their texture coordinates tᵢ in the atlas. Normals belong to
/// vertices and are shared by neighbouring faces, so that the displaced surface has no gaps along edges; the texels of
/// both faces at an edge contain the same displacements.
///
/// Lengths in metres, in the mesh's own frame; corners are counter-clockwise as seen from outside.
struct TexturedMesh {
  std::vector<glm::dvec3> vertices_m{};
  std::vector<glm::dvec3> normals{};  ///< of the vertices, unit length, outward
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  /// The texture coordinates of each triangle's corners, in texels of the atlas. Every face has a margin of at least
  /// one texel that continues it, so that bilinear interpolation never includes a neighbouring patch.
  std::vector<std::array<glm::dvec2, 3>> places{};
  DisplacementAtlas atlas{};
};

}  // namespace asperity
