// Looks after every renaming whether a path is still there, and takes flags away from renamings.

#pragma once

#include <filesystem>

namespace asperity {

/// While it lives, every call of rename(2) and renameat2(2) in this process is made, and followed by a look at `path`:
/// what a program leaves that is killed right then. One at a time.
class RenameWatch final {
 public:
  explicit RenameWatch(const std::filesystem::path& path);
  ~RenameWatch();
  RenameWatch(const RenameWatch&) = delete;
  RenameWatch& operator=(const RenameWatch&) = delete;

  int renamings() const;
  int times_missing() const;
};

/// While it lives, renameat2(2) with flags fails as on a file system without them (FAT on a stick): EINVAL. One at a time.
class RenameWithoutFlags final {
 public:
  RenameWithoutFlags();
  ~RenameWithoutFlags();
  RenameWithoutFlags(const RenameWithoutFlags&) = delete;
  RenameWithoutFlags& operator=(const RenameWithoutFlags&) = delete;
};

}  // namespace asperity
