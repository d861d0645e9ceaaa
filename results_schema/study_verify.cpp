// Everything of a study that does not hold.

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <set>
#include <stop_token>
#include <system_error>
#include <utility>

#include <sqlite3.h>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/error_text.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"
#include "results_schema/table_rules.h"

namespace asperity {
namespace {

using Findings = std::vector<std::string>;

struct VouchedFile {
  std::string path{};
  std::string sha256{};
  std::int64_t bytes = 0;
  std::string who{};  ///< what it belongs to, for the sentence
  bool is_recording = false;
  std::int64_t records = 0;  ///< of a recording
};

/// One finding for all that SQLite complains of: its lines name pages and cells, which say nothing to a reader.
void check_pages(Database& database, Findings& findings) {
  Statement integrity(database, "PRAGMA integrity_check");
  if (!integrity.step()) return;
  std::string text;
  integrity.read(text);
  if (text == "ok") return;
  if (text.starts_with("***")) text.erase(0, text.find('\n') + 1);  // "*** in database main ***"
  findings.push_back(
      "study.sqlite: the file fails the integrity check of the database, and rows may be "
      "changed or missing; restore the study from a copy. Quote in a report of this error: " +
      text.substr(0, text.find('\n')));
}

void check_constraints(Database& database, Findings& findings) {
  for (const std::string& broken : broken_checks(database)) {
    findings.push_back("study.sqlite: " + broken);
  }
}

/// Whoever may write can drop a trigger, and then change what the trigger kept.
void check_objects(Database& database, std::span<const Migration> migrations, Findings& findings) {
  Database made(database.folder(), "", Database::Mode::in_memory);
  migrate(made, 0, migrations);
  for (const std::string& changed : changed_objects(database, made)) {
    findings.push_back("study.sqlite: " + changed);
  }
}

void check_references(Database& database, Findings& findings) {
  Statement keys(database, "PRAGMA foreign_key_check");
  while (keys.step()) {
    std::string table;
    std::optional<std::int64_t> row;
    std::string parent;
    keys.read(table, row, parent);
    findings.push_back("study.sqlite: a row of " + table + " refers to a row of " + parent +
                       " that does not exist; restore the study from a copy");
  }
}

void check_seal(const std::filesystem::path& study, const SealWatch& watch, Findings& findings) {
  if (seal_of(study, watch) != Seal::broken) return;
  findings.emplace_back(
      "study.sqlite: it has changed since Asperity last closed it (its SHA-256 differs from that "
      "in study.sqlite.sha256); restore both files from a copy, or remove study.sqlite.sha256 if "
      "the study was changed on purpose: by another tool, by copying another file over it, or by a "
      "user who may not remove that file");
}

void check_protocols(const Study& study, Findings& findings) {
  for (const ProtocolRow& row : study.protocols()) {
    if (sha256_of(row.source) != row.source_sha256) {
      findings.push_back(
          "protocol " + row.name + " " + row.version +
          ": the SHA-256 of its source differs from the stored one; restore the study "
          "from a copy");
    }
  }
}

/// Each query gives sentences about rows that contradict each other in a way no constraint forbids.
void check_rows(Database& database, Findings& findings) {
  constexpr const char* kContradictions[] = {
      "SELECT 'session ' || label || '/' || session || ': its planned trials are not numbered 1 to "
      "' "
      "|| count(*) FROM trial JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id "
      "GROUP BY session.id HAVING max(trial) <> count(*)",

      "SELECT 'participant ' || label || ': the sessions of the protocol ' || protocol.name || "
      "' are in different groups: ' || group_concat(DISTINCT group_level) "
      "FROM session JOIN protocol ON protocol.id = protocol_id "
      "JOIN participant ON participant.id = participant_id "
      "GROUP BY participant.id, protocol.name, mode HAVING count(DISTINCT group_level) > 1",

      "SELECT 'participant ' || label || ': session ' || session || ' is a simulation, but the "
      "participant is not virtual; restore the study from a copy' "
      "FROM session JOIN participant ON participant.id = participant_id "
      "WHERE mode = 'simulate' AND is_virtual = 0",

      "SELECT 'session ' || label || '/' || session || ': its segments are not numbered 1 to ' "
      "|| count(*) FROM segment JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id "
      "GROUP BY session.id HAVING max(segment) <> count(*)",

      "SELECT 'trial ' || label || '/' || session || '/' || trial || "
      "': its attempts are not numbered 1 to ' || count(*) "
      "FROM attempt JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id "
      "GROUP BY session.id, trial HAVING max(attempt) <> count(*)",

      "SELECT 'attempt ' || label || '/' || session || '/' || trial || '/' || attempt || "
      "': it is answered, but there is no response' "
      "FROM attempt JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id WHERE outcome = 'answered' "
      "AND NOT EXISTS (SELECT 1 FROM response WHERE attempt_id = attempt.id)",

      "SELECT 'session ' || label || '/' || session || ': it is completed, but trial ' || trial || "
      "' was never attempted' "
      "FROM trial JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id "
      "WHERE state = 'completed' AND phase = 'main' AND NOT EXISTS "
      "(SELECT 1 FROM attempt WHERE attempt.session_id = session.id AND attempt.trial = "
      "trial.trial)",

      "SELECT 'session ' || label || '/' || session || ': it is ' || state || "
      "', but its segment ' || segment || ' has no end' "
      "FROM segment JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id "
      "WHERE state <> 'open' AND end_reason IS NULL",
  };
  for (const char* const sql : kContradictions) {
    Statement statement(database, sql);
    while (statement.step()) statement.read(findings.emplace_back());
  }
}

std::vector<VouchedFile> vouched_files(Database& database) {
  Statement statement(
      database,
      "SELECT path, sha256, bytes, 'the recording of attempt ' || label || '/' || session || '/' "
      "|| "
      "trial || '/' || attempt, 1, records FROM recording JOIN attempt ON attempt.id = attempt_id "
      "JOIN session ON session.id = session_id JOIN participant ON participant.id = participant_id "
      "UNION ALL SELECT path, sha256, bytes, 'a stimulus of session ' || min(label || '/' || "
      "session), 0, 0 FROM session_file JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id GROUP BY path, sha256, bytes "
      "ORDER BY path");
  std::vector<VouchedFile> files;
  while (statement.step()) {
    VouchedFile& file = files.emplace_back();
    statement.read(file.path, file.sha256, file.bytes, file.who, file.is_recording, file.records);
  }
  return files;
}

/// How long reading them will take, and nothing where they cannot be asked for: that is found later.
double bytes_of_vouched_files(Database& database) {
  double bytes = 0.0;
  try {
    Statement statement(
        database,
        "SELECT total(bytes) FROM (SELECT bytes FROM recording UNION ALL "
        "SELECT bytes FROM (SELECT DISTINCT path, sha256, bytes FROM session_file))");
    if (statement.step()) statement.read(bytes);
  } catch (const ResultsError&) {
  }
  return bytes;
}

/// While it lives, a statement that takes long ends when asked to, with an error, and `meanwhile` is
/// called about every millisecond by the thread that it runs on.
class WatchOfStatements final {
 public:
  WatchOfStatements(Database& database, std::stop_token stop, std::function<void()> meanwhile = {})
      : database_(database), stop_(std::move(stop)), meanwhile_(std::move(meanwhile)) {
    constexpr int kInstructions = 10'000;  // of SQLite's machine
    sqlite3_progress_handler(database_.handle(), kInstructions, is_asked_to_stop, this);
  }
  WatchOfStatements(const WatchOfStatements&) = delete;
  WatchOfStatements& operator=(const WatchOfStatements&) = delete;
  ~WatchOfStatements() { sqlite3_progress_handler(database_.handle(), 0, nullptr, nullptr); }

