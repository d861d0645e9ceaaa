// Forks the program with pipes or a pseudo-terminal, and ends it after a time limit.

#include "tests/journeys/program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <poll.h>
#include <pty.h>
#include <termios.h>

namespace asperity::test {

namespace {

// Far beyond what any journey takes, so that a hung program fails its test and not the whole run.
constexpr std::chrono::seconds kLimit{200};

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

/// Takes what is there; closes the descriptor at its end.
void take(int& descriptor, std::string& text) {
  std::array<char, 65536> bytes{};
  const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
  if (count > 0) {
    text.append(bytes.data(), static_cast<std::size_t>(count));
  } else if (count == 0 || errno != EINTR) {  // a terminal ends with EIO
    ::close(descriptor);
    descriptor = -1;
  }
}

}  // namespace

Program::Program(const Invocation& invocation) {
  const std::string program =
      invocation.program.empty() ? ASPERITY_PROGRAM : invocation.program.string();
  std::vector<std::string> words = invocation.arguments;
  words.insert(words.begin(), program);
  std::vector<char*> arguments{};
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  const Pipe error = make_pipe();
  Pipe output{};
  if (invocation.on_terminal) {
    termios raw{};
    ::cfmakeraw(&raw);
    // Line by line with signals, as a shell leaves a terminal, but without echo: what is read is
    // what the program said.
    raw.c_iflag |= ICRNL;
    raw.c_lflag |= ISIG | ICANON;
    raw.c_cc[VINTR] = 3;
    raw.c_cc[VEOF] = 4;
    winsize size{24, 80, 0, 0};
    process_ = ::forkpty(&output_, nullptr, &raw, &size);
  } else {
    output = make_pipe();
    process_ = ::fork();
  }
  if (process_ < 0) throw std::runtime_error("cannot start a process");
  if (process_ == 0) {
    if (!invocation.on_terminal) {
      ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
      ::dup2(output.write_end, STDOUT_FILENO);
    }
    ::dup2(error.write_end, STDERR_FILENO);
    for (const auto& [name, value] : invocation.environment) {
      ::setenv(name.c_str(), value.c_str(), 1);
    }
    if (!invocation.folder.empty() && ::chdir(invocation.folder.c_str()) != 0) ::_exit(126);
    if (invocation.in_child) invocation.in_child();
    ::execv(program.c_str(), arguments.data());
    ::_exit(127);
  }
  ::close(error.write_end);
  error_ = error.read_end;
  if (invocation.on_terminal) {
    ::fcntl(output_, F_SETFD, FD_CLOEXEC);
  } else {
    ::close(output.write_end);
    output_ = output.read_end;
  }
  deadline_ = std::chrono::steady_clock::now() + kLimit;
}

Program::~Program() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (output_ >= 0) ::close(output_);
  if (error_ >= 0) ::close(error_);
}

bool Program::read_some(std::chrono::microseconds patience) {
  std::array<pollfd, 2> watched{pollfd{output_, POLLIN, 0}, pollfd{error_, POLLIN, 0}};
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(patience).count() + 1;
  ::poll(watched.data(), watched.size(), static_cast<int>(milliseconds));
  if (output_ >= 0 && watched[0].revents != 0) take(output_, outcome_.out);
  if (error_ >= 0 && watched[1].revents != 0) take(error_, outcome_.err);
  return output_ >= 0 || error_ >= 0;
}

bool Program::read_until(const std::function<bool(const std::string&, const std::string&)>& seen) {
  while (!seen(outcome_.out, outcome_.err)) {
    if (std::chrono::steady_clock::now() > deadline_) return false;
    if (!read_some(std::chrono::milliseconds(100))) return seen(outcome_.out, outcome_.err);
  }
  return true;
}

bool Program::read_until_told(const std::string& text) {
  return read_until([&text](const std::string&, const std::string& err) {
    return err.find(text) != std::string::npos;
  });
}

void Program::read_for(std::chrono::microseconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  for (;;) {
    const auto left = until - std::chrono::steady_clock::now();
    if (left.count() <= 0) return;
    if (!read_some(std::chrono::duration_cast<std::chrono::microseconds>(left))) return;
  }
}

void Program::type(const std::string& text) {
  if (::write(output_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    throw std::runtime_error("the terminal does not take what is typed");
  }
}

void Program::send(int signal) const { ::kill(process_, signal); }

Outcome Program::finish() {
  while (read_some(std::chrono::milliseconds(100))) {
    if (std::chrono::steady_clock::now() > deadline_) {
      ::kill(process_, SIGKILL);
      outcome_.err += "\n(killed: over its time limit)\n";
      break;
    }
  }
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  if (WIFEXITED(status)) outcome_.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome_.signal = WTERMSIG(status);
  return outcome_;
}

Outcome run(const Invocation& invocation) { return Program(invocation).finish(); }

Outcome asperity(std::vector<std::string> arguments) {
  Invocation invocation{};
  invocation.arguments = std::move(arguments);
  return run(invocation);
}

}  // namespace asperity::test
