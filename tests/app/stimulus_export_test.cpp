// What an export has of stimuli, and of counts to fit a psychometric function to.

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study_files/height_field_files.h"
#include "results_schema/hashes/sha256.h"
#include "tests/app/exported_study.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A wave of 2 mm and 0.1 mm amplitude on 51.2 mm × 51.2 mm; returns the SHA-256 of its sidecar.
std::string add_wave(MadeUpStudy& made) {
  constexpr std::size_t kSide = 256;
  constexpr double kPitch_m = 2e-4;
  std::vector<float> heights_m(kSide * kSide);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const double x_m = static_cast<double>(i % kSide) * kPitch_m;
    heights_m[i] = static_cast<float>(1e-4 * std::sin(2.0 * std::numbers::pi * x_m / 2e-3));
  }
  const fs::path png = made.folder() / "stimuli/wave.png";
  fs::create_directories(png.parent_path());
  save_height_field(png, HeightField({kSide, kSide, kPitch_m}, heights_m), {.kind = "sinusoid"},
                    Overwrite::refuse);
  return load_height_field(png).sha256;
}

MadeUpTrial felt(const std::string& sha256, double achieved_N) {
  MadeUpTrial trial = some_trial();
  trial.surfaces = {surface_of("stone", "height_map", "stone")};
  trial.surfaces[0].assets = {{"height_field", sha256}};
  trial.surfaces[0].matched_texture_force_N = 0.05;
  trial.surfaces[0].achieved_texture_force_N = achieved_N;
  return trial;
}

double cell_number(const Table& table, const std::string& column) {
  return std::stod(std::get<std::string>(cell_of(table, 0, column)));
}

TEST(ExportedStimuli, HaveTheirForcesAndTheFeaturesOfTheirHeightFields) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::string sha256 = add_wave(made);
  MadeUpTrial invalid = felt(sha256, 9.0);
  invalid.valid = false;
  made.set_files({{"stimuli/wave.png.json", sha256, 1}});
  made.add_session("anna", made.add_protocol("recognition", "recognition", kExportedProtocol),
                   {felt(sha256, 0.04), felt(sha256, 0.08), invalid});
  const fs::path out = made.beside("out");
  export_to(made, out);
  const Table stimuli = table_in(out, "stimuli.tsv");
  ASSERT_EQ(stimuli.rows.size(), 1U);
  EXPECT_EQ(cell_of(stimuli, 0, "presentations"), Cell{"3"});
  EXPECT_EQ(cell_of(stimuli, 0, "matched_texture_force_N"), Cell{"0.05"});
  EXPECT_EQ(cell_of(stimuli, 0, "achieved_presentations"), Cell{"2"});
  EXPECT_NEAR(cell_number(stimuli, "achieved_texture_force_mean_N"), 0.06, 1e-12);
  EXPECT_NEAR(cell_number(stimuli, "achieved_texture_force_sd_N"), 0.04 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(cell_number(stimuli, "height_field_dominant_wavelength_m"), 2e-3, 2e-4);
  EXPECT_NEAR(cell_number(stimuli, "height_field_rms_m"), 1e-4 / std::sqrt(2.0), 1e-6);
  EXPECT_EQ(cell_of(stimuli, 0, "height_field"), Cell{"stimuli/wave.png"});
  EXPECT_EQ(read_file(out / "stimuli/wave.png"), read_file(made.folder() / "stimuli/wave.png"));
  EXPECT_EQ(sha256_of(read_file(out / "stimuli/wave.png.json")), sha256);
  const Exported tables(made);
  EXPECT_THAT(names_in(tables.folder()), Not(Contains("stimuli")));
  EXPECT_EQ(tables.table("stimuli").rows.size(), 1U);
}

/// A study whose only session used the wave of this SHA-256.
void add_session_with_wave(MadeUpStudy& made, const std::string& sha256) {
  made.add_person("anna", "F");
  made.set_files({{"stimuli/wave.png.json", sha256, 1}});
  made.add_session("anna", made.add_protocol("recognition", "recognition", kExportedProtocol),
                   {felt(sha256, 0.04)});
}

