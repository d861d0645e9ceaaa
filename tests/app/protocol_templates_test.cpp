// Protocols of the library in a study, with its own textures and with those of the demonstration.

#include "app/tasks/protocol_templates.h"

#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/template_overviews.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/form/form_edits.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;

std::string without_authors(const std::string& text) {
  return without(JsonDocument(text, ""), std::array<std::string, 2>{"/authors", "/license"}).text;
}

class ProtocolFromTemplate : public testing::Test {
 protected:
  ProtocolFromTemplate() { make_small_study(study_); }

  /// A relief of the study, with a photograph. `made_from`: the file name of the photograph before it was saved.
  void add_relief(const std::string& name, const std::string& made_from = {}) const {
    constexpr std::size_t kPixels = 128;
    const SurfaceCanvas canvas{0.02, kPixels, 3};
    const HeightField field = make_surface("noise", {}, canvas);
    HeightFieldProvenance made{};
    made.kind = made_from.empty() ? "noise" : "photograph";
    made.source_name = made_from;
    made.source_sha256 = sha256_of(made_from);
    save_height_field(study_ / "stimuli" / (name + ".png"), field, made, Overwrite::refuse);
    write_file(study_ / "stimuli" / (name + "_photo.png"),
               read_file(study_ / "stimuli" / (name + ".png")), Overwrite::refuse);
  }
  static std::vector<OwnTexture> named(const std::vector<OwnTexture>& all,
                                       std::initializer_list<std::string_view> names) {
    std::vector<OwnTexture> chosen{};
    for (const std::string_view name : names) {
      for (const OwnTexture& one : all) {
        if (one.name == name) chosen.push_back(one);
      }
    }
    return chosen;
  }
  static TemplateChoice with(const std::vector<OwnTexture>& own, const std::string& name,
                             const std::string& language = {}) {
    return {.name = name,
            .language = language,
            .textures = {.from = TemplateTextures::From::study, .own = own}};
  }
  /// The problems that `asperity check` finds in the file in the study.
  std::string problems_of(const std::filesystem::path& file) const {
    std::string problems{};
    for (const Diagnostic& problem :
         check_protocol(file, models_, study_, std::nullopt).diagnostics) {
      problems += problem.pointer + ": " + problem.message.english() + "\n";
    }
    return problems;
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_.path() / "study";
  ModelRegistry models_ = built_in_models();
};

TEST_F(ProtocolFromTemplate, GetsANameOfItsOwnWhereTheStudyHasOneOfThatName) {
  const auto first = protocol_from_template(study_, {.name = "chapter_matching"});
  // Of a protocol that is not in the study any more: it would be one of the new protocol.
  write_file(study_ / "protocols" / "chapter_matching_2.fr.json", "{}", Overwrite::refuse);
  const auto second = protocol_from_template(study_, {.name = "chapter_matching"});
  EXPECT_EQ(first.filename(), "chapter_matching.json");
  EXPECT_EQ(second.filename(), "chapter_matching_3.json");
  EXPECT_EQ(load_protocol(first, models_, std::nullopt).name, "chapter_matching");
  EXPECT_EQ(load_protocol(second, models_, std::nullopt).name, "chapter_matching_3");
  EXPECT_THROW(protocol_from_template(study_, {.name = "nothing"}), std::invalid_argument);
}

TEST_F(ProtocolFromTemplate, HasItsTextsInTheChosenLanguage) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    const std::string source = without_authors(std::string(protocol.text));
    for (const char* const language : {"en", "de"}) {
      const auto file = protocol_from_template(
          study_, {.name = std::string(protocol.name), .language = language});
      const std::string text = read_file(file);
      const ProtocolCheck check = check_protocol(file, models_, std::nullopt, std::nullopt);
      ASSERT_TRUE(check.is_valid()) << file;
      EXPECT_TRUE(check.warnings.empty()) << file << check.warnings.front().message.english();
      EXPECT_EQ(check.protocol->language, language);
      EXPECT_EQ(languages_of_protocol(file).size(), 1U) << "no translation next to it";
      EXPECT_EQ(check.protocol->title == read_protocol(source, "", declarations_of(models_)).title,
                std::string_view(language) == "en");
      EXPECT_TRUE(check.protocol->authors.empty()) << "those of the library did not make it";
      EXPECT_TRUE(check.protocol->license.empty());
      // Everything else is that of the library, on the same lines.
      EXPECT_EQ(without_texts(with_protocol_name(text, "any")),
                without_texts(with_protocol_name(source, "any")));
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
                std::count(source.begin(), source.end(), '\n'));
    }
  }
  const std::string german = text_from_template({.name = "chapter_matching", .language = "de"});
  EXPECT_THAT(german,
              testing::HasSubstr(R"("options": [{"value": "female", "text": "weiblich"},)"));
  EXPECT_EQ(text_from_template({.name = "chapter_matching", .language = "fr"}),
            text_from_template({.name = "chapter_matching"}));
}

