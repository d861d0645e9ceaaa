// A terminal that shows nothing of what is typed.

#pragma once

namespace asperity {

/// While it lives, a terminal does not show what is typed on it. When it goes, the terminal is as it was, and what was
/// typed meanwhile is discarded. Does nothing for an input that is not a terminal.
///
/// The terminal is also put back where a signal ends the program without destructors; what ended it still does. Only
/// SIGKILL leaves it silent (`stty echo` brings it back).
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
