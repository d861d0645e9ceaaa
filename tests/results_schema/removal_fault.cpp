// The test program's own unlink and rmdir come before the C library's.

#include "tests/results_schema/removal_fault.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <mutex>
#include <sys/syscall.h>
#include <unistd.h>

namespace asperity {
namespace {

std::mutex removal_mutex;
std::string guarded_part;  // empty: none
int removals_left = 0;
RemovalFault::Kind removal_kind = RemovalFault::Kind::error;

/// Whether the call fails.
bool fails_to_remove(const std::string& path) {
  const std::lock_guard lock(removal_mutex);
  if (guarded_part.empty() || path.find(guarded_part) == std::string::npos) return false;
  if (removals_left > 0) {
    --removals_left;
    return false;
  }
  if (removal_kind == RemovalFault::Kind::killed) ::kill(::getpid(), SIGKILL);
  return true;
}

int remove_at(const char* path, int flags) {
  if (!fails_to_remove(path)) {
    return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, flags));
  }
  errno = EIO;
  return -1;
}

}  // namespace

RemovalFault::RemovalFault(const std::string& part, int n, Kind kind) {
  const std::lock_guard lock(removal_mutex);
  guarded_part = part;
  removals_left = n - 1;
  removal_kind = kind;
}

RemovalFault::~RemovalFault() {
  const std::lock_guard lock(removal_mutex);
  guarded_part.clear();
}

}  // namespace asperity

extern "C" int unlink(const char* path) noexcept { return asperity::remove_at(path, 0); }

extern "C" int rmdir(const char* path) noexcept { return asperity::remove_at(path, AT_REMOVEDIR); }