  /// What `meanwhile` threw, which ends a statement: SQLite lets no exception through.
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  static int is_asked_to_stop(void* watch) noexcept {
    auto& own = *static_cast<WatchOfStatements*>(watch);
    try {
      if (own.meanwhile_) own.meanwhile_();
    } catch (...) {
      own.failure_ = std::current_exception();
      return 1;
    }
    return own.stop_.stop_requested() ? 1 : 0;
  }

  Database& database_;
  std::stop_token stop_;
  std::function<void()> meanwhile_;
  std::exception_ptr failure_{};
};

double bytes_of_a_page(Database& database) {
  Statement statement(database, "PRAGMA page_size");
  double bytes = 0.0;
  if (statement.step()) statement.read(bytes);
  return bytes;
}

/// From the file, through this connection.
double pages_read(Database& database) {
  int pages = 0;
  int highest = 0;
  sqlite3_db_status(database.handle(), SQLITE_DBSTATUS_CACHE_MISS, &pages, &highest, 0);
  return pages;
}

/// After a colon where a recording is damaged, as far as it says so itself.
std::string place_of_damage(const std::filesystem::path& recording) {
  try {
    read_recording(recording);
  } catch (const ResultsError& error) {
    if (error.code() == ENOMEM) throw;
    return std::string(": ") + error.what();
  }
  return {};
}

void check_file(const std::filesystem::path& study, const VouchedFile& file, Findings& findings) {
  const std::string start = file.path + " (" + file.who + "): ";
  try {
    const std::filesystem::path path = path_in_study(study, file.path);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
      const bool is_absent = !error || error == std::errc::no_such_file_or_directory ||
                             error == std::errc::not_a_directory;
      findings.push_back(
          start + (is_absent ? "the file is missing; restore it from a copy of the study"
                             : "the file cannot be read: " + text_of_error_number(error.value())));
    } else if (sha256_of_file(path) != file.sha256) {
      findings.push_back(
          start + "it has changed since its row was written (its SHA-256 differs)" +
          (file.is_recording ? place_of_damage(path) : "; restore it from a copy of the study"));
    } else {
      const auto compare = [&](const char* what, std::int64_t in_file, std::int64_t in_row) {
        if (in_file == in_row) return;
        findings.push_back(start + "the file has " + std::to_string(in_file) + ' ' + what +
                           ", and its row states " + std::to_string(in_row) +
                           "; restore study.sqlite from a copy of the study");
      };
      compare("bytes", static_cast<std::int64_t>(std::filesystem::file_size(path)), file.bytes);
      if (file.is_recording) compare("records", records_stated_in(path), file.records);
    }
  } catch (const ResultsError& error) {
    if (error.code() == ENOMEM) throw;  // of this computer, not of the file
    findings.push_back(start + error.what());
  }
}

bool passes_quick_check(Database& database, const std::stop_token& stop) {
  const WatchOfStatements watch(database, stop);
  Statement check(database, "PRAGMA quick_check(1)");
  std::string text;
  if (check.step()) check.read(text);
  return text == "ok";
}

bool says_broken(const ResultsError& error) {
  const int kind = error.code() & 0xff;
  return kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB;
}

}  // namespace

