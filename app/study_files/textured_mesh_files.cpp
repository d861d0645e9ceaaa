// Decodes the file with the checksum of its content, and writes it atomically.

#include "app/study_files/textured_mesh_files.h"

#include <span>
#include <utility>

#include "app/study_files/program.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

LoadedTexturedMesh load_textured_mesh(const std::filesystem::path& file) {
  const std::string content = read_file(file, kMeshFile);
  return {std::make_shared<const StoredTexturedMesh>(decode_textured_mesh(
              std::as_bytes(std::span(content.data(), content.size())), file.string())),
          sha256_of(content)};
}

void save_textured_mesh(const std::filesystem::path& file, StoredTexturedMesh stored,
                        Overwrite overwrite) {
  stored.provenance.program_version = version_line();
  write_file(file, encode_textured_mesh(stored), overwrite);
}

}  // namespace asperity
