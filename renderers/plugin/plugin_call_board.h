// The running calls of plug-ins, where another process sees them.

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The code of a plug-in that a call runs: a function of its description, or what loading the library runs.
enum class PluginFunction : std::uint8_t {
  initialisation,  ///< constructors of the library, while it is loaded
  model,           ///< asperity_plugin_model
  description,     ///< no function: the description is read; a pointer in it may be wrong
  band,
  create,
  destroy,
  reset,
  tick,
  finalisation,  ///< destructors of the library, while it is unloaded or the program ends
};
/// "its function tick", for a sentence about the plug-in.
const char* text_of(PluginFunction function) noexcept;

/// The calls of plug-ins that run in all threads of a process, in memory that the process shares with the one that has started
/// it and watches it: what was running is known after the process has ended in whatever way, or while it hangs.
///
/// Processes: made before the fork. The new process begins and ends calls, the other one reads them.
///
/// Real-time: `begin`, `change` and `end` take a free place with one atomic exchange and copy the name. A call for which there
/// is no free place is not on the board; kPlaces is more than the threads of a simulation.
class PluginCallBoard final {
 public:
  /// Errors: std::system_error without memory.
  PluginCallBoard();
  ~PluginCallBoard();
  PluginCallBoard(const PluginCallBoard&) = delete;
  PluginCallBoard& operator=(const PluginCallBoard&) = delete;

  static constexpr std::size_t kPlaces = 1024;
  static constexpr std::size_t kNone = kPlaces;

  /// The place of the call, or kNone. `from`: where a free place is sought first.
  std::size_t begin(std::size_t from, const char* name, PluginFunction function) noexcept;
  /// The thread of the call at this place runs another one, which is nested in it, or returns from that.
  void change(std::size_t place, const char* name, PluginFunction function) noexcept;
  void end(std::size_t place) noexcept;
  /// The call at this place is about to end the process with this signal; kNone: other code is. Async-signal-safe.
  void note_signal(std::size_t place, int number) noexcept;
  /// The process has done its work, and only ends, with this exit status, which is not negative.
  void finish(int status) noexcept;

  struct Call {
    std::size_t place = 0;
    std::uint64_t number = 0;  ///< another one for each call at this place
    PluginFunction function{};
    std::string name{};
  };
  /// The calls that run now, or ran when the process ended.
  std::vector<Call> running() const;
  struct Signal {
    int number = 0;
    std::size_t place = kNone;
  };
  std::optional<Signal> signal() const noexcept;
  /// The argument of `finish`; nullopt before.
  std::optional<int> finished_with() const noexcept;

 private:
  struct Place {
    std::atomic<bool> is_taken{false};
    std::atomic<PluginFunction> function{};
    std::atomic<std::uint64_t> number{0};
    std::array<char, 232> name{};  // a longer name is cut
  };
  struct Shared {
    std::atomic<int> signal{0};
    std::atomic<std::size_t> place_of_signal{kNone};
    std::atomic<int> finished_with{-1};
    std::array<Place, kPlaces> places{};
  };
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
                std::atomic<PluginFunction>::is_always_lock_free &&
                std::atomic<int>::is_always_lock_free);

  Shared* shared_ = nullptr;
};

}  // namespace asperity
