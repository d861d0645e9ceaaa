// A new file under a temporary name, synced, then renamed.

#include "results_schema/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <new>
#include <unistd.h>
#include <vector>

#include "results_schema/file_system.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

/// A name beside `path` that nobody uses; OutputFile refuses one that somebody took meanwhile.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  for (unsigned number = 0;; ++number) {
    std::filesystem::path name = path;
    name += "." + std::to_string(::gettid()) + "-" + std::to_string(number) + ".tmp";
    if (!std::filesystem::exists(std::filesystem::symlink_status(name))) return name;
  }
}

[[noreturn]] void refuse_existing(const std::filesystem::path& path) {
  throw ResultsError("the file " + path.string() +
                         " exists already and is not overwritten; name another or remove it",
                     path, EEXIST);
}

}  // namespace

void write_file(const std::filesystem::path& path, std::span<const std::byte> content,
                Overwrite overwrite) {
  if (overwrite == Overwrite::refuse && std::filesystem::exists(path)) refuse_existing(path);
  if (std::filesystem::is_directory(path)) fail_on_file(path, "written", EISDIR);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!std::filesystem::is_directory(folder)) {
    throw ResultsError(
        "the file " + path.string() + " cannot be made: there is no folder " + folder.string(),
        path, ENOENT);
  }
  const std::filesystem::path temporary = temporary_name(path);
  try {
    OutputFile file(temporary);
    file.write(content.data(), content.size());
    file.sync_and_close();
    if (overwrite == Overwrite::refuse) {
      if (!rename_to_free_name(temporary, path)) refuse_existing(path);
    } else if (std::rename(temporary.c_str(), path.c_str()) != 0) {
      fail_on_file(path, "written", errno);
    }
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  sync_folder(folder);
}

void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite) {
  write_file(path, std::as_bytes(std::span(content.data(), content.size())), overwrite);
}

namespace {

/// "4 MiB"; in bytes what is no whole number of them.
std::string size_text(std::uint64_t bytes) {
  constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
  if (bytes % (kMiB << 10) == 0) return std::to_string(bytes / (kMiB << 10)) + " GiB";
  if (bytes % kMiB == 0) return std::to_string(bytes / kMiB) + " MiB";
  return std::to_string(bytes) + " bytes";
}

}  // namespace

std::string read_file(const std::filesystem::path& path, const FileKind& kind) {
  InputFile file(path);
  const auto refuse_above_limit = [&](std::uint64_t bytes) {
    if (bytes <= kind.most_bytes) return;
    throw ResultsError("the file " + path.string() + " cannot be read: it is larger than " +
                           size_text(kind.most_bytes) + ", the most that " + kind.name +
                           " may have",
                       path, EFBIG);
  };
  refuse_above_limit(file.bytes());
  try {
    std::string content;
    content.reserve(static_cast<std::size_t>(file.bytes()));
    // Files of the kernel have no size, and any file may grow meanwhile.
    std::vector<char> piece(std::size_t{1} << 16);
    while (const std::size_t got = file.read(piece.data(), piece.size())) {
      content.append(piece.data(), got);
      refuse_above_limit(content.size());
    }
    return content;
  } catch (const std::bad_alloc&) {
    throw ResultsError("the file " + path.string() + " cannot be read: its " +
                           std::to_string(file.bytes()) +
                           " bytes are more than the memory that is free; close other programs, or "
                           "take a smaller file",
                       path, ENOMEM);
  }
}

}  // namespace asperity
