// The deletion of a participant's data from a study, in steps that can be repeated. Seen by this folder only.

#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "results_schema/rows.h"
#include "results_schema/sqlite.h"

namespace asperity {

/// A deletion whose rows are gone and whose last step is not done.
///
/// The steps are: (1) the rows go in one transaction, which stores the withdrawal with the label; (2) the files go; (3) the
/// database is compacted, and its log emptied into it; (4) the label is blanked, in the paths of outputs that name it as well
/// (label_in_path.h); (5) the log is emptied again, by the last program that closes the study where another one reads it, or by
/// the next one that opens it for writing. Whatever interrupts them, the label in the row of the withdrawal states until (4) that
/// they are to be done again. The rows go first so that a reader finds a participant with all their files, or neither.
struct UnfinishedDeletion {
  std::int64_t withdrawal = 0;  ///< the id of its row
  std::string label{};
};

/// How many deletions the study has begun: another number than before means that rows and files may have gone meanwhile.
std::int64_t number_of_deletions(Database& database);

/// Errors: ResultsError for a label that is not one of a participant: the study is damaged.
std::vector<UnfinishedDeletion> unfinished_deletions(Database& database);

struct DeletedRows {
  UnfinishedDeletion deletion{};
  std::vector<OutputRow> outputs{};  ///< as Study::outputs_since_added, at that moment
};

/// Step (1). `row` receives its time. Errors: ResultsError, and nothing is changed; also where rows refer to rows that do
/// not exist, where a recording is not in the participant's folder, and where a folder of the study is a symbolic link.
DeletedRows delete_rows(Database& database, const std::string& label, WithdrawalRow& row);

/// How a deletion waits for programs that read the log, such as an export.
struct Patience {
  std::chrono::milliseconds longest{0};
  std::function<void()> begins{};  ///< called before the first wait; may be empty
  std::stop_token stop{};          ///< ends the wait as the longest time does
};

/// The other steps. Waits for readers of the log with `patience`, at two of the steps. Errors: ResultsError; what was done stays done.
/// The caller holds the lock `kDeletionLock`.
void complete_deletion(Database& database, const UnfinishedDeletion& deletion,
                       const Patience& patience);

/// Names no participant: a program that is killed leaves its file.
inline constexpr const char* kDeletionLock = "withdrawal";

/// What may be in a study's folder under a label, with the leftovers of killed programs.
std::vector<std::filesystem::path> files_of_label(const std::filesystem::path& study,
                                                  const std::string& label);

/// The same of every unfinished deletion, in the folder `study`.
std::set<std::filesystem::path> files_being_deleted(Database& database,
                                                    const std::filesystem::path& study);

/// Removes a file, or a folder with its content, as far as possible; nothing is no error. Errors: ResultsError, the first one.
void remove_tree(const std::filesystem::path& path);
void remove_trees(const std::vector<std::filesystem::path>& paths);

/// The withdrawal of this participant, whose own rows, in a deletion, are deleted already. `row` receives its time. Returns the
/// id.
std::int64_t insert_withdrawal(Database& database, WithdrawalRow& row, const std::string& label);

/// In the order of listing.
std::vector<OutputRow> outputs_in(Database& database);
/// See Study::outputs_since_added.
std::vector<OutputRow> outputs_since_added_in(Database& database, const std::string& label);

}  // namespace asperity
