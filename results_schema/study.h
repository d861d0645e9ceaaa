// The store of a study: a folder with one SQLite file and the files that it vouches for.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "results_schema/rows.h"
#include "results_schema/session_answers.h"

namespace asperity {

/// A store that could not do what was asked: which file, and SQLite's or the system's code.
class ResultsError final : public std::runtime_error {
 public:
  ResultsError(const std::string& message, std::filesystem::path path, int code = 0)
      : std::runtime_error(message), path_(std::move(path)), code_(code) {}
  const std::filesystem::path& path() const noexcept { return path_; }
  int code() const noexcept { return code_; }

 private:
  std::filesystem::path path_{};
  int code_ = 0;
};

struct Migration;
struct MergeSource;
struct MergeSettings;
struct MergedCounts;

enum class Access { read_only, read_write };

/// What `Study::verify` looks at. Each part can be looked at by a thread of its own, with a Study of its
/// own.
enum class StudyPart {
  checksum,  ///< of study.sqlite, byte by byte
  database,  ///< its pages, trees and indices, by SQLite's integrity check
  files,     ///< hashes of recordings and stimuli
  rows,      ///< constraints, references, hashes of protocols, rows that contradict each other
};

/// What is known of the file `study.sqlite` as a whole.
enum class StudyCondition {
  whole,    ///< its checksum holds; or none is there, and SQLite finds nothing wrong
  changed,  ///< it is not what it was when it was last closed: its checksum does not hold
  broken,   ///< SQLite finds its pages or rows damaged: what is read may lack rows
};

/// The names and values that differ from study to study, each once, sorted.
struct StudyWords {
  std::vector<std::string> factors_json{};                          ///< of planned trials
  std::vector<std::pair<std::string, std::string>> parameters{};    ///< model, parameters_json
  std::vector<std::pair<std::string, std::string>> model_limits{};  ///< kind, model that watches it
  std::vector<std::pair<std::string, std::string>> assets{};        ///< role, model that used one
};

/// A study on disk: `study.sqlite`, `protocols/`, `stimuli/`, `recordings/`.
///
/// What the caller may rely on:
/// - When a writing function returns, its rows survive a power loss (WAL, synchronous=FULL).
/// - Attempts and what hangs on them are append-only, enforced by the schema on every connection.
/// - A transaction is all or nothing; after any error the study holds what was committed before. (One
///   that was written and could not be synced, or whose program was killed before it was reported, may be
///   there as well: a program that resumes reads first what is there.)
/// - A study opened `read_only` is never written to, not even by SQLite's own bookkeeping, so that it
///   may lie on a medium that cannot be written. While another program writes, the reader follows.
/// - A study of an older schema from which this program has migrations is read as if it had been migrated, from a copy
///   in memory. Opening it for writing migrates it, and keeps the previous file next to it, for example as
///   `study.sqlite.version-20`; the older program can no longer open the study then.
/// - Whatever is returned in order is ordered by natural keys, never by the order of writing.
///
/// Errors: ResultsError with a sentence: no study there, a schema that this program does not read, a read-only
/// folder, a full disk, a network file system (sessions only), a broken database.
///
/// Threads: one object belongs to one thread; several objects, in several processes, may be open on
/// the same study. Writers wait for each other.
class Study final {
 public:
  /// Makes a new, empty study. Refuses a folder that already holds something.
  static Study create(const std::filesystem::path& folder, const std::string& name);
  static Study open(const std::filesystem::path& folder, Access access);
  /// As a program with these migrations does, which must outlive the study. None of them may be missing in between.
  static Study create(const std::filesystem::path& folder, const std::string& name,
                      std::span<const Migration> migrations);
  static Study open(const std::filesystem::path& folder, Access access,
                    std::span<const Migration> migrations);
  /// For a program that reads and writes studies at the same time, such as the windows: from now on
  /// its readers take part in SQLite's bookkeeping (where the folder can be written to). Within one
  /// process all connections share one index of the log; a reader that may not touch it would have
  /// SQLite refuse the writers. To be called before the first study is opened.
  static void read_beside_writers() noexcept;
  static bool exists(const std::filesystem::path& folder);
  /// Whether the user of this program may write to it, where it lies. It can still be read.
  static bool can_be_written(const std::filesystem::path& folder) noexcept;

  Study(Study&&) noexcept;
  Study& operator=(Study&&) noexcept;
  ~Study();

  const std::filesystem::path& folder() const noexcept;
  Access access() const noexcept;
  std::string name() const;
  /// That of the file, also where it is read as if it had been migrated.
  int schema_version() const noexcept;

