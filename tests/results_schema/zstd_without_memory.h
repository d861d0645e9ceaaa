// A decompression that gets no memory.

#pragma once

namespace asperity {

/// While it lives, zstd decompresses nothing: it reports that it got no memory.
class ZstdWithoutMemory final {
 public:
  ZstdWithoutMemory();
  ~ZstdWithoutMemory();
  ZstdWithoutMemory(const ZstdWithoutMemory&) = delete;
  ZstdWithoutMemory& operator=(const ZstdWithoutMemory&) = delete;
};

}  // namespace asperity
