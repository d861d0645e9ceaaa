// Warnings about valid designs whose trials cannot show what they seem to.

#include "protocols/file/design_warnings.h"

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
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warned(const json& file) {
  const Protocol protocol = test::valid(file, test::models_of_library());
  std::vector<std::string> warnings{};
  for (const Diagnostic& warning : warnings_about_design(protocol, "file.json")) {
    warnings.push_back(warning.pointer + ": " + warning.message);
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

TEST(DesignWarnings, AreAboutPositionsThatAreNotBalancedWithinLevels) {
  json file = test::library_file("amplitude_jnd_psi");
  for (auto& [name, block] : file["blocks"].items()) {
    if (!block.contains("procedure")) continue;
    block.erase("procedure");
    block["vary"].erase("levels_percent");
    block["vary"]["levels_percent"] = {10, 25, 50, 90};
    block["repetitions"] = 6;
    block["positions"] = "balanced";
  }
  EXPECT_THAT(warned(file),
              ElementsAre(HasSubstr("/positions: positions are balanced over the block and not "
                                    "within each level")));
  for (auto& [name, block] : file["blocks"].items()) {
    if (block.value("phase", "main") == "main") block["vary"]["levels_percent"] = {25};
  }
  EXPECT_THAT(warned(file), IsEmpty());
}

}  // namespace
}  // namespace asperity
