// Declares the removal of narrow handles of a closed surface, which are frequent artefacts of scans.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// The number of handles (equivalently, tunnels) of the surface, all parts together: its genus. A sphere has none, a
/// torus has one.
std::size_t handles_of(const TriangleMesh& mesh);

/// The result of `cut_narrow_handles`.
struct HandleCuts {
  std::size_t handles = 0;
  double widest_m = 0.0;  ///< the greatest circumference of a handle that was cut
  /// For each vertex appended at the end, the vertex of which it is a copy.
  std::vector<std::uint32_t> copies{};
};

/// Cuts handles along three edges that do not form a face, the shortest path first, and closes both ends with one face
/// each, at the same position. A handle is cut only if the path along the three edges is shorter than `widest_m` and
/// the part does not fall into two. Faces keep their indices; two are added per cut.
///
/// `mesh` is a result of repair_mesh or a simplification of one; it remains closed. The same mesh gives the same
/// result.
HandleCuts cut_narrow_handles(TriangleMesh& mesh, double widest_m);

}  // namespace asperity
