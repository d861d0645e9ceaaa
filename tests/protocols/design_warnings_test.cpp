// Warnings about valid designs whose trials cannot show what they seem to.

#include "protocols/warnings/design_warnings.h"

#include <stdexcept>
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
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> warned(const json& file) {
  const Protocol protocol = test::valid(file, test::models_of_library());
  std::vector<std::string> warnings{};
  for (const Diagnostic& warning : warnings_about_design(protocol, "file.json")) {
    warnings.push_back(warning.pointer + ": " + warning.message.english());
    EXPECT_EQ(test::untranslated(warning.message), "");
  }
  return warnings;
}

TEST(DesignWarnings, AreNoneAboutTheLibrary) {
  for (const LibraryProtocol& each : library_protocols()) {
    EXPECT_THAT(warned(json::parse(each.text)), IsEmpty()) << each.name;
  }
}

TEST(DesignWarnings, NameACrossedFactorThatNothingUses) {
  json file = test::library_file("semantic_differential");
  file["factors"]["speed"] = {{"levels", {0.06, 0.12}}};
  file["description"] = "The speed of the hand is not prescribed.";
  for (auto& [name, block] : file["blocks"].items()) {
    if (block.value("phase", "main") == "main") block["crossed"].push_back("speed");
  }
  EXPECT_THAT(warned(file),
              ElementsAre(HasSubstr("/crossed/1: no stimulus, exploration or question uses the "
                                    "factor \"speed\"")));
}

TEST(DesignWarnings, AreAboutAScaleOfOneNameWithTwoWordings) {
  json file = test::library_file("semantic_differential");
  json& range = file["blocks"]["range"]["questions"];
  json& ratings = file["blocks"]["ratings"]["questions"];
  ratings[2]["name"] = range[2]["name"] = "pleasant";
  EXPECT_THAT(warned(file), IsEmpty());
  ratings[2]["prompt"] = "How pleasant did it feel?";
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr(
                                "/blocks/ratings/questions/2/prompt: the scale \"pleasant\" has "
                                "another question in block \"ratings\" than in block "
                                "\"range\"")));
  range[2]["prompt"] = ratings[2]["prompt"];
  ratings[2]["scale"]["labels"] = {"unpleasant", "pleasant"};
  EXPECT_THAT(warned(file), ElementsAre(AllOf(HasSubstr("/blocks/ratings/questions/2/scale: "),
                                              HasSubstr("has other labels"))));
  ratings[2]["name"] = "pleasure";
  EXPECT_THAT(warned(file), IsEmpty());
}

TEST(DesignWarnings, AreAboutAPriorOutsideTheLevels) {
  json file = test::library_file("amplitude_jnd_psi");
  for (auto& [name, block] : file["blocks"].items()) {
    if (!block.contains("procedure")) continue;
    block["procedure"]["prior"]["threshold"] = {{"lowest", 0.001}, {"highest", 1}, {"count", 41}};
  }
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr("/procedure/prior/threshold: all thresholds of "
                                                  "the prior are below the smallest difference")));
}

TEST(DesignWarnings, AreAboutPartsThatNeedNotConnectAllLevels) {
  json file = test::library_file("map_of_renderings");
  for (const auto& [parts, expected] : {std::pair{4, 0U}, {5, 1U}, {9, 1U}}) {
    for (auto& [name, block] : file["blocks"].items()) {
      if (block.contains("all_pairs")) block["all_pairs"]["parts"] = parts;
    }
    EXPECT_EQ(warned(file).size(), expected) << parts;
  }
  EXPECT_THAT(warned(file).front(), HasSubstr("/all_pairs/parts: with 9 parts, the pairs of a "
                                              "participant need not connect all 10 levels"));
}

TEST(DesignWarnings, AreAboutEqualListedTrialsOncePerGroup) {
  json file = test::library_file("roughness_diameter");
  json& practice = file["blocks"]["practice"];
  practice["listed"][2] = practice["listed"][0];
  const auto about = [](const std::string& trials) {
    return "/blocks/practice/listed/2: the listed trials " + trials +
           " have the same levels, so that this trial is presented more often than the others; "
           "change a level, or remove all but one of them and state the number of its repetitions";
  };
  EXPECT_THAT(warned(file), ElementsAre(about("1 and 3")));
  practice["listed"].push_back(practice["listed"][0]);
  EXPECT_THAT(warned(file), ElementsAre(about("1, 3 and 4")));
  practice["order"] = "shuffle";
  practice["repetitions_of"] = {{{"levels", practice["listed"][0]}, {"repetitions", 2}}};
  EXPECT_THAT(warned(file), IsEmpty());
  practice.erase("repetitions_of");
  practice["order"] = "fixed";
  EXPECT_THAT(warned(file), IsEmpty());
}

/// amplitude_jnd_psi with constant stimuli.
json constant_stimuli(int repetitions) {
  json file = test::library_file("amplitude_jnd_psi");
  for (auto& [name, block] : file["blocks"].items()) {
    if (!block.contains("procedure")) continue;
    block.erase("procedure");
    block["vary"].erase("levels_percent");
    block["vary"]["levels_percent"] = {10, 25, 50, 90};
    block["repetitions"] = repetitions;
    block["positions"] = "balanced";
  }
  return file;
}

json& main_block_of(json& file) {
  for (auto& [name, block] : file["blocks"].items()) {
    if (block.value("phase", "main") == "main") return block;
  }
  throw std::logic_error("no main block");
}

TEST(DesignWarnings, AreAboutLevelsWithAnOddNumberOfTrialsInTwoPositions) {
  EXPECT_THAT(warned(constant_stimuli(6)), IsEmpty());
  json file = constant_stimuli(7);
  EXPECT_THAT(warned(file), ElementsAre(AllOf(HasSubstr("/positions: positions need not be "
                                                        "balanced within each level"),
                                              HasSubstr("set the repetitions so that each "
                                                        "combination of levels has a multiple of "
                                                        "2 trials"))));
  main_block_of(file)["vary"]["levels_percent"] = {25};
  main_block_of(file)["repetitions"] = 8;
  main_block_of(file)["positions"] = "shuffle";
  EXPECT_THAT(warned(file), IsEmpty()) << "one level";
}

TEST(DesignWarnings, AreAboutPositionsOfABlockThatCanEndAfterAnyTrial) {
  json file = constant_stimuli(6);
  main_block_of(file)["until"] = {{"correct", 5}, {"of_last", 6}, {"maximum_trials", 24}};
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr("remove \"until\"")));
  main_block_of(file)["positions"] = "shuffle";
  EXPECT_THAT(warned(file), ElementsAre(AllOf(HasSubstr("remove \"until\""),
                                              HasSubstr("set \"positions\" to \"balanced\""))));
}

TEST(DesignWarnings, AreAboutPositionsThatAProcedureDealsOverAllLevels) {
  json file = constant_stimuli(6);
  json& block = main_block_of(file);
  block.erase("repetitions");
  block["procedure"] = {{"method", "constant_stimuli"}, {"repetitions", 8}};
  EXPECT_THAT(warned(file), ElementsAre(AllOf(HasSubstr("in place of \"procedure\""),
                                              Not(HasSubstr("set the repetitions")))));
}

TEST(DesignWarnings, AreAboutPositionsThatAreDrawnForEachTrial) {
  json file = constant_stimuli(6);
  main_block_of(file)["positions"] = "shuffle";
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr("set \"positions\" to \"balanced\"")));
}

}  // namespace
}  // namespace asperity
