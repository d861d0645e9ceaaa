// SHA-256 by libcrypto.

#include "results_schema/sha256.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <openssl/evp.h>

#include "results_schema/sha256_stream.h"
#include "results_schema/study.h"

namespace asperity {

Sha256Stream::Sha256Stream() : context_(EVP_MD_CTX_new()) {
  if (context_ == nullptr || EVP_DigestInit_ex(context_, EVP_sha256(), nullptr) != 1) {
    EVP_MD_CTX_free(context_);
    throw std::runtime_error("libcrypto offers no SHA-256");
  }
}

Sha256Stream::~Sha256Stream() { EVP_MD_CTX_free(context_); }

void Sha256Stream::add(const void* bytes, std::size_t count) {
  if (EVP_DigestUpdate(context_, bytes, count) != 1) {
    throw std::runtime_error("libcrypto could not go on with a SHA-256");
  }
}

std::array<unsigned char, 32> Sha256Stream::digest() {
  std::array<unsigned char, 32> digest{};
  if (EVP_DigestFinal_ex(context_, digest.data(), nullptr) != 1) {
    throw std::runtime_error("libcrypto could not finish a SHA-256");
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
  constexpr std::size_t kPiece_bytes = 1 << 18;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw ResultsError("the file " + path.string() + " cannot be read: " + std::strerror(errno),
                       path, errno);
  }
  Sha256Stream stream;
  std::vector<char> piece(kPiece_bytes);
  do {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    stream.add(piece.data(), static_cast<std::size_t>(file.gcount()));
  } while (file);
  if (file.bad()) {
    throw ResultsError("the file " + path.string() + " cannot be read to its end", path, EIO);
  }
  return stream.hexadecimal();
}

}  // namespace asperity
