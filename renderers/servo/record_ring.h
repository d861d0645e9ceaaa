// Declares the lock-free queue of tick records from the servo thread to the recorder.

#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderers/servo/tick_record.h"

namespace asperity {

/// A ring buffer of TickRecords with one producer (the servo) and one consumer (the recorder).
///
/// A full ring drops the newest record and counts it; the servo never waits.
///
/// Real-time: `push` and `pop` are wait-free and do not allocate; the constructor allocates.
class RecordRing final {
 public:
  /// `capacity` is rounded up to a power of two. 8192 records are 8 s at 1 kHz.
  explicit RecordRing(std::size_t capacity = 8192);

  void push(const TickRecord& record) noexcept;
  /// False if the ring is empty.
  bool pop(TickRecord& record) noexcept;
  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  std::vector<TickRecord> records_;
  std::size_t mask_ = 0;
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
  alignas(64) std::atomic<std::uint64_t> lost_{0};
};

}  // namespace asperity
