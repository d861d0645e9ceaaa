// Mesh files of other programs: OBJ, PLY, STL and OFF.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

enum class MeshFormat { obj, ply_ascii, ply_binary, stl_ascii, stl_binary, off };

/// "OBJ", "binary STL", …
const char* name_of(MeshFormat format);

/// How a file is to be taken.
struct MeshReading {
  /// What one unit of the file is long; none of the formats says it. A millimetre is what CAD and
  /// printing mean when they say nothing.
  double unit_m = 0.001;
  /// Above this many a file is refused: simplifying takes about 500 bytes for each.
  std::size_t most_triangles = 5'000'000;
};

struct ReadMesh {
  TriangleMesh mesh{};
  MeshFormat format = MeshFormat::obj;
  /// What was found that is not simply triangles, in sentences.
  std::vector<std::string> notes{};
};

/// The triangles of a file, as they stand there: nothing is welded, mended or left out.
///
/// The format is told by the content, whatever the file is called. Polygons are divided into fans
/// about their first corner, triangle strips of PLY into triangles. Coordinates keep all the
/// precision that the file has. Colours, normals, texture coordinates, lines, points and unknown
/// elements are ignored. Every index is that of a vertex; coordinates may be anything, NaN included.
///
/// Errors: std::invalid_argument, a sentence that begins with `name` and names the line or the
/// element: an unknown format, a number that is none, an index without its vertex, a file that ends
/// too early, one without vertices or faces, too many triangles, a unit that is not positive.
ReadMesh decode_mesh(std::span<const std::byte> bytes, const MeshReading& reading,
                     const std::string& name);

}  // namespace asperity
