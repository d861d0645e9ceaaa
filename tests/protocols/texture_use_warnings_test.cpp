// Textures that nothing uses are named.

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

// Each of them is used once, until it is not.
TEST(TextureUseWarnings, AreNotAboutATextureOfABody) {
  json file = test::library_file("tools_matching");
  EXPECT_THAT(warned(file), IsEmpty());
  file["bodies"]["studded_plate"]["texture"] = "fine";
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr("uses the texture \"studs\"")));
}

TEST(TextureUseWarnings, AreNotAboutATextureAmongThePicturesOfAQuestion) {
  json file = test::library_file("chapter_recognition");
  EXPECT_THAT(warned(file), IsEmpty());
  file["blocks"]["main"]["question"]["pictures"] = {"metal", "stone", "wood", "brick", "pebbles"};
  EXPECT_THAT(warned(file), ElementsAre(HasSubstr("uses the texture \"sandpaper\"")));
}

TEST(TextureUseWarnings, AreNotAboutATextureWhoseSpacingIsAnalysed) {
  json file = test::library_file("roughness_diameter");
  file["stimuli"]["cones"]["texture"] = "spacing_14";
  EXPECT_THAT(warned(file), IsEmpty());
}

}  // namespace
}  // namespace asperity
