// Reads mesh files of other programs: OBJ, PLY, STL and OFF.

#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "stimuli/meshes/read_mesh.h"

namespace asperity {

/// The triangles of a file, unchanged: nothing is welded, repaired or left out.
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
