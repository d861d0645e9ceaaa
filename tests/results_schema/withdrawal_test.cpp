// A participant who withdraws: nothing of them is used, or nothing of them is left.

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/files/atomic_file.h"
#include "tests/results_schema/removal_fault.h"
#include "tests/results_schema/study_of_two.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

class WithdrawalFromAStudy : public StudyOfTwo {};

/// Another program's change, past the rules that the statement drops.
void run_sql(const std::filesystem::path& study, const std::string& sql) {
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open((study / "study.sqlite").c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

/// While it lives SQLite overwrites what is removed only on request; some distributions build it so that it does.
class SqliteThatKeepsWhatIsRemoved final {
 public:
  SqliteThatKeepsWhatIsRemoved() { sqlite3_auto_extension(reinterpret_cast<void (*)()>(&change)); }
  ~SqliteThatKeepsWhatIsRemoved() {
    sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&change));
  }
  SqliteThatKeepsWhatIsRemoved(const SqliteThatKeepsWhatIsRemoved&) = delete;
  SqliteThatKeepsWhatIsRemoved& operator=(const SqliteThatKeepsWhatIsRemoved&) = delete;

 private:
  static int change(sqlite3* handle, const char**, const void*) {
    return sqlite3_exec(handle, "PRAGMA secure_delete = OFF", nullptr, nullptr, nullptr);
  }
};

TEST_F(WithdrawalFromAStudy, DeletesEveryTraceOfTheParticipantFromTheFolder) {
  ASSERT_THAT(files_with("Wanda7"), testing::SizeIs(testing::Ge(5U)));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
  EXPECT_THAT(files_with("secret"), testing::ElementsAre("study.sqlite"));  // of the other
  const Study study = Study::open(path_, Access::read_only);
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
  EXPECT_THAT(study.leftovers(), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, DeletesNothingOfTheOthers) {
  const auto rows_of_other = [this] {
    const Study study = Study::open(path_, Access::read_only);
    std::vector<std::string> words{};
    for (const SessionRow& session : study.sessions()) {
      if (session.participant != "Stays1") continue;
      for (const AttemptRow& attempt : study.attempts(session.id)) {
        words.push_back(attempt.responses.at(0).answer + attempt.flag_reason->text +
                        attempt.recording->sha256);
      }
      for (const ResponseRow& row : study.session_answers(session.id)) words.push_back(row.answer);
      for (const EventRow& row : study.events(session.id)) words.push_back(row.text);
    }
    return words;
  };
  {
    Study study = open();
    const std::int64_t other = study.sessions().front().id;
    ASSERT_EQ(study.session(other).participant, "Stays1");
    study.add_decision(other, {.trial = 2,
                               .attempt = 1,
                               .verdict = Verdict::flag,
                               .reason = "second",
                               .decided_by = "R. Keeper"});
  }
  const std::vector<std::string> before = rows_of_other();
  ASSERT_EQ(before.size(), 4U);
  open().withdraw("Wanda7", kDeletion);
  EXPECT_EQ(rows_of_other(), before);
}

TEST_F(WithdrawalFromAStudy, LeavesARowThatCountsWithoutNaming) {
  open().withdraw("Wanda7", kDeletion);
  const std::vector<WithdrawalRow> rows = Study::open(path_, Access::read_only).withdrawals();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].data, WithdrawnData::deleted);
  EXPECT_EQ(rows[0].reason, WithdrawalReason::consent_withdrawn);
  EXPECT_EQ(rows[0].decided_by, "R. Keeper");
  EXPECT_EQ(rows[0].sessions, 1);
  EXPECT_EQ(rows[0].attempts, 2);
  EXPECT_EQ(rows[0].answers, 5);
  EXPECT_EQ(rows[0].recordings, 2);
  EXPECT_FALSE(rows[0].is_virtual);
  EXPECT_EQ(rows[0].withdrawn_utc.back(), 'Z');
}

