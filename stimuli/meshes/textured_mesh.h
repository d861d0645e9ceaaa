// A low-resolution mesh and its haptic texture: the detail of the original as displacements.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// Displacements in an atlas of texels: `value * step_m`, row after row.
///
/// A texel's value stands at its centre, (column, row) in texels; between centres it is bilinear.
struct DisplacementAtlas {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double step_m = 0.0;  ///< what one count displaces
  std::vector<std::int16_t> values{};
};

/// A low-resolution closed mesh whose surface is displaced along its normals (Otaduy and Lin 2004:
/// "haptic texture").
///
/// The point with barycentric coordinates b of a triangle lies at Σ bᵢ pᵢ + d(Σ bᵢ tᵢ) Σ bᵢ nᵢ, with
/// its corners pᵢ, their normals nᵢ (unit length; the sum is not made one again) and their places tᵢ
/// in the atlas. Normals belong to vertices and neighbours share them, so that the displaced surface
/// does not open along an edge; the texels of both faces at an edge hold the same displacements.
///
/// Lengths in metres, in the mesh's own frame; corners run counter-clockwise seen from outside.
struct TexturedMesh {
  std::vector<glm::dvec3> vertices_m{};
  std::vector<glm::dvec3> normals{};  ///< of the vertices, unit length, outward
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  /// Of each triangle's corners, in texels of the atlas. Every face has a margin of at least one
  /// texel around it that continues it, so that a bilinear look-up never meets a neighbour's.
  std::vector<std::array<glm::dvec2, 3>> places{};
  DisplacementAtlas atlas{};
};

}  // namespace asperity
