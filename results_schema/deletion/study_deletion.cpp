// Deletes rows by foreign keys in one transaction, overwrites pages and log, then removes files.

#include "results_schema/deletion/study_deletion.h"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <sqlite3.h>

#include "results_schema/deletion/label_in_path.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

[[noreturn]] void refuse_deletion(const std::filesystem::path& folder, const std::string& why,
                                  int code = 0) {
  throw ResultsError("the study " + folder.string() + " " + why, folder, code);
}

/// Removes the rules that protect rows from deletion, for one transaction, which no other connection sees.
class WithoutTriggers final {
 public:
  explicit WithoutTriggers(Database& database) : database_(database) {
    Statement trigger(database, "SELECT name, sql FROM sqlite_master WHERE type = 'trigger'");
    std::vector<std::string> names;
    while (trigger.step()) trigger.read(names.emplace_back(), definitions_.emplace_back());
    for (const std::string& name : names) database.execute("DROP TRIGGER " + name);
  }
  /// To be called before the transaction is committed; one that is rolled back brings them back by itself.
  void restore() {
    for (const std::string& definition : definitions_) database_.execute(definition);
  }

 private:
  Database& database_;
  std::vector<std::string> definitions_{};
};

struct ForeignKey {
  std::string table{};
  std::string parent{};
  std::string condition{};  ///< that the row names a parent
  std::string match{};      ///< of a row of `parent` that it names
};

std::vector<ForeignKey> foreign_keys(Database& database) {
  std::vector<std::string> tables;
  Statement table(database, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  while (table.step()) table.read(tables.emplace_back());
  std::vector<ForeignKey> keys;
  for (const std::string& name : tables) {
    int last = -1;
    Statement list(database,
                   "SELECT id, \"table\", \"from\", coalesce(\"to\", 'id') "
                   "FROM pragma_foreign_key_list(?) ORDER BY id, seq");
    list.bind(name);
    while (list.step()) {
      int id = 0;
      std::string parent;
      std::string column;
      std::string parent_column;
      list.read(id, parent, column, parent_column);
      const bool is_new = id != last;
      last = id;
      ForeignKey& key = is_new ? keys.emplace_back() : keys.back();
      key.table = name;
      key.parent = parent;
      const char* const glue = is_new ? "" : " AND ";
      key.condition += glue + name + "." + column + " IS NOT NULL";
      key.match += glue + parent + "." + parent_column + " = " + name + "." + column;
    }
  }
  return keys;
}

/// Deletes the rows that refer to a row that does not exist, then those that refer to these, until there are none. The
/// references are read from the schema, so that a table that a later schema adds is included.
void delete_orphans(Database& database) {
  const std::vector<ForeignKey> keys = foreign_keys(database);
  for (bool found = true; found;) {
    found = false;
    for (const ForeignKey& key : keys) {
      Statement(database, "DELETE FROM " + key.table + " WHERE " + key.condition +
                              " AND NOT EXISTS (SELECT 1 FROM " + key.parent + " WHERE " +
                              key.match + ")")
          .run();
      found = found || sqlite3_changes(database.handle()) > 0;
    }
  }
}

void refuse_orphans(Database& database) {
  Statement orphans(database, "PRAGMA foreign_key_check");
  if (!orphans.step()) return;
  refuse_deletion(
      database.folder(),
      "is damaged: some of its rows refer to rows that do not exist, and a deletion could not "
      "distinguish them from the participant's. \"asperity verify\" lists them; restore the study "
      "from a copy");
}

/// No session stores a recording in another place than under the participant's label, and such a file may belong to another
/// participant.
void refuse_recordings_elsewhere(Database& database, const std::string& label) {
  Statement recording(database,
                      "SELECT path FROM recording JOIN attempt ON attempt.id = attempt_id "
                      "JOIN session ON session.id = session_id "
                      "JOIN participant ON participant.id = participant_id WHERE label = ?");
  recording.bind(label);
  while (recording.step()) {
    std::string path;
    recording.read(path);
    if (path.starts_with("recordings/" + label + "/")) continue;
    refuse_deletion(database.folder(), "is damaged: it states that the recording " + path +
                                           " belongs to participant " + label +
                                           ", whose recordings are in recordings/" + label +
                                           "; restore the study from a copy");
  }
}

/// What is deleted would lie in another folder, which may not belong to the study.
void refuse_linked_folders(const std::filesystem::path& study) {
  for (const char* const part : {"recordings", "logs", "locks"}) {
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(study / part, error)))
      continue;
    refuse_deletion(study, std::string("has a symbolic link in place of its folder ") + part +
                               ", and data are deleted only in the folder of the study. Replace "
                               "the link by the folder itself, then delete again");
  }
}

