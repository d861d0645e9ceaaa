// A copy is whole, of one moment, and checked; verify finds what does not hold.

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <sys/stat.h>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "results_schema/table_rules.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RecordingRow record(const std::filesystem::path& study, const std::string& path) {
  RecordingWriter writer(study, path, {.rate_Hz = 10.0, .columns = {{.name = "x_m"}}});
  for (int i = 0; i < 25; ++i) {
    const float x_m = 0.1F * static_cast<float>(i);
    writer.append(i, &x_m);
  }
  return writer.finish();
}

/// Changes a study by hand, past its constraints.
void execute_against_rules(const std::filesystem::path& study, const std::string& sql) {
  sqlite3* handle = nullptr;
  sqlite3_open((study / "study.sqlite").c_str(), &handle);
  const std::string unruled = "PRAGMA ignore_check_constraints = ON;" + sql;
  EXPECT_EQ(sqlite3_exec(handle, unruled.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

/// A study with a stimulus and a recorded attempt.
StudyWithSession recorded_study(const std::filesystem::path& folder) {
  Study study = Study::create(folder, "some study");
  write_file(folder / "stimuli" / "metal.png", "pixels", Overwrite::refuse);
  write_file(folder / "protocols" / "selection.json", "{}", Overwrite::refuse);
  study.add_participant(some_participant());
  SessionRow session = some_session(study.add_protocol(some_protocol()));
  session.files = {{.path = "stimuli/metal.png", .sha256 = sha256_of("pixels"), .bytes = 6}};
  const std::int64_t id = study.add_session(session, some_plan(3));
  study.begin_segment(id, 0);
  AttemptRow attempt = some_attempt(1);
  attempt.recording = record(folder, "recordings/P01/a.asprec");
  study.add_attempt(id, attempt);
  return {std::move(study), id};
}

TEST(StudyCopy, GoesToABareNameInTheCurrentFolder) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  EXPECT_NO_THROW(study.copy_to("copy"));
  std::filesystem::current_path(before);
  EXPECT_TRUE(Study::exists(folder / "copy"));
}

TEST(StudyCopy, HoldsWhatTheStudyHolds) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  write_file(folder / "s" / "stimuli" / "unused.png", "x", Overwrite::refuse);
  write_file(folder / "s" / "recordings" / "left.part", "x", Overwrite::refuse);
  const StudyLock lock(folder / "s", "device");
  study.copy_to(folder / "new" / "copy");  // while it is open for writing
  const Study copy = Study::open(folder / "new" / "copy", Access::read_only);
  EXPECT_THAT(copy.verify({}), IsEmpty());
  EXPECT_EQ(copy.name(), "some study");
  EXPECT_EQ(copy.attempts(session_id).size(), 1U);
  EXPECT_EQ(read_recording(copy.folder() / "recordings/P01/a.asprec").time_ns.size(), 25U);
  EXPECT_EQ(read_file(copy.folder() / "stimuli" / "unused.png"), "x");
  EXPECT_EQ(read_file(copy.folder() / "protocols" / "selection.json"), "{}");
  EXPECT_FALSE(std::filesystem::exists(copy.folder() / "recordings" / "left.part"));
  EXPECT_TRUE(std::filesystem::is_empty(copy.folder() / "locks"));
  EXPECT_FALSE(std::filesystem::exists(folder / "new" / "copy.part"));
}

TEST(StudyCopy, LeavesNothingWhereItIsStopped) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THAT(refusal_of<ResultsError>(
                  [&, &from = study] { from.copy_to(folder / "copy", stop.get_token()); }),
              HasSubstr("asked to stop"));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy"));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy.part"));
}

/// The same on disk, closed: nobody writes to it.
std::filesystem::path closed_study(const TemporaryFolder& folder) {
  recorded_study(folder / "s");
  return folder / "s";
}

/// Everything that is said against a study of which one bit is another; what cannot even be opened
/// says so.
std::vector<std::string> said_after_a_flip(const std::filesystem::path& study,
                                           const std::filesystem::path& file, std::size_t byte,
                                           int bit) {
  const std::string before = read_file(file);
  std::string after = before;
  after[byte] = static_cast<char>(after[byte] ^ (1 << bit));
  write_file(file, after, Overwrite::allow);
  std::vector<std::string> said;
  try {
    said = Study::open(study, Access::read_only).verify({});
  } catch (const ResultsError& error) {
    said = {error.what()};
  }
  write_file(file, before, Overwrite::allow);
  return said;
}

