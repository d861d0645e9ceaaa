// A participant who withdraws: their data are kept and never used, or deleted without a trace.

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <sqlite3.h>

#include "results_schema/file_system.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

constexpr std::array kWithdrawnData{WithdrawnData::kept, WithdrawnData::deleted};
constexpr std::array kReasons{WithdrawalReason::consent_withdrawn, WithdrawalReason::not_eligible,
                              WithdrawalReason::other};

/// Of the decisions that leave the sessions of a participant out.
StoredWords reason_of_exclusion(WithdrawalReason reason) {
  switch (reason) {
    case WithdrawalReason::consent_withdrawn:
      return {"The participant withdrew consent", R"({"code":"consent_withdrawn"})"};
    case WithdrawalReason::not_eligible:
      return {"The participant was not eligible", R"({"code":"not_eligible"})"};
    case WithdrawalReason::other:
      break;
  }
  return {"The participant was withdrawn", R"({"code":"withdrawn"})"};
}

[[noreturn]] void refuse_withdrawal(const std::filesystem::path& folder, const std::string& why,
                                    int code = 0) {
  throw ResultsError("the study " + folder.string() + " " + why, folder, code);
}

WithdrawalRow count_rows(Database& database, const std::string& label) {
  WithdrawalRow counts{};
  Statement participant(database, "SELECT is_virtual FROM participant WHERE label = ?");
  if (!participant.bind(label).step()) {
    refuse_withdrawal(database.folder(), "has no participant " + label +
                                             "; use a label from the page Participants or from "
                                             "participants.tsv of an export");
  }
  participant.read(counts.is_virtual);
  Statement count(database,
                  "WITH own AS (SELECT session.id FROM session JOIN participant "
                  "ON participant.id = session.participant_id WHERE label = ?1), "
                  "own_attempt AS (SELECT id FROM attempt WHERE session_id IN own) "
                  "SELECT (SELECT count(*) FROM own), (SELECT count(*) FROM own_attempt), "
                  "(SELECT count(*) FROM response WHERE attempt_id IN own_attempt) "
                  "+ (SELECT count(*) FROM session_answer WHERE session_id IN own), "
                  "(SELECT count(*) FROM recording WHERE attempt_id IN own_attempt)");
  if (count.bind(label).step()) {
    count.read(counts.sessions, counts.attempts, counts.answers, counts.recordings);
  }
  return counts;
}

void insert_withdrawal(Database& database, WithdrawalRow& row) {
  Statement insertion(
      database,
      "INSERT INTO withdrawal (data, is_virtual, reason, decided_by, withdrawn_utc, sessions, "
      "attempts, answers, recordings) VALUES (?, ?, ?, ?, coalesce(nullif(?, ''), "
      "strftime('%Y-%m-%dT%H:%M:%fZ', 'now')), ?, ?, ?, ?) RETURNING withdrawn_utc");
  insertion.bind(text_of(row.data), row.is_virtual, text_of(row.reason), row.decided_by,
                 row.withdrawn_utc, row.sessions, row.attempts, row.answers, row.recordings);
  if (insertion.step()) insertion.read(row.withdrawn_utc);
  insertion.run();
}

/// Each session gets the decision that leaves it out, so that whoever reads decisions needs no rule of its own.
void exclude_sessions(Database& database, const std::string& label,
                      const WithdrawalRow& withdrawal) {
  Statement(
      database,
      "INSERT INTO decision (session_id, verdict, reason, reason_json, decided_by, decided_utc) "
      "SELECT session.id, 'exclude', ?2, ?3, ?4, strftime('%Y-%m-%dT%H:%M:%fZ', 'now') "
      "FROM session JOIN participant ON participant.id = session.participant_id "
      "WHERE label = ?1 ORDER BY session.id")
      .bind(label, reason_of_exclusion(withdrawal.reason), withdrawal.decided_by)
      .run();
}

/// The rules that keep rows from being removed are taken away for one transaction, which nobody else sees.
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

/// What names a row that is not there, and what names that, until nothing does: the tables say themselves what hangs
/// on what, so that one that a later schema adds is not forgotten.
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
  refuse_withdrawal(
      database.folder(),
      "is damaged: some of its rows refer to rows that do not exist, and a deletion could not "
      "distinguish them from the participant's. \"asperity verify\" lists them; restore the study "
      "from a copy");
}

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove_all(path, error);
  if (error) fail_on_file(path, "removed", error.value());
}

/// Files that hold a participant's data, or their label in the name.
std::vector<std::filesystem::path> files_of_participant(Database& database,
                                                        const std::string& label) {
  const std::filesystem::path& study = database.folder();
  std::vector<std::filesystem::path> files{study / "recordings" / label, study / "logs" / label,
                                           study / ("sheet-" + label + ".png")};
  Statement recording(database,
                      "SELECT path FROM recording JOIN attempt ON attempt.id = attempt_id "
                      "JOIN session ON session.id = session_id "
                      "JOIN participant ON participant.id = participant_id WHERE label = ?");
  recording.bind(label);
  while (recording.step()) {
    std::string path;
    recording.read(path);
    files.push_back(path_in_study(study, path));
  }
  const std::string kept = database_in(study).filename().string() + ".version-";
  for (const auto& entry : std::filesystem::directory_iterator(study)) {
    if (entry.path().filename().string().starts_with(kept)) files.push_back(entry.path());
  }
  return files;
}