/// What is removed is overwritten with zeros, in the pages that stay and in those that become free. Cannot be changed
/// inside a transaction.
void overwrite_what_is_removed(Database& database) {
  database.execute("PRAGMA secure_delete = ON");
}

/// While it lives a parent can be removed before the rows that refer to it. Cannot be changed inside a transaction.
class WithoutForeignKeys final {
 public:
  explicit WithoutForeignKeys(Database& database) : database_(database) {
    database.execute("PRAGMA foreign_keys = OFF");
  }
  WithoutForeignKeys(const WithoutForeignKeys&) = delete;
  WithoutForeignKeys& operator=(const WithoutForeignKeys&) = delete;
  ~WithoutForeignKeys() {
    sqlite3_exec(database_.handle(), "PRAGMA foreign_keys = ON", nullptr, nullptr, nullptr);
  }

 private:
  Database& database_;
};

/// While it lives the connection does not wait for others.
class WithoutWaiting final {
 public:
  explicit WithoutWaiting(Database& database) : database_(database) {
    sqlite3_busy_timeout(database.handle(), 0);
  }
  WithoutWaiting(const WithoutWaiting&) = delete;
  WithoutWaiting& operator=(const WithoutWaiting&) = delete;
  ~WithoutWaiting() { sqlite3_busy_timeout(database_.handle(), kBusyTimeout_ms); }

 private:
  Database& database_;
};

/// Moves the content of the log into the file itself. False: another program still reads from the log.
bool empty_log(Database& database, const Patience& patience) {
  constexpr std::chrono::milliseconds kPause{100};
  const WithoutWaiting without_waiting(database);
  for (std::chrono::milliseconds waited{0};; waited += kPause) {
    int busy = 1;
    Statement checkpoint(database, "PRAGMA wal_checkpoint(TRUNCATE)");
    if (checkpoint.step()) checkpoint.read(busy);
    checkpoint.run();
    if (busy == 0) return true;
    if (waited >= patience.longest || patience.stop.stop_requested()) return false;
    if (waited == waited.zero() && patience.begins) patience.begins();
    std::this_thread::sleep_for(kPause);
  }
}

/// The log that is left to others is not worth a longer wait.
constexpr std::chrono::milliseconds kPatienceAtEnd{1000};

void refuse_busy_log(Database& database, const Patience& patience) {
  if (empty_log(database, patience)) return;
  refuse_deletion(database.folder(),
                  "is being read by another program, so that its log study.sqlite-wal cannot be "
                  "emptied. Wait until that program has finished, or close the study there",
                  SQLITE_BUSY);
}

void blank_label(Database& database, const UnfinishedDeletion& deletion) {
  Transaction transaction(database);
  std::vector<std::int64_t> blanked;
  Statement output(database, "SELECT id, path FROM output");
  while (output.step()) {
    std::int64_t id = 0;
    std::string path;
    output.read(id, path);
    if (names_label(path, deletion.label)) blanked.push_back(id);
  }
  for (const std::int64_t id : blanked) {
    Statement(database, "UPDATE output SET path = '' WHERE id = ?").bind(id).run();
  }
  Statement(database, "UPDATE withdrawal SET label = NULL WHERE id = ?")
      .bind(deletion.withdrawal)
      .run();
  transaction.commit();
}

void sync_if_there(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::is_directory(folder, error)) sync_folder(folder);
}

}  // namespace

std::int64_t number_of_deletions(Database& database) {
  Statement statement(database, "SELECT count(*) FROM withdrawal WHERE data = 'deleted'");
  std::int64_t number = 0;
  if (statement.step()) statement.read(number);
  return number;
}

std::vector<UnfinishedDeletion> unfinished_deletions(Database& database) {
  Statement statement(database,
                      "SELECT id, label FROM withdrawal WHERE label IS NOT NULL ORDER BY id");
  std::vector<UnfinishedDeletion> deletions;
  while (statement.step()) {
    UnfinishedDeletion& deletion = deletions.emplace_back();
    statement.read(deletion.withdrawal, deletion.label);
    // Files are deleted by this label: "..", or an absolute path, would lead out of the folder of recordings.
    if (!is_participant_label(deletion.label)) {
      refuse_deletion(database.folder(),
                      "is damaged: the label of a deletion that is not complete is \"" +
                          deletion.label +
                          "\", which is not a participant label; restore the study from a copy");
    }
  }
  return deletions;
}

