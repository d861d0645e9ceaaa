// The test program's own rename and renameat2 come before the C library's.

#include "tests/results_schema/rename_watch.h"

#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>

namespace asperity {
namespace {

std::mutex rename_mutex;
std::string watched_name;  // empty: none
int noted_renamings = 0;
int noted_missing = 0;
bool flags_are_unknown = false;

}  // namespace

RenameWatch::RenameWatch(const std::filesystem::path& path) {
  const std::lock_guard lock(rename_mutex);
  watched_name = path.string();
  noted_renamings = 0;
  noted_missing = 0;
}

RenameWatch::~RenameWatch() {
  const std::lock_guard lock(rename_mutex);
  watched_name.clear();
}

int RenameWatch::renamings() const {
  const std::lock_guard lock(rename_mutex);
  return noted_renamings;
}

int RenameWatch::times_missing() const {
  const std::lock_guard lock(rename_mutex);
  return noted_missing;
}

RenameWithoutFlags::RenameWithoutFlags() {
  const std::lock_guard lock(rename_mutex);
  flags_are_unknown = true;
}

RenameWithoutFlags::~RenameWithoutFlags() {
  const std::lock_guard lock(rename_mutex);
  flags_are_unknown = false;
}

}  // namespace asperity

extern "C" int renameat2(int from_folder, const char* from, int to_folder, const char* to,
                         unsigned int flags) {
  {
    const std::lock_guard lock(asperity::rename_mutex);
    if (flags != 0 && asperity::flags_are_unknown) {
      errno = EINVAL;
      return -1;
    }
  }
  const auto result =
      static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
  const int error_number = errno;
  {
    const std::lock_guard lock(asperity::rename_mutex);
    if (result == 0 && !asperity::watched_name.empty()) {
      ++asperity::noted_renamings;
      if (::access(asperity::watched_name.c_str(), F_OK) != 0) ++asperity::noted_missing;
    }
  }
  errno = error_number;
  return result;
}

extern "C" int rename(const char* from, const char* to) {
  return ::renameat2(AT_FDCWD, from, AT_FDCWD, to, 0);
}
