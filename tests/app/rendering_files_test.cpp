// Renderings as files, and their values in protocols.

#include "app/study_files/rendering_files.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/rendering_use.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/library_protocols.h"
#include "protocols/keys/page_of.h"
#include "protocols/keys/schema_of.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/app/small_study.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Rendering strong_grain() {
  const ModelRegistry models = built_in_models();
  const ModelDeclaration& model = models.find("height_map")->declaration;
  return {.model = model.id,
          .version = model.version,
          .texture = {"stimuli/grain.png", std::string(64, '0')},
          .parameters = complete_values(model, {{"height_scale", 2.5}}),
          .material = {.stiffness_N_per_m = 700.0, .friction = 0.35}};
}

std::vector<Diagnostic> problems_of(const std::string& text) {
  try {
    rendering_in(text, "grain.rendering.json");
  } catch (const ProtocolError& error) {
    return error.diagnostics();
  }
  return {};
}

std::string library_text(std::string_view name) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == name) return std::string(each.text);
  }
  return {};
}

std::vector<Diagnostic> problems_of_protocol(const std::string& text) {
  return check_protocol_text(text, {}, built_in_models(), std::nullopt, std::nullopt).diagnostics;
}

TEST(Renderings, AreReadAsTheyWereWritten) {
  const Rendering rendering = strong_grain();
  const Rendering read = rendering_in(text_of(rendering), "grain.rendering.json");
  EXPECT_EQ(text_of(read), text_of(rendering));
  EXPECT_EQ(read.parameters, rendering.parameters);
  EXPECT_EQ(read.material.friction, 0.35);
  EXPECT_EQ(read.texture.height_field, "stimuli/grain.png");
}

TEST(Renderings, OfAnotherVersionAreRefusedWithTheRemedy) {
  const auto problems = problems_of(
      replaced(text_of(strong_grain()), "asperity.rendering/1", "asperity.rendering/2"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 2);
  EXPECT_THAT(problems[0].message.english(),
              HasSubstr("reads asperity.rendering/1, not asperity.rendering/2"));
  EXPECT_THAT(problems[0].message.english(),
              HasSubstr("use the version of Asperity that wrote the file"));
  for (const char* const other : {"[]", "{}", R"({"format": "asperity.protocol/1"})"}) {
    EXPECT_THAT(problems_of(other).at(0).message.english(), HasSubstr("this is not a rendering"))
        << other;
  }
}

TEST(Renderings, HaveProblemsWithPlacesAndSuggestions) {
  std::string text = replaced(text_of(strong_grain()), "\"friction\": 0.35", "\"fricton\": 0.35");
  text = replaced(text, "\"version\":", "\"x-version\":");
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(problems[0].message.english(), HasSubstr("version"));
  EXPECT_THAT(problems[1].message.english(), HasSubstr("did you mean \"friction\""));
  EXPECT_EQ(problems[1].pointer, "/material/fricton");
  EXPECT_GT(problems[1].line, 10);
}

TEST(Renderings, HaveATextureInsideTheStudy) {
  for (const char* const path : {"../grain.png", "/tmp/grain.png", "stimuli//grain.png"}) {
    const auto problems = problems_of(replaced(text_of(strong_grain()), "stimuli/grain.png", path));
    ASSERT_EQ(problems.size(), 1U) << path;
    EXPECT_EQ(problems[0].pointer, "/texture/height_field");
    EXPECT_THAT(problems[0].message.english(), HasSubstr("name a file inside the study"));
  }
}

TEST(Renderings, HaveTheKeysOfTheirPageAndASchema) {
  const std::string page =
      read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats/rendering.md");
  for (const KeyTable* const table :
       std::initializer_list<const KeyTable*>{&kRenderingTable, &kRenderingTextureTable}) {
    EXPECT_THAT(page, HasSubstr("| --- | --- | --- | --- |\n" + page_rows_of(*table) + '\n'));
  }
  EXPECT_TRUE(schema_of(kRenderingTable).at("properties").contains("parameters"));
}

TEST(Renderings, StateAChangedTextureAndAnotherVersionOfTheModel) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder.path() / "study";
  make_small_study(study);
  Rendering rendering = strong_grain();
  rendering.texture.sha256 = load_height_field(study / "stimuli" / "grain.png").sha256;
  const auto warnings = [&](const Rendering& of) {
    std::string all{};
    for (const Phrase& each : remarks_about(of, built_in_models(), study).warnings) {
      all += each.english() + '\n';
    }
    return all;
  };
  EXPECT_EQ(warnings(rendering), "");
  std::ofstream(study / "stimuli" / "grain.png", std::ios::app) << ' ';
  const RenderingRemarks unreadable = remarks_about(rendering, built_in_models(), study);
  ASSERT_EQ(unreadable.problems.size(), 1U) << "the sidecar is unchanged, the picture is not";
  EXPECT_THAT(unreadable.problems[0].english(), HasSubstr("the SHA-256 differs"));
  save_height_field(study / "stimuli" / "grain.png",
                    make_surface("noise", {}, {.width_m = 0.02, .pixels = 128, .seed = 6}),
                    {.kind = "noise"}, Overwrite::allow);
  EXPECT_THAT(warnings(rendering), HasSubstr("stimuli/grain.png has changed"));
  EXPECT_THAT(warnings(rendering), HasSubstr("Restore the file"));
  rendering.version = "0.0.1";
  EXPECT_THAT(warnings(rendering), HasSubstr("had version 0.0.1"));
  rendering.model = "height_mop";
  rendering.texture.height_field = "stimuli/gone.png";
  EXPECT_EQ(remarks_about(rendering, built_in_models(), study).problems.size(), 2U);
}

