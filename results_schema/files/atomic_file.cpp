// A new file under a temporary name, synced, then renamed.

#include "results_schema/files/atomic_file.h"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <memory>
#include <new>
#include <set>
#include <unistd.h>
#include <utility>

#include "results_schema/files/file_system.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

/// A name beside `path` that nobody uses; OutputFile refuses one that somebody took meanwhile.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  for (unsigned number = 0;; ++number) {
    const std::string ending =
        "." + std::to_string(::gettid()) + "-" + std::to_string(number) + ".tmp";
    std::string name = path.filename().string();
    if (name.size() + ending.size() > NAME_MAX) name.resize(NAME_MAX - ending.size());
    std::filesystem::path temporary = path;
    temporary.replace_filename(name + ending);
    if (!std::filesystem::exists(std::filesystem::symlink_status(temporary))) return temporary;
  }
}

[[noreturn]] void refuse_existing(const std::filesystem::path& path) {
  throw ResultsError(
      "the file " + path.string() +
          " already exists and is not overwritten; name another file, or remove this one",
      path, EEXIST);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// Content that is on disk and has not its name yet; removed unless it gets it.
class StagedFile final {
 public:
  StagedFile(std::filesystem::path path, std::span<const std::byte> content)
      : path_(std::move(path)) {
    if (std::filesystem::is_directory(path_)) fail_on_file(path_, "written", EISDIR);
    const std::filesystem::path folder = folder_of(path_);
    if (!std::filesystem::is_directory(folder)) {
      throw ResultsError("the file " + path_.string() + " cannot be created: there is no folder " +
                             folder.string() + "; create it first",
                         path_, ENOENT);
    }
    temporary_ = temporary_name(path_);
    try {
      OutputFile file(temporary_);
      file.write(content.data(), content.size());
      file.sync_and_close();
    } catch (...) {
      remove();
      throw;
    }
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { remove(); }

  const std::filesystem::path& path() const noexcept { return path_; }

  void take_name(Overwrite overwrite) {
    if (overwrite == Overwrite::refuse) {
      if (!rename_to_free_name(temporary_, path_)) refuse_existing(path_);
    } else if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
      fail_on_file(path_, "written", errno);
    }
    temporary_.clear();
  }

 private:
  void remove() noexcept {
    std::error_code ignored;
    if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
  }

  std::filesystem::path path_;
  std::filesystem::path temporary_{};
};

/// Files that had the names of new ones, under temporary names: put back unless they are
/// given up.
class DisplacedFiles final {
 public:
  /// Does nothing where no file has the name.
  void take(const std::filesystem::path& path) {
    if (!std::filesystem::exists(std::filesystem::symlink_status(path))) return;
    const std::filesystem::path aside = temporary_name(path);
    if (!rename_to_free_name(path, aside)) fail_on_file(path, "written", EEXIST);
    files_.emplace_back(path, aside);
  }
  void give_up() noexcept {
    std::error_code ignored;
    for (const auto& [path, aside] : files_) std::filesystem::remove(aside, ignored);
    files_.clear();
  }
  ~DisplacedFiles() {
    for (const auto& [path, aside] : files_) std::rename(aside.c_str(), path.c_str());
  }

 private:
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files_{};
};

}  // namespace

void write_file(const std::filesystem::path& path, std::span<const std::byte> content,
                Overwrite overwrite) {
  if (overwrite == Overwrite::refuse && std::filesystem::exists(path)) refuse_existing(path);
  StagedFile(path, content).take_name(overwrite);
  sync_folder(folder_of(path));
}

void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite) {
  write_file(path, std::as_bytes(std::span(content.data(), content.size())), overwrite);
}

bool holds(const NewFile& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file.path, error) &&
         std::filesystem::file_size(file.path, error) == file.content.size() &&
         read_file(file.path) == file.content;
}

void write_files_together(const std::vector<NewFile>& files, Overwrite overwrite) {
  std::vector<std::unique_ptr<StagedFile>> staged;
  for (const NewFile& file : files) {
    if (overwrite == Overwrite::refuse && std::filesystem::exists(file.path)) {
      const bool is_last = &file == &files.back();
      if (is_last || !holds(file)) refuse_existing(file.path);
      continue;  // written by a call that did not come to its end
    }
    staged.push_back(
        std::make_unique<StagedFile>(file.path, std::as_bytes(std::span(file.content))));
  }
  DisplacedFiles old;
  if (overwrite == Overwrite::allow) {
    // The last one first: it is of no use with others than its own.
    for (auto file = staged.rbegin(); file != staged.rend(); ++file) old.take((*file)->path());
  }
  std::set<std::filesystem::path> folders;
  std::size_t named = 0;
  try {
    for (; named < staged.size(); ++named) {
      staged[named]->take_name(Overwrite::refuse);
      folders.insert(folder_of(staged[named]->path()));
    }
  } catch (...) {
    std::error_code ignored;
    while (named-- > 0) std::filesystem::remove(staged[named]->path(), ignored);
    throw;
  }
  old.give_up();
  for (const std::filesystem::path& folder : folders) sync_folder(folder);
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
                           size_text(kind.most_bytes) + ", the maximum size of " + kind.name +
                           "; use a smaller file",
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
    throw ResultsError("the file " + path.string() + " cannot be read: its size in bytes, " +
                           std::to_string(file.bytes()) +
                           ", exceeds the free memory; close other programs, or use a smaller file",
                       path, ENOMEM);
  }
}

}  // namespace asperity