TEST_F(WithdrawalFromAStudy, IsOneWithdrawalWhereDataThatWereKeptAreDeletedLater) {
  Study study = open();
  study.withdraw("Stays1", {.decided_by = "R. Keeper"});
  study.withdraw("Wanda7", {.decided_by = "R. Keeper"});
  ASSERT_EQ(study.withdrawals().size(), 2U);
  study.withdraw("Wanda7", kDeletion);
  const std::vector<WithdrawalRow> rows = study.withdrawals();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].data, WithdrawnData::kept) << "of the other participant";
  EXPECT_EQ(rows[1].data, WithdrawnData::deleted);
}

TEST_F(WithdrawalFromAStudy, FreesTheCounterbalancingRow) {
  const auto rows_used = [this] {
    return Study::open(path_, Access::read_only).counterbalance_counts(some_protocol().name, 2);
  };
  ASSERT_THAT(rows_used(), testing::ElementsAre(1, 1));
  open().withdraw("Wanda7", kKept);
  EXPECT_THAT(rows_used(), testing::ElementsAre(1, 0));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(rows_used(), testing::ElementsAre(1, 0));
}

TEST_F(WithdrawalFromAStudy, KeepsDataThatNothingUses) {
  open().withdraw("Wanda7", kKept);
  Study study = open();
  EXPECT_TRUE(study.participant("Wanda7")->withdrawn);
  EXPECT_FALSE(study.participant("Stays1")->withdrawn);
  const SessionRow session = study.sessions().back();
  ASSERT_EQ(session.participant, "Wanda7");
  EXPECT_TRUE(session.withdrawn);
  EXPECT_EQ(session.excluded.value().text, "The participant withdrew consent");
  for (const AttemptRow& attempt : study.attempts(session.id)) EXPECT_TRUE(attempt.excluded);
  EXPECT_EQ(study.attempts(session.id).at(0).responses.at(0).answer, "answer of Wanda7");
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, IsFinal) {
  open().withdraw("Wanda7", kKept);
  Study study = open();
  const SessionRow session = study.sessions().back();
  const auto says = [](const std::string& words) {
    return testing::ThrowsMessage<ResultsError>(testing::HasSubstr(words));
  };
  EXPECT_THAT(
      [&] {
        study.add_decision(
            session.id,
            {.verdict = Verdict::include, .reason = "by mistake", .decided_by = "R. Keeper"});
      },
      says("stay excluded"));
  SessionRow next = some_session(session.protocol_id);
  next.participant = "Wanda7";
  EXPECT_THAT([&] { study.add_session(next, some_plan(1)); },
              says("has a withdrawal of participant"));
  EXPECT_THAT([&] { study.withdraw("Wanda7", kKept); },
              says("kept the data; to delete them, repeat the withdrawal with --delete"));
  EXPECT_NO_THROW(study.withdraw("Wanda7", kDeletion));
}

TEST_F(WithdrawalFromAStudy, RefusesALabelThatIsNotThereAndARunningSession) {
  Study study = open();
  EXPECT_THAT([&] { study.withdraw("P99", kDeletion); },
              testing::ThrowsMessage<ResultsError>(testing::HasSubstr("no participant P99")));
  EXPECT_FALSE(std::filesystem::exists(path_ / "locks" / "session-P99.lock"));
  const StudyLock running(path_, Study::session_lock_name("Wanda7"));
  EXPECT_THAT([&] { study.withdraw("Wanda7", kDeletion); },
              testing::ThrowsMessage<ResultsError>(testing::HasSubstr("in use by")));
  EXPECT_EQ(study.participants().size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(path_ / "recordings" / "Wanda7"));
}

TEST_F(WithdrawalFromAStudy, DeletesWhereFilesAreMissing) {
  std::filesystem::remove_all(path_ / "recordings" / "Wanda7");
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, StatesWhenItIsRepeatedThatItIsComplete) {
  EXPECT_THAT(refusal_of<ResultsError>([&] { open().withdraw("nobody", kDeletion); }),
              testing::Not(testing::HasSubstr("complete")));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(
      refusal_of<ResultsError>([&] { open().withdraw("Wanda7", kDeletion); }),
      testing::AllOf(testing::HasSubstr("has no participant Wanda7"),
                     testing::HasSubstr("last deletion"), testing::HasSubstr("is complete")));
}

