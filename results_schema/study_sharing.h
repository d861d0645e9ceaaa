// Who can read and change a study: the permissions of its folder and files.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity {

/// The mode of the folder of a new study or of a copy: for its owner only, because it holds responses and movements of
/// participants. A folder that was there before keeps its own.
inline constexpr mode_t kOwnersFolder = 0700;

/// Makes a folder and those above it that are missing. In one that its group shares they are shared as well.
/// Errors: ResultsError naming the folder that cannot be made.
void make_folders(const std::filesystem::path& folder);

/// Gives a study to a group: its members can read and change everything in it and run sessions, other users can do
/// nothing. What is made in it later belongs to the group as well. Links are passed over.
///
/// `group` is the name of a group; empty: the group that the folder has. Returns the group's name.
/// Errors: ResultsError for an unknown group, and for the first file whose permissions cannot be changed.
std::string share_study(const std::filesystem::path& study, const std::string& group = {});

/// The first folder above a study, from the root, that the members of its group cannot pass by the permissions of the
/// group and of others: a home, often. Nothing where they get in.
std::optional<std::filesystem::path> folder_closed_to_group(const std::filesystem::path& study);

/// Errors: ResultsError for a group that is not there.
void require_group(const std::string& group);

/// Whether users other than the owner and the members of its group can read the study, by the permissions of its
/// folder and of those above it.
bool is_readable_by_others(const std::filesystem::path& study);

/// Whether the members of the study's group can read and change it, as `share_study` leaves it.
bool is_shared_with_group(const std::filesystem::path& study);

/// The names of the groups of the user who runs the program, sorted: those that a study of theirs can be given to.
std::vector<std::string> own_groups();

/// The group of a file or folder: its name, or its number where it has none.
std::string group_of(const std::filesystem::path& path);

}  // namespace asperity
