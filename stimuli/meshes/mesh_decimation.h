// Declares the reduction of a mesh's triangles.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "stimuli/meshes/side_by_side.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// The result of `decimate_mesh`.
struct SimplifiedMesh {
  TriangleMesh mesh{};
  std::size_t handles_cut = 0;
  double widest_handle_m = 0.0;  ///< the greatest circumference of a handle that was cut
};

/// Simplifies a mesh to at most `triangles` triangles that lie close to the given surface.
///
/// Edges are collapsed into one of their ends, in order of cost. The costs of many collapses are computed at a time
/// (batches.h), so the order is not strict: among the cheapest 1/64 of the vertices, those are removed whose neighbours
/// were not removed immediately before. The cost is measured on the given surface:
/// every vertex of the given mesh, weighted with its area, is a sample of the surface (if a vertex has more than 32
/// samples, every second one is kept, with double weight). The cost is the sum of the squared distances of the removed
/// vertex's samples from the remaining faces, plus a tenth of the quadric error [Garland 1997] (the squared distances
/// of the remaining position from the planes of all faces that were merged into it), which represents the curvature of
/// smooth surfaces between samples, plus a millionth of the fourth power of the edge's length, which decides where the
/// surface is flat. Quadrics alone cut corners off rough bodies: over a few wavelengths the planes of a relief deviate
/// more from the surface than the corner does.
///
/// A collapse is rejected if it would rotate a remaining face by more than 60°, or by more than 84° from the normal of
/// one of its corners in the given mesh, or create a needle. The collapses that move no sample further than a
/// thousandth of the body's size from the surface come first. If they are not sufficient, needles and rotations up to
/// 90° are permitted, then the same is repeated for twice the distance, and so on. Only if a target cannot be reached
/// at any distance is it tried with flips as the only restriction. Every vertex is one of the given mesh; a closed mesh
/// remains closed, and each part keeps at least four faces.
///
/// Handles and tunnels with a circumference below the side of a face of the result are cut (cut_narrow_handles): a scan
/// has many that are artefacts, each would need a dozen faces, and none could be felt. Other handles remain.
///
/// `mesh` is a result of repair_mesh. The same mesh gives the same result, bit for bit, with any number of
/// `workers.jobs`. `workers.progress` is called with the completed fraction, from the calling thread; it can throw, which
/// ends the simplification.
///
/// Errors: std::invalid_argument with a sentence that begins with `name`: a target below four or above the number of
/// triangles of the mesh, or one that cannot be reached (with the number that can); a mesh that is not closed.
///
/// [Garland 1997] Garland, Heckbert: Surface simplification using quadric error metrics.
SimplifiedMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles,
                             const std::string& name, const Workers& workers = {});

/// A sentence about the handles that were cut; nullopt if there are none.
std::optional<std::string> sentence_of(const SimplifiedMesh& simplified);

}  // namespace asperity
