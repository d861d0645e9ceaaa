// The real program as a process of its own: what a person or a script would start.

#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity::test {

struct Invocation {
  std::filesystem::path program{};  ///< empty: the one that was built with the tests
  std::vector<std::string> arguments{};
  std::map<std::string, std::string> environment{};  ///< on top of this process's own
  std::filesystem::path folder{};                    ///< to run in; empty: where the test runs
  bool on_terminal = false;          ///< standard input and output are a pseudo-terminal
  std::function<void()> in_child{};  ///< between fork and exec; system calls only
};

/// How a process ended and what it said.
struct Outcome {
  int status = -1;              ///< exit status, or -1
  std::optional<int> signal{};  ///< that ended it
  std::string out{};            ///< standard output; of a terminal also what was echoed
  std::string err{};
};

/// A running program. The destructor kills what still runs.
class Program final {
 public:
  explicit Program(const Invocation& invocation);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Reads until `seen(out, err)` or until the program has closed both. False: it was closed, or
  /// the time limit passed.
  bool read_until(const std::function<bool(const std::string& out, const std::string& err)>& seen);
  /// Until standard error has this text.
  bool read_until_told(const std::string& text);
  /// For so long, or until the program has closed both.
  void read_for(std::chrono::microseconds time);
  void type(const std::string& text);
  void send(int signal) const;
  /// Reads to the end. A program that is not over by the time limit is killed and says so in `err`.
  Outcome finish();

  const std::string& out() const noexcept { return outcome_.out; }
  const std::string& err() const noexcept { return outcome_.err; }
  pid_t process() const noexcept { return process_; }

 private:
  bool read_some(std::chrono::microseconds patience);

  pid_t process_ = -1;
  int output_ = -1;  ///< of a terminal its other side, to write to as well
  int error_ = -1;
  std::chrono::steady_clock::time_point deadline_{};
  Outcome outcome_{};
};

/// Runs it to its end, without input and without a terminal.
Outcome asperity(std::vector<std::string> arguments);
Outcome run(const Invocation& invocation);

}  // namespace asperity::test
