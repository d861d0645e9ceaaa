// The only way in which the program writes a file, and reads one that is named by a user.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

enum class Overwrite { refuse, allow };

/// Writes under a temporary name, syncs, renames, syncs the folder: after a crash the file is the
/// old one or the new one, never a part.
///
/// Errors: ResultsError naming the path: it exists (and `refuse`), the folder is missing, no
/// permission, no space. Nothing is left behind.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content,
                Overwrite overwrite);
void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite);

/// A file, and what it is to hold.
struct NewFile {
  std::filesystem::path path{};
  std::string content{};
};

/// Whether a regular file of this name has this content.
bool holds(const NewFile& file);

/// Writes files of which the last is of use with all the others only.
///
/// All contents are on disk under temporary names before the first of them gets its own; what a failure leaves is
/// what was there before. After a crash the last one is there with all the others or not at all, and the same call
/// can be repeated: of the others, one that holds what it is to hold already is not refused.
///
/// Errors: ResultsError naming the path, as for `write_file`.
void write_files_together(const std::vector<NewFile>& files, Overwrite overwrite);

/// A kind of file, by the words that an error uses, and how large one may be.
struct FileKind {
  const char* name;
  std::uint64_t most_bytes;
};
inline constexpr FileKind kAnyFile{"a file", std::uint64_t{2} << 30};
inline constexpr FileKind kProtocolFile{"a protocol", std::uint64_t{4} << 20};
inline constexpr FileKind kOptionsFile{"a file of options", std::uint64_t{4} << 20};
inline constexpr FileKind kProfileFile{"a device profile", std::uint64_t{64} << 20};
/// 16384 pixels a side in 16-bit colour, and room for a header.
inline constexpr FileKind kPictureFile{"a picture", std::uint64_t{2} << 30};
inline constexpr FileKind kSidecarFile{"the sidecar of a height field", std::uint64_t{4} << 20};
inline constexpr FileKind kMeshFile{"a mesh", std::uint64_t{2} << 30};
inline constexpr FileKind kSpeechFile{"recorded speech", std::uint64_t{256} << 20};
inline constexpr FileKind kTableFile{"a table", std::uint64_t{4} << 30};
inline constexpr FileKind kRecordingFile{"a recording", std::uint64_t{16} << 30};

/// The whole of a regular file.
///
/// Errors: ResultsError naming the path, at once: it is missing, or not readable; it is a folder, a pipe, a device
/// or a socket; it is larger than its kind may be, or than the memory that is free.
std::string read_file(const std::filesystem::path& path, const FileKind& kind = kAnyFile);

}  // namespace asperity
