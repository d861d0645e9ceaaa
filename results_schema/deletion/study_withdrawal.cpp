// A participant who withdraws: their data are kept and never used, or deleted without a trace.

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/error_text.h"
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

/// How long a deletion waits for programs that read the study, such as an export of it.
constexpr std::chrono::seconds kLongestWait{30};

[[noreturn]] void refuse_withdrawal(const std::filesystem::path& folder, const std::string& why) {
  throw ResultsError("the study " + folder.string() + " " + why, folder);
}

[[noreturn]] void refuse_label(Database& database, const std::string& label) {
  Statement last(database,
                 "SELECT withdrawn_utc, label IS NULL FROM withdrawal WHERE data = 'deleted' "
                 "ORDER BY id DESC LIMIT 1");
  std::string withdrawn_utc;
  bool is_complete = true;
  if (last.step()) last.read(withdrawn_utc, is_complete);
  refuse_withdrawal(
      database.folder(),
      "has no participant " + label +
          (withdrawn_utc.empty()
               ? ""
               : "; its last deletion of the data of a participant, begun at " + withdrawn_utc +
                     (is_complete ? ", is complete"
                                  : ", is not complete; repeat it with --delete")) +
          "; use a label from the page Participants or from participants.tsv of an "
          "export");
}

WithdrawalRow count_rows(Database& database, const std::string& label) {
  WithdrawalRow counts{};
  Statement participant(database,
                        "SELECT participant.is_virtual, coalesce(reason, ?2) FROM participant "
                        "LEFT JOIN withdrawal ON participant_id = participant.id "
                        "WHERE participant.label = ?1");
  if (!participant.bind(label, text_of(counts.reason)).step()) refuse_label(database, label);
  std::string reason;
  participant.read(counts.is_virtual, reason);
  counts.reason = enum_of(reason, kReasons, "withdrawal.reason");
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

/// Each session gets the decision that leaves it out, so that readers of decisions need no rule for withdrawals.
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

constexpr const char* kWithdrawalColumns =
    "SELECT data, is_virtual, reason, decided_by, withdrawn_utc, sessions, attempts, answers, "
    "recordings FROM withdrawal ";

WithdrawalRow read_withdrawal(Statement& statement) {
  WithdrawalRow row{};
  std::string data;
  std::string reason;
  statement.read(data, row.is_virtual, reason, row.decided_by, row.withdrawn_utc, row.sessions,
                 row.attempts, row.answers, row.recordings);
  row.data = enum_of(data, kWithdrawnData, "withdrawal.data");
  row.reason = enum_of(reason, kReasons, "withdrawal.reason");
  return row;
}

WithdrawalRow withdrawal_of(Database& database, std::int64_t id) {
  Statement statement(database, std::string(kWithdrawalColumns) + "WHERE id = ?");
  return statement.bind(id).step() ? read_withdrawal(statement) : WithdrawalRow{};
}

/// `waits` is called at most once. Errors: ResultsError that states what is done and what to do.
void complete(Database& database, const UnfinishedDeletion& deletion,
              const std::function<void()>& waits, const std::stop_token& stop) {
  bool is_waiting = false;
  const auto wait_once = [&] {
    if (!std::exchange(is_waiting, true) && waits) waits();
  };
  try {
    complete_deletion(database, deletion,
                      {.longest = kLongestWait, .begins = wait_once, .stop = stop});
  } catch (const std::exception& error) {
    const auto* const of_store = dynamic_cast<const ResultsError*>(&error);
    throw ResultsError("the rows of participant " + deletion.label +
                           " are deleted from the study " + database.folder().string() +
                           ", but the deletion is not complete, and files or bytes of the data may "
                           "remain: " +
                           message_of(error) +
                           ". Correct this, then repeat the deletion; the next program that writes "
                           "to the study completes it as well",
                       database.folder(), of_store == nullptr ? 0 : of_store->code());
  }
}

}  // namespace

void Study::Store::complete_deletions() noexcept {
  // A session can begin although a deletion cannot be completed: `Study::withdraw` states why.
  try {
    if (unfinished_deletions(*database).empty()) return;
    // The database cannot be compacted in time while a session writes to it.
    if (!StudyLock::held(folder, Study::session_lock_name("")).empty()) return;
    const StudyLock lock(folder, kDeletionLock);  // a withdrawal that is running completes its own
    for (const UnfinishedDeletion& deletion : unfinished_deletions(*database)) {
      try {
        std::vector<OutputRow> outputs = outputs_in(*database);
        complete_deletion(*database, deletion, {});
        completed_deletions.push_back({deletion, std::move(outputs)});
      } catch (const std::exception&) {  // one that cannot be completed does not stop the others
      }
    }
  } catch (const std::exception&) {
  }
}

