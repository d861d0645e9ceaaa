// What people decide about data, beside the data.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// The first cell that another tool reads.
std::string cell(const std::filesystem::path& study, const std::string& sql) {
  sqlite3* handle = nullptr;
  sqlite3_open_v2((study / "study.sqlite").c_str(), &handle, SQLITE_OPEN_READONLY, nullptr);
  std::string text;
  const auto keep = [](void* target, int, char** values, char**) {
    *static_cast<std::string*>(target) = values[0] != nullptr ? values[0] : "NULL";
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), keep, &text, nullptr), SQLITE_OK);
  sqlite3_close(handle);
  return text;
}

AttemptRow of(const Study& study, std::int64_t session, int attempt) {
  for (AttemptRow& row : study.attempts(session)) {
    if (row.trial == 1 && row.attempt == attempt) return row;
  }
  ADD_FAILURE() << "no attempt " << attempt;
  return {};
}

TEST(Decision, SetsAnAttemptAsideSoThatItsTrialCanBeAskedAgain) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 1);
  study.add_attempt(session, some_attempt(1, 1));
  EXPECT_THROW(study.add_attempt(session, some_attempt(1, 2)), ResultsError);
  study.set_aside(session, 1, 1, "the door opened");
  EXPECT_FALSE(of(study, session, 1).valid);
  EXPECT_EQ(of(study, session, 1).invalid_reason.value().text,
            "repeated by the experimenter: the door opened");
  EXPECT_EQ(cell(folder / "s", "SELECT invalid_reason FROM tidy_attempt"),
            "set aside: the door opened");
  study.add_attempt(session, some_attempt(1, 2));
  EXPECT_TRUE(of(study, session, 2).valid);
  EXPECT_THROW(study.add_attempt(session, some_attempt(1, 3)), ResultsError);
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
}

// Of four trials: one is done at the second attempt, one is skipped, one is set aside, and one has not begun.
TEST(Decision, LeavesATrialToBeDoneWhereItsAttemptIsSetAside) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 4);
  AttemptRow too_fast = some_attempt(1, 1);
  too_fast.valid = false;
  too_fast.invalid_reason = "too fast";
  study.add_attempt(session, too_fast);
  EXPECT_EQ(study.session_counts(session).done_trials, 0);
  study.add_attempt(session, some_attempt(1, 2));
  AttemptRow skipped = some_attempt(2);
  skipped.valid = false;
  skipped.outcome = AttemptOutcome::skipped;
  skipped.invalid_reason = "skipped";
  skipped.responses.clear();
  study.add_attempt(session, skipped);
  study.add_attempt(session, some_attempt(3));
  EXPECT_EQ(study.session_counts(session).done_trials, 3);
  study.set_aside(session, 3, 1, "the door opened");
  EXPECT_EQ(study.session_counts(session).done_trials, 2);
  EXPECT_EQ(study.session_counts(session).attempts, 4);
  EXPECT_EQ(study.session_counts(session).planned_trials, 4);
}

TEST(Decision, ExcludesAndIncludesAgain) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 1);
  study.add_attempt(session, some_attempt(1, 1));
  EXPECT_FALSE(of(study, session, 1).excluded);
  study.add_decision(session,
                     {.trial = 1, .attempt = 1, .verdict = Verdict::exclude, .reason = "asleep"});
  EXPECT_EQ(of(study, session, 1).excluded.value().text, "asleep");
  EXPECT_TRUE(of(study, session, 1).valid);
  study.add_decision(
      session,
      {.trial = 1, .attempt = 1, .verdict = Verdict::include, .reason = "awake after all"});
  EXPECT_FALSE(of(study, session, 1).excluded);
  EXPECT_EQ(study.decisions(session).size(), 2U);
  EXPECT_EQ(study.decisions(session)[0].reason.text, "asleep");
}

TEST(Decision, ExcludesAWholeSessionWithItsAttempts) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 1);
  study.add_attempt(session, some_attempt(1, 1));
  study.add_decision(session, {.verdict = Verdict::exclude, .reason = "wrong glove"});
  EXPECT_EQ(study.session(session).excluded.value().text, "wrong glove");
  EXPECT_EQ(study.sessions().at(0).excluded.value().text, "wrong glove");
  EXPECT_EQ(of(study, session, 1).excluded.value().text, "wrong glove");
  // Taking an attempt's own exclusion back does not bring it past the session's.
  study.add_decision(session,
                     {.trial = 1, .attempt = 1, .verdict = Verdict::include, .reason = "fine"});
  EXPECT_EQ(of(study, session, 1).excluded.value().text, "wrong glove");
  study.add_decision(session, {.verdict = Verdict::include, .reason = "no glove"});
  EXPECT_FALSE(study.session(session).excluded);
  EXPECT_FALSE(of(study, session, 1).excluded);
}

TEST(Decision, AddsAFlagToThoseOfTheProgram) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 1);
  study.add_attempt(session, some_attempt(1, 1));
  study.add_decision(session,
                     {.trial = 1, .attempt = 1, .verdict = Verdict::flag, .reason = "a noise"});
  EXPECT_EQ(of(study, session, 1).flag_reason.value().text, "saturated for 3 ticks; a noise");
  EXPECT_EQ(cell(folder / "s", "SELECT flag_reason FROM tidy_attempt"),
            "saturated for 3 ticks; a noise");
}

TEST(Decision, NeedsAReasonAndSomethingToDecideAbout) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 1);
  EXPECT_THROW(study.add_decision(session, {.verdict = Verdict::exclude}), ResultsError);
  EXPECT_THROW(study.set_aside(session, 1, 1, "no such attempt"), ResultsError);
  EXPECT_THROW(study.add_decision(99, {.verdict = Verdict::exclude, .reason = "x"}), ResultsError);
}

}  // namespace
}  // namespace asperity