std::int64_t insert_withdrawal(Database& database, WithdrawalRow& row, const std::string& label) {
  Statement insertion(
      database,
      "INSERT INTO withdrawal (data, is_virtual, reason, decided_by, withdrawn_utc, sessions, "
      "attempts, answers, recordings, label, participant_id) VALUES (?1, ?2, ?3, ?4, "
      "coalesce(nullif(?5, ''), strftime('%Y-%m-%dT%H:%M:%fZ', 'now')), ?6, ?7, ?8, ?9, "
      "CASE ?1 WHEN 'deleted' THEN ?10 END, (SELECT id FROM participant WHERE label = ?10)) "
      "RETURNING id, withdrawn_utc");
  insertion.bind(text_of(row.data), row.is_virtual, text_of(row.reason), row.decided_by,
                 row.withdrawn_utc, row.sessions, row.attempts, row.answers, row.recordings, label);
  std::int64_t id = 0;
  if (insertion.step()) insertion.read(id, row.withdrawn_utc);
  insertion.run();
  return id;
}

std::vector<OutputRow> outputs_since_added_in(Database& database, const std::string& label) {
  std::vector<OutputRow> outputs = outputs_in(database);
  Statement participant(database,
                        "SELECT is_virtual, created_utc FROM participant WHERE label = ?");
  bool is_virtual = true;
  std::string added_utc;
  if (participant.bind(label).step()) participant.read(is_virtual, added_utc);
  if (is_virtual) return outputs;
  std::erase_if(outputs, [&added_utc](const OutputRow& output) {
    return !output.made_utc.empty() && output.made_utc < added_utc;
  });
  return outputs;
}

DeletedRows delete_rows(Database& database, const std::string& label, WithdrawalRow& row) {
  refuse_linked_folders(database.folder());
  overwrite_what_is_removed(database);
  const WithoutForeignKeys without_foreign_keys(database);
  Transaction transaction(database);
  refuse_orphans(database);
  refuse_recordings_elsewhere(database, label);
  DeletedRows deleted{};
  // Inside: an output that reads the rows has listed itself before, and therefore before they go.
  deleted.outputs = outputs_since_added_in(database, label);
  WithoutTriggers triggers(database);
  Statement(database, "DELETE FROM participant WHERE label = ?").bind(label).run();
  delete_orphans(database);
  triggers.restore();
  deleted.deletion = {insert_withdrawal(database, row, label), label};
  transaction.commit();
  return deleted;
}

void complete_deletion(Database& database, const UnfinishedDeletion& deletion,
                       const Patience& patience) {
  const std::filesystem::path& study = database.folder();
  refuse_linked_folders(study);
  remove_trees(files_of_label(study, deletion.label));
  for (const char* const part : {"recordings", "logs", "locks", ""}) sync_if_there(study / part);
  overwrite_what_is_removed(database);
  refuse_busy_log(database, patience);  // before the work of compacting, which would be repeated
  // For pages that were free before, and for what pages keep when their rows move: in the others what was removed is
  // overwritten.
  database.execute("VACUUM");
  refuse_busy_log(database, patience);
  blank_label(database, deletion);
  // Where a program that reads keeps it from being emptied, the deletion is final all the same: the last program that closes
  // the study empties it, or the next one that opens it for writing.
  empty_log(database,
            {.longest = std::min(patience.longest, kPatienceAtEnd), .stop = patience.stop});
}

std::vector<std::filesystem::path> files_of_label(const std::filesystem::path& study,
                                                  const std::string& label) {
  const std::string sheet = "sheet-" + label + ".png";
  const std::string migrated = database_in(study).filename().string() + ".version-";
  std::vector<std::filesystem::path> files{
      study / "recordings" / label, study / "logs" / label, study / sheet,
      study / "locks" / (Study::session_lock_name(label) + ".lock")};
  for (const auto& entry : entries_in(study)) {
    const std::string name = entry.path().filename().string();
    // The temporary files of a program that was killed while it wrote the sheet, and studies from before a migration.
    if (name.starts_with(sheet + ".") || name.starts_with(migrated)) files.push_back(entry.path());
  }
  return files;
}

std::set<std::filesystem::path> files_being_deleted(Database& database,
                                                    const std::filesystem::path& study) {
  std::set<std::filesystem::path> files;
  for (const UnfinishedDeletion& deletion : unfinished_deletions(database)) {
    for (const auto& file : files_of_label(study, deletion.label)) files.insert(file);
  }
  return files;
}

void remove_trees(const std::vector<std::filesystem::path>& paths) {
  std::exception_ptr first;
  for (const std::filesystem::path& path : paths) {
    try {
      remove_tree(path);
    } catch (const ResultsError&) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

void remove_tree(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return;
  if (status.type() == std::filesystem::file_type::directory) {
    std::vector<std::filesystem::path> content;
    for (const auto& entry : entries_in(path)) content.push_back(entry.path());
    remove_trees(content);
    if (::rmdir(path.c_str()) != 0 && errno != ENOENT) fail_on_file(path, "removed", errno);
  } else if (::unlink(path.c_str()) != 0 && errno != ENOENT) {
    fail_on_file(path, "removed", errno);
  }
}

}  // namespace asperity