// Free space, unused bytes and the digits of numbers included: nothing but the checksum sees those.
TEST(StudyVerify, FindsOneFlippedBitAnywhere) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  std::mt19937_64 random(20240611);
  for (const char* const name :
       {"study.sqlite", "study.sqlite.sha256", "stimuli/metal.png", "recordings/P01/a.asprec"}) {
    const std::size_t bytes = std::filesystem::file_size(study / name);
    const int flips = name == std::string("study.sqlite") ? 100 : 20;
    for (int i = 0; i < flips; ++i) {
      const std::size_t byte = random() % bytes;
      const int bit = static_cast<int>(random() % 8);
      EXPECT_FALSE(said_after_a_flip(study, study / name, byte, bit).empty())
          << name << ", byte " << byte << ", bit " << bit;
    }
  }
  const Study whole = Study::open(study, Access::read_only);
  EXPECT_THAT(whole.verify({}), IsEmpty());
  EXPECT_THAT(whole.leftovers(), IsEmpty());
}

TEST(StudyVerify, LetsNoWriterVouchForDamageThatWasThereBefore) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  std::string content = read_file(study / "study.sqlite");
  const std::size_t place = content.find("some study");
  ASSERT_NE(place, std::string::npos);
  content[place] = 'S';
  write_file(study / "study.sqlite", content, Overwrite::allow);
  Study::open(study, Access::read_write).add_participant(some_participant("P02"));
  EXPECT_THAT(Study::open(study, Access::read_only).verify({}),
              Contains(HasSubstr("study.sqlite.sha256")));
  EXPECT_THROW(Study::open(study, Access::read_only).copy_to(folder / "copy"), ResultsError);
}

TEST(StudyVerify, FindsADatabaseWrittenToSealedByTheLastToClose) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  const auto says_unsealed = [&] {
    const std::vector<std::string> left = Study::open(study, Access::read_only).leftovers();
    return std::any_of(left.begin(), left.end(), [](const std::string& sentence) {
      return sentence.find("no checksum") != std::string::npos;
    });
  };
  EXPECT_FALSE(says_unsealed());
  {
    Study first = Study::open(study, Access::read_write);
    {
      Study second = Study::open(study, Access::read_write);
      second.add_participant(some_participant("P02"));
    }
    EXPECT_TRUE(says_unsealed());
    first.add_participant(some_participant("P03"));
  }
  EXPECT_FALSE(says_unsealed());
  EXPECT_THAT(Study::open(study, Access::read_only).verify({}), IsEmpty());
  std::filesystem::remove(study / "study.sqlite.sha256");
  EXPECT_TRUE(says_unsealed());
}

TEST(StudyCopy, IsAStudyThatContinues) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  Study::open(folder / "s", Access::read_only).copy_to(folder / "copy");
  Study copy = Study::open(folder / "copy", Access::read_write);
  copy.add_attempt(session_id, some_attempt(2));
  EXPECT_EQ(copy.attempts(session_id).size(), 2U);
  EXPECT_EQ(study.attempts(session_id).size(), 1U);
}

TEST(StudyCopy, NeedsAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  std::filesystem::create_directory(folder / "there");
  const auto refused = [&, &s = study](const std::filesystem::path& to) {
    return refusal_of<ResultsError>([&] { s.copy_to(to); });
  };
  EXPECT_THAT(refused(folder / "there"), HasSubstr("already exists"));
  EXPECT_THAT(refused(folder / "s" / "copy"), HasSubstr("into itself"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "there"));
}

TEST(StudyCopy, RefusesAStudyWhoseFilesDoNotHold) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  write_file(folder / "s" / "stimuli" / "metal.png", "other", Overwrite::allow);
  EXPECT_THAT(refusal_of<ResultsError>([&, &s = study] { s.copy_to(folder / "copy"); }),
              HasSubstr("stimuli/metal.png has changed since it was"));
  std::filesystem::remove(folder / "s" / "stimuli" / "metal.png");
  EXPECT_THAT(refusal_of<ResultsError>([&, &s = study] { s.copy_to(folder / "copy"); }),
              HasSubstr("metal.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy"));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy.part"));
}

