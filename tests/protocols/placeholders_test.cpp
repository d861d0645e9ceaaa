// Placeholders in texts: how they are read, what a protocol with them contains, and which ones are refused.

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/plan/course.h"
#include "protocols/texts/protocol_texts.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using nlohmann::json;
using namespace nlohmann::literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const DesignValues kValues{{"scales", {.number = 8}},
                           {"surfaces", {.number = 1}},
                           {"trials", {.number = 96, .is_largest = true}},
                           {"surface_names", {.names = {"A", "B", "C"}}}};

TEST(Placeholders, AreReplacedByWordsToTwelveAndDigitsBeyond) {
  EXPECT_EQ(with_values("each of {scales} scales", kValues, "en"), "each of eight scales");
  EXPECT_EQ(with_values("{scales} Skalen. {scales} sind es.", kValues, "de"),
            "Acht Skalen. Acht sind es.");
  EXPECT_EQ(with_values("{scales}", kValues, "fr"), "8");
  EXPECT_EQ(with_values("so {scales}", {{"scales", {.number = 13}}}, "en"), "so 13");
}

TEST(Placeholders, TakeTheFormForOneOrForSeveral) {
  EXPECT_EQ(with_values("{surfaces} {surfaces|surface|surfaces}", kValues, "en"), "1 surface");
  EXPECT_EQ(with_values("{scales|Skala|Skalen}", kValues, "de"), "Skalen");
}

TEST(Placeholders, SayAtMostWhereARuleCanEndATrack) {
  EXPECT_EQ(with_values("you make {trials} choices", kValues, "en"), "you make at most 96 choices");
  EXPECT_EQ(with_values("{trials} Durchgänge", kValues, "de-AT"), "Höchstens 96 Durchgänge");
}

TEST(Placeholders, ListNames) {
  EXPECT_EQ(with_values("surfaces {surface_names}", kValues, "en"), "surfaces A, B and C");
  EXPECT_EQ(with_values("{surface_names}", kValues, "de"), "A, B und C");
}

TEST(Placeholders, LeaveBracesThatAreDoubled) {
  EXPECT_EQ(with_values("{{scales} and {scales", kValues, "en"), "{scales} and {scales");
  EXPECT_THAT(placeholders_in("{{scales}"), IsEmpty());
}

std::string library_text(const std::string& name) {
  const auto all = library_protocols();
  return std::string(std::find_if(all.begin(), all.end(), [&name](const auto& each) {
                       return each.name == name;
                     })->text);
}

const std::vector<ModelDeclaration>& models() {
  static const std::vector<ModelDeclaration> kModels = declarations_of(built_in_models());
  return kModels;
}

/// The third screen, which instructs the participant.
json& instruction_of(json& root) {
  int screens = 0;
  for (json& step : root.at("flow")) {
    if (step.contains("screen") && ++screens == 3) return step.at("screen");
  }
  throw std::out_of_range("no third screen");
}

std::vector<std::string> problems_with(json root, const std::string& text) {
  instruction_of(root) = text;
  std::vector<std::string> messages{};
  for (const Diagnostic& each :
       read_protocol_with_problems(root.dump(), "test.json", models()).problems) {
    messages.push_back(each.message.english());
    EXPECT_EQ(test::untranslated(each.message), "");
  }
  return messages;
}

TEST(Placeholders, AreKeptInScreensUntilTheSession) {
  json root = json::parse(library_text("amplitude_jnd"));
  instruction_of(root) =
      "{surfaces} surfaces, {trials} trials, {practice_trials} before, {minutes} min";
  root["/blocks/comparisons/procedure/stop/reversals"_json_pointer] = 8;
  const Protocol protocol = read_protocol(root.dump(), "test.json", models());
  const Plan plan = example_plan(protocol, {1, 0});
  const DesignValues values = values_of_session(protocol, plan);
  const auto main = std::count_if(plan.trials.begin(), plan.trials.end(),
                                  [](const Trial& each) { return each.phase == Phase::main; });
  EXPECT_TRUE(values.at("trials").is_largest) << "a staircase can end early";
  EXPECT_GT(values.at("trials").number, main);
  EXPECT_EQ(values.at("trials").number, 85) << "two tracks of 40 trials, at most 5 catch trials";
  EXPECT_EQ(values.at("practice_trials").number,
            static_cast<int>(plan.trials.size()) - static_cast<int>(main));
  const std::vector<TextAsRead> read =
      texts_as_read(protocol, texts_with_placeholders(protocol), values);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_THAT(read.front().text, testing::StartsWith("Two surfaces, at most "));
  EXPECT_THAT(read.front().text, Not(HasSubstr("{")));
  const auto step = std::find_if(plan.steps.begin(), plan.steps.end(), [](const PlanStep& each) {
    const auto* const screen = std::get_if<Protocol::Screen>(&each);
    return screen != nullptr && screen->text.starts_with('{');
  });
  ASSERT_NE(step, plan.steps.end());
  const Plan shown = as_read(protocol, plan);
  EXPECT_EQ(
      std::get<Protocol::Screen>(shown.steps[static_cast<std::size_t>(step - plan.steps.begin())])
          .text,
      read.front().text);
}

