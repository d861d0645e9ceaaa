// The worst moments: a full disk, a broken disk, many writers at once.

#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/results_schema/failing_vfs.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kTrials = 2;

/// Adds attempts until an error. Returns how many were acknowledged; the sentence goes to
/// `message`.
int add_attempts(const std::filesystem::path& folder, std::string& message) {
  int acknowledged = 0;
  message = refusal_of<ResultsError>([&] {
    Study study = Study::open(folder, Access::read_write);
    for (int trial = 1; trial <= kTrials; ++trial) {
      study.add_attempt(1, some_attempt(trial));
      ++acknowledged;
    }
  });
  return acknowledged;
}

class StudyOnAFailingDisk : public testing::TestWithParam<FailingVfs::Fault> {};

TEST_P(StudyOnAFailingDisk, HoldsTheFinishedAttemptsWhicheverWriteFails) {
  const TemporaryFolder original;
  { study_with_session(original / "s", kTrials); }
  int failures = 0;
  std::set<int> acknowledged_counts;
  for (int n = 1;; ++n) {
    const TemporaryFolder folder;
    std::filesystem::copy(original / "s", folder / "s", std::filesystem::copy_options::recursive);
    FailingVfs disk;
    disk.fail_from(n, GetParam());
    std::string message;
    const int acknowledged = add_attempts(folder / "s", message);
    const bool failed = disk.has_failed();
    const int unsure = disk.has_failed_in_sync() ? 1 : 0;
    disk.heal();

    Study study = Study::open(folder / "s", Access::read_write);
    ASSERT_THAT(study.verify({}), IsEmpty()) << n;
    const std::vector<AttemptRow> attempts = study.attempts(1);
    const auto count = static_cast<int>(attempts.size());
    ASSERT_THAT(count,
                testing::AllOf(testing::Ge(acknowledged), testing::Le(acknowledged + unsure)))
        << "failing from operation " << n;
    for (const AttemptRow& attempt : attempts) {
      ASSERT_EQ(attempt.responses.size(), 2U);
      ASSERT_EQ(attempt.events.size(), 2U);
    }
    acknowledged_counts.insert(acknowledged);
    if (acknowledged == kTrials) {
      // The checkpoint at closing may still have failed; the log then holds the rows.
      if (!failed) break;
      continue;
    }
    ++failures;
    ASSERT_THAT(message, HasSubstr("Nothing that was stored before is lost")) << n;
    if (count < kTrials) study.add_attempt(1, some_attempt(count + 1));  // and it goes on
    ASSERT_LT(n, 2000);
  }
  EXPECT_GT(failures, 3 * kTrials);
  EXPECT_EQ(acknowledged_counts, (std::set<int>{0, 1, 2}));
}

INSTANTIATE_TEST_SUITE_P(Faults, StudyOnAFailingDisk,
                         testing::Values(FailingVfs::Fault::disk_full,
                                         FailingVfs::Fault::broken_disk),
                         [](const auto& param) {
                           return param.param == FailingVfs::Fault::disk_full ? "DiskFull"
                                                                              : "BrokenDisk";
                         });

TEST(StudyCreation, LeavesNothingWhenTheDiskFails) {
  for (int n = 1;; ++n) {
    const TemporaryFolder folder;
    FailingVfs disk;
    disk.fail_from(n, FailingVfs::Fault::disk_full);
    const std::string message = refusal_of<ResultsError>([&] { Study::create(folder / "s", "x"); });
    if (message.empty()) break;
    ASSERT_TRUE(std::filesystem::is_empty(folder.path())) << n;
    ASSERT_LT(n, 2000);
  }
}

TEST(StudyReading, ReadsAFileAgainThatBecomesShorterMeanwhile) {
  const TemporaryFolder folder;
  { study_with_session(folder / "s", kTrials); }  // of more than 64 KiB
  FailingVfs disk;
  for (const Access access : {Access::read_only, Access::read_write}) {
    disk.shorten_large_reads(2);
    const Study study = Study::open(folder / "s", access);
    EXPECT_EQ(study.condition(), StudyCondition::whole);
    EXPECT_EQ(disk.large_reads_to_shorten(), 0);
  }
  EXPECT_THAT(Study::open(folder / "s", Access::read_only).verify({}), IsEmpty());
}

TEST(StudyReading, GivesUpAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  { study_with_session(folder / "s", kTrials); }  // of more than 64 KiB
  constexpr int kMany = 1000;
  FailingVfs disk;
  disk.shorten_large_reads(kMany);
  EXPECT_THAT(refusal_of<ResultsError>(
                  [&] { (void)Study::open(folder / "s", Access::read_only).condition(); }),
              HasSubstr("the disk could not be read"));
  EXPECT_GT(disk.large_reads_to_shorten(), kMany - 20);
}

