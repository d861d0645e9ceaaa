// A disk that fails when told to: SQLite's own file system with one write or sync going wrong, with a program that is
// killed before it, or with a read that ends short.

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
  /// The next `count` reads of more than 64 KiB end short, as of a file that another process truncates: SQLite's own reads
  /// are of a page or less.
  void shorten_large_reads(int count) { large_reads_to_shorten_ = count; }
  int large_reads_to_shorten() const { return large_reads_to_shorten_; }
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
  int large_reads_to_shorten_ = 0;
  Fault fault_ = Fault::disk_full;
};

}  // namespace asperity
