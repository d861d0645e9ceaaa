// A lock that a dead process cannot keep.

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {
namespace {

constexpr const char* kLocks = "locks";
constexpr const char* kSuffix = ".lock";

bool is_lock_name(const std::string& name) {
  return !name.empty() && name.find_first_not_of(
                              "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_") ==
                              std::string::npos;
}

std::filesystem::path lock_path(const std::filesystem::path& study, const std::string& name) {
  if (!is_lock_name(name)) {
    throw ResultsError(
        "\"" + name +
            "\" is not a name for a lock; it must consist of letters, digits, \"-\" and \"_\"",
        study);
  }
  return study / kLocks / (name + kSuffix);
}

}  // namespace

StudyLock::StudyLock(const std::filesystem::path& study, const std::string& name)
    : path_(lock_path(study, name)) {
  const std::string network = network_file_system_at(study);
  if (!network.empty()) {
    throw ResultsError("the study " + study.string() + " lies on a network file system, " +
                           network + ", where locks are not reliable; use a local disk",
                       study);
  }
  make_folders(path_.parent_path());
  // Each try that fails means that another program has released the lock in between.
  constexpr int kMostTries = 1000;
  for (int left = kMostTries; !take(study, name); --left) {
    if (left == 0) {
      throw ResultsError("the file " + path_.string() +
                             " cannot be locked: on its file system its name refers to another "
                             "file; move the study to a local disk",
                         path_);
    }
  }
}

/// False when another holder removed the file between its opening and its locking.
bool StudyLock::take(const std::filesystem::path& study, const std::string& name) {
  descriptor_ = open_lock_file(path_, O_RDWR | O_CREAT);
  if (descriptor_ < 0) fail_on_file(path_, "opened", errno);
  try {
    give_to_group(descriptor_, path_);
    if (!take_lock(descriptor_, path_)) {
      if (!leads_to(path_, descriptor_)) {  // its holder has released it meanwhile
        ::close(descriptor_);
        return false;
      }
      throw ResultsError("\"" + name + "\" of the study " + study.string() + " is in use by " +
                             holder_in_lock(descriptor_).description +
                             "; wait until it has finished, or stop it there",
                         path_, EAGAIN);
    }
  } catch (...) {
    // Locked and not written, on a full disk: the name of the file is a participant's label.
    struct flock lock = lock_of_whole_file(F_WRLCK);
    const bool is_free = ::fcntl(descriptor_, F_OFD_GETLK, &lock) == 0 && lock.l_type == F_UNLCK;
    if (is_free && leads_to(path_, descriptor_)) ::unlink(path_.c_str());
    ::close(descriptor_);
    throw;
  }
  if (leads_to(path_, descriptor_)) return true;
  ::close(descriptor_);
  return false;
}

StudyLock::~StudyLock() {
  // Both while it is still ours: afterwards another may hold a file of this name. The file stays, empty, in a folder from
  // which this user cannot remove it.
  if (leads_to(path_, descriptor_)) ::unlink(path_.c_str());
  [[maybe_unused]] const int result = ::ftruncate(descriptor_, 0);
  ::close(descriptor_);
}

std::optional<LockHolder> StudyLock::holder(const std::filesystem::path& study,
                                            const std::string& name) {
  const std::filesystem::path path = lock_path(study, name);
  const int descriptor = open_lock_file(path, O_RDONLY);
  if (descriptor < 0) {
    if (errno == ENOENT) return std::nullopt;
    fail_on_file(path, "opened", errno);
  }
  struct flock lock = lock_of_whole_file(F_RDLCK);
  const int result = ::fcntl(descriptor, F_OFD_GETLK, &lock);
  const int error_number = errno;
  LockHolder held_by = holder_in_lock(descriptor);
  const bool is_current = leads_to(path, descriptor);
  ::close(descriptor);
  if (result != 0) fail_on_file(path, "examined", error_number);
  if (lock.l_type == F_UNLCK || !is_current) return std::nullopt;
  return held_by;
}

std::vector<std::string> StudyLock::held(const std::filesystem::path& study,
                                         const std::string& beginning) {
  std::vector<std::string> names{};
  for (const auto& entry : entries_in(study / kLocks)) {
    const std::string name = entry.path().stem().string();
    // What no lock can be called, or is no file: somebody's copy, note or folder, which nobody holds.
    if (entry.path().extension() != kSuffix || !name.starts_with(beginning) ||
        !is_lock_name(name)) {
      continue;
    }
    std::error_code unknown;
    const std::filesystem::file_status kind = entry.symlink_status(unknown);
    if (kind.type() == std::filesystem::file_type::none) {
      fail_on_file(entry.path(), "examined", unknown.value());
    }
    if (std::filesystem::is_regular_file(kind) && holder(study, name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace asperity
