// From the triangles of a file to the surface of closed bodies, with all that was done said.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// How far a repair may go. A mesh's diagonal is that of its bounding box.
struct MeshRepairLimits {
  /// A wider opening is refused. Not given: a tenth of the diagonal.
  std::optional<double> widest_hole_m{};
  /// A part whose diagonal is below this fraction of the whole's is debris.
  double smallest_part = 0.01;
};

/// What was found in a mesh, and what was done about it.
struct MeshFindings {
  std::size_t triangles_in = 0;
  double diagonal_m = 0.0;
  std::size_t vertices_welded = 0;     ///< had the coordinates of an earlier one
  std::size_t degenerate_faces = 0;    ///< left out: two corners in one place
  std::size_t duplicate_faces = 0;     ///< left out: the corners of an earlier one
  std::size_t non_manifold_edges = 0;  ///< of more than two faces, taken apart
  std::size_t vertices_split = 0;  ///< where surfaces met in nothing but a point or such an edge
  std::size_t edges_divided = 0;   ///< had the ends of another one, and got a middle
  std::size_t faces_turned = 0;    ///< ran against their neighbours
  std::size_t holes_filled = 0;
  double widest_hole_m = 0.0;
  std::size_t debris_parts = 0;      ///< left out: smaller than the limit
  std::size_t flat_parts = 0;        ///< left out: enclose nothing
  std::size_t dropped_faces = 0;     ///< of both
  std::size_t inside_out_parts = 0;  ///< turned
  std::size_t cavities = 0;          ///< parts that lie within another, and face inward
  std::size_t parts = 0;             ///< that are left
};

struct RepairedMesh {
  TriangleMesh mesh{};
  MeshFindings found{};
};

/// The mesh as the surface of closed bodies: every edge has two faces that run through it in
/// opposite directions, the faces at each vertex are one fan, every part encloses a volume and
/// faces outward (a cavity: into its hollow), no vertex is without a face.
///
/// Vertices with the very same coordinates become one. At an edge of several faces those are paired
/// that have the body between them, and the rest is taken apart. A hole is closed by a fan about the
/// middle of its border. Faces of no area between three different points stay, since they hold the
/// surface together. Passing through itself is not looked for: such a surface stays as it lies.
///
/// The result depends on the input only: order of vertices and faces is kept.
///
/// Errors: std::invalid_argument, a sentence that begins with `name`: a coordinate that is not
/// finite, a diagonal outside 0.1 mm to 10 m, a surface of one side only, an opening wider than the
/// limit, nothing that encloses a volume; a limit for holes that is no length.
RepairedMesh repair_mesh(TriangleMesh mesh, const MeshRepairLimits& limits,
                         const std::string& name);

/// What was found and done, one sentence each; empty for a mesh that needed nothing.
std::vector<std::string> sentences_of(const MeshFindings& found);

}  // namespace asperity
