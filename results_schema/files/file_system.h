// What the store asks of the operating system's files. Seen by this folder only.

#pragma once

#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <string>

namespace asperity {

struct LockHolder;

/// A new file that is being written. Errors: ResultsError naming the path.
class OutputFile final {
 public:
  /// The file must not exist.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Closes; what was written so far stays.
  ~OutputFile();

  void write(const void* bytes, std::size_t count);
  /// On disk when it returns; nothing can be written afterwards.
  void sync_and_close();
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// A regular file that is being read. What may never end or never begin (a pipe, a device, a socket) is refused
/// before it is opened. Errors: ResultsError naming the path.
class InputFile final {
 public:
  explicit InputFile(std::filesystem::path path);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  std::uint64_t bytes() const noexcept { return bytes_; }  ///< when it was opened
  /// As many as there are, up to `count`; 0 at the end.
  std::size_t read(void* bytes, std::size_t count);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0;
};

/// Whether a folder is the common work of its group: set-group-ID and writable for the group.
bool is_group_folder(const std::filesystem::path& folder) noexcept;
/// Lets the group read and write a new file where it lies in a group folder, whatever the umask.
void give_to_group(int descriptor, const std::filesystem::path& file) noexcept;

/// The end of the name of what is written before it takes the place of NAME.
inline constexpr const char* kPartEnding = ".part";
/// NAME.part
std::filesystem::path part_of(const std::filesystem::path& name);

/// Makes the names in a folder survive a power loss.
void sync_folder(const std::filesystem::path& folder);

/// False, and nothing changed, when `to` exists already.
bool rename_to_free_name(const std::filesystem::path& from, const std::filesystem::path& to);

/// Throws ResultsError: "the file … cannot be …: …" with what the error number means.
[[noreturn]] void fail_on_file(const std::filesystem::path& path, const std::string& what,
                               int error_number);

/// What F_OFD_SETLK takes and F_OFD_GETLK asks, of the type F_RDLCK or F_WRLCK. Such a lock is of the open
/// file rather than of the process: two threads exclude each other too, and closing another descriptor of
/// the same file does not release it.
struct flock lock_of_whole_file(short type) noexcept;

/// Opens a lock file of a study, `locks/NAME`, with the flags of open(2). Returns -1 and leaves errno where it
/// cannot. It is never emptied or made through a symbolic link, which would lead to other files of the user who opens it.
/// Errors: ResultsError for a link, and for what is not a file.
int open_lock_file(const std::filesystem::path& path, int flags);

/// Locks an open lock file for this process alone, and writes into it who holds it. False when another process holds
/// it. Errors: ResultsError.
bool take_lock(int descriptor, const std::filesystem::path& path);
/// Whether a path still leads to an open file, which may have been removed and made anew. A lock file that is removed
/// while it is locked is a lock only as long as this is so.
bool leads_to(const std::filesystem::path& path, int descriptor) noexcept;
/// As the file of a lock that is held has it.
LockHolder holder_in_lock(int descriptor);

/// The name of a network file system by the number that statfs gives it; empty for a local one.
std::string network_file_system_of(long type) noexcept;
/// The same for the file system that holds `path`.
std::string network_file_system_at(const std::filesystem::path& path);

/// `path` below `study`, or ResultsError when it is absolute, empty or outside the study ("..").
std::filesystem::path path_in_study(const std::filesystem::path& study, const std::string& path);

}  // namespace asperity
