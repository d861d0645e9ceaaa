// Implements the ring buffer: indices run freely and are masked on access, which distinguishes a full ring from an
// empty one.

#include "renderers/servo/record_ring.h"

#include <bit>

namespace asperity {

RecordRing::RecordRing(std::size_t capacity)
    : records_(std::bit_ceil(capacity)), mask_(records_.size() - 1) {}

void RecordRing::push(const TickRecord& record) noexcept {
  const std::size_t head = head_.load(std::memory_order_relaxed);
  if (head - tail_.load(std::memory_order_acquire) > mask_) {
    lost_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  records_[head & mask_] = record;
  head_.store(head + 1, std::memory_order_release);
}

bool RecordRing::pop(TickRecord& record) noexcept {
  const std::size_t tail = tail_.load(std::memory_order_relaxed);
  if (tail == head_.load(std::memory_order_acquire)) return false;
  record = records_[tail & mask_];
  tail_.store(tail + 1, std::memory_order_release);
  return true;
}

}  // namespace asperity
