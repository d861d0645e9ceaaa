// Studies of earlier programs open and say what they said then.

#include <cstdio>
#include <cstdlib>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/sha256.h"
#include "results_schema/study.h"
#include "results_schema/table.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

const std::filesystem::path kFixtures =
    std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/results_schema/fixtures";

const std::string kNewest = "study_version_" + std::to_string(Study::kSchemaVersion);

/// A copy of the fixture of a schema version, so that opening it may bring it up to date.
class Fixture {
 public:
  explicit Fixture(int version) : path_(folder_ / "study") {
    std::filesystem::copy(kFixtures / ("study_version_" + std::to_string(version)), path_,
                          std::filesystem::copy_options::recursive);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_{};
  std::filesystem::path path_;
};

class StudyOfSchemaVersion : public testing::TestWithParam<int> {};

TEST_P(StudyOfSchemaVersion, SaysWhatItSaidThen) {
  const Fixture fixture(GetParam());
  const Study study = Study::open(fixture.path(), Access::read_only);
  EXPECT_EQ(study.name(), "fixture");
  ASSERT_EQ(study.participants().size(), 2U);
  EXPECT_TRUE(study.participants()[0].is_virtual);
  EXPECT_FALSE(study.participants()[1].is_virtual);
  ASSERT_EQ(study.sessions().size(), 1U);
  const SessionRow session = study.sessions()[0];
  EXPECT_EQ(session.state, SessionState::completed);
  EXPECT_EQ(session.seed, "18446744073709551615");
  EXPECT_EQ(session.mirrored, GetParam() >= 2);
  EXPECT_EQ(session.group_level.value_or(""), GetParam() >= 9 ? "haptic" : "");
  EXPECT_EQ(study.protocol(session.protocol_id).source, R"({"name":"selection"})");
  const std::vector<PlannedTrialRow> plan = study.plan(session.id);
  ASSERT_EQ(plan.size(), GetParam() >= 12 ? 4U : GetParam() >= 10 ? 3U : 2U);
  if (GetParam() >= 10) {
    EXPECT_EQ(plan[2].track, 2);
    EXPECT_EQ(plan[2].step, 1);
    EXPECT_FALSE(plan[2].is_catch);
  }
  EXPECT_FALSE(plan[0].track);
  EXPECT_EQ(plan.back().is_catch, GetParam() >= 12);
  EXPECT_EQ(session.expected_trials, GetParam() >= 10 ? std::optional(7) : std::nullopt);
  EXPECT_EQ(study.session_answers(session.id).at(0).answer, "left");
  EXPECT_EQ(study.events(session.id).at(0).text, "done");
  EXPECT_EQ(study.solution("key"), R"({"A_m":0.0001})");
  const std::vector<AttemptRow> attempts = study.attempts(session.id);
  ASSERT_EQ(attempts.size(), GetParam() >= 12 ? 4U : 3U);
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    EXPECT_EQ(attempts[i].purpose, i == 3 ? AttemptPurpose::refresher : AttemptPurpose::trial);
  }
  EXPECT_EQ(attempts[0].outcome, AttemptOutcome::aborted);
  EXPECT_EQ(attempts[1].attempt, 2);
  EXPECT_EQ(attempts[1].responses.at(0).answer, "B");
  EXPECT_TRUE(attempts[1].valid);
  EXPECT_EQ(attempts[2].servo->lost_records, 5);
  EXPECT_EQ(attempts[2].servo->missed_in_contact.has_value(), GetParam() >= 4);
  EXPECT_EQ(attempts[2].presentations.at(0).matched_texture_force_N, 0.1);
  const std::vector<AssetRow>& assets = attempts[2].presentations.at(0).assets;
  EXPECT_EQ(asset_sha256(assets, "height_field"), sha256_of("metal"));
  EXPECT_EQ(asset_sha256(assets, "surface").has_value(), GetParam() >= 3);
  EXPECT_EQ(asset_sha256(assets, "tool").value_or(""), GetParam() >= 3 ? sha256_of("ball") : "");
  EXPECT_EQ(asset_sha256(assets, "vibrations").has_value(), GetParam() >= 8);
  EXPECT_TRUE(attempts[2].presentations.at(1).assets.empty());
  EXPECT_EQ(attempts[2].presentations.at(0).limits.size(), GetParam() >= 3 ? 2U : 0U);
  ASSERT_EQ(attempts[2].presentations.at(0).visits.size(), GetParam() >= 11 ? 2U : 0U);
  if (GetParam() >= 11) {
    EXPECT_EQ(attempts[2].presentations[0].visits[0].path_m, 0.06);
  }
  // In an earlier version it is absent, not a row of zeros.
  ASSERT_EQ(attempts[2].presentations[0].instability.has_value(), GetParam() >= 13);
  if (GetParam() >= 13) {
    EXPECT_EQ(attempts[2].presentations[0].instability->buzz, 0.31);
    EXPECT_EQ(attempts[2].presentations[0].instability->no_crest_share, "no_crests");
  }
  EXPECT_FALSE(attempts[2].presentations[1].instability);
  EXPECT_EQ(attempts[2].presentations[0].stiffness_N_per_m.has_value(), GetParam() >= 11);
  EXPECT_EQ(attempts[2].compliance.at(0).p95, 1.2);
  EXPECT_EQ(attempts[2].excluded.value_or("counts").text, GetParam() >= 2 ? "sneezed" : "counts");
}