TEST(ParallelSessions, NeverFailAndReadBackInNaturalOrder) {
  constexpr int kThreads = 4;
  constexpr int kAttempts = 15;
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  std::array<std::string, kThreads> messages;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      messages[static_cast<std::size_t>(i)] = refusal_of<ResultsError>([&] {
        Study study = Study::open(folder / "s", Access::read_write);
        const std::string label = "V" + std::to_string(9 - i);
        const StudyLock lock(folder / "s", Study::session_lock_name(label));
        study.add_participant(some_participant(label));
        const std::int64_t id = study.add_session(
            some_session(study.add_protocol(some_protocol()), label), some_plan(kAttempts));
        study.begin_segment(id, 0);
        for (int trial = 1; trial <= kAttempts; ++trial) study.add_attempt(id, some_attempt(trial));
        study.end_segment(id, 1, 1, "completed");
        study.end_session(id, SessionState::completed, "2026-03-01T10:00:00Z");
      });
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(messages, Each(""));

  const Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_EQ(study.protocols().size(), 1U);
  std::vector<std::string> labels;
  for (const SessionRow& row : study.sessions()) {
    labels.push_back(row.participant);
    EXPECT_EQ(study.attempts(row.id).size(), static_cast<std::size_t>(kAttempts));
  }
  EXPECT_THAT(labels, testing::ElementsAre("V6", "V7", "V8", "V9"));
  EXPECT_THAT(study.verify({}), IsEmpty());
}

// Four processes take 10 rows each out of 4: each row goes out 10 times.
TEST(Counterbalancing, GivesEveryRowEquallyOftenToProcessesThatAskAtOnce) {
  constexpr int kProcesses = 4;
  constexpr int kSessions = 10;
  const TemporaryFolder folder;
  {
    Study study = Study::create(folder / "s", "x");
    study.add_protocol(some_protocol());
    for (int i = 0; i < kProcesses; ++i) {
      study.add_participant(some_participant("V" + std::to_string(i)));
    }
  }
  std::vector<pid_t> children;
  for (int i = 0; i < kProcesses; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const std::string message = refusal_of<ResultsError>([&] {
        Study study = Study::open(folder / "s", Access::read_write);
        for (int session = 0; session < kSessions; ++session) {
          study.add_session(
              some_session(1, "V" + std::to_string(i)), {.rows = 4},
              [](const SessionRow& row) { return some_plan(row.counterbalance_row + 1); });
        }
      });
      ::_exit(message.empty() ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_THAT(study.counterbalance_counts("selection", 4), testing::ElementsAre(10, 10, 10, 10));
  for (const SessionRow& row : study.sessions()) {
    EXPECT_EQ(study.plan(row.id).size(), static_cast<std::size_t>(row.counterbalance_row + 1));
  }
}

TEST(Counterbalancing, CountsOpenAndCompletedSessionsOfTheNameAndMode) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant());
  ProtocolRow other = some_protocol("other source, same name");
  const std::int64_t first = study.add_protocol(some_protocol());
  const std::int64_t second = study.add_protocol(other);
  const auto add = [&study](std::int64_t protocol_id, SessionMode mode) {
    SessionRow session = some_session(protocol_id);
    session.mode = mode;
    const std::int64_t id =
        study.add_session(session, {.rows = 3}, [](const SessionRow&) { return some_plan(1); });
    return study.session(id).counterbalance_row;
  };
  EXPECT_EQ(add(first, SessionMode::simulate), 0);
  EXPECT_EQ(add(second, SessionMode::simulate), 1);
  EXPECT_EQ(add(first, SessionMode::run), 0);  // those that run are a group of their own
  EXPECT_THAT(study.counterbalance_counts("selection", 3), testing::ElementsAre(2, 1, 0));
  EXPECT_THAT(study.counterbalance_counts("selection", 3, SessionMode::run),
              testing::ElementsAre(1, 0, 0));
  EXPECT_THAT(study.counterbalance_counts("absent", 2), testing::ElementsAre(0, 0));
  study.end_session(1, SessionState::stopped, "2026-03-01T10:00:00Z");
  EXPECT_EQ(add(first, SessionMode::simulate), 0);  // who dropped out frees the row
  study.end_session(2, SessionState::completed, "2026-03-01T10:00:00Z");
  EXPECT_EQ(add(first, SessionMode::simulate), 2);
}

}  // namespace
}  // namespace asperity
