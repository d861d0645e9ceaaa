// Notes every change that a program makes to files below a folder, and every sync, in the order in which they happen.
//
// A library for LD_PRELOAD: its functions come before the C library's. ASPERITY_NOTED_FOLDER is the folder (a real path),
// ASPERITY_NOTES the file that the notes are appended to, which must lie elsewhere. A note is a line of fields between tabs
// (kind, inode, offset, number of bytes, path, other path), the bytes, and the end of a line:
//
//   file, folder  made, with this inode and path     write   bytes at an offset of an inode
//   size          an inode has this many bytes       sync    an inode, of a file or a folder; 0: all of them
//   move          from one path to another           remove  a path
//   said          bytes on standard error
//
// Syncs are noted and not made: they take time and change nothing. lossy_disk.py reads the notes. What it cannot note (memory that is mapped, files of the C library's streams) shows when the
// notes are replayed: the files are then not those of the folder.

#undef _FORTIFY_SOURCE

#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <dlfcn.h>

namespace {

struct Notes {
  std::string folder{};
  int file = -1;

  Notes() {
    const char* const noted = std::getenv("ASPERITY_NOTED_FOLDER");
    const char* const path = std::getenv("ASPERITY_NOTES");
    if (noted == nullptr || path == nullptr) return;
    folder = noted;
    file = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  }
  bool concern(std::string_view path) const {
    return file >= 0 && path.starts_with(folder) &&
           (path.size() == folder.size() || path[folder.size()] == '/');
  }
};

const Notes& notes() {
  static const Notes kNotes{};
  return kNotes;
}

// A change and its note are one step: the notes have the order of the changes.
std::mutex& step() {
  static std::mutex one{};
  return one;
}

struct Note {
  const char* kind;
  ino_t inode = 0;
  long long offset = 0;
  std::string path{};
  std::string other{};
  std::string_view bytes{};
};

void write_note(const Note& note) {
  const int error_number = errno;
  const std::string head = std::string(note.kind) + '\t' + std::to_string(note.inode) + '\t' +
                           std::to_string(note.offset) + '\t' + std::to_string(note.bytes.size()) +
                           '\t' + note.path + '\t' + note.other + '\n';
  char end = '\n';
  iovec parts[3] = {{const_cast<char*>(head.data()), head.size()},
                    {const_cast<char*>(note.bytes.data()), note.bytes.size()},
                    {&end, 1}};
  const std::size_t size = head.size() + note.bytes.size() + 1;
  if (::syscall(SYS_writev, notes().file, parts, 3L) != static_cast<long>(size)) std::abort();
  errno = error_number;
}

std::string path_of(int descriptor) {
  char path[PATH_MAX];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(link.c_str(), path, sizeof path);
  return length < 0 ? std::string() : std::string(path, static_cast<std::size_t>(length));
}

std::string absolute(int folder, const char* path) {
  std::filesystem::path whole = path;
  if (whole.is_relative()) {
    whole = (folder == AT_FDCWD ? std::filesystem::current_path()
                                : std::filesystem::path(path_of(folder))) /
            whole;
  }
  return whole.lexically_normal().string();
}

ino_t inode_of(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_ino : 0;
}

ino_t inode_at(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

/// Whether an open descriptor is of a file or folder that is noted.
bool is_noted(int descriptor) {
  return notes().file >= 0 && descriptor > STDERR_FILENO && notes().concern(path_of(descriptor));
}

/// `change` and, if it was made, its note, which may need what it returned.
template <typename Change, typename MakeNote>
auto noted(bool is_noted, const Change& change, const MakeNote& note) {
  if (!is_noted) return change();
  const std::lock_guard lock(step());
  const auto result = change();
  if (result >= 0) write_note(note(result));
  return result;
}

int open_noted(int folder, const char* path, int flags, mode_t mode) {
  const auto open = [&] {
    return static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
  };
  if (notes().file < 0 || (flags & (O_CREAT | O_TRUNC)) == 0) return open();
  const std::string whole = absolute(folder, path);
  if (!notes().concern(whole)) return open();
  const std::lock_guard lock(step());
  const bool is_new = inode_at(whole) == 0;
  const int descriptor = open();
  if (descriptor < 0) return descriptor;
  if (is_new) {
    write_note({.kind = "file", .inode = inode_of(descriptor), .path = whole});
  } else if ((flags & O_TRUNC) != 0) {
    write_note({.kind = "size", .inode = inode_of(descriptor)});
  }
  return descriptor;
}

ssize_t write_noted(int descriptor, const void* bytes, std::size_t count, long long offset) {
  const bool is_at_end = offset < 0;
  const auto write = [&] {
    return static_cast<ssize_t>(is_at_end
                                    ? ::syscall(SYS_write, descriptor, bytes, count)
                                    : ::syscall(SYS_pwrite64, descriptor, bytes, count, offset));
  };
  const auto written = [&](ssize_t size) {
    return std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  };
  if (descriptor == STDERR_FILENO) {
    return noted(notes().file >= 0, write,
                 [&](ssize_t size) { return Note{.kind = "said", .bytes = written(size)}; });
  }
  return noted(is_noted(descriptor), write, [&](ssize_t size) {
    const long long at = is_at_end ? ::lseek(descriptor, 0, SEEK_CUR) - size : offset;
    return Note{
        .kind = "write", .inode = inode_of(descriptor), .offset = at, .bytes = written(size)};
  });
}

int truncate_noted(int descriptor, off_t size) {
  return noted(
      is_noted(descriptor),
      [&] { return static_cast<int>(::syscall(SYS_ftruncate, descriptor, size)); },
      [&](int) { return Note{.kind = "size", .inode = inode_of(descriptor), .offset = size}; });
}

enum class Synced { one, all };

int sync_noted(int descriptor, Synced synced) {
  return noted(
      is_noted(descriptor), [] { return 0; },
      [&](int) {
        return Note{.kind = "sync", .inode = synced == Synced::all ? 0 : inode_of(descriptor)};
      });
}

int move_noted(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  const std::string old_path = absolute(from_folder, from);
  const std::string new_path = absolute(to_folder, to);
  return noted(
      notes().concern(old_path) || notes().concern(new_path),
      [&] {
        return static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
      },
      [&](int) { return Note{.kind = "move", .path = old_path, .other = new_path}; });
}

int remove_noted(int folder, const char* path, int flags) {
  const std::string whole = absolute(folder, path);
  return noted(
      notes().concern(whole),
      [&] { return static_cast<int>(::syscall(SYS_unlinkat, folder, path, flags)); },
      [&](int) { return Note{.kind = "remove", .path = whole}; });
}

template <typename Open>
FILE* stream_noted(const char* name, const char* path, const char* mode) {
  static const auto real = reinterpret_cast<Open>(::dlsym(RTLD_NEXT, name));
  const std::string whole = absolute(AT_FDCWD, path);
  if (!notes().concern(whole) || *mode == 'r') return real(path, mode);
  const std::lock_guard lock(step());
  const bool is_new = inode_at(whole) == 0;
  FILE* const stream = real(path, mode);
  if (stream == nullptr) return stream;
  if (is_new) {
    write_note({.kind = "file", .inode = inode_at(whole), .path = whole});
  } else if (*mode == 'w') {
    write_note({.kind = "size", .inode = inode_at(whole)});
  }
  return stream;
}

mode_t mode_in(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_noted(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_noted(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_noted(folder, path, flags, mode);
}
int mkstemp(char* name) {
  using Make = int (*)(char*);
  static const auto real = reinterpret_cast<Make>(::dlsym(RTLD_NEXT, "mkstemp"));
  return noted(
      notes().concern(absolute(AT_FDCWD, name)), [&] { return real(name); },
      [&](int descriptor) {
        return Note{
            .kind = "file", .inode = inode_of(descriptor), .path = absolute(AT_FDCWD, name)};
      });
}
FILE* fopen(const char* path, const char* mode) {
  return stream_noted<FILE* (*)(const char*, const char*)>("fopen", path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  return stream_noted<FILE* (*)(const char*, const char*)>("fopen64", path, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
  return write_noted(descriptor, bytes, count, -1);
}
ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t offset) {
  return write_noted(descriptor, bytes, count, offset);
}
ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t offset) {
  return write_noted(descriptor, bytes, count, offset);
}
ssize_t writev(int descriptor, const iovec* parts, int count) {
  ssize_t total = 0;
  for (int i = 0; i < count; ++i) {
    if (parts[i].iov_len == 0) continue;
    const ssize_t size = write_noted(descriptor, parts[i].iov_base, parts[i].iov_len, -1);
    if (size < 0) return total > 0 ? total : size;
    total += size;
    if (static_cast<std::size_t>(size) < parts[i].iov_len) break;
  }
  return total;
}
// Refused, so that what copies a file reads and writes it.
ssize_t sendfile(int, int, off_t*, size_t) noexcept {
  errno = EINVAL;
  return -1;
}
ssize_t copy_file_range(int, off64_t*, int, off64_t*, size_t, unsigned) {
  errno = EINVAL;
  return -1;
}

int ftruncate(int descriptor, off_t size) noexcept { return truncate_noted(descriptor, size); }
int ftruncate64(int descriptor, off64_t size) noexcept { return truncate_noted(descriptor, size); }
int fsync(int descriptor) { return sync_noted(descriptor, Synced::one); }
int fdatasync(int descriptor) { return sync_noted(descriptor, Synced::one); }
int syncfs(int descriptor) noexcept { return sync_noted(descriptor, Synced::all); }

int rename(const char* from, const char* to) noexcept {
  return move_noted(AT_FDCWD, from, AT_FDCWD, to, 0);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  return move_noted(from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) noexcept { return remove_noted(AT_FDCWD, path, 0); }
int rmdir(const char* path) noexcept { return remove_noted(AT_FDCWD, path, AT_REMOVEDIR); }
int unlinkat(int folder, const char* path, int flags) noexcept {
  return remove_noted(folder, path, flags);
}
int remove(const char* path) noexcept {
  const int result = unlink(path);
  return result != 0 && (errno == EISDIR || errno == EPERM) ? rmdir(path) : result;
}
int mkdir(const char* path, mode_t mode) noexcept {
  const std::string whole = absolute(AT_FDCWD, path);
  return noted(
      notes().concern(whole),
      [&] { return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode)); },
      [&](int) { return Note{.kind = "folder", .inode = inode_at(whole), .path = whole}; });
}

}  // extern "C"