/// From version 7 on words are codes with arguments; earlier ones are the text alone.
TEST_P(StudyOfSchemaVersion, KeepsTheCodesOfWords) {
  const Fixture fixture(GetParam());
  const Study study = Study::open(fixture.path(), Access::read_only);
  const std::int64_t session = study.sessions().at(0).id;
  const StoredWords reason = study.attempts(session).at(0).invalid_reason.value();
  const std::vector<EventRow> events = study.events(session);
  if (GetParam() < 7) {
    EXPECT_EQ(reason, StoredWords("the participant stopped", ""));
    EXPECT_EQ(events.at(0).words(), StoredWords("done", ""));
    return;
  }
  const std::string repeated =
      R"({"code":"trial_repeated","arguments":["the participant sneezed"]})";
  EXPECT_EQ(reason.text,
            "not explored as instructed: normal force of surface 2; repeated by the experimenter: "
            "the participant sneezed");
  EXPECT_EQ(reason.json,
            R"({"code":"list","arguments":[{"code":"exploration_not_compliant","arguments":)"
            R"([{"code":"quantity_of_surface","arguments":[{"code":"normal_force_N"},"2"]}]},)" +
                repeated + "]}");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].text_json, repeated);
}

TEST_P(StudyOfSchemaVersion, Verifies) {
  const Fixture fixture(GetParam());
  EXPECT_THAT(Study::open(fixture.path(), Access::read_only).verify({}), testing::IsEmpty());
}

TEST_P(StudyOfSchemaVersion, ContinuesInACopy) {
  const Fixture fixture(GetParam());
  const TemporaryFolder folder;
  Study::open(fixture.path(), Access::read_only).copy_to(folder / "copy");
  Study study = Study::open(folder / "copy", Access::read_write);
  study.add_participant({.label = "P03"});
  EXPECT_EQ(study.participants().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(All, StudyOfSchemaVersion, testing::Range(1, Study::kSchemaVersion + 1),
                         testing::PrintToStringParamName());

std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) contents[entry.path().string()] = read_file(entry.path());
  }
  return contents;
}

TEST(OlderStudy, IsNotWrittenToByWhoeverOnlyReads) {
  const Fixture fixture(1);
  const auto before = contents_of(fixture.path());
  {
    const Study study = Study::open(fixture.path(), Access::read_only);
    EXPECT_EQ(study.schema_version(), 1);
    EXPECT_TRUE(study.decisions(study.sessions().at(0).id).empty());  // a table of version 2
    EXPECT_THAT(study.verify({}), testing::IsEmpty());
  }
  EXPECT_EQ(contents_of(fixture.path()), before);
}

TEST(OlderStudy, IsBroughtUpToDateByWhoeverWritesAndKeptAsItWas) {
  const Fixture fixture(1);
  const Study reader = Study::open(fixture.path(), Access::read_only);
  EXPECT_EQ(reader.participants().size(), 2U);
  {
    Study study = Study::open(fixture.path(), Access::read_write);
    EXPECT_EQ(study.schema_version(), Study::kSchemaVersion);
    study.add_participant({.label = "P03"});
  }
  EXPECT_EQ(reader.participants().size(), 3U) << "the reader follows";
  EXPECT_EQ(reader.schema_version(), Study::kSchemaVersion);
  // What was kept is a study of version 1 as soon as it has its name back.
  const std::filesystem::path kept = fixture.path() / "study.sqlite.version-1";
  ASSERT_TRUE(std::filesystem::exists(kept));
  std::filesystem::rename(kept, fixture.path() / "study.sqlite");
  const Study older = Study::open(fixture.path(), Access::read_only);
  EXPECT_EQ(older.schema_version(), 1);
  EXPECT_EQ(older.participants().size(), 2U);
}

