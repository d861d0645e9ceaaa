// Reads mesh files of other programs: OBJ, PLY, STL and OFF.

#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "stimuli/meshes/read_mesh.h"

namespace asperity {

/// The triangles of a file, unchanged: nothing is welded, repaired or left out.
///
/// The format is determined from the content, independent of the file's name. Polygons are divided into fans about
/// their first corner, triangle strips of PLY into triangles. Coordinates keep the full precision of the file. Colours,
/// normals, texture coordinates, lines, points and unknown elements are ignored. Every index has a vertex; coordinates
/// may have any value, including NaN.
///
/// Errors: std::invalid_argument with a sentence that begins with `name` and contains the line or the element: an
/// unknown format, an invalid number, an index without a vertex, a file that ends too early, one without vertices or
/// faces, too many triangles, a unit that is not positive.
ReadMesh decode_mesh(std::span<const std::byte> bytes, const MeshReading& reading,
                     const std::string& name);

}  // namespace asperity
