// Runs jobs with their output held where they have a lasting effect, or in a process that is watched.

#include "app/cli/command.h"

#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <unistd.h>
#include <utility>

#include <poll.h>

#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_process.h"
#include "protocols/file/diagnostic.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr int kNotAcceptable = 1;
constexpr const char* kUnwritten =
    "standard output cannot be written to (it was closed, or its disk is full)";

/// What a shell states of a program that SIGPIPE has ended.
constexpr int kUnread = 128 + SIGPIPE;

/// Whether it is a pipe whose reader has closed it, as `head` does once it has enough.
bool is_unread(int descriptor) {
  pollfd pipe{.fd = descriptor, .events = POLLOUT, .revents = 0};
  return ::poll(&pipe, 1, 0) == 1 && (pipe.revents & POLLERR) != 0;
}

/// While it lives, what is written to standard output is kept, to be written at its end.
class HeldOutput final {
 public:
  HeldOutput() : target_(std::cout.rdbuf(held_.rdbuf())) {}
  HeldOutput(const HeldOutput&) = delete;
  HeldOutput& operator=(const HeldOutput&) = delete;
  ~HeldOutput() { write(); }

  /// False where it could not be written.
  bool write() {
    if (target_ == nullptr) return true;
    std::cout.rdbuf(std::exchange(target_, nullptr));
    return static_cast<bool>(std::cout << held_.str() << std::flush);
  }
  std::string text() const { return held_.str(); }

 private:
  std::ostringstream held_{};
  std::streambuf* target_;
};

}  // namespace

int status_of(const Job& job) {
  constexpr int kWrongUsage = 2;
  try {
    const int status = job();
    if (std::cout.flush()) return status;
    if (is_unread(STDOUT_FILENO)) return kUnread;
    say(std::string("asperity: the output is incomplete: ") + kUnwritten +
        "; repeat the command with its output in another file");
    return kNotAcceptable;
  } catch (const WrongUsage& error) {
    say(std::string("asperity: ") + error.what());
    return kWrongUsage;
  } catch (const ProtocolError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) say(text_of(diagnostic));
    return kNotAcceptable;
  } catch (const std::exception& error) {
    say(std::string("asperity: ") + message_of(error));
    return kNotAcceptable;
  }
}

Job with_lasting_effect(Job job) {
  return [job = std::move(job)] {
    HeldOutput output;
    const int status = job();
    if (output.write()) return status;
    std::cout.clear();  // it is reported here
    say(std::string("asperity: ") + kUnwritten +
        "; the command has ended all the same, and need not be repeated. It states:");
    std::cerr << output.text() << std::flush;
    return kNotAcceptable;
  };
}

Job watched_with(const std::vector<std::filesystem::path>& plugins, Job job) {
  if (plugins.empty()) return job;
  return [plugins, job = std::move(job)] {
    return in_plugin_process(
        {.plugins = plugins, .work = [&job] { return status_of(job); }, .report = say});
  };
}

}  // namespace asperity
