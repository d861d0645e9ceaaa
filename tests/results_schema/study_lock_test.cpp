// A lock has one holder, names it, and does not outlive it.

#include <array>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/waiting_child.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(StudyLock, HasOneHolder) {
  const TemporaryFolder folder;
  {
    const StudyLock lock(folder.path(), "device");
    EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder.path(), "device"); }),
                HasSubstr("is in use by"));
    const StudyLock other(folder.path(), "session-P01");
  }
  const StudyLock again(folder.path(), "device");
}

TEST(StudyLock, LeavesNoFileWithTheNameBehind) {
  const TemporaryFolder folder;
  { const StudyLock lock(folder.path(), "session-P01"); }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "locks"));
  write_file(folder / "locks/session-P02.lock", "", Overwrite::refuse);  // after a crash
  { const StudyLock lock(folder.path(), "session-P02"); }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "locks"));
}

// A file is opened before it is locked, and meanwhile its holder may remove it.
TEST(StudyLock, HasOneHolderWhileItsFileComesAndGoes) {
  const TemporaryFolder folder;
  std::atomic<int> holders{0};
  std::atomic<bool> was_shared{false};
  std::atomic<int> taken{0};
  const auto compete = [&] {
    for (int i = 0; i < 3000; ++i) {
      try {
        const StudyLock lock(folder.path(), "device");
        if (++holders > 1) was_shared = true;
        ++taken;
        --holders;
      } catch (const ResultsError& error) {
        EXPECT_EQ(error.code(), EAGAIN) << error.what();
      }
    }
  };
  {
    std::vector<std::jthread> threads{};
    for (int i = 0; i < 4; ++i) threads.emplace_back(compete);
  }
  EXPECT_FALSE(was_shared);
  EXPECT_GT(taken, 0);
}

TEST(StudyLock, NamesTheHostAndProcessThatHoldIt) {
  const TemporaryFolder folder;
  WaitingChild child([&] { return std::make_unique<StudyLock>(folder.path(), "device"); });
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  const std::string process =
      "process " + std::to_string(child.process()) + " on host " + host.data() + ", started 20";
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder.path(), "device"); }),
              HasSubstr(process));
  const std::optional<LockHolder> holder = StudyLock::holder(folder.path(), "device");
  ASSERT_TRUE(holder);
  EXPECT_THAT(holder->description, HasSubstr(process));
  EXPECT_EQ(holder->process, std::to_string(child.process()));
  EXPECT_EQ(holder->host, host.data());
  EXPECT_THAT(holder->started_utc, testing::StartsWith("20"));
}

TEST(StudyLock, OfADeadProcessIsFree) {
  const TemporaryFolder folder;
  WaitingChild child([&] { return std::make_unique<StudyLock>(folder.path(), "device"); });
  child.kill();
  EXPECT_FALSE(StudyLock::holder(folder.path(), "device"));
  const StudyLock lock(folder.path(), "device");
}

TEST(StudyLock, OfNobodyHasNoHolder) {
  const TemporaryFolder folder;
  EXPECT_FALSE(StudyLock::holder(folder.path(), "device"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(StudyLock, StaysInItsFolder) {
  const TemporaryFolder folder;
  for (const char* const name : {"", "../x", "a/b", "a.b", "ä"}) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder.path(), name); }),
                HasSubstr("not a name for a lock"));
  }
}

// A member of the group of a shared study must not have others empty their own files.
TEST(StudyLock, IsNeverALink) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "s/locks");
  write_file(folder / "precious", "words", Overwrite::refuse);
  std::filesystem::create_symlink(folder / "precious", folder / "s/locks/session-P01.lock");
  std::filesystem::create_symlink(folder / "made", folder / "s/locks/device.lock");
  const std::string sentence = (folder / "s/locks/session-P01.lock").string() +
                               " is a symbolic link to " + (folder / "precious").string();
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder / "s", "session-P01"); }),
              AllOf(HasSubstr(sentence), HasSubstr("Remove the link")));
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock::holder(folder / "s", "session-P01"); }),
              HasSubstr(sentence));
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder / "s", "device"); }),
              HasSubstr("is a symbolic link"));
  EXPECT_THAT(StudyLock::held(folder / "s", "session-"), IsEmpty());
  EXPECT_EQ(read_file(folder / "precious"), "words");
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
}

