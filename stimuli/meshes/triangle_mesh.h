// Declares a triangle mesh as read from a file: vertices and faces only.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace asperity {

/// Stores triangles over shared vertices.
///
/// Lengths in metres, in the mesh's own frame; a triangle's corners are counter-clockwise as seen from outside. The
/// contents of a file are not checked here: repair_mesh checks and repairs them.
struct TriangleMesh {
  std::vector<glm::dvec3> vertices_m{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};
};

}  // namespace asperity
