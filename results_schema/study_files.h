// The files of a study on their way into another folder: a copy of the study, or a merged one. Seen by this folder only.

#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "results_schema/sqlite.h"

namespace asperity {

/// What becomes of the files, for errors: "cannot be copied … then copy again".
struct FileTransferWords {
  std::string participle{};  ///< "copied"
  std::string verb{};        ///< "copy"
};

/// Where the files of a study go.
struct FileTransfer {
  FileTransferWords words{};
  /// The path in the other folder of a path in the study; both are relative.
  std::function<std::filesystem::path(const std::filesystem::path&)> new_path{};
  /// Throws: the other folder has a file at the new path of this one, with another content. May be empty where the other
  /// folder is new.
  std::function<void(const std::filesystem::path&)> refuse_other_content{};
  /// Whether a file that no row names stays, because it is not true of the other folder. May be empty.
  std::function<bool(const std::filesystem::path&)> leaves_out{};
  std::stop_token stop{};  ///< looked at before each file
};

/// Copies the files of the study `from` into `to`, to disk: those that the rows of `rows` name, whose SHA-256 is checked,
/// and those that users put there. What a running program has not finished, locks, files of a participant whose deletion
/// is not complete and the database itself stay. A file that is there already with the same content is left as it is.
///
/// Errors: ResultsError for a file that rows name and that is missing or has changed, for a link, for what is not a
/// file, and where it was asked to stop.
void transfer_files(Database& rows, const std::filesystem::path& from,
                    const std::filesystem::path& to, const FileTransfer& transfer);

/// The database of a study is a symbolic link. Errors: ResultsError.
void refuse_linked_database(const std::filesystem::path& study, const FileTransferWords& words);

}  // namespace asperity
