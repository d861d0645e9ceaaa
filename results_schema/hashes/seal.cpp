// Writes the checksum into study.sqlite.sha256 after the last writer, under a lock that writers share.

#include "results_schema/hashes/seal.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <optional>
#include <thread>
#include <unistd.h>
#include <vector>

#include <sqlite3.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/sha256_stream.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

std::filesystem::path beside_database(const std::filesystem::path& study, const char* ending) {
  std::filesystem::path path = database_in(study);
  path += ending;
  return path;
}

std::filesystem::path lock_of_writers(const std::filesystem::path& study) {
  return study / "locks" / "writers.lock";
}

/// Nothing when it was asked to stop. A file that another process makes shorter meanwhile, as a compacted database is, is
/// read again. Errors: ResultsError, also where it becomes shorter each of five times.
std::optional<std::string> seal_text_of(Database& database, const SealWatch& watch = {}) {
  constexpr int kMostReadings = 5;
  constexpr sqlite3_int64 kPiece_bytes = 1 << 20;
  sqlite3_file* file = nullptr;
  int code = sqlite3_file_control(database.handle(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
  if (code != SQLITE_OK || file == nullptr) database.fail(code, "cannot be read");
  for (int reading = 1;; ++reading) {
    sqlite3_int64 bytes = 0;
    code = file->pMethods->xFileSize(file, &bytes);
    if (code != SQLITE_OK) database.fail(code, "cannot be read");
    Sha256Stream sha256;
    std::vector<char> piece(static_cast<std::size_t>(std::min(kPiece_bytes, bytes)));
    for (sqlite3_int64 at = 0; at < bytes && code == SQLITE_OK; at += kPiece_bytes) {
      if (watch.progress) watch.progress(static_cast<double>(at) / static_cast<double>(bytes));
      if (watch.stop.stop_requested()) return std::nullopt;
      const auto count = static_cast<int>(std::min(kPiece_bytes, bytes - at));
      code = file->pMethods->xRead(file, piece.data(), count, at);
      sha256.add(piece.data(), static_cast<std::size_t>(count));
    }
    if (code == SQLITE_OK) return sha256.hexadecimal() + "  study.sqlite\n";
    if (code != SQLITE_IOERR_SHORT_READ || reading == kMostReadings)
      database.fail(code, "cannot be read");
  }
}

/// Nothing when there is none, also when it went away just now or nobody here may read it.
std::optional<std::string> seal_text_in(const std::filesystem::path& seal) {
  try {
    if (std::filesystem::exists(seal)) return read_file(seal);
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

/// As who may write to the study's database may write to what lies beside it, whatever the mask of the
/// process that came first. Failing to is no error.
void give_mode_of_database(const std::filesystem::path& study, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(database_in(study), error);
  if (!error) std::filesystem::permissions(file, status.permissions(), error);
}

/// Waits for whoever is sealing, but not for ever: a program that was stopped holds its lock.
bool lock_shared(int file) {
  constexpr int kTries = 600;
  constexpr auto kPause = std::chrono::milliseconds(50);
  struct flock shared = lock_of_whole_file(F_RDLCK);
  for (int i = 0; i < kTries; ++i) {
    if (::fcntl(file, F_OFD_SETLK, &shared) == 0) return true;
    if (errno != EINTR && errno != EAGAIN && errno != EACCES) return false;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

/// Those of writers that were killed while they sealed: who has the lock alone is the only one who seals.
void remove_unfinished(const std::filesystem::path& seal) {
  for (const auto& entry : entries_in(seal.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(seal.filename().string() + ".") && name.ends_with(".tmp")) {
      std::filesystem::remove(entry.path());
    }
  }
}

}  // namespace

Seal seal_of(const std::filesystem::path& study, const SealWatch& watch) {
  const std::filesystem::path seal = beside_database(study, ".sha256");
  for (;;) {
    const std::optional<std::string> text = seal_text_in(seal);
    if (!text) return Seal::absent;
    if (!log_is_empty(study)) return Seal::in_use;
    Database database(study, database_in(study), Database::Mode::immutable);
    const std::optional<std::string> now = seal_text_of(database, watch);
    if (!now) return Seal::not_read;
    if (now == text) return Seal::holds;
    // Somebody may have written meanwhile, who takes the seal away before and leaves another after.
    if (seal_text_in(seal) == text) return log_is_empty(study) ? Seal::broken : Seal::in_use;
  }
}

bool has_seal(const std::filesystem::path& study) {
  return seal_text_in(beside_database(study, ".sha256")) && log_is_empty(study);
}

bool is_being_written(const std::filesystem::path& study) noexcept {
  int file = -1;
  try {
    file = open_lock_file(lock_of_writers(study), O_RDONLY);
  } catch (const std::exception&) {
  }
  if (file < 0) return false;
  struct flock lock = lock_of_whole_file(F_WRLCK);
  const bool asked = ::fcntl(file, F_OFD_GETLK, &lock) == 0;
  ::close(file);
  return asked && lock.l_type != F_UNLCK;
}

void seal_new(const std::filesystem::path& study) {
  Database database(study, database_in(study), Database::Mode::immutable);
  write_file(beside_database(study, ".sha256"), *seal_text_of(database), Overwrite::refuse);
}

SealBreaker::SealBreaker(const std::filesystem::path& study, Database& database) : study_(study) {
  const std::filesystem::path path = lock_of_writers(study);
  if (network_file_system_at(study).empty()) {
    std::error_code error;
    const bool is_new = !std::filesystem::exists(path, error);
    lock_ = open_lock_file(path, O_RDWR | O_CREAT);
    if (lock_ >= 0 && is_new) give_mode_of_database(study, path);
    // Whoever may only read it can still tell others that somebody writes.
    if (lock_ < 0) lock_ = open_lock_file(path, O_RDONLY);
    if (lock_ >= 0 && !lock_shared(lock_)) {
      ::close(lock_);
      lock_ = -1;
    }
  }
  const std::filesystem::path seal = beside_database(study, ".sha256");
  const std::optional<std::string> text = seal_text_in(seal);
  if (text && log_is_empty(study) && text != seal_text_of(database)) return;
  // One that cannot be taken away must not keep a participant waiting. It is replaced at the end; if the program
  // dies before, it does not hold, and what says so says how that can be.
  std::error_code error;
  if (std::filesystem::remove(seal, error)) sync_folder(study);
  is_in_the_way_ = static_cast<bool>(error);
}

SealBreaker::~SealBreaker() {
  if (lock_ >= 0) ::close(lock_);
}

void SealBreaker::seal_again(Database& database) noexcept {
  if (lock_ < 0) {
    // Nobody knew of this writer: a seal made meanwhile is of what it has not written yet.
    std::error_code error;
    std::filesystem::remove(beside_database(study_, ".sha256"), error);
    return;
  }
  struct flock alone = lock_of_whole_file(F_WRLCK);
  if (::fcntl(lock_, F_OFD_SETLK, &alone) != 0) return;  // the next to close will
  try {
    const std::filesystem::path seal = beside_database(study_, ".sha256");
    remove_unfinished(seal);
    if (std::filesystem::exists(seal) && !is_in_the_way_) return;
    sqlite3_busy_timeout(database.handle(), 0);
    database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
    if (!log_is_empty(study_)) return;
    write_file(seal, *seal_text_of(database),
               is_in_the_way_ ? Overwrite::allow : Overwrite::refuse);
    give_mode_of_database(study_, seal);
  } catch (const std::exception&) {
  }
}

}  // namespace asperity
