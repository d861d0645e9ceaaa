// Warnings about analyses that the trials of a valid protocol cannot support.

#include "protocols/warnings/analysis_warnings.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> warnings_of(const json& file) {
  const Protocol protocol = test::valid(file, test::models_of_library());
  std::vector<std::string> warnings{};
  for (const Diagnostic& warning : warnings_about_analysis(protocol, "file.json")) {
    warnings.push_back(warning.pointer + ": " + warning.message.english());
    EXPECT_EQ(test::untranslated(warning.message), "");
  }
  return warnings;
}

TEST(AnalysisWarnings, AreNoneAboutTheLibrary) {
  for (const LibraryProtocol& each : library_protocols()) {
    EXPECT_THAT(warnings_of(json::parse(each.text)), testing::IsEmpty()) << each.name;
  }
}

TEST(AnalysisWarnings, NameTestsThatADesignDoesNotHave) {
  json file = test::library_file("amplitude_same_different");
  file["analysis"]["family"] = {"conditions", "order"};
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/analysis/family/0: the test \"conditions\""),
                                HasSubstr("one condition"), HasSubstr("; remove it")),
                          HasSubstr("/analysis/family/1: the test \"order\" is not possible")));
  file = test::library_file("amplitude_jnd");
  file["analysis"]["family"] = {"order", "point_of_subjective_equality"};
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/analysis/family/1:"),
                                HasSubstr("requires the judgement \"comparison\""))));
}

TEST(AnalysisWarnings, AreAboutStaircasesThatGuessesAttain) {
  json file = test::library_file("amplitude_jnd");
  for (auto& [name, block] : file["blocks"].items()) {
    if (block.contains("procedure")) {
      block["procedure"]["down"] = 1;
      block["procedure"]["up"] = 1;
    }
  }
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/procedure/method: the levels converge on 50 %"),
                                HasSubstr("guesses are correct in 50 %"))));
}

TEST(AnalysisWarnings, AreAboutTooFewSurfacesForAConfiguration) {
  json file = test::library_file("map_of_renderings");
  for (auto& [name, block] : file["blocks"].items()) {
    if (!block.contains("all_pairs")) continue;
    json& levels = file["factors"][block["all_pairs"]["factor"].get<std::string>()]["levels"];
    while (levels.size() > 8) levels.erase(levels.size() - 1);
  }
  EXPECT_THAT(warnings_of(file), ElementsAre(AllOf(HasSubstr("requires at least 9 surfaces"),
                                                   HasSubstr("compares 8"))));
}

TEST(AnalysisWarnings, AreAboutRatingsOfASingleSurface) {
  json file = test::library_file("roughness_of_photographs");
  EXPECT_THAT(warnings_of(file), testing::IsEmpty());
  for (auto& [name, stimulus] : file["stimuli"].items()) stimulus["texture"] = "metal";
  EXPECT_THAT(warnings_of(file), ElementsAre(HasSubstr("every trial presents the same surface")));
}

TEST(AnalysisWarnings, AreAboutASingleSurfaceWhateverItsAnchorsPresent) {
  json file = test::library_file("roughness_of_photographs");
  json& block = file["blocks"]["ratings"];
  block.erase("crossed");
  block.erase("minimum_distance");
  block["listed"] = json::parse(R"([{"texture": "metal"}])");
  block["anchor"] = {{"texture", "wood"}};
  block["anchor_at"] = {"start", "end"};
  EXPECT_THAT(warnings_of(file),
              testing::Contains(HasSubstr("every trial presents the same surface")));
}

TEST(AnalysisWarnings, AreAboutAPredictorWithoutRecordings) {
  json file = test::library_file("roughness_diameter");
  const std::string items = file["estimation"]["spacing"];
  file["estimation"].erase("spacing");
  file["estimation"]["factor"] = items;
  file["estimation"]["predictor"] = "waves_1.25_to_2.5_mm";
  file["analysis"].erase("family");
  EXPECT_THAT(warnings_of(file), testing::IsEmpty());
  file["recording"]["every_tick"] = false;
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/recording/every_tick: the predictor "
                                          "\"waves_1.25_to_2.5_mm\" is computed from"),
                                HasSubstr("set this to true"))));
}

TEST(AnalysisWarnings, StateWhomALimitOfCatchErrorsExcludes) {
  json file = test::library_file("amplitude_jnd_psi");
  file["analysis"]["exclude"] = {{"catch_error_rate_above", 0.5}};
  // 5 catch trials: a guesser makes at most 2 errors in half of all sessions; 3 of 5 errors at 5 % have p = 0.00116.
  EXPECT_THAT(
      warnings_of(file),
      ElementsAre(AllOf(HasSubstr("/analysis/exclude: a session has at most 5 catch trials"),
                        HasSubstr("stays in the analysis with a probability of 50.0 %"),
                        HasSubstr("excluded with a probability of 0.1 %"))));
  // 1 − 0.95⁵ = 0.226.
  file["analysis"]["exclude"] = {{"more_catch_errors_than", 0}};
  EXPECT_THAT(warnings_of(file), ElementsAre(HasSubstr("with a probability of 22.6 %")));
  for (auto& [name, block] : file["blocks"].items()) {
    if (block.contains("procedure")) block["procedure"]["catch_trials"]["every"] = 5;
  }
  file["analysis"]["exclude"] = {{"more_catch_errors_than", 4}};
  EXPECT_THAT(warnings_of(file), testing::IsEmpty());
}

TEST(AnalysisWarnings, AreAboutAResponseThatVirtualParticipantsNeverGive) {
  json file = test::library_file("amplitude_jnd_psi");
  file["blocks"]["comparisons"]["question"]["allow_cannot_tell"] = true;
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/blocks/comparisons/question/allow_cannot_tell"),
                                HasSubstr("state \"unsure_within\" under \"observer\""))));
  file["observer"]["unsure_within"] = 0.1;
  EXPECT_THAT(warnings_of(file), testing::IsEmpty());
}

TEST(AnalysisWarnings, AreAboutAScaleThatMayRateConfidence) {
  json file = test::library_file("amplitude_same_different");
  json& block = file["blocks"]["comparisons"];
  const std::string judged = block["question"]["name"];
  block["questions"] = {block["question"],
                        {{"name", "sure"}, {"prompt", "How sure?"}, {"scale", {{"points", 4}}}}};
  block.erase("question");
  EXPECT_THAT(warnings_of(file),
              ElementsAre(AllOf(HasSubstr("/blocks/comparisons/questions/1: this scale"),
                                HasSubstr("add \"confidence_of\": \"" + judged + '"'))));
  block["questions"][1]["confidence_of"] = judged;
  EXPECT_THAT(warnings_of(file), testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
