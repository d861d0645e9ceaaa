// Textures that nothing uses and trials that are listed twice are named.

#include "protocols/warnings/texture_use_warnings.h"

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
  for (const Diagnostic& warning : warnings_about_texture_use(protocol, "file.json")) {
    warnings.push_back(warning.pointer + ": " + warning.message.english());
  }
  return warnings;
}

TEST(TextureUseWarnings, AreNoneAboutTheLibrary) {
  for (const LibraryProtocol& each : library_protocols()) {
    EXPECT_THAT(warned(json::parse(each.text)), IsEmpty()) << each.name;
  }
}

TEST(TextureUseWarnings, NameATextureThatNothingUses) {
  json file = test::library_file("semantic_differential");
  json& textures = file["textures"];
  textures["spare"] = textures.begin().value();
  if (textures["spare"].contains("code")) textures["spare"]["code"] = "spare";
  EXPECT_THAT(warned(file),
              ElementsAre("/textures/spare: no stimulus, level, question or body uses the texture "
                          "\"spare\"; use it, or remove it"));
}

// As after a level that became another texture.
TEST(TextureUseWarnings, NameATrialThatIsListedTwice) {
  json file = test::library_file("roughness_diameter");
  json& practice = file["blocks"]["practice"];
  practice["listed"][2]["texture"] = practice["listed"][0]["texture"];
  EXPECT_THAT(warned(file),
              ElementsAre("/blocks/practice/listed/2: the listed trials 1 and 3 have the same "
                          "levels, so that this trial is presented twice; change a level, or "
                          "remove one of them and state the number of its repetitions"));
  practice["order"] = "shuffle";
  practice["repetitions_of"] = {{{"levels", practice["listed"][0]}, {"repetitions", 2}}};
  EXPECT_THAT(warned(file), IsEmpty());
  practice.erase("repetitions_of");
  practice["order"] = "fixed";
  EXPECT_THAT(warned(file), IsEmpty());
}

}  // namespace
}  // namespace asperity
