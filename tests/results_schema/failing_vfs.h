// A disk that fails when told to: SQLite's own file system with one write or sync going wrong, or with a program that is
// killed before it.

#pragma once

#include <vector>

#include <sqlite3.h>

namespace asperity {

/// While it lives every database that is opened uses it.
class FailingVfs final {
 public:
  enum class Fault { disk_full, broken_disk, killed };

  FailingVfs();
  ~FailingVfs();
  FailingVfs(const FailingVfs&) = delete;
  FailingVfs& operator=(const FailingVfs&) = delete;

  /// The `n`-th write, sync or truncation from now on fails, and, as on a disk that is full, all
  /// after it, until `heal`. With `killed` this process ends instead, as by kill -9.
  void fail_from(int n, Fault fault);
  void heal();
  /// Whether the failure has happened.
  bool has_failed() const { return has_failed_; }
  /// Whether it was a sync that failed first: then what it should have secured is written all the
  /// same.
  bool has_failed_in_sync() const { return has_failed_in_sync_; }

 private:
  struct File;
  struct Methods;

  int next_operation();

  sqlite3_vfs* real_ = nullptr;
  sqlite3_vfs vfs_{};
  int operations_left_ = -1;  ///< negative: healthy
  bool has_failed_ = false;
  bool has_failed_in_sync_ = false;
  Fault fault_ = Fault::disk_full;
};

}  // namespace asperity
