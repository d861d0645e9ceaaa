// A tick that is under way while somebody closes the door behind it, in events instead of time.

#pragma once

#include <atomic>
#include <thread>

namespace asperity {

/// Begins, waits until somebody wants the calls to end, and gives them many turns to go away before it has
/// ended.
struct LongTick {
  std::atomic<bool> has_begun{false};
  std::atomic<bool> is_unwanted{false};  ///< set by who then ends the calls
  std::atomic<bool> is_left{false};      ///< set by who has ended them
  std::atomic<bool> has_ended{false};
  std::atomic<bool> was_left{false};  ///< before it had ended
  std::atomic<int> ticks{0};

  static void run(void* self) noexcept {
    constexpr int kTurns = 10'000;
    auto* tick = static_cast<LongTick*>(self);
    ++tick->ticks;
    tick->has_begun = true;
    while (!tick->is_unwanted) std::this_thread::yield();
    for (int turn = 0; turn < kTurns && !tick->is_left; ++turn) std::this_thread::yield();
    tick->was_left = tick->is_left.load();
    tick->has_ended = true;
  }
  void wait_until_begun() const {
    while (!has_begun) std::this_thread::yield();
  }
  /// Calls `end`, which has to come back after the tick has ended.
  template <typename End>
  void end_calls(End end) {
    is_unwanted = true;
    end();
    is_left = true;
  }
};

}  // namespace asperity
