// Files that are on disk when we say so.

#include "results_schema/files/file_system.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <sstream>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "results_schema/error_text.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

void refuse_lock_through_link(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  if (error) return;
  throw ResultsError(
      path.string() + " is a symbolic link to " + target.string() +
          "; the locks of a study must be regular files. Remove the link, then try again",
      path, ELOOP);
}

/// When this process was started, as UTC: the kernel dates /proc/self so.
std::string process_start_utc() {
  struct stat status {};
  if (::stat("/proc/self", &status) != 0) return "unknown";
  const std::time_t time = status.st_ctim.tv_sec;
  std::tm parts{};
  std::array<char, 32> text{};
  ::gmtime_r(&time, &parts);
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return std::string(text.data(), length);
}

/// What stands in the file: "process 123 on host lab1, started 2026-03-01T09:00:00Z".
/// As `holder_in_lock` reads it: a line each for the process, its host and its start.
std::string lines_of_this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return std::to_string(::getpid()) + '\n' + host.data() + '\n' + process_start_utc() + '\n';
}

}  // namespace

void fail_on_file(const std::filesystem::path& path, const std::string& what, int error_number) {
  throw ResultsError("the file " + path.string() + " cannot be " + what + ": " +
                         text_of_error_number(error_number),
                     path, error_number);
}

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)),
      descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail_on_file(path_, "made", errno);
  give_to_group(descriptor_, path_);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::write(descriptor_, next, count);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail_on_file(path_, "written", errno);
    }
    next += written;
    count -= static_cast<std::size_t>(written);
  }
}

void OutputFile::sync_and_close() {
  if (::fsync(descriptor_) != 0) fail_on_file(path_, "written", errno);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail_on_file(path_, "written", errno);
}

namespace {

void refuse_irregular(const std::filesystem::path& path, mode_t mode) {
  if (S_ISREG(mode)) return;
  if (S_ISDIR(mode)) fail_on_file(path, "read", EISDIR);
  const char* what = S_ISFIFO(mode) ? "a pipe" : S_ISSOCK(mode) ? "a socket" : "a device";
  throw ResultsError("the file " + path.string() + " cannot be read: it is " + what +
                         ", and only regular files are read; save its content to a file first",
                     path, EINVAL);
}

}  // namespace

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) fail_on_file(path_, "read", errno);
  refuse_irregular(path_, status.st_mode);
  // Another file may have the name by now: opening a pipe would wait for a writer.
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0) fail_on_file(path_, "read", errno);
  try {
    if (::fstat(descriptor_, &status) != 0) fail_on_file(path_, "read", errno);
    refuse_irregular(path_, status.st_mode);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
  bytes_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(void* bytes, std::size_t count) {
  for (;;) {
    const ssize_t got = ::read(descriptor_, bytes, count);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) fail_on_file(path_, "read", errno);
  }
}

bool is_group_folder(const std::filesystem::path& folder) noexcept {
  constexpr mode_t kShared = S_ISGID | S_IRWXG;
  struct stat status {};
  return ::stat(folder.empty() ? "." : folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         (status.st_mode & kShared) == kShared;
}

void give_to_group(int descriptor, const std::filesystem::path& file) noexcept {
  struct stat status {};
  if (!is_group_folder(file.parent_path()) || ::fstat(descriptor, &status) != 0) return;
  // Only its owner can, who has just made it.
  [[maybe_unused]] const int result =
      ::fchmod(descriptor, (status.st_mode | S_IRGRP | S_IWGRP) & 07777U);
}

std::filesystem::path part_of(const std::filesystem::path& name) {
  std::filesystem::path part = name;
  part += kPartEnding;
  return part;
}

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail_on_file(folder, "opened", errno);
  const int result = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  // Some file systems cannot sync a folder and say so with EINVAL: there is nothing more to do
  // there.
  if (result != 0 && error_number != EINVAL) fail_on_file(folder, "written", error_number);
}