TEST(StudyLock, IsNotReachedThroughALink) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "s");
  std::filesystem::create_directories(folder / "elsewhere");
  write_file(folder / "elsewhere/session-P01.lock", "words", Overwrite::refuse);
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "s/locks");
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock(folder / "s", "session-P01"); }),
              HasSubstr((folder / "s/locks").string() + " is a symbolic link to"));
  EXPECT_EQ(read_file(folder / "elsewhere/session-P01.lock"), "words");
}

TEST(StudyLock, IsAFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "locks");
  ASSERT_EQ(::mkfifo((folder / "locks/session-P01.lock").c_str(), 0666), 0);
  EXPECT_THAT(refusal_of<ResultsError>([&] { StudyLock::holder(folder.path(), "session-P01"); }),
              HasSubstr("session-P01.lock is not a file"));
}

TEST(LockOfWriters, IsNeverALink) {
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  write_file(folder / "precious", "words", Overwrite::refuse);
  std::filesystem::permissions(folder / "precious", std::filesystem::perms::owner_read);
  std::filesystem::remove(folder / "s/locks/writers.lock");
  std::filesystem::create_symlink(folder / "precious", folder / "s/locks/writers.lock");
  EXPECT_THAT(refusal_of<ResultsError>([&] { Study::open(folder / "s", Access::read_write); }),
              HasSubstr("writers.lock is a symbolic link to"));
  EXPECT_EQ(Study::open(folder / "s", Access::read_only).name(), "x");
  EXPECT_EQ(std::filesystem::status(folder / "precious").permissions(),
            std::filesystem::perms::owner_read);
}

// People copy, rename and save into every folder that they can open.
TEST(StudyLock, TellsWhichAreHeldWhateverElseLiesInTheirFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(StudyLock::held(folder.path(), "session-"), IsEmpty()) << "there is no folder yet";
  const StudyLock second(folder.path(), "session-P2");
  const StudyLock first(folder.path(), "session-P1");
  const StudyLock other(folder.path(), "device-test");
  { const StudyLock over(folder.path(), "session-P3"); }
  const std::filesystem::path locks = folder / "locks";
  for (const char* const stray : {"session-P1 (copy).lock", "session-Ä.lock", "session-.lock.txt",
                                  "session-P1.lock~", "session-a.b.lock", ".lock", "notes"}) {
    std::ofstream(locks / stray) << "process 1 on host x";
  }
  std::filesystem::create_directory(locks / "session-P4.lock");
  std::filesystem::create_symlink("nowhere", locks / "session-P5.lock");
  EXPECT_THAT(StudyLock::held(folder.path(), "session-"), ElementsAre("session-P1", "session-P2"));
}

TEST(CrashedSession, IsAnOpenOneWhoseLockNobodyHolds) {
  const TemporaryFolder folder;
  {
    Study study = study_with_session(folder / "s", 1).study;
    study.add_participant(some_participant("P02"));
    study.add_session(some_session(1, "P02"), some_plan(1));
    study.add_participant(some_participant("P03"));
    const std::int64_t ended = study.add_session(some_session(1, "P03"), some_plan(1));
    study.end_session(ended, SessionState::stopped, "2026-03-01T10:00:00Z");
  }
  WaitingChild runs_P02(
      [&] { return std::make_unique<StudyLock>(folder / "s", Study::session_lock_name("P02")); });
  Study study = Study::open(folder / "s", Access::read_write);
  EXPECT_THAT(study.mark_crashed_sessions(), ElementsAre(1));
  EXPECT_EQ(study.session(1).state, SessionState::crashed);
  EXPECT_EQ(study.session(2).state, SessionState::open);
  EXPECT_EQ(study.session(3).state, SessionState::stopped);
  EXPECT_THAT(study.mark_crashed_sessions(), IsEmpty());
  EXPECT_THAT(study.verify({}), IsEmpty());  // its segment has ended

  study.reopen_session(1);
  EXPECT_EQ(study.begin_segment(1, 5'000'000'000), 2);
  AttemptRow attempt = some_attempt(1);
  attempt.segment = 2;
  study.add_attempt(1, attempt);

  runs_P02.kill();
  const StudyLock mine(folder / "s", Study::session_lock_name("P01"));
  EXPECT_THAT(study.mark_crashed_sessions(), ElementsAre(2));
}

}  // namespace
}  // namespace asperity