TEST_F(WithdrawalFromAStudy, IsUnfinishedUntilEveryFileIsRemoved) {
  {
    const RemovalFault fault("recordings/Wanda7", 1, RemovalFault::Kind::error);
    EXPECT_THAT(refusal_of<ResultsError>([&] { open().withdraw("Wanda7", kDeletion); }),
                testing::AllOf(testing::HasSubstr("is not complete"),
                               testing::HasSubstr("recordings/Wanda7"),
                               testing::HasSubstr("repeat the deletion")));
    Study study = open();  // and tries in vain
    EXPECT_FALSE(study.participant("Wanda7"));
    EXPECT_THAT(study.verify({}), testing::IsEmpty());
    EXPECT_THAT(study.leftovers(),
                testing::AllOf(
                    testing::Contains(testing::HasSubstr("the deletion of a participant's data")),
                    testing::Not(testing::Contains(testing::HasSubstr("recordings/")))));
    EXPECT_THAT(
        refusal_of<ResultsError>([&] { study.add_participant(some_participant("Wanda7")); }),
        testing::HasSubstr("is not complete"));
    EXPECT_THAT(refusal_of<ResultsError>([&] { study.withdraw("Wanda7", kDeletion); }),
                testing::HasSubstr("is not complete"));
  }
  Study study = open();
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty()) << "whoever writes completes it";
  const WithdrawalRow counts = study.counts_of_participant("Wanda7");
  EXPECT_EQ(counts.attempts, 2);
  EXPECT_EQ(study.withdraw("Wanda7", kDeletion).row.recordings, 2) << "the repeated command";
  EXPECT_EQ(study.withdrawals().size(), 1U);
  study.add_participant(some_participant("Wanda7"));
}

/// The withdrawal that `label` states, as a damaged study or another tool stores it.
void store_unfinished_deletion(const std::filesystem::path& study, const std::string& label) {
  run_sql(study,
          "PRAGMA ignore_check_constraints = ON; INSERT INTO withdrawal VALUES "
          "(NULL,'deleted',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,'" +
              label + "',NULL)");
}

TEST_F(WithdrawalFromAStudy, DeletesNoFilesUnderALabelThatIsNotOneOfAParticipant) {
  const std::filesystem::path outside = folder_ / "outside";
  std::filesystem::create_directory(outside);
  write_file(outside / "kept.txt", "x", Overwrite::refuse);
  const std::filesystem::path intact = path_;
  int number = 0;
  for (const std::string& label : {outside.string(), std::string(".."), std::string("."),
                                   std::string("../../outside"), std::string(33, 'a')}) {
    path_ = folder_ / ("damaged" + std::to_string(number++));
    std::filesystem::copy(intact, path_, std::filesystem::copy_options::recursive);
    std::filesystem::create_directory(path_ / "recordings" / label);
    store_unfinished_deletion(path_, label);
    Study study = open();
    EXPECT_THAT(refusal_of<ResultsError>([&] { study.withdraw("nobody", kDeletion); }),
                testing::HasSubstr("is not a participant label"));
    EXPECT_TRUE(std::filesystem::exists(outside / "kept.txt")) << label;
    EXPECT_TRUE(std::filesystem::exists(path_ / "recordings" / label)) << label;
    EXPECT_TRUE(std::filesystem::exists(path_ / "recordings/Stays1/1-1.asprec")) << label;
  }
}

TEST_F(WithdrawalFromAStudy, RefusesAFolderThatIsASymbolicLink) {
  std::filesystem::rename(path_ / "recordings", folder_ / "disk");
  std::filesystem::create_directory_symlink(folder_ / "disk", path_ / "recordings");
  EXPECT_THAT(refusal_of<ResultsError>([&] { open().withdraw("Wanda7", kDeletion); }),
              testing::HasSubstr("symbolic link"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "disk/Wanda7/1-1.asprec"));
  EXPECT_TRUE(open().participant("Wanda7"));
}