TEST(Renderings, ReplaceASurfaceAndLeaveTheRestOfTheText) {
  const std::string before = library_text("attributes_of_textures");
  ASSERT_THAT(usable_surfaces(before), testing::SizeIs(1));
  EXPECT_EQ(usable_surfaces(before)[0].name, "rendered");
  EXPECT_TRUE(usable_surfaces(before)[0].has_texture);
  EXPECT_FALSE(usable_surfaces(R"({"stimuli": {"flat": {"model": "height_map"}}})")[0].has_texture);
  EXPECT_EQ(usable_surfaces(before)[0].texture_factor, "texture");
  const std::string after = with_rendering(before, strong_grain(), "strong",
                                           {.replaced = "rendered", .keeps_texture = true});
  EXPECT_TRUE(problems_of_protocol(after).empty());
  EXPECT_THAT(renderings_in(after), ElementsAre("strong"));
  const std::string first = "  \"stimuli\": {\"rendered\"";
  EXPECT_EQ(after.substr(0, after.find(first)), before.substr(0, before.find(first)));
  EXPECT_EQ(after.substr(after.find("\"explorations\"")),
            before.substr(before.find("\"explorations\"")));
  std::vector<std::string> changes{};
  for (const ChangedValue& change : changed_values(before, after)) {
    changes.push_back(change.pointer + ": " + change.before + " > " + change.after);
  }
  EXPECT_THAT(changes, testing::Contains("/stimuli/rendered/material/friction:  > 0.35"));
  EXPECT_THAT(changes,
              testing::Contains("/stimuli/rendered/material/stiffness_N_per_m:  > 700 N/m"));
  EXPECT_THAT(changes, testing::Contains("/stimuli/rendered/x-rendering:  > strong"));
  EXPECT_THAT(changes,
              testing::Contains(HasSubstr("/stimuli/rendered/parameters/height_scale:  > 2.5")));
  EXPECT_THAT(changes, testing::Each(testing::StartsWith("/stimuli/rendered/")));
  EXPECT_EQ(with_rendering(after, strong_grain(), "strong",
                           {.replaced = "rendered", .keeps_texture = true}),
            after)
      << "once more";
}

