// The test program's own fsync and fdatasync come before the C library's.

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

void note_sync(int descriptor) {
  const std::lock_guard lock(sync_mutex);
  if (!is_watching_syncs) return;
  std::error_code unknown;
  noted_syncs.insert(
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), unknown));
}

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
  asperity::note_sync(descriptor);
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int fdatasync(int descriptor) {
  asperity::note_sync(descriptor);
  return static_cast<int>(::syscall(SYS_fdatasync, descriptor));
}