TEST_F(WithdrawalFromAStudy, LeavesNothingInACopyThatIsMadeMeanwhile) {
  const RemovalFault fault(path_ / "recordings/Wanda7", 1, RemovalFault::Kind::error);
  EXPECT_THROW(open().withdraw("Wanda7", kDeletion), ResultsError);
  ASSERT_THAT(files_with("Wanda7"), testing::Contains("recordings/Wanda7/1-1.asprec"));
  Study::open(path_, Access::read_only).copy_to(folder_ / "copy");
  path_ = folder_ / "copy";
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
  EXPECT_THAT(Study::open(path_, Access::read_only).verify({}), testing::IsEmpty());
}

// Before the file is compacted, which a full disk may prevent.
TEST_F(WithdrawalFromAStudy, OverwritesTheRowsThatItRemoves) {
  ASSERT_THAT(files_with("free words of Wanda7"), testing::ElementsAre("study.sqlite"));
  const SqliteThatKeepsWhatIsRemoved keeping;
  const RemovalFault fault("recordings/Wanda7", 1, RemovalFault::Kind::error);
  EXPECT_THROW(open().withdraw("Wanda7", kDeletion), ResultsError);
  EXPECT_THAT(files_with("free words of Wanda7"), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, LeavesNothingInPagesThatWereFreeBefore) {
  run_sql(path_,
          "PRAGMA secure_delete = OFF; CREATE TABLE scratch (words TEXT); "
          "WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200) "
          "INSERT INTO scratch SELECT 'scratch of Wanda7 ' || hex(zeroblob(400)) FROM n; "
          "DROP TABLE scratch");
  ASSERT_THAT(files_with("scratch of Wanda7"), testing::ElementsAre("study.sqlite"));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, RefusesADamagedStudyInWhichOthersRowsWouldGoToo) {
  run_sql(path_,
          "PRAGMA foreign_keys = OFF; DROP TRIGGER participant_no_delete; "
          "DELETE FROM participant WHERE label = 'Stays1'");
  Study study = open();
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.withdraw("Wanda7", kDeletion); }),
              testing::HasSubstr("refer to rows that do not exist"));
  EXPECT_TRUE(study.participant("Wanda7"));
  for (const std::int64_t session : {1, 2}) {
    EXPECT_EQ(study.attempts(session).size(), 2U) << session;
  }
  EXPECT_TRUE(std::filesystem::exists(path_ / "recordings" / "Wanda7"));
  EXPECT_TRUE(study.withdrawals().empty());
}

TEST_F(WithdrawalFromAStudy, BlanksThePathsOfOutputsThatNameTheParticipant) {
  Study study = open();
  const std::vector<std::string> paths{"/out/Wanda7.html", "/out/report-wanda7.pdf", "/out/Wanda71",
                                       "/out/LWanda7",     "/wanda7/tables",         "/out/tables"};
  for (const std::string& path : paths) {
    study.end_output(study.begin_output({.kind = OutputKind::report, .path = path}));
  }
  const Withdrawal done = study.withdraw("Wanda7", kDeletion);
  ASSERT_EQ(done.outputs.size(), paths.size());
  EXPECT_EQ(done.outputs[0].path, paths[0]) << "it is reported before it is blanked";
  std::vector<std::string> left;
  for (const OutputRow& output : study.outputs()) left.push_back(output.path);
  EXPECT_THAT(left,
              testing::ElementsAre("", "", "/out/Wanda71", "/out/LWanda7", "", "/out/tables"));
}

TEST_F(WithdrawalFromAStudy, WaitsWhileAProgramReads) {
  Study study = open();
  sqlite3* reader = nullptr;
  ASSERT_EQ(sqlite3_open((path_ / "study.sqlite").c_str(), &reader), SQLITE_OK);
  ASSERT_EQ(
      sqlite3_exec(reader, "BEGIN; SELECT count(*) FROM participant", nullptr, nullptr, nullptr),
      SQLITE_OK);
  std::thread program;
  EXPECT_NO_THROW(study.withdraw("Wanda7", kDeletion, [&] {
    program = std::thread([reader] {
      std::this_thread::sleep_for(std::chrono::milliseconds(250));
      sqlite3_exec(reader, "COMMIT", nullptr, nullptr, nullptr);
    });
  }));
  ASSERT_TRUE(program.joinable());
  program.join();
  sqlite3_close(reader);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
}

