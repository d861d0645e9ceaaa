// A folder for temporary files of one computation.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// A new folder that no other process has, removed with what is in it.
class WorkFolder final {
 public:
  /// In the folder of the system for temporary files (TMPDIR, or /tmp). Studies are simulated in it: sessions cannot be stored on a
  /// network file system. `purpose` is a part of its name: "shard".
  ///
  /// Errors: std::runtime_error naming the folder for temporary files, where none can be made in it.
  explicit WorkFolder(std::string_view purpose);
  /// In `place`, with a name that begins with `beginning`; `remedy` completes the error.
  ///
  /// Errors: std::runtime_error naming `place`.
  WorkFolder(const std::filesystem::path& place, const std::string& beginning,
             const std::string& remedy);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_{};
};

}  // namespace asperity
