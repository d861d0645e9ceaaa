// A text file that grows by whole lines, and whose writer may be stopped at any time.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace asperity {

/// Open for reading and growing, locked against other programs and other objects as long as it lives: two writers would mix their
/// lines. After a crash the file ends with what was on disk, perhaps within a line.
///
/// Errors: ResultsError naming the path; also where another process has it open this way, and for a symbolic link and
/// what is not a regular file.
class GrowingFile final {
 public:
  /// Makes the file where it is missing; its folder must exist.
  explicit GrowingFile(std::filesystem::path path);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Calls `line` with every complete line, without its end, and the number of bytes up to and with its end. In pieces: the file
  /// may be larger than memory. What follows the last end of a line is left out.
  void for_each_line(
      const std::function<void(std::string_view line, std::uint64_t end)>& line) const;
  /// Removes what follows so many bytes.
  void cut_to(std::uint64_t bytes);
  /// At the end of the file; on disk when it returns.
  void append(std::string_view text);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace asperity
