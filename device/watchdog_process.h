// A second process, which sets motors to zero when this one no longer can.

#pragma once

#include <cstddef>
#include <sys/types.h>

namespace asperity {

/// Part of a device's sentences: what WatchdogProcess::is_there has denied.
inline constexpr const char* kWatchdogIsGone =
    "the process that sets its force to zero if this program crashes has ended";

/// Waits in a process of its own for this one to end, however badly, or to stand still.
///
/// What the caller may rely on:
/// - Killed by a signal (a crash, abort(), SIGKILL, a second Ctrl-C): `act(ended, …)` is called there as
///   soon as the kernel closes this process's files.
/// - Stopped (SIGSTOP, Ctrl-Z, a debugger) or writing a core dump: `act(stopped, …)` within 0.1 s, and
///   again every 50 ms until it goes on.
/// - Constructed: the other process watches. One that does not say so is killed and started again, with longer limits.
/// - Destroyed in order: nothing is called, or after `leave_to_act` `act(left, …)`; the destructor waits until the
///   other process is gone, and kills it after 5 s.
///
/// What it cannot see: a thread that hangs in a process that runs, a kernel that died, a plug that was
/// pulled; the end of this process while another fork of it, which called no exec, goes on. What kills or freezes
/// all processes of a session or container at once takes it too.
///
/// The other process is a fork, with its memory as it was then: `act` may make system calls and nothing
/// else (no heap, no lock, no C++ of others). It has its own terminal session, so that no key reaches it,
/// blocks all signals, runs as a normal thread whatever the caller is, and closes every file of this
/// process but `keep_open`: locks and connections end with this one.
///
/// Errors: the constructor throws std::runtime_error when the machine has no process or file left, and when no process
/// has said within 7 s that it watches.
///
/// Threads: construct and destroy from any; not in real time (a fork takes milliseconds).
class WatchdogProcess final {
 public:
  enum class Cause {
    ended,    ///< the process that started it is gone
    stopped,  ///< it is called again and again
    left,     ///< the destructor waits for it
  };
  using Act = void (*)(Cause cause, const void* about) noexcept;

  /// `about` is handed to `act` as it is now. `keep_open` is a file of this process that `act` needs, −1 for none.
  WatchdogProcess(Act act, const void* about, int keep_open);
  ~WatchdogProcess();
  /// False when the other process has ended, for whatever reason: `act` is not called any more. A system call, without waiting.
  bool is_there() const noexcept;
  /// Has the destructor ask for `act(left, …)`, where this process could not set the motors to zero itself. What `act` needs has
  /// to be free before it is destroyed.
  void leave_to_act() noexcept { is_left_to_act_ = true; }

  WatchdogProcess(const WatchdogProcess&) = delete;
  WatchdogProcess& operator=(const WatchdogProcess&) = delete;

 private:
  void start(Act act, const void* about, int keep_open);
  bool says_that_it_watches(int limit_ms) const noexcept;
  void end_by_force() const noexcept;

  int leash_ = -1;  // closes when this process ends: no program that it starts has this end
  pid_t process_ = -1;
  bool is_left_to_act_ = false;
};

}  // namespace asperity
