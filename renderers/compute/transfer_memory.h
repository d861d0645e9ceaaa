// Declares memory of this process from and to which a compute device copies directly.

#pragma once

#include <cstddef>

#include "renderers/compute/open_cl.h"

namespace asperity {

/// Pinned memory: the driver copies other memory in more steps, which takes some 10 µs for each transfer.
///
/// Filled by this process and by transfers of the queue, at most one at a time. The destructor waits for the queue.
/// Errors: cl::Error.
template <class Value>
class TransferMemory final {
 public:
  TransferMemory(const cl::Context& context, const cl::CommandQueue& queue, std::size_t count)
      : queue_(queue),
        bytes_(count * sizeof(Value)),
        buffer_(context, CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR, bytes_),
        values_(static_cast<Value*>(
            queue_.enqueueMapBuffer(buffer_, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, bytes_))) {}

  ~TransferMemory() {
    try {
      queue_.enqueueUnmapMemObject(buffer_, values_);
      queue_.finish();
    } catch (const cl::Error&) {
      // The device is lost, and with it everything on it.
    }
  }

  TransferMemory(const TransferMemory&) = delete;
  TransferMemory& operator=(const TransferMemory&) = delete;

  std::size_t bytes() const { return bytes_; }
  Value* data() const { return values_; }
  Value& operator[](std::size_t i) const { return values_[i]; }

 private:
  cl::CommandQueue queue_;
  std::size_t bytes_ = 0;
  cl::Buffer buffer_;
  Value* values_ = nullptr;
};

}  // namespace asperity
