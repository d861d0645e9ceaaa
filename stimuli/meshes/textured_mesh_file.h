// Declares the file format of a textured mesh.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "stimuli/meshes/mesh_error.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The origin of a textured mesh; stored with it, so that it can be reproduced.
struct TexturedMeshProvenance {
  std::string source_name{};    ///< the original's file name
  std::string source_sha256{};  ///< of that file
  double source_unit_m = 0.0;
  std::size_t source_triangles = 0;
  std::vector<std::string> findings{};  ///< problems of the original and their repairs
  std::string program_version{};
};

struct StoredTexturedMesh {
  TexturedMesh mesh{};
  GeometricError plain{};     ///< of the mesh without its texture, against the original
  GeometricError textured{};  ///< with it
  TexturedMeshProvenance provenance{};
};

/// Encodes the file (docs/formats/textured_mesh.md). All numbers are preserved exactly.
std::vector<std::byte> encode_textured_mesh(const StoredTexturedMesh& stored);

/// Errors: std::invalid_argument with a sentence that begins with `name`: another format or version, truncated, damaged
/// (the SHA-256 differs), or contents that are invalid for a textured mesh.
StoredTexturedMesh decode_textured_mesh(std::span<const std::byte> bytes, const std::string& name);

}  // namespace asperity