  StudyMetadata metadata() const;
  /// In place of what there was.
  void set_metadata(const StudyMetadata& metadata);

  /// Lists what is about to be made of the study, so that a withdrawal from then on knows of it; `made_utc` is ignored.
  /// Returns its id.
  std::int64_t begin_output(const OutputRow& output);
  void end_output(std::int64_t id);        ///< it is complete, from now on for ever
  void remove_output(std::int64_t id);     ///< it was not made
  std::vector<OutputRow> outputs() const;  ///< in the order of listing
  /// Those that can contain data of a participant: not complete, or made since the participant was added; of a virtual one,
  /// whose dates are those of a simulated calendar, all.
  std::vector<OutputRow> outputs_since_added(const std::string& label) const;

  /// `created_utc` may be empty: the time of the call.
  void add_participant(const ParticipantRow& participant);
  void add_participants(const std::vector<ParticipantRow>& participants);  ///< all or none
  std::optional<ParticipantRow> participant(const std::string& label) const;
  std::vector<ParticipantRow> participants() const;  ///< by label

  /// What the study holds of a participant: counts as in WithdrawalRow, with the reason of a withdrawal that kept the data. Of one
  /// whose deletion was interrupted, what it held.
  WithdrawalRow counts_of_participant(const std::string& label) const;
  /// A participant withdraws, for good. With `kept` all their sessions are excluded, none can be begun, resumed or
  /// included again, and their counterbalancing rows are free. With `deleted` nothing of them is left in the folder:
  /// rows, recordings, files named after them, the paths of outputs that name them (label_in_path.h), the study from before a
  /// migration (`study.sqlite.version-*`), which holds them as well, and the free pages of the database. One who withdrew
  /// before can still be deleted. Returns what was stored, with its counts.
  ///
  /// The rows go in one transaction. When the deletion fails after that, or its program is killed, it is completed by the
  /// next program that opens the study for writing, or by a second call; until then no participant can have the label.
  /// Errors: ResultsError for a label that is not there, a session of theirs that is running, an empty `decided_by`, a
  /// file that cannot be removed, another program that reads for so long that the database's log cannot be emptied.
  ///
  /// `waits` is called once before a deletion waits for another program that reads the study; `stop` ends the wait as its longest
  /// time does.
  Withdrawal withdraw(const std::string& label, const WithdrawalRow& withdrawal,
                      const std::function<void()>& waits = {}, const std::stop_token& stop = {});
  std::vector<WithdrawalRow> withdrawals() const;  ///< in the order of withdrawing

  /// The row of this content, added if it is new. Returns its id. `source_sha256` is that of
  /// `source`, or empty to have it computed.
  std::int64_t add_protocol(const ProtocolRow& protocol);
  std::vector<ProtocolRow> protocols() const;
  ProtocolRow protocol(std::int64_t id) const;

  /// The session and its plan, as far as it is determined, in one transaction. Returns the session's id. The number
  /// `SessionRow::session` must be the participant's next one, or 0 to be given it.
  std::int64_t add_session(const SessionRow& session, const std::vector<PlannedTrialRow>& plan);
  /// The same with group and counterbalance row taken inside the transaction. The group, unless the session
  /// states it: that of the participant's earlier sessions of this protocol's name and this mode, otherwise the one
  /// with the fewest participants who have an open or completed session of that name and mode, or that of the claim's
  /// sequence. The row: the least
  /// used by such sessions of the group. The first of equals in both cases; who withdrew does not count. Where places are
  /// dealt to the study: group and row of the participant's place, or of the first one that no participant with such a session
  /// has; an event `dealt` states it. `plan_of` is
  /// called with the session as it will be stored. Two laboratories that start at once cannot both be given the same.
  std::int64_t add_session(
      const SessionRow& session, const SessionClaim& claim,
      const std::function<std::vector<PlannedTrialRow>(const SessionRow&)>& plan_of);
  SessionRow session(std::int64_t id) const;
  std::vector<SessionRow> sessions() const;  ///< by participant, session
  std::vector<PlannedTrialRow> plan(std::int64_t session_id) const;
  /// How many sessions of this protocol (open or completed) have each counterbalance row.
  std::vector<int> counterbalance_counts(const std::string& protocol_name, int rows) const;
  /// Of one mode and, where it is given, of one group.
  std::vector<int> counterbalance_counts(const std::string& protocol_name, int rows,
                                         SessionMode mode,
                                         const std::optional<std::string>& group = {}) const;
  /// How many participants with such a session each of these groups has.
  std::vector<int> group_counts(const std::string& protocol_name,
                                const std::vector<std::string>& groups, SessionMode mode) const;
  /// The group of a participant who has a session of this protocol's name and mode in one.
  std::optional<std::string> group_of_participant(const std::string& label,
                                                  const std::string& protocol_name,
                                                  SessionMode mode) const;

