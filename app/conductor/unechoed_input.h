// A terminal that shows nothing of what is typed.

#pragma once

namespace asperity {

/// While it lives, a terminal does not show what is typed on it. The destructor restores the terminal and discards what
/// was typed meanwhile. Does nothing for an input that is not a terminal.
///
/// The terminal is also restored where a signal ends the program without destructors. Only signals that are not handled
/// here, such as SIGKILL and SIGSTOP, leave it silent (`stty echo` restores it).
///
/// Threads: one object at a time.
class UnechoedInput final {
 public:
  explicit UnechoedInput(int input);  ///< a file descriptor that outlives the object
  ~UnechoedInput();
  UnechoedInput(const UnechoedInput&) = delete;
  UnechoedInput& operator=(const UnechoedInput&) = delete;
};

/// For a program that is about to end without destructors. Async-signal-safe.
void restore_echo() noexcept;

}  // namespace asperity
