// A folder that lives as long as a test.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <stdlib.h>

namespace asperity {

/// A new, empty folder that is removed with the object, with all that is in it.
///
/// It is in memory where the machine offers that: syncing to a disk is what a study does most, and in
/// memory the tests take a tenth of the time.
class TemporaryFolder final {
 public:
  TemporaryFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto place =
        ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
    std::string name = (place / "asperity-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_{};
};

}  // namespace asperity