/// Every file and folder below `folder`, without the one named.
std::vector<std::string> names_below(const std::filesystem::path& folder,
                                     const std::filesystem::path& without) {
  std::vector<std::string> names;
  for (auto entry = std::filesystem::recursive_directory_iterator(folder);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (entry->path() == without) {
      entry.disable_recursion_pending();
    } else {
      names.push_back(entry->path().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(StudyCopy, RefusesLinksAndWritesNowhereElse) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  std::filesystem::create_directories(folder / "elsewhere");
  write_file(folder / "elsewhere" / "a.png", "x", Overwrite::refuse);
  const auto refused_with = [&](const std::filesystem::path& target,
                                const std::string& link) -> std::string {
    std::filesystem::create_symlink(target, study / link);
    const auto before = names_below(folder.path(), study);
    const std::string refusal = refusal_of<ResultsError>(
        [&] { Study::open(study, Access::read_only).copy_to(folder / "copy"); });
    EXPECT_EQ(names_below(folder.path(), study), before);
    std::filesystem::remove(study / link);
    return refusal;
  };
  const auto names = [](const std::string& link, const std::string& target) {
    return AllOf(HasSubstr("its " + link + " is a symbolic link to " + target),
                 HasSubstr("Replace the link"));
  };
  EXPECT_THAT(refused_with("../../elsewhere/a.png", "stimuli/x"),
              names("stimuli/x", "../../elsewhere/a.png"));
  EXPECT_THAT(refused_with("../../nowhere", "stimuli/y"), names("stimuli/y", "../../nowhere"));
  EXPECT_THAT(refused_with("../../elsewhere", "protocols/more"),
              names("protocols/more", "../../elsewhere"));
  // What rows vouch for.
  std::filesystem::rename(study / "stimuli/metal.png", folder / "elsewhere" / "metal.png");
  EXPECT_THAT(refused_with(folder / "elsewhere" / "metal.png", "stimuli/metal.png"),
              HasSubstr("its stimuli/metal.png is a symbolic link"));
  std::filesystem::rename(folder / "elsewhere" / "metal.png", study / "stimuli/metal.png");
  std::filesystem::rename(study / "recordings", folder / "elsewhere" / "recordings");
  EXPECT_THAT(refused_with(folder / "elsewhere" / "recordings", "recordings"),
              HasSubstr("its recordings is a symbolic link"));
  std::filesystem::rename(folder / "elsewhere" / "recordings", study / "recordings");
  std::filesystem::rename(study / "study.sqlite", folder / "elsewhere" / "study.sqlite");
  EXPECT_THAT(refused_with(folder / "elsewhere" / "study.sqlite", "study.sqlite"),
              HasSubstr("its study.sqlite is a symbolic link"));
}

TEST(StudyCopy, RefusesWhatItCannotCopy) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  ASSERT_EQ(::mkfifo((study / "stimuli/pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal_of<ResultsError>(
                  [&] { Study::open(study, Access::read_only).copy_to(folder / "copy"); }),
              AllOf(HasSubstr("its stimuli/pipe is not a regular file"), HasSubstr("Remove it")));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy"));
}

TEST(StudyVerify, FindsNothingWrongInAGoodStudy) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  std::vector<double> told;
  EXPECT_THAT(study.verify([&told](double fraction) { told.push_back(fraction); }), IsEmpty());
  ASSERT_GE(told.size(), 5U);  // the database, SQLite's checks, a recording, a stimulus, the end
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(StudyVerify, StopsBeforeTheFilesAndBetweenThem) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  std::filesystem::remove(folder / "s" / "recordings/P01/a.asprec");
  std::filesystem::remove(folder / "s" / "stimuli" / "metal.png");
  ASSERT_EQ(study.verify({}).size(), 2U);
  for (const double from : {0.0, 0.5}) {
    std::stop_source stop;
    const auto stop_there = [&](double fraction) {
      if (fraction >= from) stop.request_stop();
    };
    EXPECT_EQ(study.verify(stop_there, stop.get_token()).size(), from == 0.0 ? 0U : 1U) << from;
  }
}

std::uint64_t bytes_read_by_this_process() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  std::uint64_t bytes = 0;
  counts >> name >> bytes;
  return name == "rchar:" ? bytes : 0;
}

TEST(StudyVerify, ReadsALargeDatabaseForItsChecksumOnceUnlessItIsStopped) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  constexpr std::uint64_t kBytes = 64U << 20;
  std::filesystem::resize_file(folder / "s" / "study.sqlite", kBytes);
  const Study study = Study::open(folder / "s", Access::read_only);
  const std::uint64_t before = bytes_read_by_this_process();
  if (before == 0) GTEST_SKIP() << "the kernel does not count what is read";
  EXPECT_THAT(study.verify({}), Contains(HasSubstr("it has changed since")));
  const std::uint64_t once = bytes_read_by_this_process();
  EXPECT_GE(once - before, kBytes);
  EXPECT_LT(once - before, kBytes * 3 / 2);
  EXPECT_THAT(study.leftovers(), IsEmpty());
  const std::uint64_t for_leftovers = bytes_read_by_this_process();
  EXPECT_LT(for_leftovers - once, kBytes / 4);
  std::stop_source stop;
  EXPECT_THAT(study.verify([&stop](double) { stop.request_stop(); }, stop.get_token()), IsEmpty());
  EXPECT_LT(bytes_read_by_this_process() - for_leftovers, kBytes / 4) << "it did not stop";
}

