// Studies of another schema, with made-up versions: those that the program has migrations from, and others.

#include "results_schema/migrations.h"

#include <array>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/files/atomic_file.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The schema of today under another number, and a later one in which the name of the study and a rule are different.
const std::array<Migration, 2> kMigrations{
    Migration{.version = 101, .sql = migrations().back().sql},
    Migration{.version = 102,
              .sql = "CREATE TABLE room (number INTEGER NOT NULL CHECK (number > 0)) STRICT;"
                     "INSERT INTO room VALUES (7);"
                     "UPDATE study SET name = name || ' in room 7';"}};
const std::span<const Migration> kOlder(kMigrations.data(), 1);
const std::span<const Migration> kNewer(kMigrations);

void change_study(const std::filesystem::path& study, const char* sql) {
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open((study / "study.sqlite").c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) contents[entry.path().string()] = read_file(entry.path());
  }
  return contents;
}

/// A study that the older program closed.
class OlderStudy : public testing::Test {
 protected:
  OlderStudy() {
    Study study = Study::create(place_, "some study", kOlder);
    study.add_participant(some_participant());
    const std::int64_t session =
        study.add_session(some_session(study.add_protocol(some_protocol())), some_plan(1));
    study.begin_segment(session, 1'000'000'000);
    study.add_attempt(session, some_attempt(1));
  }
  std::string refusal(Access access, std::span<const Migration> migrations) const {
    return refusal_of<ResultsError>([&] { Study::open(place_, access, migrations); });
  }

  TemporaryFolder folder_{};
  std::filesystem::path place_ = folder_ / "s";
  std::filesystem::path kept_ = place_ / "study.sqlite.version-101";
};

TEST_F(OlderStudy, IsReadAsIfItHadBeenMigratedAndNotWrittenTo) {
  const auto before = contents_of(place_);
  {
    const Study study = Study::open(place_, Access::read_only, kNewer);
    EXPECT_EQ(study.schema_version(), 101);
    EXPECT_EQ(study.name(), "some study in room 7");
    EXPECT_EQ(study.attempts(study.sessions().at(0).id).size(), 1U);
    EXPECT_THAT(study.verify({}), IsEmpty());
    EXPECT_EQ(study.condition(), StudyCondition::whole);
  }
  EXPECT_EQ(contents_of(place_), before);
}

TEST_F(OlderStudy, IsMigratedWhenItIsOpenedForWritingAndKeptAsItWas) {
  const Study reader = Study::open(place_, Access::read_only, kNewer);
  EXPECT_EQ(reader.participants().size(), 1U);
  {
    Study study = Study::open(place_, Access::read_write, kNewer);
    EXPECT_EQ(study.schema_version(), 102);
    EXPECT_EQ(study.name(), "some study in room 7");
    study.add_participant({.label = "P02"});
  }
  EXPECT_EQ(reader.participants().size(), 2U) << "the reader follows";
  EXPECT_EQ(reader.schema_version(), 102);
  EXPECT_THAT(Study::open(place_, Access::read_only, kNewer).verify({}), IsEmpty());
  // What was kept is a study of the older program as soon as it has its name back.
  std::filesystem::rename(kept_, place_ / "study.sqlite");
  const Study older = Study::open(place_, Access::read_write, kOlder);
  EXPECT_EQ(older.name(), "some study");
  EXPECT_EQ(older.participants().size(), 1U);
}

TEST_F(OlderStudy, IsMigratedOnceByProgramsThatOpenItAtOnce) {
  std::vector<std::thread> programs;
  for (int i = 0; i < 4; ++i) {
    programs.emplace_back([this] {
      EXPECT_EQ(Study::open(place_, Access::read_write, kNewer).name(), "some study in room 7");
    });
  }
  for (std::thread& program : programs) program.join();
  EXPECT_EQ(Study::open(place_, Access::read_only, kNewer).name(), "some study in room 7");
}

TEST_F(OlderStudy, IsMigratedInACopy) {
  Study::open(place_, Access::read_only, kNewer).copy_to(folder_ / "copy");
  Study study = Study::open(folder_ / "copy", Access::read_write, kNewer);
  study.add_participant({.label = "P02"});
  EXPECT_EQ(study.name(), "some study in room 7");
  EXPECT_EQ(Study::open(place_, Access::read_only, kOlder).name(), "some study");
}

TEST_F(OlderStudy, KeepsTheFirstCopyWhenItIsMigratedAgain) {
  write_file(kept_, "what somebody put there", Overwrite::refuse);
  Study::open(place_, Access::read_write, kNewer);
  EXPECT_EQ(read_file(kept_), "what somebody put there");
}

TEST_F(OlderStudy, StaysAsItWasWhenItsMigrationFails) {
  const std::array<Migration, 2> broken{
      kMigrations[0], Migration{.version = 102, .sql = "DROP TABLE author; DROP TABLE nothing;"}};
  EXPECT_THAT(refusal(Access::read_write, broken), HasSubstr("nothing"));
  const Study study = Study::open(place_, Access::read_only, kOlder);
  EXPECT_EQ(study.schema_version(), 101);
  EXPECT_THAT(study.verify({}), IsEmpty());
}

TEST_F(OlderStudy, IsVerifiedByTheRulesOfTheNewerSchema) {
  Study::open(place_, Access::read_write, kNewer);
  change_study(place_,
               "PRAGMA ignore_check_constraints = ON; UPDATE room SET number = 0;"
               "DROP TRIGGER trial_no_delete;");
  EXPECT_THAT(
      Study::open(place_, Access::read_only, kNewer).verify({}),
      AllOf(Contains(HasSubstr("1 row of room violates the rule CHECK (number > 0)")),
            Contains(HasSubstr("the trigger trial_no_delete, which every study has, is missing")),
            Not(Contains(HasSubstr("the table room was not made by Asperity")))));
}

TEST_F(OlderStudy, IsRefusedByAProgramWithoutMigrationsFromIt) {
  const std::span<const Migration> only_newer = kNewer.subspan(1);
  for (const Access access : {Access::read_only, Access::read_write}) {
    EXPECT_EQ(refusal(access, only_newer),
              "the study " + place_.string() +
                  " has the schema version 101 (its last session was begun by Asperity 0.2.0, "
                  "commit abc). This program reads only the schema version 102. Open the study "
                  "with the version of Asperity that wrote it, or create a new study");
  }
}

TEST_F(OlderStudy, IsRefusedByTheOlderProgramOnceItIsMigrated) {
  Study::open(place_, Access::read_write, kNewer);
  for (const Access access : {Access::read_only, Access::read_write}) {
    EXPECT_THAT(
        refusal(access, kOlder),
        AllOf(HasSubstr("has the schema version 102 (its last session was begun by Asperity"),
              HasSubstr("This program reads only the schema version 101. Open the study with the "
                        "version of Asperity that wrote it or with a newer one")));
  }
}

// Its tables may be others than those that this program reads.
TEST(SchemaVersion, IsRefusedWhereNoSessionNamesAProgram) {
  const TemporaryFolder folder;
  const std::filesystem::path place = folder / "s";
  Study::create(place, "some study", kNewer);
  for (const char* const sql : {"PRAGMA user_version = 7", "DROP TABLE session"}) {
    change_study(place, sql);
    EXPECT_EQ(refusal_of<ResultsError>([&] { Study::open(place, Access::read_only, kNewer); }),
              "the study " + place.string() +
                  " has the schema version 7, which another version of Asperity wrote. This "
                  "program reads the schema versions 101 to 102. Open the study with the version "
                  "of Asperity that wrote it, or create a new study")
        << sql;
  }
}

TEST(SchemaVersion, IsThatOfTheLastMigration) {
  const TemporaryFolder folder;
  EXPECT_EQ(Study::create(folder / "s", "x").schema_version(), migrations().back().version);
  EXPECT_EQ(Study::create(folder / "t", "x", kNewer).schema_version(), 102);
}

}  // namespace
}  // namespace asperity
