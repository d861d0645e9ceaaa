// Fewer triangles for a mesh.

#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "stimuli/triangle_mesh.h"

namespace asperity {

/// A mesh of at most `triangles` triangles that lies close to the given one.
///
/// Edges are collapsed one after the other into one of their ends, the cheapest first. What a
/// collapse costs is the quadric error [Garland 1997]: the squared distances of the place that stays
/// from the planes of all faces that were merged into it, each weighted with its area, plus a
/// millionth of the fourth power of the edge's length, which decides where all is flat. A collapse is not done that would turn a remaining face by more than 60°, or
/// away from what one of its corners looked like in the given mesh, or leave a needle; when the
/// target cannot be reached so, only flips are still forbidden. Every vertex
/// is one of the given mesh; a closed mesh stays closed, and each part keeps four faces at least.
///
/// `mesh` is what repair_mesh returns. The same mesh gives the same result.
/// `progress` is told the fraction that is done, from this thread.
///
/// Errors: std::invalid_argument, a sentence that begins with `name`: a target below four or above
/// what the mesh has, or one that cannot be reached (with what can be).
///
/// [Garland 1997] Garland, Heckbert: Surface simplification using quadric error metrics.
TriangleMesh decimate_mesh(const TriangleMesh& mesh, std::size_t triangles, const std::string& name,
                           const std::function<void(double)>& progress = {});

}  // namespace asperity