// Between reading the checksum and reading the file, as may happen to whoever analyses a study that
// is in use.
TEST(SealOf, AFileThatWasWrittenMeanwhileHolds) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  bool is_written = false;
  const auto write_once = [&](double) {
    if (std::exchange(is_written, true)) return;
    ParticipantRow other = some_participant();
    other.label = "P77";
    Study::open(folder / "s", Access::read_write).add_participant(other);
  };
  EXPECT_EQ(seal_of(folder / "s", {.progress = write_once}), Seal::holds);
  EXPECT_TRUE(is_written);
}

// The deletion compacts the file while it is read.
TEST(SealOf, AFileThatBecameShorterMeanwhileHolds) {
  const TemporaryFolder folder;
  ParticipantRow large = some_participant("Large1");
  large.answers_json = R"({"words":")" + std::string(200'000, 'x') + R"("})";
  { Study::create(folder / "s", "x").add_participant(large); }
  const auto before = std::filesystem::file_size(folder / "s" / "study.sqlite");
  int deletions = 0;
  const auto delete_once = [&](double) {
    if (deletions++ > 0) return;
    Study::open(folder / "s", Access::read_write)
        .withdraw("Large1", {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
  };
  EXPECT_EQ(seal_of(folder / "s", {.progress = delete_once}), Seal::holds);
  EXPECT_LT(std::filesystem::file_size(folder / "s" / "study.sqlite"), before);
}

// As the middle of a compaction can look, which is read without locks.
TEST(SealOf, AFileWhoseSchemaMakesNoSenseIsAnsweredAndNoError) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  const std::filesystem::path file = folder / "s" / "study.sqlite";
  std::string content = read_file(file);
  constexpr std::size_t kHeader_bytes = 100;  // of the file; the root page of the schema follows
  content.replace(kHeader_bytes, 400, std::string(400, '\xff'));
  write_file(file, content, Overwrite::allow);
  EXPECT_EQ(seal_of(folder / "s", {}), Seal::broken);
}

TEST(StudyVerify, FindsFilesThatAreMissingOrChanged) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  const std::filesystem::path recording = folder / "s" / "recordings/P01/a.asprec";
  std::string content = read_file(recording);
  content[content.size() - 20] = static_cast<char>(content[content.size() - 20] ^ 1);
  write_file(recording, content, Overwrite::allow);
  std::filesystem::remove(folder / "s" / "stimuli" / "metal.png");
  EXPECT_THAT(
      study.verify({}),
      ElementsAre(
          AllOf(HasSubstr("recordings/P01/a.asprec (the recording of attempt P01/1/1/1): it has "
                          "changed since"),
                HasSubstr("is damaged in chunk 4")),
          HasSubstr("stimuli/metal.png (a stimulus of session P01/1): the file is missing")));
}

