// Runs work that calls plug-ins in a separate process, which the present one watches.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// How long one call of a plug-in may last before the process that makes it is ended.
struct PluginCallLimits {
  /// Of `reset` and `tick`. A servo loop waits 50 ms for them.
  double real_time_s = 5.0;
  /// Of the others, which may read files and tabulate.
  double preparing_s = 60.0;
};

struct PluginProcessInputs {
  std::vector<std::filesystem::path> plugins{};  ///< that `work` loads, for messages
  /// Returns the exit status; does not throw.
  std::function<int()> work{};
  /// Receives a message for the user, at most one.
  std::function<void(const std::string&)> report{};
  PluginCallLimits limits{};
};

/// Does `work` in a child process and returns its exit status. A plug-in can end its process with `exit` or `_exit`, crash it,
/// or never return from a call: the child then ends, or is ended, without having finished the work, and `report` receives the
/// plug-in, what it ran and the limit; the result is 1.
///
/// The child is in the process group of this process, with its standard streams: what it writes, and a Ctrl-C or a Ctrl-Z at the
/// terminal, pass as without it. A signal that was sent to this process alone is forwarded to it. If one of these signals, SIGXCPU,
/// or SIGPIPE outside of a plug-in, ends or stops the child, it ends or stops this process as well; if this process is killed, so is
/// the child.
///
/// A stretch in which this process does not run, because it is stopped or the computer sleeps, does not count for the limits.
///
/// Threads: called while the process has only one; until it returns, it handles the signals of the process.
///
/// Errors: std::system_error where no process can be made.
int in_plugin_process(const PluginProcessInputs& inputs);

}  // namespace asperity
