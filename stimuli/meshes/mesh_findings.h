// The defects that were found and repaired in a mesh, and the limits of a repair.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The limits of a repair. The diagonal of a mesh is that of its bounding box.
struct MeshRepairLimits {
  /// Wider openings are refused. Default: a tenth of the diagonal.
  std::optional<double> widest_hole_m{};
  /// A part whose diagonal is below this fraction of that of the mesh is debris.
  double smallest_part = 0.01;
};

/// The defects of a mesh and their repairs.
struct MeshFindings {
  std::size_t triangles_in = 0;
  double diagonal_m = 0.0;
  std::size_t vertices_welded = 0;     ///< had the coordinates of an earlier vertex
  std::size_t degenerate_faces = 0;    ///< left out: two corners with the same coordinates
  std::size_t duplicate_faces = 0;     ///< left out: the corners of an earlier face
  std::size_t non_manifold_edges = 0;  ///< of more than two faces, separated
  std::size_t vertices_split = 0;      ///< where surfaces met only in a point or at such an edge
  std::size_t edges_divided = 0;  ///< had the ends of another edge, and got a vertex in the middle
  std::size_t faces_turned = 0;   ///< orientation differed from that of their neighbours
  std::size_t holes_filled = 0;
  double widest_hole_m = 0.0;
  std::size_t debris_parts = 0;      ///< left out: smaller than the limit
  std::size_t flat_parts = 0;        ///< left out: without a volume
  std::size_t dropped_faces = 0;     ///< of both
  std::size_t inside_out_parts = 0;  ///< turned
  std::size_t cavities = 0;          ///< parts within another part, which face inwards
  std::size_t parts = 0;             ///< in the result
};

/// The repairs, a sentence each; empty for a mesh that needed none.
std::vector<std::string> sentences_of(const MeshFindings& found);

/// A length as text, rounded to micrometres: "1.25 mm".
std::string millimetres(double length_m);

}  // namespace asperity