// What cannot be asked after is one finding, and no end of the others.
TEST(StudyVerify, ContinuesWhereAFileCannotBeAskedAfter) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  const std::filesystem::path recording = folder / "s" / "recordings/P01/a.asprec";
  std::filesystem::remove(recording);
  std::filesystem::create_symlink(recording, recording);
  std::filesystem::remove(folder / "s" / "stimuli" / "metal.png");
  EXPECT_THAT(study.verify({}),
              ElementsAre(AllOf(HasSubstr("recordings/P01/a.asprec (the recording of attempt "
                                          "P01/1/1/1): "),
                                HasSubstr("symbolic links")),
                          HasSubstr("the file is missing")));
}

/// With so much in it that SQLite takes a while to look at it.
Study large_study(const std::filesystem::path& folder) {
  Study study = recorded_study(folder).study;
  const std::string solution = '"' + std::string(5000, 'x') + '"';
  for (int i = 0; i < 1000; ++i) study.remember_solution(std::to_string(i), solution);
  return study;
}

TEST(StudyVerify, TellsHowFarSQLiteHasCome) {
  const TemporaryFolder folder;
  { large_study(folder / "s"); }
  const Study study = Study::open(folder / "s", Access::read_only);
  std::vector<double> told;
  const auto tell = [&told, here = std::this_thread::get_id()](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    told.push_back(fraction);
  };
  EXPECT_THAT(study.verify(tell, {}, {StudyPart::database}), IsEmpty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_GT(std::count_if(told.begin(), told.end(),
                          [](double fraction) { return fraction > 0.2 && fraction < 1.0; }),
            0);
}

TEST(StudyVerify, LetsOutWhatTheCallerThrowsWhileSQLiteWorks) {
  const TemporaryFolder folder;
  { large_study(folder / "s"); }
  const Study study = Study::open(folder / "s", Access::read_only);
  const auto fail = [](double fraction) {
    if (fraction > 0.0) throw std::range_error("of the caller");
  };
  EXPECT_THROW(study.verify(fail, {}, {StudyPart::database}), std::range_error);
  EXPECT_THAT(study.verify({}), IsEmpty());  // and is as usable as before
}

// Of a database that may only be read SQLite forgets the CHECK constraints. verify reads.
TEST(StudyVerify, FindsRowsAgainstTheConstraintsInAStudyThatIsOpenForReading) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  execute_against_rules(folder / "s",
                        "DROP TRIGGER trial_no_update; UPDATE trial SET plan_json = '{';"
                        "DROP TRIGGER attempt_no_update;"
                        "UPDATE attempt SET valid = 1, invalid_reason = 'so';"
                        "DROP TRIGGER presentation_no_update;"
                        "UPDATE presentation SET seed = 'X' WHERE position = 1;");
  for (const Access access : {Access::read_only, Access::read_write}) {
    const std::vector<std::string> findings = Study::open(folder / "s", access).verify({});
    EXPECT_THAT(
        findings,
        Contains("study.sqlite: 3 rows of trial violate the rule CHECK (json_valid(plan_json))"));
    EXPECT_THAT(findings, Contains("study.sqlite: 1 row of attempt violates the rule CHECK "
                                   "((valid = 1) = (invalid_reason IS NULL))"));
    EXPECT_THAT(findings, Contains(AllOf(HasSubstr("1 row of presentation violates the rule"),
                                         HasSubstr("seed NOT GLOB '*[^0-9]*'"))));
    if (access == Access::read_only) continue;
    EXPECT_THAT(
        findings,
        Contains(HasSubstr(
            "study.sqlite: the file fails the integrity check of the database, and rows may "
            "be changed or missing; restore the study from a copy. Quote in a report of "
            "this error: CHECK constraint failed in ")));
  }
}

