// Writes into a part folder under a lock, and exchanges it with the target when it is complete.

#include "results_schema/files/part_folder.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "results_schema/files/file_system.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {
namespace {

std::filesystem::path without_slash(const std::filesystem::path& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

PartFolder::PartFolder(const std::filesystem::path& target, mode_t mode)
    : target_(without_slash(target)),
      part_(part_of(target_)),
      content_(part_ / "content"),
      replaced_(part_ / "replaced"),
      lock_path_(part_ / "lock") {
  make_folders(target_.parent_path());
  while (!claim()) {
  }
  std::error_code error;
  std::filesystem::remove_all(content_, error);
  if (!error) std::filesystem::remove_all(replaced_, error);
  const int error_number = error ? error.value() : ::mkdir(content_.c_str(), mode) == 0 ? 0 : errno;
  if (error_number == 0) return;
  clear();
  fail_on_file(content_, "made", error_number);
}

PartFolder::~PartFolder() { clear(); }

void PartFolder::remove_leftover(const std::filesystem::path& target) {
  if (std::filesystem::exists(std::filesystem::symlink_status(part_of(without_slash(target))))) {
    PartFolder(target, 0700);
  }
}

/// False when the folder was removed meanwhile by the program that made it.
bool PartFolder::claim() {
  if (::mkdir(part_.c_str(), 0700) != 0) {
    if (errno != EEXIST) fail_on_file(part_, "made", errno);
    refuse_what_is_not_left_by_us();
  }
  lock_ = open_lock_file(lock_path_, O_RDWR | O_CREAT);
  if (lock_ < 0) {
    if (errno == ENOENT) return false;
    fail_on_file(lock_path_, "made", errno);
  }
  try {
    // Where a lock cannot be had, on a network file system, nothing was taken for a leftover.
    const bool is_local = network_file_system_at(part_).empty();
    bool is_locked = false;
    try {
      is_locked = take_lock(lock_, lock_path_);
    } catch (const ResultsError&) {
      if (is_local) throw;
    }
    if (!is_locked && is_local) {
      throw ResultsError("the folder " + target_.string() + " is being written by " +
                             holder_in_lock(lock_).description +
                             "; wait until it has finished, or stop it there",
                         part_, EAGAIN);
    }
    if (leads_to(lock_path_, lock_)) return true;
  } catch (...) {
    ::close(lock_);
    lock_ = -1;
    throw;
  }
  ::close(lock_);
  lock_ = -1;
  return false;
}

void PartFolder::refuse_what_is_not_left_by_us() const {
  namespace fs = std::filesystem;
  std::error_code error;
  const bool is_folder = fs::is_directory(fs::symlink_status(part_, error));
  if (is_folder && fs::is_empty(part_, error)) return;
  if (!is_folder || !fs::is_regular_file(fs::symlink_status(lock_path_, error))) {
    // Gone meanwhile is not in the way.
    if (!fs::exists(fs::symlink_status(part_, error))) return;
    throw ResultsError(
        part_.string() +
            " already exists, and no running or interrupted program owns it. Remove or rename it, "
            "then try again",
        part_, EEXIST);
  }
  const std::string network = network_file_system_at(part_);
  if (network.empty()) return;
  throw ResultsError(
      part_.string() +
          " already exists: an interrupted program left it, or another program is writing to it "
          "now. It lies on a network file system, " +
          network +
          ", where this cannot be determined. If no program is writing to it, remove it, then try "
          "again",
      part_, EEXIST);
}

void PartFolder::take_place(Overwrite overwrite) {
  sync_folder(content_);
  const bool replaces = overwrite == Overwrite::allow &&
                        std::filesystem::exists(std::filesystem::symlink_status(target_));
  if (!replaces) {
    if (!rename_to_free_name(content_, target_)) fail_on_file(target_, "made", EEXIST);
  } else if (::renameat2(AT_FDCWD, content_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) !=
             0) {
    if (errno != EINVAL && errno != ENOSYS) fail_on_file(target_, "replaced", errno);
    // A file system that cannot exchange two names.
    if (std::rename(target_.c_str(), replaced_.c_str()) != 0) {
      fail_on_file(target_, "replaced", errno);
    }
    if (std::rename(content_.c_str(), target_.c_str()) != 0) {
      const int error_number = errno;
      std::rename(replaced_.c_str(), target_.c_str());
      fail_on_file(target_, "replaced", error_number);
    }
  }
  sync_folder(target_.parent_path());
}

ResultsError PartFolder::about_target(const ResultsError& error) const {
  const std::string content = content_.string();
  const std::string target = target_.string();
  std::string message = error.what();
  for (std::size_t at = message.find(content); at != std::string::npos;
       at = message.find(content, at + target.size())) {
    message.replace(at, content.size(), target);
  }
  const bool is_of_content = message != error.what();
  return ResultsError(message, is_of_content ? target_ : error.path(), error.code());
}

/// The lock is removed last, and only if nothing else is left: without it, the next program could not distinguish the rest
/// from a user's folder.
void PartFolder::clear() noexcept {
  if (lock_ < 0) return;
  std::error_code error;
  std::filesystem::remove_all(content_, error);
  if (!error) std::filesystem::remove_all(replaced_, error);
  if (!error) std::filesystem::remove(lock_path_, error);
  if (!error) std::filesystem::remove(part_, error);
  ::close(lock_);
  lock_ = -1;
}

}  // namespace asperity
