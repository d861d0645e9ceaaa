// Names the plug-in whose code ends the program.

#pragma once

#include "renderers/plugin/plugin_call_board.h"

namespace asperity {

/// Marks that the current thread runs the code of a plug-in. Calls may be nested.
///
/// Real-time: sets variables of the thread; in a process that is watched also those of a PluginCallBoard.
class PluginCall final {
 public:
  /// `name` must exist as long as this object: "ridges (ridges.so)".
  PluginCall(const char* name, PluginFunction function) noexcept;
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

 private:
  const char* outer_name_ = nullptr;
  PluginFunction outer_function_{};
};

/// From now on the calls of this process are on this board, which must exist until the process ends. Before the first call.
void show_plugin_calls_on(PluginCallBoard& shared) noexcept;

/// From the first call on, a signal that ends the program while the code of a plug-in runs (SIGSEGV, SIGBUS, SIGFPE, SIGILL,
/// SIGABRT) first writes a line with the name of the plug-in to standard error. What happens next is what happened
/// before: the handler that was installed, or the end of the program. Code that uses up the stack of its thread is named only
/// if this thread has called the function. In a process whose calls are on a board the signal is noted there instead of the
/// line: the process that watches it names the plug-in.
void name_plugins_that_end_the_program();

/// "an invalid memory access (SIGSEGV)"; null for a signal that is not one of these.
const char* meaning_of_ending_signal(int number) noexcept;

/// What to do about a plug-in that ended the program, for the end of a sentence.
inline constexpr const char* kCorrectPlugin =
    "correct the plug-in (docs/write-a-force-model.md, \"When something is wrong\")";

}  // namespace asperity
