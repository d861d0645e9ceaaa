// Creates the folder, but not its parent.

#include "app/power/curve/power_files.h"

#include <stdexcept>

#include "results_schema/study_sharing.h"

namespace asperity {

void make_folder(const PowerFiles& files) {
  std::filesystem::path named = std::filesystem::absolute(files.folder).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();  // "FOLDER/"
  if (!std::filesystem::is_directory(named.parent_path())) {
    throw std::runtime_error("there is no folder " + named.parent_path().string() + " for " +
                             named.filename().string() +
                             "; create it first, or choose another --out");
  }
  make_folders(named);
}

}  // namespace asperity