TEST_F(ProtocolFromTemplate, HasAnotherTitle) {
  const std::string before = text_from_template({.name = "chapter_matching"});
  nlohmann::json expected = nlohmann::json::parse(before);
  EXPECT_EQ(text_from_template({.name = "chapter_matching", .title = expected["title"]}), before);
  expected["title"] = "Which \"stone\"?";
  EXPECT_EQ(nlohmann::json::parse(
                text_from_template({.name = "chapter_matching", .title = "Which \"stone\"?"})),
            expected);
}

TEST_F(ProtocolFromTemplate, ComparesTheTexturesOfTheStudy) {
  for (const char* const name : {"brick", "grass", "gravel"}) add_relief(name);
  const std::vector<OwnTexture> own = named(reliefs_of_study(study_), {"grass", "brick", "gravel"});
  ASSERT_EQ(own.size(), 3U);
  EXPECT_EQ(own[0].picture, "stimuli/grass_photo.png");
  const auto file = protocol_from_template(study_, with(own, "semantic_differential"));
  EXPECT_EQ(problems_of(file), "");
  const nlohmann::json protocol = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(protocol["factors"]["texture"]["levels"], nlohmann::json({"grass", "brick", "gravel"}));
  EXPECT_EQ(protocol["textures"]["brick"], nlohmann::json::parse(R"({
    "code": "T2", "height_field": "stimuli/brick.png", "picture": "stimuli/brick_photo.png",
    "true_height_field": "stimuli/brick.png"})"));
  EXPECT_FALSE(protocol.contains("description")) << "of the textures of the template";
  EXPECT_FALSE(protocol["factors"]["texture"].contains("meaning"));
  // Trials that present textures of the template are gone.
  EXPECT_EQ(protocol["blocks"]["range"]["listed"].size(), 1U);
}

/// Of a photograph gravel.png two reliefs were saved: under the proposed name, and as stones.png.
TEST_F(ProtocolFromTemplate, ShowsNoReliefAsAPhotograph) {
  add_relief("gravel", "gravel.png");
  add_relief("stones", "gravel.png");
  std::vector<std::string> pictures{};
  for (const OwnTexture& own : named(reliefs_of_study(study_), {"gravel", "stones"})) {
    pictures.push_back(own.picture);
  }
  EXPECT_EQ(pictures,
            (std::vector<std::string>{"stimuli/gravel_photo.png", "stimuli/stones_photo.png"}));
  // The photograph itself is in the study.
  write_file(study_ / "stimuli" / "pebbles.jpg", "pebbles.jpg", Overwrite::refuse);
  add_relief("pebbles", "pebbles.jpg");
  EXPECT_EQ(named(reliefs_of_study(study_), {"pebbles"}).at(0).picture, "stimuli/pebbles.jpg");
}

TEST_F(ProtocolFromTemplate, HasAsManyTexturesAsTheStudy) {
  for (const char* const name : {"a", "b", "c", "d", "e", "f"}) add_relief(name);
  const std::vector<OwnTexture> own =
      named(reliefs_of_study(study_), {"a", "b", "c", "d", "e", "f"});
  for (const char* const name : {"photo_recognition", "attributes_of_textures"}) {
    for (const char* const language : {"en", "de"}) {
      const auto file = protocol_from_template(study_, with(own, name, language));
      EXPECT_EQ(problems_of(file), "") << name;
      EXPECT_EQ(nlohmann::json::parse(read_file(file))["textures"].size(), 6U);
    }
  }
}

TEST_F(ProtocolFromTemplate, HasAnAnchorAmongFewerTextures) {
  for (const char* const name : {"a", "b", "c"}) add_relief(name);
  const auto file = protocol_from_template(
      study_, with(named(reliefs_of_study(study_), {"a", "b", "c"}), "roughness_force"));
  const nlohmann::json protocol = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(protocol["blocks"]["main"]["anchor"]["texture"], "b")
      << "the template's is the fourth texture, in the middle";
}

