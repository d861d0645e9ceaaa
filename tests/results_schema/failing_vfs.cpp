// Every method is SQLite's own but those that put something on a disk, and large reads.

#include "tests/results_schema/failing_vfs.h"

#include <csignal>
#include <cstddef>
#include <cstring>
#include <new>
#include <stdexcept>
#include <unistd.h>

namespace asperity {

/// SQLite asks for memory of szOsFile bytes; the real file follows ours.
struct FailingVfs::File {
  sqlite3_file base{};
  FailingVfs* owner = nullptr;
  sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

struct FailingVfs::Methods {
  static File& file(sqlite3_file* base) { return *reinterpret_cast<File*>(base); }
  static sqlite3_file* real(sqlite3_file* base) { return file(base).real(); }
  static const sqlite3_io_methods& of(sqlite3_file* base) { return *real(base)->pMethods; }

  static int close(sqlite3_file* base) { return of(base).xClose(real(base)); }
  static int read(sqlite3_file* base, void* data, int count, sqlite3_int64 offset) {
    constexpr int kLarge_bytes = 1 << 16;
    int& to_shorten = file(base).owner->large_reads_to_shorten_;
    if (count <= kLarge_bytes || to_shorten == 0) {
      return of(base).xRead(real(base), data, count, offset);
    }
    --to_shorten;
    std::memset(data, 0, static_cast<std::size_t>(count));
    return SQLITE_IOERR_SHORT_READ;
  }
  static int write(sqlite3_file* base, const void* data, int count, sqlite3_int64 offset) {
    const int code = file(base).owner->next_operation();
    if (code == SQLITE_OK) return of(base).xWrite(real(base), data, count, offset);
    of(base).xWrite(real(base), data, count / 2, offset);  // what fits is there
    return code;
  }
  static int truncate(sqlite3_file* base, sqlite3_int64 size) {
    const int code = file(base).owner->next_operation();
    return code == SQLITE_OK ? of(base).xTruncate(real(base), size) : code;
  }
  static int sync(sqlite3_file* base, int flags) {
    FailingVfs& owner = *file(base).owner;
    const bool failed_before = owner.has_failed_;
    const bool fails = owner.fault_ != Fault::disk_full && owner.next_operation() != SQLITE_OK;
    if (!fails) return of(base).xSync(real(base), flags);
    if (!failed_before) owner.has_failed_in_sync_ = true;
    return SQLITE_IOERR_FSYNC;
  }
  static int file_size(sqlite3_file* base, sqlite3_int64* size) {
    return of(base).xFileSize(real(base), size);
  }
  static int lock(sqlite3_file* base, int level) { return of(base).xLock(real(base), level); }
  static int unlock(sqlite3_file* base, int level) { return of(base).xUnlock(real(base), level); }
  static int check_lock(sqlite3_file* base, int* held) {
    return of(base).xCheckReservedLock(real(base), held);
  }
  static int control(sqlite3_file* base, int operation, void* argument) {
    return of(base).xFileControl(real(base), operation, argument);
  }
  static int sector(sqlite3_file* base) { return of(base).xSectorSize(real(base)); }
  static int device(sqlite3_file* base) { return of(base).xDeviceCharacteristics(real(base)); }
  static int map(sqlite3_file* base, int region, int size, int extend, void volatile** memory) {
    return of(base).xShmMap(real(base), region, size, extend, memory);
  }
  static int shared_lock(sqlite3_file* base, int offset, int count, int flags) {
    return of(base).xShmLock(real(base), offset, count, flags);
  }
  static void barrier(sqlite3_file* base) { of(base).xShmBarrier(real(base)); }
  static int unmap(sqlite3_file* base, int remove) {
    return of(base).xShmUnmap(real(base), remove);
  }

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* base, int flags, int* out) {
    static const sqlite3_io_methods kMethods{2,        &close,     &read,   &write,  &truncate,
                                             &sync,    &file_size, &lock,   &unlock, &check_lock,
                                             &control, &sector,    &device, &map,    &shared_lock,
                                             &barrier, &unmap,     nullptr, nullptr};
    auto* owner = static_cast<FailingVfs*>(vfs->pAppData);
    File* file = new (base) File{.base = {}, .owner = owner};
    const int code = owner->real_->xOpen(owner->real_, name, file->real(), flags, out);
    base->pMethods = file->real()->pMethods == nullptr ? nullptr : &kMethods;
    return code;
  }
};

FailingVfs::FailingVfs() : real_(sqlite3_vfs_find(nullptr)), vfs_(*real_) {
  vfs_.pNext = nullptr;
  vfs_.zName = "failing";
  vfs_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
  vfs_.pAppData = this;
  vfs_.xOpen = &Methods::open;
  if (sqlite3_vfs_register(&vfs_, 1) != SQLITE_OK) throw std::runtime_error("no VFS");
}

FailingVfs::~FailingVfs() {
  sqlite3_vfs_unregister(&vfs_);
  sqlite3_vfs_register(real_, 1);
}

void FailingVfs::fail_from(int n, Fault fault) {
  operations_left_ = n - 1;
  has_failed_ = false;
  has_failed_in_sync_ = false;
  fault_ = fault;
}

void FailingVfs::heal() { operations_left_ = -1; }

int FailingVfs::next_operation() {
  if (operations_left_ < 0) return SQLITE_OK;
  if (operations_left_ > 0) {
    --operations_left_;
    return SQLITE_OK;
  }
  has_failed_ = true;
  if (fault_ == Fault::killed) ::kill(::getpid(), SIGKILL);
  return fault_ == Fault::disk_full ? SQLITE_FULL : SQLITE_IOERR_WRITE;
}

}  // namespace asperity
