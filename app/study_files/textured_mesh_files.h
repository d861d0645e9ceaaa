// Reads and writes textured meshes.

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "results_schema/files/atomic_file.h"
#include "stimuli/meshes/textured_mesh_file.h"

namespace asperity {

/// A textured mesh with the hash of its content.
struct LoadedTexturedMesh {
  std::shared_ptr<const StoredTexturedMesh> stored{};
  std::string sha256{};  ///< of the file
};

/// Errors: ResultsError or std::invalid_argument, naming the file.
LoadedTexturedMesh load_textured_mesh(const std::filesystem::path& file);

/// The program's version is added to the provenance.
void save_textured_mesh(const std::filesystem::path& file, StoredTexturedMesh stored,
                        Overwrite overwrite);

}  // namespace asperity