TEST_F(ProtocolFromTemplate, EstimatesTexturesThatHaveNoSpacing) {
  for (int i = 0; i < 8; ++i) add_relief("own_" + std::to_string(i));
  const std::vector<OwnTexture> all =
      named(reliefs_of_study(study_),
            {"own_0", "own_1", "own_2", "own_3", "own_4", "own_5", "own_6", "own_7"});
  ASSERT_EQ(all.size(), 8U);
  for (const char* const name : {"roughness_diameter", "roughness_force", "roughness_speed"}) {
    for (const std::size_t count : {2U, 3U, 7U, 8U}) {
      const std::vector<OwnTexture> own(all.begin(), all.begin() + static_cast<int>(count));
      const auto file = protocol_from_template(study_, with(own, name));
      EXPECT_EQ(problems_of(file), "") << name << " " << count;
      const nlohmann::json protocol = nlohmann::json::parse(read_file(file));
      EXPECT_EQ(protocol["estimation"]["factor"], "texture");
      EXPECT_FALSE(protocol["estimation"].contains("spacing"));
      EXPECT_EQ(protocol["analysis"]["family"],
                nlohmann::json({"stimuli", "stimuli_by_condition"}));
    }
  }
}

TEST_F(ProtocolFromTemplate, EstimatesComputedSurfacesBySpacing) {
  for (const double spacing_m : {0.002, 0.003, 0.004}) {
    const std::string name = "ridges_" + std::to_string(static_cast<int>(spacing_m * 1e3));
    const ParameterValues values{{"spacing_m", spacing_m}};
    save_height_field(study_ / "stimuli" / (name + ".png"),
                      make_surface("grating", values, {0.024, 128, 3}),
                      {.kind = "grating", .parameters = values}, Overwrite::refuse);
  }
  add_relief("plain");
  const std::vector<OwnTexture> all =
      named(reliefs_of_study(study_), {"ridges_2", "ridges_3", "ridges_4", "plain"});
  ASSERT_EQ(all.size(), 4U);
  const auto made = [&](std::vector<OwnTexture> own) {
    const auto file = protocol_from_template(study_, with(own, "roughness_force"));
    EXPECT_EQ(problems_of(file), "");
    return nlohmann::json::parse(read_file(file));
  };
  const nlohmann::json protocol = made({all[2], all[0], all[1]});
  EXPECT_EQ(protocol["estimation"]["spacing"], "texture");
  EXPECT_EQ(protocol["textures"]["ridges_4"]["spacing_m"], 0.004);
  EXPECT_EQ(protocol["textures"]["ridges_2"]["spacing_m"], 0.002);
  // Two spacings are no curve, and one of the textures has none.
  EXPECT_EQ(made({all[0], all[1]})["estimation"]["factor"], "texture");
  EXPECT_EQ(made(all)["estimation"]["factor"], "texture");
}

TEST_F(ProtocolFromTemplate, IsCheckedBeforeItIsWritten) {
  using From = TemplateTextures::From;
  for (const char* const name : {"a", "b", "c"}) add_relief(name);
  const std::vector<OwnTexture> own = named(reliefs_of_study(study_), {"a", "b", "c"});
  const auto check = [&](const TemplateChoice& choice) {
    return check_of_template(study_, choice, models_).check;
  };
  EXPECT_TRUE(check(with(own, "map_of_textures")).is_valid());
  const TemplateChoice one_picture = with({own.front()}, "photo_matching");
  const ProtocolCheck matching = check(one_picture);
  ASSERT_FALSE(matching.diagnostics.empty());
  // The files of the template's textures are not in the study yet.
  EXPECT_TRUE(
      check({.name = "map_of_renderings", .textures = {.from = From::demonstration}}).is_valid());
  EXPECT_FALSE(std::filesystem::exists(study_ / "protocols" / "map_of_renderings.json"));
  // What is written has the problems of the check.
  const auto file = protocol_from_template(study_, one_picture);
  const ProtocolCheck written = check_protocol(file, models_, study_, std::nullopt);
  ASSERT_EQ(written.diagnostics.size(), matching.diagnostics.size());
  EXPECT_EQ(written.diagnostics.front().message.english(),
            matching.diagnostics.front().message.english());
}

TEST_F(ProtocolFromTemplate, ComparesNoModelThatNeedsOtherFilesThanReliefs) {
  add_relief("bark");
  for (const char* const name : {"map_of_renderings", "models_in_pairs", "realism_of_models"}) {
    const auto file =
        protocol_from_template(study_, with(named(reliefs_of_study(study_), {"bark"}), name));
    EXPECT_EQ(problems_of(file), "") << name;
    EXPECT_THAT(read_file(file), testing::Not(testing::HasSubstr("recorded"))) << name;
  }
}

