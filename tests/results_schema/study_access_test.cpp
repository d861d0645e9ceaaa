// Who may open what: reading writes nothing, writing needs a study of ours, on a disk of ours.

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/files/file_system.h"
#include "results_schema/migrations.h"
#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Every file of a folder with its content and time of change.
std::map<std::string, std::string> state_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> state;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto time = entry.last_write_time().time_since_epoch().count();
    state[entry.path().string()] =
        std::to_string(time) + (entry.is_regular_file() ? read_file(entry.path()) : "");
  }
  return state;
}

void read_everything(const Study& study) {
  EXPECT_EQ(study.name(), "some study");
  EXPECT_EQ(study.participants().size(), 1U);
  EXPECT_EQ(study.protocols().size(), 1U);
  ASSERT_EQ(study.sessions().size(), 1U);
  EXPECT_EQ(study.attempts(study.sessions()[0].id).size(), 1U);
  EXPECT_TRUE(study.verify({}).empty());
}

/// A study of one attempt, whose writer has closed it.
void make_closed_study(const std::filesystem::path& folder) {
  auto [study, session_id] = study_with_session(folder, 1);
  study.add_attempt(session_id, some_attempt(1));
  study.end_segment(session_id, 1, 2'000'000'000, "completed");
}

/// The same, whose writer was killed: the last rows are in the log only.
void make_killed_study(const std::filesystem::path& folder) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    auto [study, session_id] = study_with_session(folder, 1);
    study.add_attempt(session_id, some_attempt(1));
    study.end_segment(session_id, 1, 2'000'000'000, "completed");
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
}

TEST(StudyReading, WritesNothing) {
  const TemporaryFolder folder;
  make_closed_study(folder / "s");
  const auto before = state_of(folder.path());
  read_everything(Study::open(folder / "s", Access::read_only));
  EXPECT_EQ(state_of(folder.path()), before);
}

TEST(StudyReading, WritesNothingIntoAStudyWhoseWriterWasKilled) {
  const TemporaryFolder folder;
  make_killed_study(folder / "s");
  ASSERT_GT(std::filesystem::file_size(folder / "s" / "study.sqlite-wal"), 0U);
  const auto before = state_of(folder.path());
  read_everything(Study::open(folder / "s", Access::read_only));
  EXPECT_EQ(state_of(folder.path()), before);
}

/// A closed study whose next writer was killed before its first commit: of what it wrote to the log, only the
/// first bytes.
void make_study_with_log(const std::filesystem::path& folder, const std::string& log) {
  make_closed_study(folder);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Study study = Study::open(folder, Access::read_write);
    study.add_participant({.label = "Lost"});
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  const std::filesystem::path file = folder / "study.sqlite-wal";
  const std::string whole = read_file(file);
  ASSERT_GT(whole.size(), log.size());
  // An empty byte stands for what SQLite wrote there.
  std::string start = log;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (start[i] == 0) start[i] = whole[i];
  }
  write_file(file, start, Overwrite::allow);
}

// The header has 32 bytes, the head of a frame 24, a page 4096.
TEST(StudyReading, NeedsNoWriterAfterOneWasKilledBeforeItsFirstCommit) {
  for (const std::size_t bytes : {0U, 1U, 31U, 32U, 33U, 56U, 4151U, 4152U}) {
    const TemporaryFolder folder;
    ASSERT_NO_FATAL_FAILURE(make_study_with_log(folder / "s", std::string(bytes, '\0'))) << bytes;
    const auto before = state_of(folder.path());
    ASSERT_NO_THROW(read_everything(Study::open(folder / "s", Access::read_only))) << bytes;
    EXPECT_EQ(state_of(folder.path()), before) << bytes;
    Study::open(folder / "s", Access::read_only).copy_to(folder / "copy");
    EXPECT_EQ(Study::open(folder / "copy", Access::read_only).participants().size(), 1U) << bytes;
    Study::open(folder / "s", Access::read_write).add_participant({.label = "Later"});
    EXPECT_EQ(Study::open(folder / "s", Access::read_only).participants().size(), 2U) << bytes;
  }
}

TEST(StudyReading, PassesOverALogWithoutAValidHeader) {
  for (const std::string& log :
       {std::string(5000, 'x'), std::string(8, '\0') + std::string(5000, 'x')}) {
    const TemporaryFolder folder;
    ASSERT_NO_FATAL_FAILURE(make_study_with_log(folder / "s", log));
    read_everything(Study::open(folder / "s", Access::read_only));
  }
}

// The log of a study whose last writer was killed stays a header only until the next write.
TEST(StudyReading, FollowsAWriterThatComesAfterOneThatWasKilled) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_study_with_log(folder / "s", std::string(32, '\0')));
  const Study reader = Study::open(folder / "s", Access::read_only);
  EXPECT_EQ(reader.participants().size(), 1U);
  Study writer = Study::open(folder / "s", Access::read_write);
  for (int i = 0; i < 20; ++i) {
    writer.add_participant({.label = "N" + std::to_string(i)});
    EXPECT_EQ(reader.participants().size(), 2U + static_cast<std::size_t>(i));
  }
}

