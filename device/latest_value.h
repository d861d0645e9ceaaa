// A one-slot mailbox: the newest value of one thread for another, without waiting.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace asperity {

/// Carries values from one writing thread to one reading thread; older values that were not
/// taken are lost. Three copies: one belongs to the writer, one to the reader, and one lies between them.
///
/// Real-time: `put` and `take` are wait-free and do not allocate, where copying a `Value` is.
template <typename Value>
class LatestValue final {
 public:
  /// The writer's.
  void put(const Value& value) noexcept {
    slots_[writers_] = value;
    writers_ = between_.exchange(writers_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
  }
  /// The reader's: true when there is a newer value than the last one taken.
  bool take(Value& value) noexcept {
    if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    readers_ = between_.exchange(readers_, std::memory_order_acq_rel) & ~kFresh;
    value = slots_[readers_];
    return true;
  }

 private:
  static constexpr std::uint32_t kFresh = 4;
  std::array<Value, 3> slots_{};
  std::uint32_t writers_ = 0;
  std::uint32_t readers_ = 1;
  std::atomic<std::uint32_t> between_{2};
};

}  // namespace asperity