// Also without a warning, except where three textures are too few for the analysis.
TEST_F(ProtocolFromTemplate, IsValidWithThreeTexturesOfTheStudy) {
  for (const char* const name : {"a", "b", "c"}) add_relief(name);
  const std::vector<OwnTexture> own = named(reliefs_of_study(study_), {"a", "b", "c"});
  for (const LibraryProtocol& each : library_protocols()) {
    if (textures_of(each).names.empty()) continue;
    const std::string name(each.name);
    const ProtocolCheck check = check_of_template(study_, with(own, name), models_).check;
    EXPECT_TRUE(check.is_valid()) << name << ": " << text_of(check.diagnostics.front());
    std::vector<std::string> warnings{};
    for (const Diagnostic& warning : check.warnings) {
      // The textures of a template that has one for all of its force models.
      if (!warning.pointer.starts_with("/textures/")) warnings.push_back(text_of(warning));
    }
    if (name == "map_of_textures") {
      EXPECT_THAT(warnings, ElementsAre(testing::HasSubstr("requires at least 9 surfaces")));
    } else {
      EXPECT_THAT(warnings, testing::IsEmpty()) << name;
    }
  }
}

TEST_F(ProtocolFromTemplate, KeepsTheRestBetweenTheRunsOfABlock) {
  for (const char* const name : {"a", "b", "c"}) add_relief(name);
  const std::vector<OwnTexture> own = named(reliefs_of_study(study_), {"a", "b", "c"});
  for (const char* const name : {"roughness_diameter", "roughness_force", "roughness_speed"}) {
    int runs = 0;
    const auto made = nlohmann::json::parse(text_from_template(with(own, name)));
    for (const nlohmann::json& step : made["flow"]) {
      if (!step.contains("for_each")) continue;
      ++runs;
      EXPECT_FALSE(step.contains("break_every_trials")) << name;
      EXPECT_EQ(step.value("/pause/minimum_s"_json_pointer, 0), 120) << name;
    }
    EXPECT_EQ(runs, 1) << name;
  }
}

TEST_F(ProtocolFromTemplate, HasNoOrderThatFewTexturesCannotHave) {
  for (const char* const name : {"a", "b", "c"}) add_relief(name);
  const std::vector<OwnTexture> all = named(reliefs_of_study(study_), {"a", "b", "c"});
  const std::vector<OwnTexture> own{all[0], all[1]};
  const auto block = [](const TemplateChoice& choice, const char* name) {
    return nlohmann::json::parse(text_from_template(choice))["blocks"][name];
  };
  EXPECT_EQ(block(with(all, "semantic_differential"), "ratings")["minimum_distance"]["texture"], 2)
      << "at a distance of 3 the same order would be repeated";
  EXPECT_FALSE(block(with(own, "semantic_differential"), "ratings").contains("minimum_distance"));
  EXPECT_FALSE(block(with({own[0]}, "improved_selection"), "main").contains("maximum_in_a_row"));
  EXPECT_EQ(block(with(own, "improved_recognition"), "practice")["repetitions"], 18)
      << "as many trials for the criterion as six textures have";
}

TEST_F(ProtocolFromTemplate, WritesTheTexturesOfTheDemonstration) {
  using From = TemplateTextures::From;
  add_relief("file_fine");  // another texture of this name
  const std::string own = read_file(study_ / "stimuli" / "file_fine.png");
  const TemplateChoice tools{.name = "tools_matching", .textures = {.from = From::demonstration}};
  const auto file = protocol_from_template(study_, tools);
  EXPECT_EQ(problems_of(file), "");
  EXPECT_EQ(read_file(study_ / "stimuli" / "file_fine.png"), own);
  const nlohmann::json protocol = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(protocol["textures"]["fine"]["height_field"], "stimuli/file_fine_2.png");
  EXPECT_EQ(protocol["textures"]["medium"]["height_field"], "stimuli/file_medium.png");
  // The same files are used again.
  protocol_from_template(study_, tools);
  EXPECT_FALSE(std::filesystem::exists(study_ / "stimuli" / "file_medium_2.png"));
  EXPECT_FALSE(std::filesystem::exists(study_ / "stimuli" / "file_fine_3.png"));
}

TEST(TemplateOverviews, HaveTitlesInTheLanguageOfTheReader) {
  const ModelRegistry models = built_in_models();
  const auto english = template_overviews(models, "en", {});
  const auto german = template_overviews(models, "de", {});
  ASSERT_EQ(english.size(), library_protocols().size());
  ASSERT_EQ(german.size(), english.size());
  for (std::size_t i = 0; i < english.size(); ++i) {
    ASSERT_EQ(english[i].protocols.size(), 2U);
    EXPECT_EQ(english[i].protocols.front().language, "en");
    EXPECT_EQ(german[i].protocols.front().language, "de");
    EXPECT_EQ(english[i].protocols.back().title, german[i].protocols.front().title);
    EXPECT_GT(english[i].cost.trials, 0);
  }
  EXPECT_TRUE(english.front().textures.names.empty());  // amplitude_jnd
}

}  // namespace
}  // namespace asperity
