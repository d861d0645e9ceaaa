// Counts what the current thread does to the heap, to hold real-time code to its promise.

#include "tests/support/allocation_guard.h"

#include "renderers/conformance/heap_calls.h"

namespace asperity {

AllocationGuard::AllocationGuard() noexcept : at_start_(heap_calls()) {}

std::int64_t AllocationGuard::count() const noexcept { return heap_calls() - at_start_; }

}  // namespace asperity
