// Locks a file in the submission's folder by flock, for a limited time of waiting.

#include "app/cluster/submission_turn.h"

#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <sys/file.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace asperity {

SubmissionTurn::SubmissionTurn(const Submission& submission, std::chrono::milliseconds patience) {
  const std::filesystem::path file = submission.folder / "lock";
  constexpr mode_t kReadable = 0666;  // less the umask
  // Writable: a network file system locks no other.
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kReadable);
  if (descriptor_ < 0) {
    throw std::runtime_error("the file " + file.string() + " cannot be opened (" +
                             std::generic_category().message(errno) +
                             "); change the permissions of the folder, then repeat the command");
  }
  constexpr std::chrono::milliseconds kPause{50};
  for (std::chrono::milliseconds waited{0}; ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0;
       waited += kPause) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return;  // there are no locks here
    if (waited >= patience) {
      ::close(descriptor_);
      throw std::runtime_error("another asperity submit is submitting the jobs of " +
                               submission.folder.string() + " and has locked " + file.string() +
                               "; wait until it has ended, or stop it, then repeat the command");
    }
    std::this_thread::sleep_for(kPause);
  }
}

SubmissionTurn::~SubmissionTurn() { ::close(descriptor_); }

}  // namespace asperity
