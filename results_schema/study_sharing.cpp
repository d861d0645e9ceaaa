// Sets group and mode of folder and files, and reads them to state who has access.

#include "results_schema/study_sharing.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

#include <grp.h>

#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

constexpr mode_t kSharedFolder = S_ISGID | S_IRWXG;
constexpr mode_t kSharedFile = S_IRGRP | S_IWGRP;

std::string name_of_group(gid_t number) {
  const struct group* const entry = ::getgrgid(number);
  return entry == nullptr ? std::to_string(number) : entry->gr_name;
}

std::optional<gid_t> number_of_group(const std::string& name) {
  if (name.empty()) return std::nullopt;
  const struct group* const entry = ::getgrnam(name.c_str());
  if (entry == nullptr) {
    throw ResultsError(
        "there is no group " + name +
            "; name one that you are a member of (the command \"groups\" lists them)",
        {}, ENOENT);
  }
  return entry->gr_gid;
}

void share_one(const std::filesystem::path& path, const std::optional<gid_t>& group) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) return;  // a log or a temporary file that a running session had
    fail_on_file(path, "examined", errno);
  }
  const bool is_folder = S_ISDIR(status.st_mode);
  if (!is_folder && !S_ISREG(status.st_mode)) return;
  if (group && status.st_gid != *group &&
      ::lchown(path.c_str(), static_cast<uid_t>(-1), *group) != 0) {
    fail_on_file(path, "given to the group " + name_of_group(*group), errno);
  }
  constexpr mode_t kOthers = S_IRWXO;
  const mode_t mode =
      ((status.st_mode & 07777U) | (is_folder ? kSharedFolder : kSharedFile)) & ~kOthers;
  if ((status.st_mode & 07777U) == mode && (!group || status.st_gid == *group)) return;
  if (::chmod(path.c_str(), mode) != 0) fail_on_file(path, "shared", errno);
}

}  // namespace

void make_folders(const std::filesystem::path& folder) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
  const std::filesystem::path around = folder.parent_path();
  if (around != folder) make_folders(around);
  if (::mkdir(folder.c_str(), 0777) != 0) {
    if (errno == EEXIST && std::filesystem::is_directory(folder, error)) return;
    fail_on_file(folder, "made", errno);
  }
  if (!is_group_folder(around)) return;
  struct stat status {};
  if (::stat(folder.c_str(), &status) == 0) {
    ::chmod(folder.c_str(), (status.st_mode | S_ISGID | S_IRWXG) & 07777U);
  }
}

void require_group(const std::string& group) { static_cast<void>(number_of_group(group)); }

std::string share_study(const std::filesystem::path& study, const std::string& group) {
  const std::optional<gid_t> number = number_of_group(group);
  for (const auto& entry : entries_below(study)) {
    share_one(entry.path(), number);
  }
  // Last: until everything in it is ready nobody else comes in.
  share_one(study, number);
  return group_of(study);
}

std::optional<std::filesystem::path> folder_closed_to_group(const std::filesystem::path& study) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(study, error);
  struct stat status {};
  if (error || ::stat(folder.c_str(), &status) != 0) return {};
  const gid_t group = status.st_gid;
  std::filesystem::path above{};
  for (const std::filesystem::path& name : folder.parent_path()) {
    above /= name;
    if (::stat(above.c_str(), &status) != 0) return above;
    const mode_t needed = status.st_gid == group ? S_IXGRP : S_IXOTH;
    if ((status.st_mode & needed) == 0) return above;
  }
  return {};
}

bool is_readable_by_others(const std::filesystem::path& study) {
  const auto others_may = [](const std::filesystem::path& path, mode_t what) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && (status.st_mode & what) == what;
  };
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(study, error);
  if (error) return false;
  for (std::filesystem::path above = folder;; above = above.parent_path()) {
    if (!others_may(above, S_IXOTH)) return false;
    if (above == above.parent_path()) break;
  }
  return others_may(folder, S_IROTH) || others_may(folder / "study.sqlite", S_IROTH);
}

bool is_shared_with_group(const std::filesystem::path& study) {
  const auto group_may = [](const std::filesystem::path& path, mode_t what) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && (status.st_mode & what) == what;
  };
  return group_may(study, kSharedFolder) && group_may(study / "study.sqlite", kSharedFile);
}

std::vector<std::string> own_groups() {
  std::vector<gid_t> numbers{::getegid()};
  const int count = ::getgroups(0, nullptr);
  if (count > 0) {
    numbers.resize(static_cast<std::size_t>(count) + 1);
    const int got = ::getgroups(count, numbers.data() + 1);
    numbers.resize(static_cast<std::size_t>(std::max(got, 0)) + 1);
  }
  std::vector<std::string> names;
  for (const gid_t number : numbers) names.push_back(name_of_group(number));
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string group_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) fail_on_file(path, "examined", errno);
  return name_of_group(status.st_gid);
}

}  // namespace asperity