std::optional<Study::Store::InterruptedDeletion> Study::Store::interrupted_deletion(
    Database& of, const std::string& label) const {
  Statement participant(of, "SELECT 1 FROM participant WHERE label = ?");
  if (participant.bind(label).step()) return std::nullopt;
  for (const CompletedDeletion& completed : completed_deletions) {
    if (completed.deletion.label != label) continue;
    return InterruptedDeletion{completed.deletion, completed.outputs, true};
  }
  for (const UnfinishedDeletion& deletion : unfinished_deletions(of)) {
    if (deletion.label != label) continue;
    return InterruptedDeletion{deletion, outputs_in(of), false};
  }
  return std::nullopt;
}

WithdrawalRow Study::counts_of_participant(const std::string& label) const {
  return store_->read([this, &label](Database& database) {
    const auto interrupted = store_->interrupted_deletion(database, label);
    return interrupted ? withdrawal_of(database, interrupted->deletion.withdrawal)
                       : count_rows(database, label);
  });
}

Withdrawal Study::withdraw(const std::string& label, const WithdrawalRow& withdrawal,
                           const std::function<void()>& waits, const std::stop_token& stop) {
  Database& database = store_->writable();
  if (withdrawal.decided_by.empty()) {
    refuse_withdrawal(store_->folder,
                      "has no name of the person who decided on the withdrawal of participant " +
                          label + "; enter that name");
  }
  const bool deletes = withdrawal.data == WithdrawnData::deleted;
  if (deletes) {
    if (const auto interrupted = store_->interrupted_deletion(database, label)) {
      if (!interrupted->is_complete) {
        const StudyLock lock(store_->folder, kDeletionLock);
        // Another program can have completed it before the lock was taken, and the label can be in use again.
        const auto unfinished = unfinished_deletions(database);
        const bool is_unfinished =
            std::any_of(unfinished.begin(), unfinished.end(), [&](const UnfinishedDeletion& other) {
              return other.withdrawal == interrupted->deletion.withdrawal;
            });
        if (is_unfinished) complete(database, interrupted->deletion, waits, stop);
      }
      return {.row = withdrawal_of(database, interrupted->deletion.withdrawal),
              .outputs = interrupted->outputs};
    }
  }
  count_rows(database, label);  // before a lock is made for a label that is not there
  std::optional<StudyLock> deletions;
  if (deletes) deletions.emplace(store_->folder, kDeletionLock);
  std::optional<StudyLock> session(std::in_place, store_->folder, session_lock_name(label));
  Withdrawal done{.row = count_rows(database, label), .outputs = {}};
  done.row.data = withdrawal.data;
  done.row.reason = withdrawal.reason;
  done.row.decided_by = withdrawal.decided_by;
  done.row.withdrawn_utc = withdrawal.withdrawn_utc;
  if (deletes) {
    const DeletedRows deleted = delete_rows(database, label, done.row);
    done.outputs = deleted.outputs;
    session.reset();  // removes its file; the rules of the schema keep the label from being used
    complete(database, deleted.deletion, waits, stop);
    return done;
  }
  if (participant(label)->withdrawn) {
    refuse_withdrawal(store_->folder,
                      "already has a withdrawal of participant " + label +
                          ", which kept the data; to delete them, repeat the withdrawal "
                          "with --delete");
  }
  Transaction transaction(database);
  done.outputs = outputs_since_added_in(database, label);
  exclude_sessions(database, label, done.row);
  Statement(database, "UPDATE participant SET withdrawn = 1 WHERE label = ?").bind(label).run();
  insert_withdrawal(database, done.row, label);
  transaction.commit();
  return done;
}

std::vector<WithdrawalRow> Study::withdrawals() const {
  return store_->read([](Database& database) {
    Statement statement(database, std::string(kWithdrawalColumns) + "ORDER BY id");
    std::vector<WithdrawalRow> rows;
    while (statement.step()) rows.push_back(read_withdrawal(statement));
    return rows;
  });
}

}  // namespace asperity