void Study::begin_condition() const {
  if (store_->condition.valid()) return;
  // Objects of its own: this one belongs to the caller's thread.
  const auto find = [folder = store_->folder, migrations = store_->migrations,
                     stop = store_->end_of_condition.get_token()] {
    const Seal seal = seal_of(folder, {.progress = {}, .stop = stop});
    if (seal == Seal::holds) return StudyCondition::whole;
    // Whoever writes has SQLite look at what they touch, and there is no end to what they change.
    if (seal != Seal::broken && is_being_written(folder)) return StudyCondition::whole;
    try {
      const Study study = open(folder, Access::read_only, migrations);
      const auto check = [&stop](Database& database) { return passes_quick_check(database, stop); };
      if (!study.store_->read(check)) return StudyCondition::broken;
    } catch (const ResultsError& error) {
      if (!says_broken(error)) throw;
      return StudyCondition::broken;
    }
    return seal == Seal::broken ? StudyCondition::changed : StudyCondition::whole;
  };
  // Where the system has no more threads, it is found when somebody wants to know.
  store_->condition = std::async(std::launch::async | std::launch::deferred, find).share();
}

StudyCondition Study::condition() const {
  begin_condition();
  return store_->condition.get();
}

std::vector<std::string> Study::verify(const std::function<void(double)>& progress,
                                       const std::stop_token& stop,
                                       const std::vector<StudyPart>& parts) const {
  const auto has = [&parts](StudyPart part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(database_in(store_->folder), error);
  const double database_bytes = error ? 0.0 : static_cast<double>(size);
  // SQLite reads every page for its trees, and about as many again for what is in them.
  const double bytes_of_pages = 2.0 * database_bytes;
  const double bytes_of_files = has(StudyPart::files) ? store_->read(bytes_of_vouched_files) : 0.0;
  const double bytes = (has(StudyPart::checksum) ? database_bytes : 0.0) +
                       (has(StudyPart::database) ? bytes_of_pages : 0.0) + bytes_of_files;
  double bytes_done = 0.0;
  const auto tell = [&](double more) {
    if (progress && bytes > 0.0) progress(std::min(1.0, (bytes_done + more) / bytes));
  };
  Findings all;
  const auto add = [&all](const Findings& findings) {
    for (const std::string& finding : findings) {
      // What is so broken that it cannot be read is told by every part.
      if (std::find(all.begin(), all.end(), finding) == all.end()) all.push_back(finding);
    }
  };
  const auto look = [&](const std::function<void(Database&, Findings&)>& check) {
    add(store_->read([&](Database& database) {
      Findings findings;
      try {
        check(database, findings);
      } catch (const ResultsError& broken) {
        if (!stop.stop_requested()) findings.emplace_back(broken.what());
      }
      return findings;
    }));
  };
  tell(0.0);
  for (const StudyPart part : parts) {
    if (stop.stop_requested()) return all;
    switch (part) {
      case StudyPart::checksum: {
        Findings findings;
        try {
          const auto tell_share = [&](double share) { tell(share * database_bytes); };
          check_seal(store_->folder, {.progress = tell_share, .stop = stop}, findings);
        } catch (const ResultsError& broken) {
          findings.emplace_back(broken.what());
        }
        add(findings);
        bytes_done += database_bytes;
        break;
      }
      case StudyPart::database:
        tell(0.0);
        look([&](Database& database, Findings& findings) {
          const double pages_before = pages_read(database);
          const double page_bytes = bytes_of_a_page(database);
          const WatchOfStatements watch(database, stop, [&] {
            const double pages = pages_read(database) - pages_before;
            tell(std::min(bytes_of_pages, pages * page_bytes));
          });
          try {
            check_pages(database, findings);
          } catch (const ResultsError&) {
            watch.rethrow_failure();
            throw;
          }
        });
        bytes_done += bytes_of_pages;
        break;
      case StudyPart::files: {
        std::vector<VouchedFile> files;
        look([&](Database& database, Findings&) {
          const WatchOfStatements watch(database, stop);
          files = vouched_files(database);
        });
        double bytes_hashed = 0.0;
        for (const VouchedFile& file : files) {
          if (stop.stop_requested()) return all;
          tell(bytes_hashed);
          Findings findings;
          check_file(store_->folder, file, findings);
          add(findings);
          bytes_hashed += static_cast<double>(file.bytes);
        }
        bytes_done += bytes_of_files;
        break;
      }
      case StudyPart::rows:
        look([&](Database& database, Findings& findings) {
          const WatchOfStatements watch(database, stop);
          check_protocols(*this, findings);
          check_objects(database, store_->migrations, findings);
          check_constraints(database, findings);
          check_references(database, findings);
          check_rows(database, findings);
        });
        break;
    }
  }
  if (!stop.stop_requested()) tell(0.0);
  return all;
}

std::vector<std::string> Study::leftovers() const {
  std::set<std::string> known;
  const std::filesystem::path& study = store_->folder;
  std::set<std::filesystem::path> being_deleted;
  bool is_deleting = false;
  bool has_deleted = false;
  store_->read([&](Database& database) {
    known.clear();
    for (const VouchedFile& file : vouched_files(database)) known.insert(file.path);
    is_deleting = !unfinished_deletions(database).empty();
    has_deleted = number_of_deletions(database) > 0;
    being_deleted = files_being_deleted(database, study);
    return true;
  });
  std::vector<std::string> leftovers;
  for (const auto& entry : entries_below(study)) {
    // A folder comes before its content.
    if (being_deleted.contains(entry.path()) ||
        being_deleted.contains(entry.path().parent_path())) {
      being_deleted.insert(entry.path());
      continue;
    }
    std::error_code unknown;
    if (!entry.is_regular_file(unknown)) continue;
    const std::filesystem::path relative = entry.path().lexically_relative(study);
    const std::string path = relative.string();
    if (relative.extension() == kPartEnding || relative.extension() == ".tmp") {
      leftovers.push_back(
          path +
          ": an incomplete file, which is being written now or was left by a program that crashed. "
          "If no program is writing to the study, remove it: " +
          (relative.extension() == kPartEnding ? "no row refers to the records that it contains"
                                               : "the file of this name was not changed"));
    } else if (*relative.begin() == "recordings" && !known.contains(path)) {
      leftovers.push_back(path +
                          ": a recording that belongs to no attempt, which is being written now or "
                          "was left by a program that crashed. If no program is writing to the "
                          "study, remove it, or keep it as the record of an attempt that is not "
                          "stored");
    }
  }
  if (is_deleting) {
    leftovers.emplace_back(
        "study.sqlite: the deletion of a participant's data is not complete: it is being done, or "
        "its program crashed. The next program that writes to the study completes it");
  }
  // The last step of a deletion is in the log first, and what it overwrites in the file.
  if (has_deleted && !is_deleting && !log_is_empty(study) && !is_being_written(study)) {
    leftovers.emplace_back(
        "study.sqlite-wal: the log is not empty: a program crashed before it had emptied it, or "
        "reads "
        "the study. If the data of a participant were deleted last, study.sqlite may still contain "
        "bytes of them. The next program that writes to the study empties the log; do not copy the "
        "folder before");
  }
  if (!has_seal(study)) {
    leftovers.push_back(
        "study.sqlite: there is no checksum of the whole file: it is being written, was left by a "
        "program that crashed, or was changed by another tool. The next program that writes to the "
        "study stores one");
  }
  std::sort(leftovers.begin(), leftovers.end());
  return leftovers;
}

}  // namespace asperity