/// It is read before the row and the group of a participant are known.
TEST(Placeholders, OfTheConsentHoldForEveryParticipant) {
  json root = json::parse(library_text("roughness_diameter"));
  root.at("consent").at("statement") = "{trials} trials, {minutes} minutes, {{so}.";
  const Protocol protocol = read_protocol(root.dump(), "test.json", models());
  ASSERT_GT(counterbalance_rows(protocol), 1);
  DesignValues values = values_of_session(protocol, example_plan(protocol, {5, 1}));
  const std::string expected = with_values(protocol.consent_statement, values, "en");
  EXPECT_THAT(expected, testing::AllOf(HasSubstr(" minutes, {so}."), Not(HasSubstr("at most"))));
  EXPECT_EQ(consent_as_read(protocol), expected);
  for (const TextPlace& place : texts_with_placeholders(protocol))
    EXPECT_NE(place.pointer, "/consent/statement") << "sessions do not resolve it again";
}

TEST(Placeholders, OfTheConsentAreTheLargestWhereSessionsDiffer) {
  json root = json::parse(library_text("amplitude_jnd"));
  root.at("consent").at("statement") = "You judge {trials} pairs.";
  root["/blocks/comparisons/procedure/stop/reversals"_json_pointer] = 8;
  EXPECT_EQ(consent_as_read(read_protocol(root.dump(), "test.json", models())),
            "You judge at most 85 pairs.");
}

/// The numbers of a block are those of every participant: every reader of the protocol has the text with them.
TEST(Placeholders, AreReplacedInBlocksWhenTheProtocolIsRead) {
  json root = json::parse(library_text("semantic_differential"));
  root.at("blocks").at("ratings").at("page_prompt") = "Mark on {scales} scales. {{x}";
  const Protocol protocol = read_protocol(root.dump(), "test.json", models());
  EXPECT_EQ(protocol.blocks.at("ratings").page_prompt, "Mark on eight scales. {x}");
  EXPECT_EQ(stored_protocol(root.dump()).protocol.blocks.at("ratings").page_prompt,
            "Mark on eight scales. {x}");
  EXPECT_THAT(protocol.source, HasSubstr("{scales}"));
}

/// Blocks that have none of them do not matter.
TEST(Placeholders, OfScreensAreThoseInWhichTheMainBlocksAgree) {
  json root = json::parse(library_text("attributes_of_textures"));
  const auto values = [&root] {
    return values_of_all_blocks(read_protocol(root.dump(), "test.json", models()));
  };
  EXPECT_EQ(values().at("scales").number, 5) << "the recognition has none";
  EXPECT_EQ(values().at("pictures").number, 6);
  EXPECT_FALSE(values().contains("questions")) << "five and one";
}

TEST(Placeholders, ThatMeanNothingAreRefused) {
  const json jnd = json::parse(library_text("amplitude_jnd"));
  EXPECT_THAT(problems_with(jnd, "{trails}"),
              ElementsAre(HasSubstr("\"trails\"; did you mean \"trials\"?")));
  EXPECT_THAT(problems_with(jnd, "a set {1, 2} of"),
              ElementsAre(HasSubstr("write {{ for a brace")));
  EXPECT_THAT(problems_with(jnd, "{trials"), ElementsAre(HasSubstr("add the closing brace")));
  EXPECT_THAT(problems_with(jnd, "{trials|trial}"), ElementsAre(HasSubstr("takes two forms")));
  EXPECT_THAT(problems_with(jnd, "{scales} scales"),
              ElementsAre(HasSubstr("the main blocks have no scales, or differ in them")));
  EXPECT_THAT(problems_with(json::parse(library_text("chapter_selection")), "{practice_trials}"),
              ElementsAre(HasSubstr("a session has no trials of practice")));
}

TEST(Placeholders, OfTheSessionAreRefusedInBlocks) {
  json root = json::parse(library_text("semantic_differential"));
  root.at("blocks").at("ratings").at("page_prompt") = "{trials} trials";
  const auto reading = read_protocol_with_problems(root.dump(), "test.json", models());
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems.front().pointer, "/blocks/ratings/page_prompt");
  EXPECT_THAT(reading.problems.front().message.english(),
              HasSubstr("is known when a session begins"));
}

}  // namespace
}  // namespace asperity