TEST_F(WithdrawalFromAStudy, ReportsOnceThatItWaitsForAProgramThatReads) {
  Study study = open();
  sqlite3* reader = nullptr;
  ASSERT_EQ(sqlite3_open((path_ / "study.sqlite").c_str(), &reader), SQLITE_OK);
  ASSERT_EQ(
      sqlite3_exec(reader, "BEGIN; SELECT count(*) FROM participant", nullptr, nullptr, nullptr),
      SQLITE_OK);
  int waits = 0;
  study.withdraw("Wanda7", kDeletion, [&] {
    ++waits;
    sqlite3_exec(reader, "COMMIT", nullptr, nullptr, nullptr);
  });
  EXPECT_EQ(waits, 1);
  sqlite3_close(reader);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
}

/// A connection that begins to read just before the label is blanked, and reads until it is destroyed.
class ReaderOfTheLabel final {
 public:
  explicit ReaderOfTheLabel(const std::filesystem::path& study) {
    EXPECT_EQ(sqlite3_open((study / "study.sqlite").c_str(), &reader_), SQLITE_OK);
    watching = this;
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(&watch));
  }
  ~ReaderOfTheLabel() {
    sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&watch));
    watching = nullptr;
    sqlite3_close(reader_);
  }
  ReaderOfTheLabel(const ReaderOfTheLabel&) = delete;
  ReaderOfTheLabel& operator=(const ReaderOfTheLabel&) = delete;

  bool reads() const { return sqlite3_get_autocommit(reader_) == 0; }

 private:
  static inline ReaderOfTheLabel* watching = nullptr;

  static int watch(sqlite3* handle, const char**, const void*) {
    return sqlite3_trace_v2(handle, SQLITE_TRACE_STMT, &begin_before_blanking, nullptr);
  }
  static int begin_before_blanking(unsigned, void*, void* statement, void*) {
    const std::string sql = sqlite3_sql(static_cast<sqlite3_stmt*>(statement));
    if (watching != nullptr && sql.find("SET label = NULL") != std::string::npos) {
      sqlite3_exec(watching->reader_, "BEGIN; SELECT count(*) FROM withdrawal", nullptr, nullptr,
                   nullptr);
    }
    return 0;
  }

  sqlite3* reader_ = nullptr;
};

// Nothing could be repeated then: the label is blanked.
TEST_F(WithdrawalFromAStudy, IsCompleteAlthoughAProgramReadsWhenTheLabelIsBlanked) {
  {
    const ReaderOfTheLabel reader(path_);
    open().withdraw("Wanda7", kDeletion);
    EXPECT_TRUE(reader.reads());
    EXPECT_THAT(files_with("Wanda7"), testing::Not(testing::IsEmpty())) << "in what is read";
    EXPECT_THAT(Study::open(path_, Access::read_only).leftovers(),
                testing::Contains(testing::HasSubstr("study.sqlite-wal")));
  }
  open().set_metadata({});
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
  EXPECT_THAT(Study::open(path_, Access::read_only).leftovers(), testing::IsEmpty());
  expect_the_end_when_repeated();
}

// At a terminal nobody waits 30 s without a word.
TEST_F(WithdrawalFromAStudy, StatesWhatIsLeftWhereItIsStoppedWhileItWaits) {
  sqlite3* reader = nullptr;
  ASSERT_EQ(sqlite3_open((path_ / "study.sqlite").c_str(), &reader), SQLITE_OK);
  ASSERT_EQ(
      sqlite3_exec(reader, "BEGIN; SELECT count(*) FROM participant", nullptr, nullptr, nullptr),
      SQLITE_OK);
  std::stop_source stop;
  std::thread program;
  const auto stop_and_release_later = [&] {
    stop.request_stop();
    program = std::thread([reader] {
      std::this_thread::sleep_for(std::chrono::seconds(2));  // a wait that went on would succeed
      sqlite3_exec(reader, "COMMIT", nullptr, nullptr, nullptr);
    });
  };
  EXPECT_THAT(refusal_of<ResultsError>([&] {
                open().withdraw("Wanda7", kDeletion, stop_and_release_later, stop.get_token());
              }),
              testing::HasSubstr("the deletion is not complete"));
  ASSERT_TRUE(program.joinable());
  program.join();
  sqlite3_close(reader);
  expect_the_end_when_repeated();
}

