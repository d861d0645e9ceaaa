// A consistent copy of a study that may be in use.

#include <algorithm>
#include <cerrno>
#include <exception>
#include <optional>
#include <system_error>
#include <vector>

#include <sqlite3.h>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/study.h"
#include "results_schema/study_files.h"
#include "results_schema/study_sharing.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

const FileTransferWords kCopyWords{.participle = "copied", .verb = "copy"};

void copy_files(const std::filesystem::path& from, const std::filesystem::path& to,
                const std::stop_token& stop) {
  Database copy(to, database_in(to), Database::Mode::read_write);
  transfer_files(copy, from, to,
                 {.words = kCopyWords,
                  .new_path = [](const std::filesystem::path& path) { return path; },
                  .stop = stop});
}

/// A copy of a study whose deletion is under way has the label and free pages.
void complete_deletions_of(Database& copy) {
  for (const UnfinishedDeletion& deletion : unfinished_deletions(copy)) {
    complete_deletion(copy, deletion, {});
  }
}

/// The study lists the copy that is being made at `path`; to the copy it is the study itself.
void remove_itself_from_outputs(Database& copy, const std::filesystem::path& path) {
  std::vector<std::int64_t> ids;
  Statement output(copy, "SELECT id, path FROM output WHERE kind = 'copy' AND made_utc IS NULL");
  while (output.step()) {
    std::int64_t id = 0;
    std::string listed;
    output.read(id, listed);
    std::error_code unreadable;  // a folder of another user, for example, which is not this copy
    if (std::filesystem::weakly_canonical(listed, unreadable) == path) ids.push_back(id);
  }
  for (const std::int64_t id : ids) {
    Statement(copy, "DELETE FROM output WHERE id = ?").bind(id).run();
  }
}

}  // namespace

void copy_pages(Database& from, Database& to) {
  sqlite3_backup* const backup = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  if (backup == nullptr) to.fail(sqlite3_errcode(to.handle()), "cannot be written");
  sqlite3_backup_step(backup, -1);  // in one go: no writer can come between two pages
  const int code = sqlite3_backup_finish(backup);
  if (code != SQLITE_OK) to.fail(code, "cannot be written");
}

void Study::refuse_copy_to(const std::filesystem::path& folder) const {
  const std::filesystem::path from = std::filesystem::canonical(store_->folder);
  const std::filesystem::path to =
      std::filesystem::weakly_canonical(std::filesystem::absolute(folder));
  if (std::filesystem::exists(std::filesystem::symlink_status(to))) {
    throw ResultsError("a study cannot be copied to " + folder.string() +
                           ", which already exists; name a new folder",
                       folder, EEXIST);
  }
  if (std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end()) {
    throw ResultsError(
        "a study cannot be copied into itself; name a folder outside the study, not " +
            folder.string(),
        folder, EINVAL);
  }
  if (seal_of(from) == Seal::broken) {
    throw ResultsError("the study " + from.string() +
                           " cannot be copied: its study.sqlite has changed since Asperity last "
                           "closed it (its SHA-256 differs from that in study.sqlite.sha256). "
                           "\"asperity verify\" lists the possible causes; if the change was "
                           "intended, remove study.sqlite.sha256 and copy again",
                       from);
  }
  refuse_linked_database(from, kCopyWords);
}

void Study::copy_to(const std::filesystem::path& folder, const std::stop_token& stop) const {
  refuse_copy_to(folder);
  const std::filesystem::path from = std::filesystem::canonical(store_->folder);
  const std::filesystem::path to =
      std::filesystem::weakly_canonical(std::filesystem::absolute(folder));
  std::optional<PartFolder> part;
  name_target_in_errors(part, [&] {
    // Rows of one moment, with files that go with the participant: once more, without them, where data are deleted meanwhile.
    for (bool is_whole = false; !is_whole;) {
      part.emplace(to, kOwnersFolder);
      const std::filesystem::path& content = part->content();
      const std::int64_t deletions = store_->read([&content](Database& database) {
        Database copy(content, database_in(content), Database::Mode::create);
        copy_pages(database, copy);
        return number_of_deletions(database);
      });
      try {
        copy_files(from, content, stop);
        is_whole = store_->read(number_of_deletions) == deletions;
      } catch (const std::exception&) {
        if (store_->read(number_of_deletions) == deletions) throw;
      }
    }
    {
      Database copy(part->content(), database_in(part->content()), Database::Mode::read_write);
      remove_itself_from_outputs(copy, to);
      complete_deletions_of(copy);
    }
    seal_new(part->content());
    part->take_place();
  });
}

}  // namespace asperity
