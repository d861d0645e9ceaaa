// Handles of a closed surface that are too narrow to be kept, as scans have them where they guessed.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// How many handles (or tunnels, which are the same) the surface has, all parts together: its genus.
/// A ball has none, a ring one.
std::size_t handles_of(const TriangleMesh& mesh);

/// What `cut_narrow_handles` did.
struct HandleCuts {
  std::size_t handles = 0;
  double widest_m = 0.0;  ///< the longest way around one
  /// Which vertex each of those is a copy of that were added at the end.
  std::vector<std::uint32_t> copies{};
};

/// Cuts handles along three edges that are not a face, the shortest first, and closes both ends with
/// a face each: the two ends lie in the same place. Only where the way along the three edges is
/// shorter than `widest_m`, and never so that a part falls into two. Faces keep their places, two are
/// added for each cut.
///
/// `mesh` is what repair_mesh returns, or was simplified from it; it stays closed. The same mesh gives the same
/// result.
HandleCuts cut_narrow_handles(TriangleMesh& mesh, double widest_m);

}  // namespace asperity
