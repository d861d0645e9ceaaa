// Names the plug-in whose code ends the program.

#pragma once

namespace asperity {

/// Marks that the current thread runs the code of a plug-in. Calls may be nested.
///
/// Real-time: sets a variable of the thread.
class PluginCall final {
 public:
  /// `name` must exist as long as this object: "ridges (ridges.so)".
  explicit PluginCall(const char* name) noexcept;
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

 private:
  const char* outer_ = nullptr;
};

/// From the first call on, a signal that ends the program while the code of a plug-in runs (SIGSEGV, SIGBUS, SIGFPE, SIGILL,
/// SIGABRT) first writes a line with the name of the plug-in to standard error. What happens next is what happened
/// before: the handler that was installed, or the end of the program. Code that uses up the stack of its thread is named only
/// if this thread has called the function.
void name_plugins_that_end_the_program();

}  // namespace asperity