// Until version 7 the hashes of assets were columns. They stay there, and become rows as well.
TEST(OlderStudy, WithADamagedHashIsStillReadAndTheDamageIsFound) {
  const Fixture fixture(7);
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open((fixture.path() / "study.sqlite").c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle,
                         "PRAGMA ignore_check_constraints = ON;"
                         "DROP TRIGGER presentation_no_update;"
                         "UPDATE presentation SET surface_sha256 = 'X' WHERE position = 1;",
                         nullptr, nullptr, nullptr),
            SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
  for (const Access access : {Access::read_only, Access::read_write}) {
    const Study study = Study::open(fixture.path(), access);
    const AttemptRow attempt = study.attempts(study.sessions().at(0).id).at(1);
    const std::vector<AssetRow>& assets = attempt.presentations.at(0).assets;
    EXPECT_EQ(asset_sha256(assets, "surface"), std::nullopt);
    EXPECT_EQ(asset_sha256(assets, "tool"), sha256_of("ball"));
    EXPECT_THAT(study.verify({}), testing::Contains(testing::AllOf(
                                      testing::HasSubstr("rows of presentation violate the rule"),
                                      testing::HasSubstr("length(surface_sha256) = 64"))));
  }
}

TEST(OlderStudy, KeepsTheFirstCopyWhenItIsBroughtUpToDateAgain) {
  const Fixture fixture(1);
  const std::filesystem::path kept = fixture.path() / "study.sqlite.version-1";
  write_file(kept, "what somebody put there", Overwrite::refuse);
  Study::open(fixture.path(), Access::read_write);
  EXPECT_EQ(read_file(kept), "what somebody put there");
}

/// The program between ```python and ``` in a page of documentation.
std::string python_of(const std::filesystem::path& page) {
  const std::string text = read_file(page);
  const std::string opening = "```python\n";
  const std::size_t start = text.find(opening) + opening.size();
  return text.substr(start, text.find("```", start) - start);
}

std::string output_of(const std::string& command) {
  FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string output;
  for (int character = std::fgetc(pipe); character != EOF; character = std::fgetc(pipe)) {
    output += static_cast<char>(character);
  }
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return output;
}

TEST(RecordingDocumentation, HasAReaderThatReadsWhatWeRead) {
  const std::filesystem::path formats = std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats";
  const TemporaryFolder folder;
  write_file(folder / "reader.py", python_of(formats / "recording.md"), Overwrite::refuse);
  const std::filesystem::path file = kFixtures / "study_version_1" / "recordings/P01-1-2.asprec";
  const Table table = read_tsv(
      output_of("python3 '" + (folder / "reader.py").string() + "' '" + file.string() + "'"),
      "python's output");
  const Recording recording = read_recording(file);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"time_ns", "x_m", "force_N"}));
  ASSERT_EQ(table.rows.size(), 25U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto number = [&table, i](std::size_t column) {
      return number_in(std::get<std::string>(table.rows[i][column]));
    };
    EXPECT_EQ(number(0), static_cast<double>(recording.time_ns[i]));
    EXPECT_EQ(number(1), static_cast<double>(recording.columns[0][i]));
    EXPECT_EQ(number(2), static_cast<double>(recording.columns[1][i]));
  }
}

TEST(StudyDocumentation, HasAReaderThatReadsTheFixture) {
  const std::filesystem::path formats = std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats";
  const TemporaryFolder folder;
  write_file(folder / "reader.py", python_of(formats / "study.md"), Overwrite::refuse);
  EXPECT_EQ(output_of("python3 '" + (folder / "reader.py").string() + "' '" +
                      (kFixtures / "study_version_3").string() + "'"),
            "P01 1 1 2 confidence sure None\nP01 1 1 2 which B 1\n");
}

/// Every table and column of the schema is explained.
TEST(StudyDocumentation, NamesEveryTableAndColumn) {
  const std::filesystem::path source(ASPERITY_SOURCE_DIR);
  const std::string page = read_file(source / "docs/formats/study.md");
  const std::string output = output_of(
      "python3 -c \"import sqlite3, sys\n"
      "c = sqlite3.connect('file:" +
      (kFixtures / kNewest / "study.sqlite").string() +
      "?immutable=1', uri=True)\n"
      "for (t,) in c.execute('SELECT name FROM sqlite_schema WHERE type IN (\\\"table\\\", "
      "\\\"view\\\")').fetchall():\n"
      "  print(t)\n"
      "  if not t.startswith('tidy'):\n"
      "    for r in c.execute('PRAGMA table_info(' + t + ')'): print(r[1])\n\"");
  std::size_t start = 0;
  int names = 0;
  for (std::size_t end = 0; (end = output.find('\n', start)) != std::string::npos;
       start = end + 1, ++names) {
    const std::string name = "`" + output.substr(start, end - start) + "`";
    EXPECT_NE(page.find(name), std::string::npos) << name;
  }
  EXPECT_GT(names, 100);
}

}  // namespace
}  // namespace asperity
