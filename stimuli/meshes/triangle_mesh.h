// A triangle mesh as it comes from a file: vertices and faces, nothing else.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace asperity {

/// Triangles over shared vertices.
///
/// Lengths in metres, in the mesh's own frame; a triangle's corners run counter-clockwise seen from
/// outside. Nothing is promised here of what a file held: see what checks and mends it.
struct TriangleMesh {
  std::vector<glm::dvec3> vertices_m{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};
};

}  // namespace asperity