/// Into the file itself whatever the log holds, and nothing left in the log.
void empty_log(Database& database) {
  constexpr int kTries = 50;
  constexpr std::chrono::milliseconds kPause{100};
  for (int i = 0; i < kTries; ++i) {
    if (i > 0) std::this_thread::sleep_for(kPause);
    int busy = 1;
    Statement checkpoint(database, "PRAGMA wal_checkpoint(TRUNCATE)");
    if (checkpoint.step()) checkpoint.read(busy);
    checkpoint.run();
    if (busy == 0) return;
  }
  refuse_withdrawal(database.folder(),
                    "no longer contains the participant's rows, but another program is reading it. "
                    "The log study.sqlite-wal contains them until that program closes the study. "
                    "Close it there, then open the study once",
                    SQLITE_BUSY);
}

/// While it lives a parent can be removed before what hangs on it, and what is removed is overwritten with zeros.
/// Neither can be changed inside a transaction.
class Removing final {
 public:
  explicit Removing(Database& database) : database_(database) {
    database.execute("PRAGMA foreign_keys = OFF; PRAGMA secure_delete = ON");
  }
  Removing(const Removing&) = delete;
  Removing& operator=(const Removing&) = delete;
  ~Removing() {
    sqlite3_exec(database_.handle(), "PRAGMA foreign_keys = ON", nullptr, nullptr, nullptr);
  }

 private:
  Database& database_;
};

void delete_rows(Database& database, const std::string& label, WithdrawalRow& row) {
  const Removing removing(database);
  Transaction transaction(database);
  WithoutTriggers triggers(database);
  Statement(database, "DELETE FROM participant WHERE label = ?").bind(label).run();
  delete_orphans(database);
  triggers.restore();
  insert_withdrawal(database, row);
  transaction.commit();
}

}  // namespace

WithdrawalRow Study::counts_of_participant(const std::string& label) const {
  return store_->read([&label](Database& database) { return count_rows(database, label); });
}

WithdrawalRow Study::withdraw(const std::string& label, const WithdrawalRow& withdrawal) {
  Database& database = store_->writable();
  if (withdrawal.decided_by.empty()) {
    refuse_withdrawal(store_->folder,
                      "has no name of the person who decided on the withdrawal of participant " +
                          label + "; enter that name");
  }
  WithdrawalRow row = withdrawal;
  count_rows(database, label);  // before a lock is made for a label that is not there
  std::optional<StudyLock> lock(std::in_place, store_->folder, session_lock_name(label));
  const WithdrawalRow counts = count_rows(database, label);
  row.is_virtual = counts.is_virtual;
  row.sessions = counts.sessions;
  row.attempts = counts.attempts;
  row.answers = counts.answers;
  row.recordings = counts.recordings;
  if (row.data == WithdrawnData::kept) {
    if (participant(label)->withdrawn) {
      refuse_withdrawal(store_->folder, "already has a withdrawal of participant " + label +
                                            "; to delete the data as well, request their deletion");
    }
    Transaction transaction(database);
    exclude_sessions(database, label, row);
    Statement(database, "UPDATE participant SET withdrawn = 1 WHERE label = ?").bind(label).run();
    insert_withdrawal(database, row);
    transaction.commit();
    return row;
  }
  refuse_orphans(database);
  // The rows go after the files, so that an interrupted deletion can be repeated.
  for (const auto& file : files_of_participant(database, label)) remove_file(file);
  sync_folder(store_->folder / "recordings");
  sync_folder(store_->folder);
  delete_rows(database, label, row);
  lock.reset();  // removes its file
  // For pages that were free before: in the others what was removed is overwritten.
  database.execute("VACUUM");
  empty_log(database);
  return row;
}

std::vector<WithdrawalRow> Study::withdrawals() const {
  return store_->read([](Database& database) {
    Statement statement(database,
                        "SELECT data, is_virtual, reason, decided_by, withdrawn_utc, sessions, "
                        "attempts, answers, recordings FROM withdrawal ORDER BY id");
    std::vector<WithdrawalRow> rows;
    while (statement.step()) {
      WithdrawalRow& row = rows.emplace_back();
      std::string data;
      std::string reason;
      statement.read(data, row.is_virtual, reason, row.decided_by, row.withdrawn_utc, row.sessions,
                     row.attempts, row.answers, row.recordings);
      row.data = enum_of(data, kWithdrawnData, "withdrawal.data");
      row.reason = enum_of(reason, kReasons, "withdrawal.reason");
    }
    return rows;
  });
}

}  // namespace asperity
