// Locks the file while it is open, and cuts an incomplete last line off.

#include "results_schema/files/growing_file.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "results_schema/files/file_system.h"
#include "results_schema/study.h"

namespace asperity {

GrowingFile::GrowingFile(std::filesystem::path path) : path_(std::move(path)) {
  constexpr mode_t kReadable = 0666;  // less the umask
  // O_NONBLOCK: opening a named pipe would wait for its other end.
  descriptor_ = ::open(
      path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, kReadable);
  if (descriptor_ < 0) fail_on_file(path_, "opened", errno);
  try {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail_on_file(path_, "opened", errno);
    if (!S_ISREG(status.st_mode)) {
      throw ResultsError("the file " + path_.string() +
                             " cannot be written: it is not a regular file; choose another name",
                         path_, EINVAL);
    }
    struct flock lock = lock_of_whole_file(F_WRLCK);
    if (::fcntl(descriptor_, F_OFD_SETLK, &lock) != 0) {
      if (errno != EAGAIN && errno != EACCES) fail_on_file(path_, "locked", errno);
      throw ResultsError("another program is writing the file " + path_.string() +
                             "; wait until it has ended, or choose another file",
                         path_, EAGAIN);
    }
    give_to_group(descriptor_, path_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

GrowingFile::~GrowingFile() { ::close(descriptor_); }

void GrowingFile::for_each_line(
    const std::function<void(std::string_view line, std::uint64_t end)>& line) const {
  std::array<char, 65536> piece{};
  std::string begun{};  // of the line whose end is still to come
  std::uint64_t read = 0;
  for (;;) {
    const ssize_t got = ::pread(descriptor_, piece.data(), piece.size(), static_cast<off_t>(read));
    if (got < 0) {
      if (errno == EINTR) continue;
      fail_on_file(path_, "read", errno);
    }
    if (got == 0) return;
    std::string_view rest(piece.data(), static_cast<std::size_t>(got));
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      begun += rest.substr(0, end);
      read += end + 1;
      line(begun, read);
      begun.clear();
      rest.remove_prefix(end + 1);
    }
    begun += rest;
    read += rest.size();
  }
}

void GrowingFile::cut_to(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) {
    fail_on_file(path_, "written", errno);
  }
}

void GrowingFile::append(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail_on_file(path_, "written", errno);
    }
  }
  if (::fdatasync(descriptor_) != 0) fail_on_file(path_, "written", errno);
}

}  // namespace asperity