// Without its triggers and indices a study takes what it should refuse.
TEST(StudyVerify, FindsRulesThatAreGoneOrAreNotTheProgramsOwn) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  const std::filesystem::path file = folder / "s" / "study.sqlite";
  const std::string before = read_file(file);
  const auto findings_after = [&](const char* sql) {
    write_file(file, before, Overwrite::allow);
    sqlite3* handle = nullptr;
    sqlite3_open(file.c_str(), &handle);
    EXPECT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle);
    sqlite3_close(handle);
    return Study::open(folder / "s", Access::read_only).verify({}, {}, {StudyPart::rows});
  };
  EXPECT_THAT(findings_after("SELECT 1"), IsEmpty());
  EXPECT_THAT(findings_after("ANALYZE"), IsEmpty()) << "what SQLite keeps for itself";
  EXPECT_THAT(
      findings_after("DROP TRIGGER attempt_no_update"),
      ElementsAre(
          "study.sqlite: the trigger attempt_no_update, which every study has, is missing"));
  EXPECT_THAT(
      findings_after("DROP INDEX decision_attempt"),
      ElementsAre("study.sqlite: the index decision_attempt, which every study has, is missing"));
  EXPECT_THAT(
      findings_after("DROP VIEW tidy_response"),
      ElementsAre("study.sqlite: the view tidy_response, which every study has, is missing"));
  EXPECT_THAT(findings_after("DROP TRIGGER attempt_no_update; CREATE TRIGGER attempt_no_update "
                             "BEFORE UPDATE ON attempt WHEN 0 BEGIN SELECT 1; END"),
              ElementsAre(HasSubstr("the trigger attempt_no_update differs from the one that "
                                    "Asperity makes; it is now: CREATE "
                                    "TRIGGER attempt_no_update BEFORE UPDATE ON attempt WHEN 0 ")));
  EXPECT_THAT(
      findings_after("ALTER TABLE attempt ADD COLUMN mood TEXT"),
      ElementsAre(AllOf(HasSubstr("the table attempt differs from the one that Asperity makes"),
                        HasSubstr("mood TEXT"))));
  EXPECT_THAT(
      findings_after(
          "CREATE VIEW mine AS SELECT * FROM event; CREATE INDEX my_events ON event (kind)"),
      IsEmpty())
      << "whoever looks in their own way";
  EXPECT_THAT(findings_after("CREATE UNIQUE INDEX once ON participant (label)"),
              ElementsAre(HasSubstr("the index once was not made by Asperity")));
  EXPECT_THAT(findings_after("CREATE TRIGGER more AFTER INSERT ON event BEGIN SELECT 1; END"),
              ElementsAre("study.sqlite: the trigger more was not made by Asperity: CREATE TRIGGER "
                          "more AFTER INSERT ON event BEGIN SELECT 1; END"));
}

TEST(StudyVerify, ComparesRulesWithoutTheirCommentsAndBlanks) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  sqlite3* handle = nullptr;
  sqlite3_open((folder / "s" / "study.sqlite").c_str(), &handle);
  EXPECT_EQ(
      sqlite3_exec(handle,
                   "DROP TRIGGER attempt_no_update; CREATE TRIGGER attempt_no_update  -- as was\n"
                   "BEFORE UPDATE /* of all */ ON attempt\nBEGIN SELECT RAISE(ABORT, "
                   "'an attempt is append-only'); END;"
                   "DROP TRIGGER event_no_update; CREATE TRIGGER event_no_update BEFORE UPDATE "
                   "ON event BEGIN SELECT RAISE(ABORT, 'an event  is append-only'); END;",
                   nullptr, nullptr, nullptr),
      SQLITE_OK);
  sqlite3_close(handle);
  EXPECT_THAT(Study::open(folder / "s", Access::read_only).verify({}, {}, {StudyPart::rows}),
              ElementsAre(HasSubstr(
                  "the trigger event_no_update differs from the one that Asperity makes")));
}

TEST(TableRules, AreFoundInWhateverSurroundsThem) {
  EXPECT_THAT(
      checks_in(
          "CREATE TABLE \"check (x)\" (a TEXT CHECK (a <> ')' AND a <> '(''('), -- CHECK (no)\n"
          "b CHECK(b IN (1, (2))) , /* check (no) */ recheck TEXT, [check (] INT,\n"
          "cHeCk\n(a GLOB \"it's (\" OR b)) STRICT"),
      ElementsAre("a <> ')' AND a <> '(''('", "b IN (1, (2))", "a GLOB \"it's (\" OR b"));
  EXPECT_THAT(checks_in("CREATE TABLE t (a, b)"), IsEmpty());
}

