// A process of another program whose standard input, output and error the caller reads and writes.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace asperity {

/// Runs a program in its own process group. Nothing blocks: bytes pass only in `pump`, which waits no longer than asked.
///
/// The program receives an empty signal mask and the default actions, so that it does not inherit how this program
/// handles Ctrl-C; a Ctrl-C at the terminal does not reach it.
///
/// The destructor ends the process group (SIGTERM, then SIGKILL) and waits for the process. Until then a process that has
/// ended is not reaped, so that its identifier, which is that of the group, belongs to no other process.
class ChildProcess final {
 public:
  /// Errors: std::system_error where the program cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Queues bytes for its standard input.
  void write(std::string_view bytes) { to_write_ += bytes; }
  /// Closes its standard input once the queued bytes are written.
  void close_input() { closes_input_ = true; }
  /// Writes queued bytes and reads what has come, at most 64 KiB of each output in one call, and no more of its standard
  /// output while more than 64 KiB of it are unused. Waits for at most this time until there is something to read or the
  /// process ends.
  void pump(double longest_wait_s);

  /// What its standard output has brought; the caller removes what it has used.
  std::string& output() noexcept { return output_; }
  std::string take_errors() { return std::exchange(errors_, {}); }
  /// Whether it has ended, or has closed its standard output, and everything that it wrote has been read.
  bool has_ended() const noexcept;
  /// How it ended; `closed` also while it runs. Waits up to 0.1 s for it.
  enum class End { closed, exited, signalled };
  struct Ending {
    End how = End::closed;
    int number = 0;  ///< its exit status, or the signal
  };
  Ending ending();

 private:
  /// A file descriptor that is closed at the end.
  class Descriptor final {
   public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
      std::swap(number_, other.number_);
      return *this;
    }
    int number() const noexcept { return number_; }
    bool is_open() const noexcept { return number_ >= 0; }
    void close() noexcept;

   private:
    int number_ = -1;
  };
  struct Pipe {
    Descriptor read{};
    Descriptor write{};
  };

  static Pipe make_pipe();
  void start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
             int input, int output, int errors);
  void write_queued();
  static bool read_into(std::string& text, Descriptor& from);
  void look_for_end();

  pid_t process_ = -1;
  std::optional<Ending> ending_{};
  Descriptor input_{};
  Descriptor from_output_{};
  Descriptor from_errors_{};
  std::string to_write_{};
  bool closes_input_ = false;
  std::string output_{};
  std::string errors_{};
};

}  // namespace asperity
