// Starts the program with posix_spawn, and moves data through non-blocking pipes by poll.

#include "app/processes/child_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <poll.h>
#include <spawn.h>

// Declared by <unistd.h> only with GNU extensions.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace asperity {

namespace {

constexpr std::size_t kMostBytes = 64 * 1024;

[[noreturn]] void fail_to_start(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Keeps a write to a program that has ended from ending this program: SIGPIPE is blocked in this thread and, if the
/// write raised it, taken away again.
class WithoutPipeSignal final {
 public:
  WithoutPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending{};
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutPipeSignal() {
    const timespec at_once{};
    if (!was_pending_) {
      while (::sigtimedwait(&pipe_, nullptr, &at_once) == -1 && errno == EINTR) {
      }
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

/// The attributes and file actions of a start, freed at the end.
struct StartSettings {
  StartSettings() {
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_init(&actions);
  }
  ~StartSettings() {
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
  }
  StartSettings(const StartSettings&) = delete;
  StartSettings& operator=(const StartSettings&) = delete;
  posix_spawnattr_t attributes{};
  posix_spawn_file_actions_t actions{};
};

void never_block(int descriptor) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

}  // namespace

void ChildProcess::Descriptor::close() noexcept {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

ChildProcess::Pipe ChildProcess::make_pipe() {
  std::array<int, 2> ends{};
  // Closed in every other program that is started meanwhile: its copy would keep the pipe open.
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    fail_to_start(errno, "no pipe to the program can be opened");
  return {.read = Descriptor(ends[0]), .write = Descriptor(ends[1])};
}

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments) {
  Pipe input = make_pipe();
  Pipe output = make_pipe();
  Pipe errors = make_pipe();
  start(program, arguments, input.read.number(), output.write.number(), errors.write.number());
  input_ = std::move(input.write);
  from_output_ = std::move(output.read);
  from_errors_ = std::move(errors.read);
  for (const Descriptor* const end : {&input_, &from_output_, &from_errors_}) {
    never_block(end->number());
  }
}

void ChildProcess::start(const std::filesystem::path& program,
                         const std::vector<std::string>& arguments, int input, int output,
                         int errors) {
  StartSettings settings{};
  ::posix_spawn_file_actions_adddup2(&settings.actions, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&settings.actions, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&settings.actions, errors, STDERR_FILENO);
  sigset_t none{};
  ::sigemptyset(&none);
  sigset_t usual{};
  ::sigfillset(&usual);
  ::posix_spawnattr_setsigmask(&settings.attributes, &none);
  ::posix_spawnattr_setsigdefault(&settings.attributes, &usual);
  ::posix_spawnattr_setpgroup(&settings.attributes, 0);
  ::posix_spawnattr_setflags(
      &settings.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers{};
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int error = ::posix_spawn(&process_, program.c_str(), &settings.actions,
                                  &settings.attributes, pointers.data(), environ);
  if (error != 0) {
    process_ = -1;
    fail_to_start(error, "the program cannot be started");
  }
}

ChildProcess::~ChildProcess() {
  input_.close();
  if (process_ <= 0) return;
  look_for_end();
  if (has_ended()) ending();  // a program that has closed its output is about to end
  if (!ending_) {
    ::kill(-process_, SIGTERM);
    constexpr int kLooks = 20;
    constexpr std::chrono::milliseconds kBetweenLooks{10};
    for (int look = 0; look < kLooks && !ending_; ++look) {
      std::this_thread::sleep_for(kBetweenLooks);
      look_for_end();
    }
  }
  // Also what the program has started, and left behind.
  ::kill(-process_, SIGKILL);
  // Only now: the identifier of a process that was reaped can be that of another program's group.
  int status = 0;
  while (::waitpid(process_, &status, 0) == -1 && errno == EINTR) {
  }
}

void ChildProcess::look_for_end() {
  if (ending_ || process_ <= 0) return;
  siginfo_t info{};  // si_pid remains 0 while the process runs
  const int result =
      ::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (result != 0 || info.si_pid != process_) return;
  ending_ = {.how = info.si_code == CLD_EXITED ? End::exited : End::signalled,
             .number = info.si_status};
}

void ChildProcess::write_queued() {
  const WithoutPipeSignal without{};
  while (!to_write_.empty()) {
    const ssize_t written = ::write(input_.number(), to_write_.data(), to_write_.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EAGAIN) return;
    if (written < 0) {  // it has ended or closed its input, which shows at its output
      to_write_.clear();
      input_.close();
      return;
    }
    to_write_.erase(0, static_cast<std::size_t>(written));
  }
  if (closes_input_) input_.close();
}

/// False where nothing came. Closes the end of what has ended.
bool ChildProcess::read_into(std::string& text, Descriptor& from) {
  if (!from.is_open()) return false;
  std::array<char, kMostBytes> bytes{};
  const ssize_t count = ::read(from.number(), bytes.data(), bytes.size());
  if (count > 0) {
    text.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) from.close();
  return false;
}

void ChildProcess::pump(double longest_wait_s) {
  if (input_.is_open()) write_queued();
  std::vector<pollfd> watched{};
  const bool has_room = output_.size() <= kMostBytes;
  for (const Descriptor* const from : {&from_output_, &from_errors_}) {
    if (from == &from_output_ && !has_room) continue;
    if (from->is_open()) watched.push_back({.fd = from->number(), .events = POLLIN, .revents = 0});
  }
  if (input_.is_open() && !to_write_.empty()) {
    watched.push_back({.fd = input_.number(), .events = POLLOUT, .revents = 0});
  }
  ::poll(watched.data(), watched.size(), static_cast<int>(longest_wait_s * 1000.0));
  if (input_.is_open()) write_queued();
  look_for_end();  // before the outputs: what it wrote before it ended is read
  const bool has_output = !has_room || read_into(output_, from_output_);
  const bool has_errors = read_into(errors_, from_errors_);
  // A process that it started may keep the pipes open.
  if (ending_ && !has_output && !has_errors) from_output_.close();
}

bool ChildProcess::has_ended() const noexcept { return !from_output_.is_open(); }

ChildProcess::Ending ChildProcess::ending() {
  // The system closes the pipes of a process shortly before its status can be read.
  constexpr int kLooks = 20;
  constexpr std::chrono::milliseconds kBetweenLooks{5};
  look_for_end();
  for (int look = 0; look < kLooks && !ending_; ++look) {
    std::this_thread::sleep_for(kBetweenLooks);
    look_for_end();
  }
  return ending_.value_or(Ending{});
}

}  // namespace asperity
