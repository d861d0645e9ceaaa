// Fewer triangles for a mesh.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// What `decimate_mesh` makes.
struct SimplifiedMesh {
  TriangleMesh mesh{};
  std::size_t handles_cut = 0;
  double widest_handle_m = 0.0;  ///< the longest way around one that was cut
};

/// A mesh of at most `triangles` triangles that lies close to the given one.
///
/// Edges are collapsed one after the other into one of their ends, the cheapest first. What a
/// collapse costs is measured where the given mesh was: every vertex of it, weighted with its area,
/// is a sample of the surface (of more than 32 about a vertex every second one, for two), and the
/// squared distances of the samples about the vertex that goes from the faces that stay are summed;
/// to these are added a tenth of the quadric error [Garland 1997] (the squared distances of the
/// place that stays from the planes of all faces that were merged into it), which tells how smooth
/// surfaces bend where no sample lies, and a millionth of the fourth power of the edge's length,
/// which decides where all is flat. Quadrics alone cut corners off rough bodies: over a few
/// wavelengths the planes of a relief are further from the surface than the corner was.
///
/// A collapse is not done that would turn a remaining face by more than 60°, or by 84° from what
/// one of its corners looked like in the given mesh, or leave a needle. All that can go without
/// taking a sample further than a thousandth of the body's size from the surface goes first; when
/// that is not enough, needles and turns up to 90° are permitted, then the same again for twice the
/// distance, and so on. Only a target that cannot be reached at any distance is tried with flips
/// alone forbidden. Every vertex is one of the given mesh; a closed mesh stays closed, and each
/// part keeps four faces at least.
///
/// Handles and tunnels around which the way is shorter than the side of a face of the result are cut
/// (cut_narrow_handles): a scan has many that are no part of the thing, each would keep a dozen faces, and
/// none could be felt. Others stay.
///
/// `mesh` is what repair_mesh returns. The same mesh gives the same result.
/// `progress` is told the fraction that is done, from this thread.
///
/// Errors: std::invalid_argument, a sentence that begins with `name`: a target below four or above
/// what the mesh has, or one that cannot be reached (with what can be).
///
/// [Garland 1997] Garland, Heckbert: Surface simplification using quadric error metrics.
SimplifiedMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles,
                             const std::string& name,
                             const std::function<void(double)>& progress = {});

/// That handles were cut; nothing where none were.
std::optional<std::string> sentence_of(const SimplifiedMesh& simplified);

}  // namespace asperity
