// Notes which files and folders a program has synced.

#pragma once

#include <filesystem>
#include <set>

namespace asperity {

/// While it lives, every call of fsync(2) and fdatasync(2) in this process, SQLite's included, is noted, and made. One at a time.
class SyncWatch final {
 public:
  SyncWatch();
  ~SyncWatch();
  SyncWatch(const SyncWatch&) = delete;
  SyncWatch& operator=(const SyncWatch&) = delete;

  /// By the names that they had when they were synced.
  std::set<std::filesystem::path> synced() const;
};

}  // namespace asperity
