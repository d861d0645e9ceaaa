// SHA-256 by libcrypto.

#include "results_schema/hashes/sha256.h"

#include <stdexcept>
#include <vector>

#include <openssl/evp.h>

#include "results_schema/files/file_system.h"
#include "results_schema/hashes/sha256_stream.h"

namespace asperity {

Sha256Stream::Sha256Stream() : context_(EVP_MD_CTX_new()) {
  if (context_ == nullptr || EVP_DigestInit_ex(context_, EVP_sha256(), nullptr) != 1) {
    EVP_MD_CTX_free(context_);
    throw std::runtime_error("libcrypto offers no SHA-256; check its installation");
  }
}

Sha256Stream::~Sha256Stream() { EVP_MD_CTX_free(context_); }

void Sha256Stream::add(const void* bytes, std::size_t count) {
  if (EVP_DigestUpdate(context_, bytes, count) != 1) {
    throw std::runtime_error("libcrypto could not compute a SHA-256; check its installation");
  }
}

std::array<unsigned char, 32> Sha256Stream::digest() {
  std::array<unsigned char, 32> digest{};
  if (EVP_DigestFinal_ex(context_, digest.data(), nullptr) != 1) {
    throw std::runtime_error("libcrypto could not compute a SHA-256; check its installation");
  }
  return digest;
}

std::string Sha256Stream::hexadecimal() {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest()) text += {kDigits[byte >> 4], kDigits[byte & 15]};
  return text;
}

std::string sha256_of(std::string_view content) {
  Sha256Stream stream;
  stream.add(content.data(), content.size());
  return stream.hexadecimal();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  InputFile file(path);
  Sha256Stream stream;
  std::vector<char> piece(std::size_t{1} << 18);
  while (const std::size_t got = file.read(piece.data(), piece.size())) {
    stream.add(piece.data(), got);
  }
  return stream.hexadecimal();
}

}  // namespace asperity