  /// The plug-ins with which surfaces were rendered, by model.
  std::vector<PluginUse> plugin_uses() const;
  /// What all plans and presentations together speak of.
  StudyWords words() const;

  /// Further trials of an open session whose plan depends on responses, in one transaction.
  void add_trials(std::int64_t session_id, const std::vector<PlannedTrialRow>& trials);

  /// A stretch of uninterrupted running. `time_ns` on the session's clock.
  int begin_segment(std::int64_t session_id, std::int64_t time_ns);
  void end_segment(std::int64_t session_id, int segment, std::int64_t time_ns,
                   const std::string& reason);
  void end_session(std::int64_t session_id, SessionState state, const std::string& ended_utc);
  /// A stopped or crashed session is resumed.
  void reopen_session(std::int64_t session_id);
  /// Sessions that are open but whose lock is not held become `crashed`, their running segments
  /// end with the reason "crashed". Returns their ids. Rests on `session_lock_name`.
  std::vector<std::int64_t> mark_crashed_sessions();
  /// The StudyLock that a program which runs a session of this participant holds, from before `add_session`
  /// or `reopen_session` until after `end_session`.
  static std::string session_lock_name(const std::string& participant);

  /// Returns the attempt's id. All rows or none.
  std::int64_t add_attempt(std::int64_t session_id, const AttemptRow& attempt);
  /// Attempts of a session in order, with everything that hangs on them.
  std::vector<AttemptRow> attempts(std::int64_t session_id) const;
  std::optional<AttemptRow> attempt(std::int64_t id) const;
  /// Of the attempts of a session what analyses count, which is read much faster than `attempts`.
  SessionAnswers answers(std::int64_t session_id, AnswerParts parts = AnswerParts::answers) const;
  /// Of every session, by its id: without reading what hangs on attempts.
  std::map<std::int64_t, SessionCounts> session_counts() const;
  /// Of one session.
  SessionCounts session_counts(std::int64_t session_id) const;
  /// The session of an attempt.
  std::int64_t session_of(std::int64_t attempt_id) const;

  /// A decision of the experimenter about data that stay unchanged. What is read of attempts and sessions
  /// afterwards states it: see AttemptRow::valid and `excluded`. Errors: ResultsError for an attempt
  /// that is not there, an empty reason, an attempt to set aside of a session that is not open.
  void add_decision(std::int64_t session_id, const DecisionRow& decision);
  std::vector<DecisionRow> decisions(std::int64_t session_id) const;  ///< in the order of deciding
  /// The attempt no longer counts, for ever, so that its trial can be asked again: the verdict
  /// `set_aside`, decided now by the experimenter.
  void set_aside(std::int64_t session_id, int trial, int attempt, const StoredWords& reason);

  /// Answers to questions that belong to a session rather than a trial.
  void add_session_answer(std::int64_t session_id, const ResponseRow& answer) {
    add_session_answer(session_id, std::span(&answer, 1));
  }
  /// The items of one answer, all or none of them.
  void add_session_answer(std::int64_t session_id, std::span<const ResponseRow> items);
  std::vector<ResponseRow> session_answers(std::int64_t session_id) const;

  /// What happened between attempts; those of an attempt are in its row.
  void add_event(std::int64_t session_id, const EventRow& event);
  std::vector<EventRow> events(std::int64_t session_id) const;
  /// The data of the events of a kind in all sessions, each content once, in the order in which they were first stored.
  std::vector<std::string> event_data(const std::string& kind) const;

  /// Solutions of matching problems, by a key of everything they depend on. The first one
  /// stays.
  void remember_solution(const std::string& key, const std::string& solution_json);
  std::optional<std::string> solution(const std::string& key) const;

  /// Runs `reading`; what it reads of this study is of one moment, whatever sessions write meanwhile. Begins again
  /// where the file turns out to have changed under it, or data of a participant were deleted meanwhile, so that `reading`
  /// must set its results, not add to them.
  void read_at_one_moment(const std::function<void()>& reading) const;