TEST(ExportedStimuli, AreCompleteWithoutAWord) {
  MadeUpStudy made;
  add_session_with_wave(made, add_wave(made));
  const ExportOutcome outcome = export_to(made, made.beside("out"));
  EXPECT_THAT(outcome.warnings, IsEmpty());
  EXPECT_EQ(cell_of(table_in(made.beside("out"), "stimuli.tsv"), 0, "height_field_state"),
            Cell{"complete"});
  EXPECT_THAT(read_file(made.beside("out") / "README.txt"), Not(HasSubstr("INCOMPLETE")));
}

TEST(ExportedStimuli, HaveNoFeaturesOfAFileThatWasChangedAndTheExportWarnsOfIt) {
  MadeUpStudy made;
  add_wave(made);
  add_session_with_wave(made, std::string(64, '0'));
  const fs::path out = made.beside("out");
  const ExportOutcome outcome = export_to(made, out);
  const Table stimuli = table_in(out, "stimuli.tsv");
  EXPECT_EQ(cell_of(stimuli, 0, "height_field_rms_m"), Cell{});
  EXPECT_EQ(cell_of(stimuli, 0, "height_field_state"), Cell{"changed"});
  EXPECT_THAT(names_in(out), Not(Contains("stimuli")));
  ASSERT_EQ(outcome.warnings.size(), 1U);
  EXPECT_THAT(outcome.warnings[0].english(), HasSubstr("is not the file that the sessions used"));
}

class MissingStimulusFile : public testing::TestWithParam<const char*> {};

TEST_P(MissingStimulusFile, IsWarnedOfWithStimulusFileAndRemedy) {
  MadeUpStudy made;
  add_session_with_wave(made, add_wave(made));
  fs::remove(made.folder() / GetParam());
  const fs::path out = made.beside("out");
  const ExportOutcome outcome = export_to(made, out);
  ASSERT_EQ(outcome.warnings.size(), 1U);
  const std::string warning = outcome.warnings[0].english();
  EXPECT_EQ(
      warning,
      "stimuli/wave.png, the height field of the stimulus \"surface\" (stone), is missing from the "
      "study: the export has neither the file nor its features. Restore it from a backup or "
      "a copy of the study, then export again.");
  EXPECT_THAT(read_file(out / "README.txt"), HasSubstr("INCOMPLETE: " + warning));
  EXPECT_EQ(cell_of(table_in(out, "stimuli.tsv"), 0, "height_field_state"), Cell{"missing"});
}

INSTANTIATE_TEST_SUITE_P(HeightFieldOrSidecar, MissingStimulusFile,
                         testing::Values("stimuli/wave.png", "stimuli/wave.png.json"));

MadeUpTrial at_level(double spacing_m, const std::string& answer) {
  MadeUpTrial trial = some_trial();
  trial.factors_json = R"({"order": "first", "spacing_m": )" + text_of_number(spacing_m) + "}";
  trial.answers = {answer};
  return trial;
}

// Two of three correct at 1 mm and one of one at 10 mm. A session that was stopped has a selection of the
// levels: it is not in the counts.
TEST(ExportedCounts, AreOfCompletedSessionsByParticipantAndCondition) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  made.add_person("ben", "M");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kExportedProtocol);
  made.add_session("anna", protocol,
                   {at_level(0.001, "stone"), at_level(0.001, "wood"), at_level(0.001, "stone"),
                    at_level(0.01, "stone")});
  made.set_state(SessionState::stopped);
  made.add_session("ben", protocol, {at_level(0.001, "stone"), at_level(0.01, "wood")});
  const fs::path out = made.beside("out");
  export_to(made, out);
  const Table fit = table_in(out, "fit.tsv");
  ASSERT_EQ(fit.rows.size(), 2U);
  EXPECT_EQ(cell_of(fit, 0, "condition"),
            Cell{"anna: recognition 1, which, correct, order = first"});
  EXPECT_EQ(cell_of(fit, 1, "condition"), cell_of(fit, 0, "condition"));
  for (const auto& [row, x, k, n] :
       {std::tuple(0U, "0.001", "2", "3"), std::tuple(1U, "0.01", "1", "1")}) {
    EXPECT_EQ(cell_of(fit, row, "x"), Cell{x});
    EXPECT_EQ(cell_of(fit, row, "k"), Cell{k});
    EXPECT_EQ(cell_of(fit, row, "n"), Cell{n});
    EXPECT_EQ(cell_of(fit, row, "participant"), Cell{"anna"});
    EXPECT_EQ(cell_of(fit, row, "factor"), Cell{"spacing_m"});
  }
}

