// Declares the reading of a zip archive in memory.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"

struct zip;

namespace asperity {

/// The entries of a zip archive. The bytes of the archive and `name` must outlive it.
///
/// Errors: std::invalid_argument that begins with `name`, for an archive without a readable directory, and for what the
/// functions state.
class ZipArchive final {
 public:
  ZipArchive(std::span<const std::byte> bytes, const std::string& name);

  /// The paths of all entries, in the order of the archive.
  std::vector<std::string> paths() const;

  /// The number of bytes of an entry after its decompression; nullopt without such an entry.
  std::optional<std::size_t> bytes_of(const std::string& path) const;

  /// Decompresses an entry and compares its checksum (CRC-32).
  ///
  /// Errors: an entry that is missing, has more than `most` bytes, is neither stored nor deflated, is encrypted or damaged.
  std::vector<std::byte> content(const std::string& path, std::size_t most) const;

 private:
  struct Close {
    void operator()(zip* archive) const noexcept;
  };
  [[noreturn]] void refuse(const Phrase& sentence) const;

  std::span<const std::byte> bytes_;
  const std::string& name_;
  std::unique_ptr<zip, Close> archive_{};
};

}  // namespace asperity