  /// A consistent copy of a study that may be in use, into a folder that does not exist yet. Where a participant's data are
  /// deleted meanwhile, it is begun again without them. Errors: ResultsError, also where it was asked to stop; nothing is left then.
  void copy_to(const std::filesystem::path& folder, const std::stop_token& stop = {}) const;
  /// The errors of `copy_to` that are known before anything is copied. Reads the file of the study.
  void refuse_copy_to(const std::filesystem::path& folder) const;

  /// A new study with the participants of several, into a folder that does not exist yet: their rows by natural keys, and
  /// the files of each (results_schema/merge/study_merge.h). The order of the sources does not matter: the same studies give
  /// the same `study.sqlite`. Each is read at one moment; where a participant's data are deleted meanwhile, the merge is
  /// begun again without them. Rows are copied one by one, whatever their number.
  ///
  /// Where the folder is a study already, the merge is made next to it and compared: the same bytes are accepted, so that a
  /// command can be repeated, and nothing is written.
  ///
  /// Errors: ResultsError, naming both places where it is about two studies: a study that is damaged, was changed, has a
  /// session that is running or a deletion that is not complete; two copies of one study, or studies that were merged from a
  /// common one; a label that two of them have; files of the same name, or statements about the study, that differ.
  static MergedCounts merge(std::span<const MergeSource> sources,
                            const std::filesystem::path& folder, const MergeSettings& settings);
  /// The errors of `merge` that are known from names alone.
  static void refuse_merge_to(std::span<const MergeSource> sources,
                              const std::filesystem::path& folder);

  /// Whether numbers read from the file can be trusted, for a caller that is about to read many. Much cheaper
  /// than `verify`: one pass over the file for its checksum, some half a second per gigabyte, and
  /// SQLite's quick check only where no checksum covers it and no program is writing.
  ///
  /// `begin_condition` has that done in the background; `condition` waits for it, and begins it if need
  /// be. Found once, for as long as this object lives. Errors: as `open`.
  void begin_condition() const;
  StudyCondition condition() const;

  /// Everything that does not hold: constraints, hashes of files and recordings, rows that
  /// contradict each other; part by part, in the order given. `progress` is called with 0 to 1 by the caller's
  /// thread, about as bytes are read; when asked to stop, what was found by then, within the moment that
  /// SQLite takes for one of its trees.
  std::vector<std::string> verify(const std::function<void(double)>& progress,
                                  const std::stop_token& stop = {},
                                  const std::vector<StudyPart>& parts = {
                                      StudyPart::checksum, StudyPart::database, StudyPart::files,
                                      StudyPart::rows}) const;
  /// Files that nothing vouches for: what a program that died was writing, the database itself while
  /// it is written to (docs/formats/study.md, "Checksum"). They contradict nothing, and whether they
  /// are of use is for a person to decide.
  std::vector<std::string> leftovers() const;

 private:
  struct Store;
  explicit Study(std::unique_ptr<Store> store);
  std::unique_ptr<Store> store_;
};

/// The process that holds a lock of a study.
struct LockHolder {
  std::string process{};  ///< its number; empty where only the description is known
  std::string host{};
  std::string started_utc{};
  std::string description{};  ///< "process 123 on host lab1, started …"
};

/// Holds `locks/<name>.lock` in the study while it lives. Throws ResultsError naming the host and
/// process that holds it. A lock whose process is gone is free: the kernel releases it.
///
/// The destructor removes the file, because its name may hold the label of a participant who is not in the study: of a
/// declined consent nothing remains. After a crash the file remains; what counts is the lock on it. A child made by
/// fork() without exec keeps the lock of a crashed process alive. Errors: also a name with other than letters, digits, "-" and "_", a folder
/// that cannot be written, a network file system, where such a lock cannot be trusted.
class StudyLock final {
 public:
  StudyLock(const std::filesystem::path& study, const std::string& name);
  ~StudyLock();
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

  /// The process that holds it now, if any. Takes and writes nothing.
  static std::optional<LockHolder> holder(const std::filesystem::path& study,
                                          const std::string& name);

  /// The names of those that begin so and are held now, in order. What lies in the folder of locks and is
  /// none, by its name or because it is no file, is passed over.
  /// Errors: ResultsError for a folder that cannot be read, and for a file that could be a lock and cannot be opened.
  static std::vector<std::string> held(const std::filesystem::path& study,
                                       const std::string& beginning);

 private:
  bool take(const std::filesystem::path& study, const std::string& name);

  std::filesystem::path path_{};
  int descriptor_ = -1;
};

}  // namespace asperity
