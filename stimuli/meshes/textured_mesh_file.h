// A textured mesh as one file.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "stimuli/meshes/mesh_error.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// How a textured mesh came about; stored with it, so that it can be made again.
struct TexturedMeshProvenance {
  std::string source_name{};    ///< the original's file name
  std::string source_sha256{};  ///< of that file
  double source_unit_m = 0.0;
  std::size_t source_triangles = 0;
  std::vector<std::string> findings{};  ///< what was found in the original and done about it
  std::string program_version{};
};

struct StoredTexturedMesh {
  TexturedMesh mesh{};
  GeometricError plain{};     ///< of the mesh without its texture, against the original
  GeometricError textured{};  ///< with it
  TexturedMeshProvenance provenance{};
};

/// The bytes of the file (docs/formats/textured_mesh.md). All numbers come back as they are.
std::vector<std::byte> encode_textured_mesh(const StoredTexturedMesh& stored);

/// Errors: std::invalid_argument, a sentence that begins with `name`: not this format or another
/// version, cut off, damaged (the SHA-256 differs), or saying something that no textured mesh can be.
StoredTexturedMesh decode_textured_mesh(std::span<const std::byte> bytes, const std::string& name);

}  // namespace asperity
