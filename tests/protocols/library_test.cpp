// The protocols that come with the program: valid, and as careful as they claim to be.

#include <algorithm>
#include <set>

#include "protocols/library_protocols.h"
#include "protocols/plan.h"
#include "protocols/protocol_reader.h"
#include "protocols/virtual_observer.h"
#include "tests/protocols/example.h"

namespace asperity {
namespace {

class Library : public testing::TestWithParam<LibraryProtocol> {
 protected:
  Protocol protocol() const {
    return read_protocol(GetParam().text, std::string(GetParam().name) + ".json",
                         test::example_models());
  }
};

TEST_P(Library, IsValidAndNamedLikeItsFile) {
  try {
    EXPECT_EQ(protocol().name, GetParam().name);
  } catch (const ProtocolError& error) {
    FAIL() << error.what();
  }
}

TEST_P(Library, AsksWhatAnEthicsBoardExpects) {
  const Protocol read = protocol();
  EXPECT_FALSE(read.consent_version.empty());
  EXPECT_NE(read.consent_statement.find("stop at any moment"), std::string::npos);
  std::set<std::string> asked{};
  for (const Question& question : read.participant_questions) asked.insert(question.name);
  for (const char* const name : {"age", "sex", "handedness", "hand_used", "hand_problems"}) {
    EXPECT_TRUE(asked.contains(name)) << name;
  }
  const auto* const first = std::get_if<Protocol::Screen>(&read.flow.front());
  ASSERT_NE(first, nullptr);
  EXPECT_NE(first->text.find("stop at any moment"), std::string::npos);
  EXPECT_TRUE(std::any_of(read.flow.begin(), read.flow.end(), [](const Protocol::Step& step) {
    return std::holds_alternative<Protocol::Ask>(step);
  })) << "closing questions";
}

// Even somebody who feels every surface for as long as allowed rests in time.
TEST_P(Library, RestsAtLeastEveryTenMinutesWithTheForceZeroed) {
  Protocol read = protocol();
  for (auto& [name, exploration] : read.explorations) {
    exploration.minimum_contact_s = exploration.maximum_contact_s;
  }
  const Plan plan = make_plan(read, {.seed = 1, .counterbalance_row = 0});
  const PlanCost cost = cost_of(read, plan);
  EXPECT_LE(cost.longest_without_break_s, 600.0);
  EXPECT_LE(cost.total_s, 3600.0);
  int breaks = 0;
  for (const PlanStep& step : plan.steps) {
    if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
      ++breaks;
      EXPECT_TRUE(pause->zero_force);
      EXPECT_FALSE(pause->text.empty());
    }
  }
  EXPECT_GE(breaks, 1);
}

TEST_P(Library, ChapterVariantsGiveOneOutcomePerColumn) {
  const Protocol read = protocol();
  if (read.design != ProtocolDesign::chapter) return;
  const Plan plan = make_plan(read, {.seed = 7, .counterbalance_row = 0});
  ASSERT_EQ(plan.trials.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(text_of(plan.trials[i].factors.at("column")), std::to_string(i + 1));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Library,
                         testing::ValuesIn(library_protocols().begin(), library_protocols().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(LibraryProtocols, CoverTheThreeExperimentsTwiceAndThePhotographs) {
  std::vector<std::string> names{};
  for (const LibraryProtocol& each : library_protocols()) names.emplace_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"chapter_matching", "chapter_recognition",
                                             "chapter_selection", "improved_matching",
                                             "improved_recognition", "improved_selection",
                                             "photo_matching", "photo_recognition"}));
}

TEST(LibraryProtocols, ShowDistractorsThatNobodyFeels) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name != "chapter_recognition") continue;
    const Protocol read = read_protocol(each.text, "f", test::example_models());
    for (const char* const name : {"sandpaper", "pebbles"}) {
      const Texture& texture = read.textures.at(name);
      EXPECT_FALSE(texture.height_field);
      EXPECT_TRUE(texture.picture && texture.true_height_field);
      EXPECT_NE(texture.note.find("no rendered counterpart"), std::string::npos);
    }
  }
}

// What virtual hands felt on three strokes of the textures that scripts/demo-photos makes of the
// photographs (scripts/fetch-photos), rendered by height_map.
const std::vector<std::vector<ForceFeatures>>& strokes_over_the_photographs() {
  static const std::vector<std::vector<ForceFeatures>> kStrokes{
      {ForceFeatures{
           {-4.79, -4.92, -3.99, -3.75, -3.38, -3.58, -4.4, -5.0, -5.78, -6.68}, -2.88, -3.04},
       ForceFeatures{
           {-4.21, -4.07, -3.82, -3.78, -3.75, -3.96, -4.27, -4.67, -5.42, -6.21}, -2.95, -2.96},
       ForceFeatures{
           {-4.67, -4.66, -4.22, -4.01, -3.74, -4.04, -4.12, -4.45, -5.13, -5.78}, -3.1, -3.1}},
      {ForceFeatures{
           {-5.28, -5.03, -4.11, -3.87, -3.53, -3.7, -4.47, -5.12, -5.94, -6.79}, -3.01, -3.25},
       ForceFeatures{
           {-4.52, -4.1, -3.83, -3.84, -3.73, -3.97, -4.22, -4.49, -5.31, -6.02}, -2.97, -3.28},
       ForceFeatures{
           {-4.5, -4.34, -3.88, -3.75, -3.8, -3.79, -3.99, -4.4, -4.96, -5.66}, -2.93, -3.1}},
      {ForceFeatures{
           {-4.62, -4.81, -4.11, -3.84, -3.51, -3.68, -4.43, -5.17, -5.81, -6.59}, -2.97, -3.05},
       ForceFeatures{
           {-4.64, -4.27, -4.1, -3.86, -3.83, -4.1, -4.34, -4.7, -5.31, -6.03}, -3.1, -3.26},
       ForceFeatures{
           {-4.39, -4.33, -4.07, -3.78, -3.8, -3.78, -4.07, -4.38, -5.01, -5.88}, -2.97, -3.06}}};
  return kStrokes;
}

// The priors come from another recipe and another stroke, and still fit: an observer without noise
// gets all three right, which chance does once in 6³ = 216 times.
TEST(LibraryProtocols, StatePriorsByWhichThePhotographsCanBeMatched) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (!each.name.starts_with("photo_")) continue;
    const Protocol read = read_protocol(each.text, "f", test::example_models());
    std::vector<ForceFeatures> expected{};
    for (const char* const name : {"brick", "gravel", "grass"}) {
      expected.push_back(read.textures.at(name).prior.value());
    }
    ObserverDeclaration ideal = read.observer;
    ideal.feature_noise = 0.0;
    ideal.position_bias = 0.0;
    ideal.lapse = 0.0;
    for (const std::vector<ForceFeatures>& felt : strokes_over_the_photographs()) {
      VirtualObserver observer(ideal, Random(1));
      EXPECT_EQ(observer.match(felt, expected), (std::vector<std::size_t>{0, 1, 2})) << each.name;
    }
  }
}

}  // namespace
}  // namespace asperity
