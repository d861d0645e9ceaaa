// A SHA-256 that grows as the content does. Seen by this folder only.

#pragma once

#include <array>
#include <cstddef>
#include <string>

struct evp_md_ctx_st;

namespace asperity {

/// `digest` and `hexadecimal` end it: one of them, once.
class Sha256Stream final {
 public:
  Sha256Stream();
  Sha256Stream(const Sha256Stream&) = delete;
  Sha256Stream& operator=(const Sha256Stream&) = delete;
  ~Sha256Stream();

  void add(const void* bytes, std::size_t count);
  std::array<unsigned char, 32> digest();
  std::string hexadecimal();

 private:
  evp_md_ctx_st* context_;
};

}  // namespace asperity
