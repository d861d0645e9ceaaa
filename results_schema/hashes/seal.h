// The checksum of a study's whole database file, while no program writes to it. Used in this folder only.

#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>

#include "results_schema/sqlite.h"

namespace asperity {

/// How `study.sqlite` stands to the SHA-256 that the last writer left beside it, in
/// `study.sqlite.sha256` (what `sha256sum` writes and checks).
///
/// Constraints and SQLite's own check see a page's structure, not a digit of a number, and nothing
/// of what is free in a page. The checksum sees every byte.
enum class Seal {
  absent,  ///< no checksum that can be read: a program died, wrote with other tools, or writes now
  in_use,  ///< what was written last is still in the log
  holds,
  broken,
  not_read,  ///< it was asked to stop
};

/// For a caller that waits while a large file is read.
struct SealWatch {
  std::function<void(double)> progress{};  ///< called with 0 to 1
  std::stop_token stop{};
};

/// Reads the file through SQLite: a descriptor of our own would, when closed, take the locks of
/// this process's other connections with it. Errors: ResultsError.
Seal seal_of(const std::filesystem::path& study, const SealWatch& watch = {});

/// Whether there is a checksum that vouches for the whole file, be it right or not: neither `absent` nor
/// `in_use`. Reads no more than the checksum.
bool has_seal(const std::filesystem::path& study);

/// Whether the lock by which writers find each other is held. False also where such a lock cannot be
/// examined.
bool is_being_written(const std::filesystem::path& study) noexcept;

/// Seals a database that no other program has opened yet. Errors: ResultsError.
void seal_new(const std::filesystem::path& study);

/// One writer's part in the seal: opening for writing breaks it, the last one to close makes a new
/// one. A seal that did not hold stays as it is for ever, so that no writer vouches for damage that
/// was there before it.
///
/// Writers find each other by a lock on `locks/writers.lock`. A writer that can have none (a network
/// file system, no permission) leaves no seal, and takes away one that was made while it wrote. No
/// seal, and none that cannot be read or removed, prevents writing.
class SealBreaker final {
 public:
  /// `database` is the writer's, before anything is written through it.
  SealBreaker(const std::filesystem::path& study, Database& database);
  SealBreaker(const SealBreaker&) = delete;
  SealBreaker& operator=(const SealBreaker&) = delete;
  ~SealBreaker();

  /// To be called with nothing left to write, before `database` is closed. Failing to is no error:
  /// it is the seal that is missing then.
  void seal_again(Database& database) noexcept;

 private:
  std::filesystem::path study_{};
  int lock_ = -1;
  bool is_in_the_way_ = false;  ///< a checksum that held and could not be taken away
};

}  // namespace asperity
