// Studies that are stored with their numbers are verified, resumed, analysed, reported and exported, with these numbers.

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/earlier_studies/numbers.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kFixtures = fs::path(ASPERITY_SOURCE_DIR) / "tests/earlier_studies";

/// The program whose numbers are stored; empty when numbers are compared.
fs::path program_to_store() {
  const char* const program = std::getenv("ASPERITY_STORE_NUMBERS_OF");
  return program == nullptr ? fs::path() : fs::path(program);
}

/// "present": the folders that hold a study and its numbers.
std::vector<std::string> all_studies() {
  std::vector<std::string> studies{};
  for (const fs::directory_entry& version : fs::directory_iterator(kFixtures)) {
    if (fs::exists(version.path() / "study")) studies.push_back(version.path().filename());
  }
  std::sort(studies.begin(), studies.end());
  return studies;
}

/// Runs the program on a copy of an earlier study.
class EarlierStudy : public testing::Test {
 protected:
  void take(const std::string& name) {
    fixture_ = kFixtures / name;
    fs::copy(fixture_ / "study", study(), fs::copy_options::recursive);
  }
  fs::path study() const { return folder_ / "study"; }
  fs::path place(const std::string& name) const { return folder_ / name; }
  fs::path protocol(const std::string& name) const { return study() / "protocols" / name; }

  Invocation invocation(std::vector<std::string> arguments) const {
    Invocation invocation{};
    invocation.program = program_to_store();
    invocation.arguments = std::move(arguments);
    return invocation;
  }
  /// Standard output of a run that succeeds.
  std::string output_of(std::vector<std::string> arguments) const {
    const Outcome outcome = run(invocation(std::move(arguments)));
    if (outcome.status != 0) throw std::runtime_error(outcome.err + outcome.out);
    return outcome.out;
  }

  Numbers analysis() const {
    return numbers_of_analysis(output_of({"analyze", study(), "--json"}));
  }
  /// The tables of one outcome, or of all outcomes of a group, that depend on answers and not on how a hand moved.
  Numbers answers_of(const std::string& outcome) const {
    Numbers numbers = analysis();
    std::erase_if(numbers, [&](const NumberTable& table) {
      return table.name.find(outcome + ':') == std::string::npos ||
             table.name.ends_with(": table texture_force") || table.name.ends_with(": findings");
    });
    return numbers;
  }
  Numbers exported_tables() const {
    const fs::path out = place("tables");
    fs::remove_all(out);
    output_of({"export", study(), "--out", out, "--formats", "all"});
    return numbers_of_export(out);
  }
  Numbers report() const {
    const fs::path out = place("report.html");
    output_of({"report", study(), "--out", out, "--force"});
    return numbers_of_report(text_of(out));
  }

  /// Compares with a file of the fixture, or writes it.
  void expect_numbers(const std::string& file, const Numbers& now) const {
    if (!program_to_store().empty())
      return write_text(fixture_ / file, asperity::test::text_of(now));
    EXPECT_THAT(differences(stored_numbers(file), now), IsEmpty());
  }
  Numbers stored_numbers(const std::string& file) const {
    Numbers stored = read_numbers(text_of(fixture_ / file));
    const fs::path corrections = fixture_ / ("corrections_of_" + file);
    if (fs::exists(corrections)) correct(stored, read_corrections(text_of(corrections)));
    return stored;
  }
  void expect_everything_holds() const {
    std::size_t recordings = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(study())) {
      if (entry.path().extension() == ".rec") ++recordings;
    }
    const std::string verified = output_of({"verify", study(), "--replay"});
    EXPECT_THAT(verified, HasSubstr(std::to_string(recordings) + " recording"));
  }

 private:
  TemporaryFolder folder_{};
  fs::path fixture_{};
};

class StudyOfAnEarlierVersion : public EarlierStudy,
                                public testing::WithParamInterface<std::string> {
 protected:
  StudyOfAnEarlierVersion() { take(GetParam()); }
};

TEST_P(StudyOfAnEarlierVersion, Verifies) { expect_everything_holds(); }

TEST_P(StudyOfAnEarlierVersion, GivesTheSameAnalysis) {
  expect_numbers("analysis.tsv", analysis());
}

TEST_P(StudyOfAnEarlierVersion, GivesTheSameTables) {
  expect_numbers("export.tsv", exported_tables());
}

#ifdef ASPERITY_WITH_REPORT
TEST_P(StudyOfAnEarlierVersion, GivesTheSameReport) { expect_numbers("report.tsv", report()); }
#endif

// From the first schema after 1.0.0 on, this migrates an earlier one.
TEST_P(StudyOfAnEarlierVersion, KeepsItsNumbersWhenItIsOpenedForWriting) {
  if (!program_to_store().empty()) return;
  Study::open(study(), Access::read_write);
  expect_everything_holds();
  expect_numbers("analysis.tsv", analysis());
  expect_numbers("export.tsv", exported_tables());
}

std::string name_of(const testing::TestParamInfo<std::string>& study) {
  std::string name = study.param;
  std::replace_if(
      name.begin(), name.end(), [](char sign) { return sign == '.' || sign == '/'; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, StudyOfAnEarlierVersion, testing::ValuesIn(all_studies()), name_of);

// --- the interrupted session ----------------------------------------------------------------------

class InterruptedSession : public EarlierStudy {
 protected:
  InterruptedSession() { take("present"); }

  /// Every trial of the main phase has one valid attempt. Practice may have ended early.
  void expect_completed(const std::string& participant) const {
    const Study stored = Study::open(study(), Access::read_only);
    for (const SessionRow& session : stored.sessions()) {
      if (session.participant != participant) continue;
      EXPECT_EQ(session.state, SessionState::completed) << session.session;
      const std::vector<AttemptRow> attempts = stored.attempts(session.id);
      for (const PlannedTrialRow& planned : stored.plan(session.id)) {
        if (planned.phase != "main") continue;
        EXPECT_EQ(std::count_if(attempts.begin(), attempts.end(),
                                [&](const AttemptRow& attempt) {
                                  return attempt.trial == planned.trial && attempt.valid;
                                }),
                  1)
            << "session " << session.session << ", trial " << planned.trial;
      }
    }
  }
  /// Resuming adds rows and changes none.
  void expect_unchanged_rows() const {
    if (!program_to_store().empty()) return;
    Numbers before{};
    for (NumberTable& table : stored_numbers("export.tsv")) {
      if (!kAppendOnly.contains(table.name)) continue;
      table.may_grow = true;
      before.push_back(std::move(table));
    }
    EXPECT_EQ(before.size(), kAppendOnly.size());
    EXPECT_THAT(differences(before, exported_tables()), IsEmpty());
  }

 private:
  static inline const std::set<std::string> kAppendOnly{"attempts.tsv", "presentations.tsv",
                                                        "responses.tsv", "servo_quality.tsv",
                                                        "compliance.tsv"};
};

TEST_F(InterruptedSession, OfAKilledProgramContinues) {
  output_of({"run", protocol("improved_recognition.json"), "--study", study(), "--participant",
             "P01", "--virtual", "--mode", "pilot", "--resume"});
  expect_completed("P01");
  expect_unchanged_rows();
  expect_everything_holds();
  expect_numbers("resumed_session.tsv", answers_of("improved_recognition 1.1.0 virtual"));
}

}  // namespace
}  // namespace asperity::test