/// What a program that reads and writes at once can do with a study whose writer was killed.
bool can_write_beside_a_reader(const std::filesystem::path& folder, bool is_told) {
  const pid_t child = ::fork();  // being told holds for the whole process
  if (child == 0) {
    if (is_told) Study::read_beside_writers();
    try {
      const Study reader = Study::open(folder, Access::read_only);
      read_everything(Study::open(folder, Access::read_only));
      Study::open(folder, Access::read_write).add_participant({.label = "Later"});
      const bool follows = reader.participant("Later").has_value();
      ::_exit(follows ? 0 : 2);
    } catch (const ResultsError&) {
      ::_exit(1);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(StudyReading, LeavesRoomForWritersOfTheSameProcessWhenToldSo) {
  const TemporaryFolder folder;
  make_killed_study(folder / "s");
  std::filesystem::copy(folder / "s", folder / "t", std::filesystem::copy_options::recursive);
  EXPECT_TRUE(can_write_beside_a_reader(folder / "s", true));
  EXPECT_FALSE(can_write_beside_a_reader(folder / "t", false)) << "then it needs no telling";
}

/// Runs as somebody who may not write here; the superuser may write everywhere.
class AsSomebodyElse {
 public:
  AsSomebodyElse() : was_(::geteuid()) {
    if (was_ == 0 && ::seteuid(65534) != 0) throw std::runtime_error("no other user");
  }
  ~AsSomebodyElse() {
    if (was_ == 0 && ::seteuid(0) != 0) std::abort();
  }
  AsSomebodyElse(const AsSomebodyElse&) = delete;
  AsSomebodyElse& operator=(const AsSomebodyElse&) = delete;

 private:
  uid_t was_;
};

void make_read_only(const std::filesystem::path& folder) {
  using std::filesystem::perms;
  const perms reading = perms::owner_read | perms::group_read | perms::others_read;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) std::filesystem::permissions(entry.path(), reading);
  }
  for (const auto& part : {folder, folder / "stimuli", folder / "locks", folder / "protocols",
                           folder / "recordings"}) {
    std::filesystem::permissions(
        part, reading | perms::owner_exec | perms::group_exec | perms::others_exec);
  }
  std::filesystem::permissions(folder.parent_path(), perms::all);
}

void make_writable(const std::filesystem::path& folder) {
  std::filesystem::permissions(folder, std::filesystem::perms::all);
  for (const char* const part : {"stimuli", "locks", "protocols", "recordings"}) {
    std::filesystem::permissions(folder / part, std::filesystem::perms::all);
  }
}

TEST(StudyOnReadOnlyDisk, IsReadAndNotWritten) {
  for (const bool killed : {false, true}) {
    const TemporaryFolder folder;
    if (killed) {
      make_killed_study(folder / "s");
    } else {
      make_closed_study(folder / "s");
    }
    make_read_only(folder / "s");
    {
      const AsSomebodyElse somebody_else;
      EXPECT_FALSE(Study::can_be_written(folder / "s"));
      read_everything(Study::open(folder / "s", Access::read_only));
      EXPECT_THAT(refusal_of<ResultsError>([&] { Study::open(folder / "s", Access::read_write); }),
                  HasSubstr("is read-only here"));
      EXPECT_THAT(refusal_of<ResultsError>([&] { Study::create(folder / "s" / "new", "x"); }),
                  HasSubstr("Permission denied"));
    }
    make_writable(folder / "s");
  }
}

// An older study lies on such a medium more often than any other.
TEST(StudyOnReadOnlyDisk, IsReadWhereItsSchemaIsOlder) {
  const std::array<Migration, 2> versions{
      Migration{.version = 101, .sql = migrations().back().sql},
      Migration{.version = 102, .sql = "UPDATE study SET name = name || ' in room 7'"}};
  const std::span<const Migration> newer(versions);
  const TemporaryFolder folder;
  Study::create(folder / "s", "some study", newer.first(1));
  make_read_only(folder / "s");
  {
    const AsSomebodyElse somebody_else;
    EXPECT_EQ(Study::open(folder / "s", Access::read_only, newer).name(), "some study in room 7");
    EXPECT_THAT(
        refusal_of<ResultsError>([&] { Study::open(folder / "s", Access::read_write, newer); }),
        HasSubstr("is read-only here"));
  }
  make_writable(folder / "s");
}

TEST(StudyWriting, IsPossibleWhereFolderAndStoreCanBeWritten) {
  const TemporaryFolder folder;
  make_closed_study(folder / "s");
  EXPECT_TRUE(Study::can_be_written(folder / "s"));
  std::filesystem::remove_all(folder / "s" / "locks");  // made anew when it is needed
  EXPECT_TRUE(Study::can_be_written(folder / "s"));
  EXPECT_FALSE(Study::can_be_written(folder / "nowhere"));
}

TEST(StudyReading, RefusesToWrite) {
  const TemporaryFolder folder;
  make_closed_study(folder / "s");
  Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_participant({.label = "P02"}); }),
              HasSubstr("open for reading only"));
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_attempt(1, some_attempt(2)); }),
              HasSubstr("open for reading only"));
}

