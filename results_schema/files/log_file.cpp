// Opens the file for appending, without following links, and writes the whole text.

#include "results_schema/files/log_file.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include "results_schema/files/file_system.h"
#include "results_schema/study_sharing.h"

namespace asperity {

void append_to_log(const std::filesystem::path& path, std::string_view text) {
  make_folders(path.parent_path());
  constexpr mode_t kReadable = 0666;  // less the umask
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kReadable);
  if (descriptor < 0) fail_on_file(path, "opened", errno);
  give_to_group(descriptor, path);
  int error = 0;
  while (!text.empty() && error == 0) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  ::close(descriptor);
  if (error != 0) fail_on_file(path, "written", error);
}

}  // namespace asperity
