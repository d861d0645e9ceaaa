// The result of reading a mesh file, and the settings of the reading.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

enum class MeshFormat { obj, ply_ascii, ply_binary, stl_ascii, stl_binary, off };

/// "OBJ", "binary STL", …
const char* name_of(MeshFormat format);

/// How a file is read.
struct MeshReading {
  /// The length of one unit of the file, which no format states. Files from CAD and for printing usually have
  /// millimetres.
  double unit_m = 0.001;
  /// Files with more are refused: simplification takes about 500 bytes per triangle.
  std::size_t most_triangles = 5'000'000;
};

struct ReadMesh {
  TriangleMesh mesh{};
  MeshFormat format = MeshFormat::obj;
  /// Sentences on everything that was not simply triangles.
  std::vector<std::string> notes{};
};

}  // namespace asperity
