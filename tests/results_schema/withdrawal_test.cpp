// A participant who withdraws: nothing of them is used, or nothing of them is left.

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/atomic_file.h"
#include "results_schema/recording.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

const WithdrawalRow kDeletion{.data = WithdrawnData::deleted,
                              .reason = WithdrawalReason::consent_withdrawn,
                              .decided_by = "R. Keeper"};
const WithdrawalRow kKept{.data = WithdrawnData::kept, .decided_by = "R. Keeper"};

/// Two participants with a completed session each: what is told of one can be told from the other.
class Withdrawal : public testing::Test {
 protected:
  void SetUp() override {
    Study study = Study::create(path_, "fixture");
    const std::int64_t protocol = study.add_protocol(some_protocol());
    for (const std::string label : {"Wanda7", "Stays1"}) {
      ParticipantRow participant = some_participant(label);
      participant.is_virtual = false;
      participant.answers_json = R"({"hand":"secret)" + label + R"("})";
      study.add_participant(participant);
      SessionRow session = some_session(protocol);
      session.participant = label;
      session.mode = SessionMode::run;
      session.counterbalance_row = label == "Wanda7" ? 1 : 0;
      const std::int64_t id = study.add_session(session, some_plan(2));
      study.begin_segment(id, 1'000'000'000);
      study.add_session_answer(
          id, {.question = "why", .answer = "free words of " + label, .source = "keyboard"});
      study.add_event(id, {.time_ns = 2, .kind = "note", .text = label + " sneezed"});
      for (int trial = 1; trial <= 2; ++trial) {
        AttemptRow attempt = some_attempt(trial);
        attempt.responses.at(0).answer = "answer of " + label;
        const std::string name = "recordings/" + label + "/1-" + std::to_string(trial) + ".asprec";
        RecordingWriter writer(
            path_, name,
            {.rate_Hz = 10.0, .columns = {{.name = "x_m", .unit = "m", .meaning = label}}});
        const float x_m = 0.5F;
        writer.append(2'000'000'000, &x_m);
        attempt.recording = writer.finish();
        study.add_attempt(id, attempt);
      }
      study.add_decision(id, {.trial = 1,
                              .attempt = 1,
                              .verdict = Verdict::flag,
                              .reason = "odd of " + label,
                              .decided_by = "R. Keeper"});
      study.end_segment(id, 1, 5'000'000'000, "completed");
      study.end_session(id, SessionState::completed, "2026-01-01T10:00:00Z");
      write_file(path_ / ("sheet-" + label + ".png"), label, Overwrite::refuse);
    }
    write_file(path_ / "study.sqlite.version-4", "Wanda7 as an older program left it",
               Overwrite::refuse);
    // As a session leaves it that was killed.
    std::filesystem::create_directory(path_ / "locks");
    write_file(path_ / "locks" / "session-Wanda7.lock", "", Overwrite::refuse);
  }

  /// The files of the folder that hold the words, in their content or name.
  std::vector<std::string> files_with(const std::string& words) const {
    std::vector<std::string> found{};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
      const std::string name = entry.path().lexically_relative(path_).string();
      std::string content = name;
      if (entry.is_regular_file()) {
        std::ifstream file(entry.path(), std::ios::binary);
        content.append(std::istreambuf_iterator<char>(file), {});
      }
      if (content.find(words) != std::string::npos) found.push_back(name);
    }
    return found;
  }

  Study open() const { return Study::open(path_, Access::read_write); }

  TemporaryFolder folder_{};
  std::filesystem::path path_ = folder_ / "study";
};

TEST_F(Withdrawal, DeletesEveryTraceOfTheParticipantFromTheFolder) {
  ASSERT_THAT(files_with("Wanda7"), testing::SizeIs(testing::Ge(5U)));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
  EXPECT_THAT(files_with("secret"), testing::ElementsAre("study.sqlite"));  // of the other
  const Study study = Study::open(path_, Access::read_only);
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
  EXPECT_THAT(study.leftovers(), testing::IsEmpty());
}

TEST_F(Withdrawal, DeletesNothingOfTheOthers) {
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

TEST_F(Withdrawal, LeavesARowThatCountsWithoutNaming) {
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

TEST_F(Withdrawal, FreesTheCounterbalancingRow) {
  const auto rows_used = [this] {
    return Study::open(path_, Access::read_only).counterbalance_counts(some_protocol().name, 2);
  };
  ASSERT_THAT(rows_used(), testing::ElementsAre(1, 1));
  open().withdraw("Wanda7", kKept);
  EXPECT_THAT(rows_used(), testing::ElementsAre(1, 0));
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(rows_used(), testing::ElementsAre(1, 0));
}

TEST_F(Withdrawal, KeepsDataThatNothingUses) {
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

TEST_F(Withdrawal, IsFinal) {
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
  EXPECT_THAT([&] { study.add_session(next, some_plan(1)); }, says("has a withdrawal of participant"));
  EXPECT_THAT([&] { study.withdraw("Wanda7", kKept); }, says("already"));
  EXPECT_NO_THROW(study.withdraw("Wanda7", kDeletion));
}

TEST_F(Withdrawal, RefusesALabelThatIsNotThereAndARunningSession) {
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

TEST_F(Withdrawal, CanBeRepeatedWhereFilesCouldNotBeRemoved) {
  const std::filesystem::path recordings = path_ / "recordings";
  // As an interrupted deletion leaves them, with only some of the files removed.
  std::filesystem::remove_all(recordings / "Wanda7");
  open().withdraw("Wanda7", kDeletion);
  EXPECT_THAT(files_with("Wanda7"), testing::IsEmpty());
}

TEST_F(Withdrawal, LeavesTheRulesInForce) {
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
  study.add_output(
      {.kind = OutputKind::public_export, .path = "/tmp/x", .program_version = "0.2.0"});
  ASSERT_EQ(study.outputs().size(), 1U);
  EXPECT_EQ(study.outputs()[0].kind, OutputKind::public_export);
  EXPECT_EQ(study.outputs()[0].path, "/tmp/x");
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
