// A new file under a temporary name, synced, then renamed.

#include "results_schema/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
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

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) fail_on_file(path, "read", EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_on_file(path, "read", errno != 0 ? errno : EIO);
  std::string content;
  // Files of hundreds of megabytes are read too; what is no file of a known size grows as it comes.
  std::error_code unknown;
  const std::uintmax_t expected = std::filesystem::file_size(path, unknown);
  if (!unknown) content.reserve(static_cast<std::size_t>(expected));
  std::vector<char> piece(std::size_t{1} << 16);
  do {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    content.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  } while (file);
  if (file.bad()) fail_on_file(path, "read", EIO);
  return content;
}

}  // namespace asperity
