// Creates the folder by mkdtemp in the temporary folder or at a place, and removes it in the destructor.

#include "app/tasks/work_folder.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace asperity {

namespace {

/// TMPDIR, or /tmp.
std::filesystem::path folder_for_temporary_files() {
  std::error_code error{};
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* const stated = std::getenv("TMPDIR");
  throw std::runtime_error("the folder for temporary files, " +
                           std::string(stated == nullptr ? "/tmp" : stated) + ", cannot be used (" +
                           error.message() + "); set TMPDIR to a folder that you may write to");
}

}  // namespace

WorkFolder::WorkFolder(std::string_view purpose)
    : WorkFolder(folder_for_temporary_files(), "asperity-" + std::string(purpose) + "-",
                 "set TMPDIR to a folder that you may write to") {}

WorkFolder::WorkFolder(const std::filesystem::path& place, const std::string& beginning,
                       const std::string& remedy) {
  std::string name = (place / (beginning + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) {
    const std::string reason = std::generic_category().message(errno);
    throw std::runtime_error("no folder can be made in " + place.string() + " (" + reason + "); " +
                             remedy);
  }
  path_ = name;
}

WorkFolder::~WorkFolder() {
  std::error_code left{};
  std::filesystem::remove_all(path_, left);
}

}  // namespace asperity
