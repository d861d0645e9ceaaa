// The protocols that come with the program: valid, and as careful as they claim to be.

#include <algorithm>
#include <set>

#include "protocols/library_protocols.h"
#include "protocols/plan.h"
#include "protocols/protocol_reader.h"
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

}  // namespace
}  // namespace asperity
