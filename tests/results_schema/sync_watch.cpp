// The test program's own fsync comes before the C library's.

#include "tests/results_schema/sync_watch.h"

#include <mutex>
#include <string>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>

namespace asperity {
namespace {

std::mutex sync_mutex;
bool is_watching_syncs = false;
std::set<std::filesystem::path> noted_syncs;

}  // namespace

SyncWatch::SyncWatch() {
  const std::lock_guard lock(sync_mutex);
  is_watching_syncs = true;
  noted_syncs.clear();
}

SyncWatch::~SyncWatch() {
  const std::lock_guard lock(sync_mutex);
  is_watching_syncs = false;
}

std::set<std::filesystem::path> SyncWatch::synced() const {
  const std::lock_guard lock(sync_mutex);
  return noted_syncs;
}

}  // namespace asperity

extern "C" int fsync(int descriptor) {
  {
    const std::lock_guard lock(asperity::sync_mutex);
    if (asperity::is_watching_syncs) {
      std::error_code unknown;
      asperity::noted_syncs.insert(
          std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), unknown));
    }
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}
