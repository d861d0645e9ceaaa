// The test program's own ZSTD_decompress comes before the library's.

#include "tests/results_schema/zstd_without_memory.h"

#include <atomic>
#include <cstddef>

#include <dlfcn.h>
#include <zstd_errors.h>

namespace {

std::atomic<bool> has_no_memory{false};

}  // namespace

namespace asperity {

ZstdWithoutMemory::ZstdWithoutMemory() { has_no_memory = true; }

ZstdWithoutMemory::~ZstdWithoutMemory() { has_no_memory = false; }

}  // namespace asperity

extern "C" std::size_t ZSTD_decompress(void* to, std::size_t room, const void* from,
                                       std::size_t bytes) {
  using Decompress = std::size_t (*)(void*, std::size_t, const void*, std::size_t);
  // As the library states errors: the negative code.
  if (has_no_memory) return static_cast<std::size_t>(-ZSTD_error_memory_allocation);
  static const auto decompress =
      reinterpret_cast<Decompress>(::dlsym(RTLD_NEXT, "ZSTD_decompress"));
  return decompress(to, room, from, bytes);
}