TEST_F(WithdrawalFromAStudy, KeepsTheReasonOfAnEarlierOneForADeletion) {
  Study study = open();
  EXPECT_EQ(study.counts_of_participant("Wanda7").reason, WithdrawalReason::consent_withdrawn);
  study.withdraw("Wanda7", {.reason = WithdrawalReason::not_eligible, .decided_by = "R. Keeper"});
  EXPECT_EQ(study.counts_of_participant("Wanda7").reason, WithdrawalReason::not_eligible);
}

TEST_F(WithdrawalFromAStudy, ReportsWhatIsBeingMadeAndWhatWasMadeSinceThePersonWasAdded) {
  Study study = open();
  study.end_output(study.begin_output({.kind = OutputKind::report, .path = "/before"}));
  ParticipantRow late = some_participant("Late1");
  late.is_virtual = false;
  late.created_utc = "2096-01-01T00:00:00Z";
  study.add_participant(late);
  study.begin_output({.kind = OutputKind::copy, .path = "/being-made"});
  const std::vector<OutputRow> of_late = study.withdraw("Late1", kDeletion).outputs;
  ASSERT_EQ(of_late.size(), 1U);
  EXPECT_EQ(of_late[0].path, "/being-made");
  EXPECT_EQ(study.withdraw("Wanda7", kKept).outputs.size(), 2U);
}

TEST_F(WithdrawalFromAStudy, LeavesTheRulesInForce) {
  Study study = open();
  study.withdraw("Wanda7", kDeletion);
  const std::int64_t id = study.sessions().front().id;
  study.add_event(id, {.time_ns = 3, .kind = "note", .text = "afterwards"});
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((path_ / "study.sqlite").c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, "DELETE FROM event", nullptr, nullptr, nullptr),
            SQLITE_CONSTRAINT);
  sqlite3_close(database);
}

// A call that succeeds leaves the error of an earlier one.
TEST(RemoveTree, RemovesAFileWhateverErrorWasBefore) {
  const TemporaryFolder folder;
  for (const int before : {0, ENOENT, EACCES}) {
    write_file(folder / "file", "content", Overwrite::allow);
    errno = before;
    EXPECT_NO_THROW(remove_tree(folder / "file")) << before;
    EXPECT_FALSE(std::filesystem::exists(folder / "file"));
    EXPECT_NO_THROW(remove_tree(folder / "file")) << "what is gone is removed";
  }
}

TEST(StudyRecord, KeepsMetadataAndOutputs) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "study", "fixture");
  EXPECT_EQ(study.metadata(), StudyMetadata{});
  const StudyMetadata metadata{.authors = {"Lin, M. C.", "Otaduy, M. A."},
                               .license = "CC-BY-4.0",
                               .ethics_approval = "EK 12/2026"};
  study.set_metadata({.authors = {"Somebody else"}, .license = {}, .ethics_approval = {}});
  study.set_metadata(metadata);
  EXPECT_EQ(study.metadata(), metadata);
  study.remove_output(study.begin_output({.kind = OutputKind::copy, .path = "/tmp/stopped"}));
  const std::int64_t output = study.begin_output(
      {.kind = OutputKind::public_export, .path = "/tmp/x", .program_version = "0.2.0"});
  ASSERT_EQ(study.outputs().size(), 1U);
  EXPECT_EQ(study.outputs()[0].made_utc, "");
  study.end_output(output);
  EXPECT_EQ(study.outputs()[0].made_utc.back(), 'Z');
  EXPECT_THROW(study.remove_output(output), ResultsError) << "it was made";
  EXPECT_EQ(study.outputs()[0].kind, OutputKind::public_export);
  EXPECT_EQ(study.outputs()[0].path, "/tmp/x");
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