TEST(ExportedCounts, AreOfEachAnswerWhereNoneIsCorrect) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  std::vector<MadeUpTrial> trials{at_level(0.001, "stone"), at_level(0.001, "wood"),
                                  at_level(0.01, "wood")};
  for (MadeUpTrial& trial : trials) trial.right = {};
  made.add_session("anna", made.add_protocol("choose", "selection", kExportedProtocol), trials);
  const fs::path out = made.beside("out");
  export_to(made, out);
  const Table fit = table_in(out, "fit.tsv");
  std::vector<std::string> rows{};
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    std::string row{};
    for (const char* column : {"counted", "x", "k", "n"}) {
      row += std::get<std::string>(cell_of(fit, i, column)) + ' ';
    }
    rows.push_back(row);
  }
  EXPECT_THAT(rows, ElementsAre("stone 0.001 1 2 ", "stone 0.01 0 1 ", "wood 0.001 1 2 ",
                                "wood 0.01 1 1 "));
}

// A repetition is a number in many protocols, and no level of anything: responses of all are counted together.
TEST(ExportedCounts, TakeNoRepetitionForALevel) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  std::vector<MadeUpTrial> trials{};
  for (const int column : {1, 2}) {
    for (const char* spacing_m : {"0.001", "0.01"}) {
      trials.push_back(some_trial());
      trials.back().factors_json =
          R"({"column": )" + std::to_string(column) + R"(, "spacing_m": )" + spacing_m + "}";
    }
  }
  made.add_session("anna", made.add_protocol("recognition", "recognition", kExportedProtocol),
                   trials);
  export_to(made, made.beside("out"));
  const Table fit = table_in(made.beside("out"), "fit.tsv");
  ASSERT_EQ(fit.rows.size(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(cell_of(fit, row, "factor"), Cell{"spacing_m"});
    EXPECT_EQ(cell_of(fit, row, "n"), Cell{"2"});
    EXPECT_EQ(cell_of(fit, row, "condition"), Cell{"anna: recognition 1, which, correct"});
  }
}

struct NothingToFit {
  const char* factors_json;
  SessionState state;
  const char* why;
};

class NoCounts : public testing::TestWithParam<NothingToFit> {};

TEST_P(NoCounts, HaveNoFileAndTheExportSaysWhy) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial trial = some_trial();
  trial.factors_json = GetParam().factors_json;
  made.set_state(GetParam().state);
  made.add_session("anna", made.add_protocol("recognition", "recognition"), {trial, trial});
  const ExportOutcome outcome = export_to(made, made.beside("out"));
  EXPECT_THAT(names_in(made.beside("out")), Not(Contains("fit.tsv")));
  ASSERT_EQ(outcome.not_written.size(), 1U);
  EXPECT_EQ(outcome.not_written[0].english(),
            std::string("fit.tsv was not written: ") + GetParam().why);
}

INSTANTIATE_TEST_SUITE_P(
    Reasons, NoCounts,
    testing::Values(NothingToFit{R"({"texture": "stone", "column": 1})", SessionState::completed,
                                 "no factor of the trials has numeric levels (those of the factor "
                                 "column are repetitions). Use the other tables, or vary a factor "
                                 "with numeric levels."},
                    NothingToFit{R"({"spacing_m": 0.01})", SessionState::completed,
                                 "no participant has choices at two levels of a numeric factor. "
                                 "Complete more trials, then export again."},
                    NothingToFit{R"({"spacing_m": 0.01})", SessionState::stopped,
                                 "no completed session has choices that count in analyses. "
                                 "Complete a session, then export again."}));

TEST(Export, StatesThatAStudyWithoutSessionsHasNoFilesForOtherPrograms) {
  MadeUpStudy made;
  const ExportOutcome outcome = export_to(made, made.beside("out"));
  ASSERT_EQ(outcome.not_written.size(), 1U);
  EXPECT_THAT(outcome.not_written[0].english(), HasSubstr("has no sessions"));
}

}  // namespace
}  // namespace asperity