bool rename_to_free_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return false;
  if (errno != EINVAL && errno != ENOSYS) fail_on_file(to, "made", errno);
  // A file system without that call (FAT on a stick, say): look first.
  if (std::filesystem::exists(std::filesystem::symlink_status(to))) return false;
  if (::rename(from.c_str(), to.c_str()) != 0) fail_on_file(to, "made", errno);
  return true;
}

std::string network_file_system_of(long type) noexcept {
  // From statfs(2) and the kernel's magic.h; FUSE is what sshfs and most cloud folders are.
  switch (static_cast<unsigned long>(type) & 0xffffffffUL) {
    case 0x6969:
      return "NFS";
    case 0xff534d42:
      return "CIFS";
    case 0xfe534d42:
      return "SMB2";
    case 0x517b:
      return "SMB";
    case 0x65735546:
      return "FUSE (sshfs or a cloud folder)";
    case 0x5346414f:
      return "AFS";
    case 0x00c36400:
      return "Ceph";
    case 0x01021997:
      return "9P";
    case 0x73757245:
      return "Coda";
    case 0x564c:
      return "NCP";
    case 0x0bd00bd0:
      return "Lustre";
    default:
      return "";
  }
}

std::string network_file_system_at(const std::filesystem::path& path) {
  struct statfs status {};
  if (::statfs(path.c_str(), &status) != 0) fail_on_file(path, "examined", errno);
  return network_file_system_of(static_cast<long>(status.f_type));
}

struct flock lock_of_whole_file(short type) noexcept {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

int open_lock_file(const std::filesystem::path& path, int flags) {
  refuse_lock_through_link(path.parent_path());
  const int folder =
      ::open(path.parent_path().c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return -1;
  // O_NONBLOCK: opening a named pipe would wait for its other end.
  const int file =
      ::openat(folder, path.filename().c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  const int error_number = errno;
  ::close(folder);
  if (file < 0) {
    if (error_number == ELOOP) refuse_lock_through_link(path);
    errno = error_number;
    return -1;
  }
  struct stat status {};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(file);
    throw ResultsError(
        path.string() + " is not a file, so it cannot be a lock; remove it, then try again", path,
        EINVAL);
  }
  return file;
}

bool take_lock(int descriptor, const std::filesystem::path& path) {
  struct flock lock = lock_of_whole_file(F_WRLCK);
  if (::fcntl(descriptor, F_OFD_SETLK, &lock) != 0) {
    if (errno == EAGAIN || errno == EACCES) return false;
    fail_on_file(path, "locked", errno);
  }
  const std::string text = lines_of_this_process();
  if (::ftruncate(descriptor, 0) != 0 ||
      ::pwrite(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    fail_on_file(path, "written", errno);
  }
  return true;
}

bool leads_to(const std::filesystem::path& path, int descriptor) noexcept {
  struct stat there {};
  struct stat open {};
  return ::lstat(path.c_str(), &there) == 0 && ::fstat(descriptor, &open) == 0 &&
         there.st_dev == open.st_dev && there.st_ino == open.st_ino;
}

LockHolder holder_in_lock(int descriptor) {
  std::array<char, 512> bytes{};
  const ssize_t length = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  // Empty in the moment between taking the lock and writing into the file.
  if (length <= 0) return {.description = "another process on this machine"};
  const std::string text(bytes.data(), static_cast<std::size_t>(length));
  LockHolder holder{};
  std::istringstream lines(text);
  std::getline(lines, holder.process);
  std::getline(lines, holder.host);
  std::getline(lines, holder.started_utc);
  holder.description =
      "process " + holder.process + " on host " + holder.host + ", started " + holder.started_utc;
  return holder;
}

std::filesystem::path path_in_study(const std::filesystem::path& study, const std::string& path) {
  const std::filesystem::path relative(path);
  bool inside = !path.empty() && relative.is_relative() && relative.has_filename();
  for (const auto& part : relative) inside = inside && part != ".." && part != ".";
  if (!inside) {
    throw ResultsError("\"" + path + "\" is not a path inside the study " + study.string() +
                           "; it must be relative and without \"..\"",
                       study);
  }
  return study / relative;
}

}  // namespace asperity