// With the guards taken away by hand, as only a person who means to can.
TEST(StudyVerify, FindsInItsPartsWhatItFindsAltogether) {
  const TemporaryFolder folder;
  { recorded_study(folder / "s"); }
  execute_against_rules(folder / "s",
                        "DROP TRIGGER protocol_no_update;"
                        "UPDATE protocol SET source = 'x';"
                        "DROP TRIGGER trial_no_update; UPDATE trial SET plan_json = '{' "
                        "WHERE trial = 2; DROP TRIGGER attempt_no_delete; DELETE FROM attempt;");
  const Study study = Study::open(folder / "s", Access::read_only);
  std::vector<std::string> by_part{};
  std::map<StudyPart, std::size_t> counts{};
  for (const StudyPart part :
       {StudyPart::checksum, StudyPart::database, StudyPart::files, StudyPart::rows}) {
    for (const std::string& finding : study.verify({}, {}, {part})) {
      by_part.push_back(finding);
      ++counts[part];
    }
  }
  EXPECT_EQ(counts[StudyPart::checksum], 1U);
  EXPECT_EQ(counts[StudyPart::files], 0U) << "a recording without its attempt has no name";
  EXPECT_GT(counts[StudyPart::rows], 2U);
  EXPECT_EQ(study.verify({}), by_part);
  EXPECT_THAT(by_part, Contains(HasSubstr("the SHA-256 of its source differs")));
  EXPECT_THAT(
      by_part,
      Contains(HasSubstr("a row of response refers to a row of attempt that does not exist")));
}

TEST(StudyVerify, FindsWhatACrashLeft) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  record(folder / "s", "recordings/P01/b.asprec");
  write_file(folder / "s" / "recordings" / "c.asprec.part", "x", Overwrite::refuse);
  write_file(folder / "s" / "stimuli" / "d.png.1-0.tmp", "x", Overwrite::refuse);
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
  EXPECT_THAT(study.leftovers(),
              ElementsAre(HasSubstr("recordings/P01/b.asprec: a recording that belongs to no"),
                          AllOf(HasSubstr("recordings/c.asprec.part: an incomplete file"),
                                HasSubstr("If no program is writing to the study, remove it")),
                          HasSubstr("stimuli/d.png.1-0.tmp: an incomplete file"),
                          HasSubstr("study.sqlite: there is no checksum of the whole file")));
}

TEST(StudyVerify, FindsRowsThatContradictEachOther) {
  const TemporaryFolder folder;
  auto [study, session_id] = recorded_study(folder / "s");
  AttemptRow silent = some_attempt(2, 3);
  silent.responses.clear();
  study.add_attempt(session_id, silent);
  study.end_session(session_id, SessionState::completed, "2026-03-01T10:00:00Z");
  std::vector<PlannedTrialRow> gap = some_plan(2);
  gap[1].trial = 3;
  study.add_session(some_session(1), gap);
  EXPECT_THAT(study.verify({}),
              testing::UnorderedElementsAre(
                  "trial P01/1/2: its attempts are not numbered 1 to 1",
                  "attempt P01/1/2/3: it is answered, but there is no response",
                  "session P01/1: it is completed, but trial 3 was never attempted",
                  "session P01/1: it is completed, but its segment 1 has no end",
                  "session P01/2: its planned trials are not numbered 1 to 2"));
}

// The analyses of people would contain a simulation.
TEST(StudyVerify, FindsAVirtualParticipantMadeAPerson) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  EXPECT_THAT(study.verify({}), IsEmpty());
  execute_against_rules(
      folder / "s",
      "DROP TRIGGER participant_keeps_its_identity; UPDATE participant SET is_virtual = 0;");
  EXPECT_THAT(study.verify({}),
              Contains("participant P01: session 1 is a simulation, but the participant is not "
                       "virtual; restore the study from a copy"));
}

TEST(StudyVerify, ComparesTheLengthsOfFilesWithTheirRows) {
  const TemporaryFolder folder;
  const auto [study, session_id] = recorded_study(folder / "s");
  execute_against_rules(folder / "s",
                        "DROP TRIGGER recording_no_update; DROP TRIGGER session_file_no_update;"
                        "UPDATE recording SET bytes = bytes + 1, records = 24;"
                        "UPDATE session_file SET bytes = 7;");
  const std::vector<std::string> findings = study.verify({});
  EXPECT_THAT(findings,
              Contains(AllOf(HasSubstr("recordings/P01/a.asprec"), HasSubstr(" bytes, and"))));
  EXPECT_THAT(findings, Contains(HasSubstr("the file has 25 records, and its row states 24")));
  EXPECT_THAT(findings, Contains(AllOf(HasSubstr("stimuli/metal.png"),
                                       HasSubstr("the file has 6 bytes, and its row states 7"))));
}