TEST(Renderings, AreAddedAsASurfaceWithTheirTexture) {
  const std::string before = library_text("attributes_of_textures");
  const std::string after =
      with_rendering(before, strong_grain(), "Strong grain", {}, "stimuli/grain_photo.png");
  EXPECT_TRUE(problems_of_protocol(after).empty());
  const auto surfaces = usable_surfaces(after);
  ASSERT_EQ(surfaces.size(), 2U);
  EXPECT_EQ(surfaces[1].name, "strong_grain");
  std::string pointers{};
  for (const ChangedValue& change : changed_values(before, after))
    pointers += change.pointer + '\n';
  EXPECT_THAT(pointers, HasSubstr("/textures/grain/height_field"));
  EXPECT_THAT(pointers, HasSubstr("/textures/grain/picture"));
  const std::string again = with_rendering(after, strong_grain(), "Strong grain", {});
  EXPECT_EQ(usable_surfaces(again).size(), 3U);
  for (const ChangedValue& change : changed_values(after, again)) {
    EXPECT_THAT(change.pointer, testing::StartsWith("/stimuli/strong_grain_2/"));
  }
}

TEST(Renderings, NeedAPhotographWhereTheProtocolShowsPictures) {
  const std::string before = library_text("attributes_of_textures");
  const auto complaint = [](const std::string& text, const std::string& height_field,
                            const std::string& picture) {
    Rendering rendering = strong_grain();
    rendering.texture.height_field = height_field;
    const auto check = check_protocol_text(text, {}, built_in_models(), std::nullopt, std::nullopt);
    return complaint_about_picture(check.protocol.value(), rendering, picture)
        .value_or(Phrase())
        .english();
  };
  EXPECT_THAT(complaint(before, "stimuli/grain.png", ""),
              HasSubstr("Save the photograph as stimuli/grain_photo.png"));
  EXPECT_EQ(complaint(before, "stimuli/grain.png", "stimuli/grain_photo.png"), "");
  EXPECT_EQ(complaint(before, "stimuli/metal.png", ""), "") << "the protocol has its picture";
  EXPECT_EQ(complaint(library_text("semantic_differential"), "stimuli/grain.png", ""), "")
      << "no picture is shown";

  const std::string without = with_rendering(before, strong_grain(), "strong", {});
  EXPECT_THAT(without, testing::Not(HasSubstr("grain_photo.png")));
  EXPECT_THAT(with_rendering(without, strong_grain(), "strong", {}, "stimuli/grain_photo.png"),
              HasSubstr("grain_photo.png"))
      << "a texture without a picture gets that of the study";
}

TEST(Renderings, TakeTheEqualForceFromTheSurfaceThatTheyReplace) {
  const std::string before = library_text("realism_of_models");
  const std::string after =
      with_rendering(before, strong_grain(), "strong", {.replaced = "reference"});
  std::string changes{};
  for (const ChangedValue& change : changed_values(before, after)) {
    if (change.after.empty()) changes += change.pointer + '\n';
  }
  EXPECT_EQ(
      changes,
      "/stimuli/reference/equal_force/band_high_Hz\n/stimuli/reference/equal_force/band_low_Hz\n"
      "/stimuli/reference/equal_force/to_model\n");
}

TEST(Renderings, GiveAnInvalidProtocolWhereTheModelIsALevel) {
  const std::string after =
      with_rendering(small_protocol(), strong_grain(), "strong", {.replaced = "rendered"});
  EXPECT_FALSE(problems_of_protocol(after).empty()) << "the factor \"model\" has no use any more";
}

TEST(Renderings, AreNotWrittenOverAnother) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder.path() / "study";
  make_small_study(study);
  save_rendering(study, "strong", strong_grain());
  EXPECT_THROW(save_rendering(study, "strong", strong_grain()), std::runtime_error);
  EXPECT_THAT(rendering_files(study), ElementsAre(rendering_file(study, "strong")));
  EXPECT_EQ(rendering_name(rendering_file(study, "strong")), "strong");
  EXPECT_EQ(text_of(load_rendering(rendering_file(study, "strong"))), text_of(strong_grain()));
}

}  // namespace
}  // namespace asperity
