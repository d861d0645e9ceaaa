// Disables the echo of a terminal.

#pragma once

namespace asperity {

/// Disables the echo of a terminal during its lifetime. The destructor restores the terminal and
/// discards text typed meanwhile. Does nothing for an input that is not a terminal.
///
/// The terminal is also restored where a signal ends the program without destructors, with these
/// exceptions: SIGKILL and real-time signals leave it silent, and SIGSTOP while the program is
/// stopped (`stty echo` restores it).
///
/// Threads: one object at a time.
class UnechoedInput final {
 public:
  explicit UnechoedInput(int input);  ///< a file descriptor that outlives the object
  ~UnechoedInput();
  UnechoedInput(const UnechoedInput&) = delete;
  UnechoedInput& operator=(const UnechoedInput&) = delete;
};

/// Restores the terminal of a program that is about to end without destructors, and discards typed
/// text. Does not wait for the terminal. Async-signal-safe.
void restore_echo() noexcept;

}  // namespace asperity
