// Implements the count of heap calls by replacing malloc and its family.

#include "renderers/conformance/heap_calls.h"

#include <cerrno>
#include <cstddef>
#include <cstdlib>

namespace {
// Constant-initialised and in the executable's own block: reaching it allocates nothing.
constinit thread_local std::int64_t calls_of_thread = 0;
}  // namespace

namespace asperity {

std::int64_t heap_calls() noexcept { return calls_of_thread; }

}  // namespace asperity

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" {

// glibc's own, under the names it keeps for those who replace the public ones.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void* __libc_valloc(std::size_t size);
void* __libc_pvalloc(std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_memalign(alignment, size);
}

void* valloc(std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_valloc(size);
}

void* pvalloc(std::size_t size) noexcept {
  ++calls_of_thread;
  return __libc_pvalloc(size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) {
    return EINVAL;
  }
  ++calls_of_thread;
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr) {
    return ENOMEM;
  }
  *block = found;
  return 0;
}

void free(void* block) noexcept {
  if (block != nullptr) {
    ++calls_of_thread;
    __libc_free(block);
  }
}
}
#endif
