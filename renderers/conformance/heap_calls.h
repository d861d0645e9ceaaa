// Declares the count of the heap calls of a thread, by which real-time code is checked.

#pragma once

#include <cstdint>

namespace asperity {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kCountsHeapCalls = false;
#else
/// False under the address and thread sanitizers, which need these functions for themselves.
inline constexpr bool kCountsHeapCalls = true;
#endif

/// The number of allocations and frees of the current thread so far, those of loaded plug-ins included. Freeing a null pointer
/// does not count.
///
/// A program that calls this function has malloc and its family, in which operator new and delete end, in front of
/// those of the C library (glibc). Every call is counted in a variable of its thread and passed on.
std::int64_t heap_calls() noexcept;

}  // namespace asperity