// What can neither be read nor taken away must not keep a participant waiting.
TEST(StudyVerify, LetsNoChecksumThatIsInTheWayKeepAnybodyFromWriting) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "s";
  { recorded_study(path); }
  const std::filesystem::path seal = path / "study.sqlite.sha256";
  std::filesystem::remove(seal);
  std::filesystem::create_directories(seal / "already exists");
  {
    Study study = Study::open(path, Access::read_write);
    ParticipantRow person = some_participant();
    person.label = "P77";
    study.add_participant(person);
    EXPECT_THAT(study.verify({}), IsEmpty());
  }
  EXPECT_EQ(Study::open(path, Access::read_only).participants().size(), 2U);
}

TEST(StudyVerify, FindsAChecksumRenewedThatCouldNotBeTakenAway) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  const std::filesystem::path seal = study / "study.sqlite.sha256";
  // What cannot be removed when the writer comes can be when it goes, as after an error of the disk.
  std::filesystem::rename(seal, folder / "aside");
  std::filesystem::create_directories(seal / "already exists");
  {
    Study writer = Study::open(study, Access::read_write);
    std::filesystem::remove_all(seal);
    std::filesystem::rename(folder / "aside", seal);
    writer.add_participant(some_participant("P02"));
  }
  const Study after = Study::open(study, Access::read_only);
  EXPECT_THAT(after.verify({}), IsEmpty());
  EXPECT_THAT(after.leftovers(), IsEmpty());
}

// It is the last thing that a command writes: one that was complete before it was killed has no repetition that ends otherwise.
TEST(StudyVerify, FindsNothingOfAChecksumWhoseWriterWasKilled) {
  const TemporaryFolder folder;
  const std::filesystem::path study = closed_study(folder);
  const std::filesystem::path unfinished = study / "study.sqlite.sha256.7-0.tmp";
  write_file(unfinished, "12ab", Overwrite::refuse);
  EXPECT_THAT(Study::open(study, Access::read_only).leftovers(), testing::SizeIs(1));
  {
    const Study other = Study::open(study, Access::read_write);
    { const Study first_to_close = Study::open(study, Access::read_write); }
    EXPECT_TRUE(std::filesystem::exists(unfinished)) << "the other may be writing it";
  }
  EXPECT_FALSE(std::filesystem::exists(unfinished));
  EXPECT_THAT(Study::open(study, Access::read_only).leftovers(), IsEmpty());
}

TEST(StudyVerify, TakesAwayAChecksumOfAWriterThatNobodyKnewOf) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "s";
  { recorded_study(path); }
  // A file where the folder of locks should be: such a writer can have none.
  std::filesystem::remove_all(path / "locks");
  write_file(path / "locks", "", Overwrite::refuse);
  {
    Study study = Study::open(path, Access::read_write);
    write_file(path / "study.sqlite.sha256", "somebody else's", Overwrite::refuse);
    ParticipantRow person = some_participant();
    person.label = "P78";
    study.add_participant(person);
  }
  EXPECT_FALSE(std::filesystem::exists(path / "study.sqlite.sha256"));
  EXPECT_THAT(Study::open(path, Access::read_only).verify({}), IsEmpty());
}

// Past the rules of the tables, as a tool does that has switched them off.
TEST(StudyCopy, NamesTheColumnOfAWordThatItDoesNotKnow) {
  const TemporaryFolder folder;
  const std::int64_t id = recorded_study(folder / "s").session_id;
  execute_against_rules(folder / "s", "UPDATE session SET state = '[]'");
  EXPECT_THAT(
      refusal_of<ResultsError>([&] { Study::open(folder / "s", Access::read_only).session(id); }),
      AllOf(HasSubstr("\"[]\" in the column session.state"), HasSubstr("complete"),
            HasSubstr("Restore the study from a copy")));
}

}  // namespace
}  // namespace asperity