// The reader opened while nobody wrote, without locks; it has to notice.
TEST(StudyReading, FollowsAWriterWhoComesLater) {
  const TemporaryFolder folder;
  make_closed_study(folder / "s");
  const Study reader = Study::open(folder / "s", Access::read_only);
  EXPECT_EQ(reader.participants().size(), 1U);
  {
    Study writer = Study::open(folder / "s", Access::read_write);
    for (int i = 0; i < 50; ++i) {
      writer.add_participant({.label = "N" + std::to_string(i)});
      EXPECT_EQ(reader.participants().size(), 2U + static_cast<std::size_t>(i));
    }
  }
  EXPECT_EQ(reader.participants().size(), 51U);
  Study::open(folder / "s", Access::read_write).add_participant({.label = "Last"});
  EXPECT_EQ(reader.participants().size(), 52U);
}

TEST(StudyReading, FollowsAWriterWhoHasItOpenAlready) {
  const TemporaryFolder folder;
  Study writer = Study::create(folder / "s", "x");
  const Study reader = Study::open(folder / "s", Access::read_only);
  for (int i = 0; i < 50; ++i) {
    writer.add_participant({.label = "N" + std::to_string(i)});
    EXPECT_EQ(reader.participants().size(), static_cast<std::size_t>(i + 1));
  }
}

void run_sql(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* handle = nullptr;
  sqlite3_open(file.c_str(), &handle);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

TEST(StudyReading, SeesOneMomentWhateverAWriterAddsMeanwhile) {
  for (const bool is_open_already : {false, true}) {
    const TemporaryFolder folder;
    make_closed_study(folder / "s");
    std::optional<Study> writer{};
    if (is_open_already) writer.emplace(Study::open(folder / "s", Access::read_write));
    const Study reader = Study::open(folder / "s", Access::read_only);
    std::size_t before = 0;
    std::size_t after = 0;
    reader.read_at_one_moment([&] {
      before = reader.participants().size();
      if (!writer) writer.emplace(Study::open(folder / "s", Access::read_write));
      if (writer->participants().size() == 1) {
        writer->add_participant({.label = "late", .created_utc = "2026-01-01T00:00:00.000Z"});
      }
      after = reader.participants().size();
    });
    EXPECT_EQ(before, after) << is_open_already;
    EXPECT_EQ(reader.participants().size(), 2U);
  }
}

TEST(StudyOpening, RefusesWhatIsNoStudy) {
  const TemporaryFolder folder;
  const auto refused = [&folder](const std::string& sentence) {
    for (const Access access : {Access::read_only, Access::read_write}) {
      EXPECT_THAT(refusal_of<ResultsError>([&] { Study::open(folder / "s", access); }),
                  AllOf(HasSubstr(sentence), Not(HasSubstr("SQLite"))));
    }
  };
  refused("there is no folder");
  std::filesystem::create_directory(folder / "s");
  refused("is not a study: it has no study.sqlite");
  EXPECT_FALSE(Study::exists(folder / "s"));
  const std::filesystem::path file = folder / "s" / "study.sqlite";
  write_file(file, "", Overwrite::allow);
  refused("made by another program");
  write_file(file, "this is a letter, not a database, and it is long enough to look like one",
             Overwrite::allow);
  refused("is damaged");
  std::filesystem::remove(file);
  run_sql(file, "PRAGMA application_id = 7; CREATE TABLE study (x);");
  refused("made by another program");
}

TEST(StudyOpening, RefusesABrokenDatabase) {
  const TemporaryFolder folder;
  make_closed_study(folder / "s");
  const std::filesystem::path file = folder / "s" / "study.sqlite";
  const std::string whole = read_file(file);
  std::string broken = whole;
  broken.replace(100, 500, std::string(500, '\xff'));  // the root of the schema
  write_file(file, broken, Overwrite::allow);
  for (const Access access : {Access::read_only, Access::read_write}) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { Study::open(folder / "s", access); }),
                HasSubstr("is damaged; restore it from a copy"));
  }
}

// Numbers from statfs(2).
TEST(NetworkFileSystem, IsKnownByItsNumber) {
  EXPECT_EQ(network_file_system_of(0x6969), "NFS");
  EXPECT_EQ(network_file_system_of(static_cast<long>(0xff534d42)), "CIFS");
  EXPECT_EQ(network_file_system_of(static_cast<int>(0xff534d42)), "CIFS");  // where long is short
  EXPECT_EQ(network_file_system_of(0x65735546), "FUSE (sshfs or a cloud folder)");
  EXPECT_EQ(network_file_system_of(0xef53), "");      // ext4
  EXPECT_EQ(network_file_system_of(0x01021994), "");  // tmpfs
  EXPECT_EQ(network_file_system_at("/proc"), "");
}

}  // namespace
}  // namespace asperity
