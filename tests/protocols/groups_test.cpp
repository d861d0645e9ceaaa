// Groups of participants: their protocol, and the plans of their members.

#include "protocols/plan/groups.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/editing/renaming.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/form/form_edits.h"
#include "protocols/form/new_values.h"
#include "protocols/keys/names_in.h"
#include "protocols/keys/tables.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The example with a between-participants factor, to which an exploration is bound.
std::string grouped() {
  std::string text = replaced(test::example_selection(), R"("factors": {)",
                              R"("groups": {"factor": "training"},
  "factors": {"training": {"levels": ["stroking", "pressing"], "meaning": "Practised way."},)");
  text = replaced(text, R"("explorations": {)",
                  R"("explorations": {"pressing": {"minimum_contact_s": 1},)");
  return replaced(text, R"("exploration": "stroking")", R"("exploration": {"factor": "training"})");
}

Protocol read_grouped(const std::string& text) {
  return read_protocol(text, "p.json", test::example_models());
}

std::string problems_in(const std::string& text) {
  try {
    (void)read_grouped(text);
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return {};
}

TEST(Groups, SetTheLevelOfTheirFactorInEveryTrial) {
  const Protocol protocol = read_grouped(grouped());
  ASSERT_THAT(groups_of(protocol), ElementsAre("stroking", "pressing"));
  for (const std::string& group : groups_of(protocol)) {
    const Plan plan = make_plan(protocol, {.seed = 5, .group = group});
    ASSERT_EQ(plan.trials.size(), 6U);
    for (const Trial& trial : plan.trials) {
      EXPECT_EQ(text_of(trial.factors.at("training")), group);
      EXPECT_EQ(exploration_of(protocol, trial).name, group);
      EXPECT_THAT(factors_json_of(trial), HasSubstr("\"training\":\"" + group + "\""));
    }
  }
}

TEST(Groups, DifferOnlyInTheLevelOfTheirFactor) {
  const Protocol protocol = read_grouped(grouped());
  const Plan one = make_plan(protocol, {.seed = 5, .group = "stroking"});
  const Plan other = make_plan(protocol, {.seed = 5, .group = "pressing"});
  for (std::size_t i = 0; i < one.trials.size(); ++i) {
    EXPECT_EQ(
        replaced(json_of(one.trials[i]), R"("training":"stroking")", R"("training":"pressing")"),
        json_of(other.trials[i]));
  }
}

/// `grouped()`, whose first screen has these groups.
std::string with_groups_of_screen(const std::string& groups) {
  return replaced(grouped(), R"("flow": [)",
                  R"("flow": [{"screen": "Press.", "groups": )" + groups + "}, ");
}

std::vector<std::string> screens_of(const Plan& plan) {
  std::vector<std::string> texts{};
  for (const PlanStep& step : plan.steps) {
    const auto* const screen = std::get_if<Protocol::Screen>(&step);
    if (screen != nullptr) texts.push_back(screen->text);
  }
  return texts;
}

TEST(Groups, ReadTheirOwnScreens) {
  const Protocol protocol = read_grouped(with_groups_of_screen(R"(["pressing"])"));
  const Plan one = make_plan(protocol, {.seed = 5, .group = "stroking"});
  const Plan other = make_plan(protocol, {.seed = 5, .group = "pressing"});
  std::vector<std::string> expected = screens_of(one);
  EXPECT_THAT(expected, testing::Not(testing::Contains("Press.")));
  expected.insert(expected.begin(), "Press.");
  EXPECT_EQ(screens_of(other), expected);
  EXPECT_EQ(one.steps.size() + 1, other.steps.size());
  for (const char* const group : {"stroking", "pressing"}) {
    const Protocol both = read_grouped(with_groups_of_screen(R"(["pressing", "stroking"])"));
    EXPECT_EQ(screens_of(make_plan(both, {.seed = 5, .group = group})), expected);
  }
}

TEST(Groups, OfScreensExist) {
  EXPECT_THAT(
      problems_in(with_groups_of_screen(R"(["presing"])")),
      testing::AllOf(HasSubstr("did you mean \"pressing\"?"), HasSubstr("(/flow/0/groups/0)")));
  EXPECT_THAT(problems_in(replaced(test::example_selection(), R"("flow": [)",
                                   R"("flow": [{"screen": "Press.", "groups": ["pressing"]}, )")),
              HasSubstr("participants have no groups"));
}

TEST(Groups, AreRenamedInScreens) {
  const std::string text = with_groups_of_screen(R"(["pressing"])");
  const JsonDocument document(text, "p.json");
  const std::string renamed =
      changed(text, rename(document, levels_of("training"), "pressing", "pressing_hard"));
  const Protocol protocol = read_grouped(renamed);
  EXPECT_THAT(groups_of(protocol), ElementsAre("stroking", "pressing_hard"));
  EXPECT_THAT(std::get<Protocol::Screen>(protocol.flow.front()).groups,
              ElementsAre("pressing_hard"));
}

// A form offers the groups, and begins with the first one.
TEST(Groups, AreOfferedToScreens) {
  const auto names = names_in(nlohmann::json::parse(grouped()));
  EXPECT_THAT(declared_names(names, kGroupNames), ElementsAre("stroking", "pressing"));
  EXPECT_EQ(new_value(kStepTable.find("groups")->shape, names).dump(), R"(["stroking"])");
  const std::string text = with_groups_of_screen(R"(["stroking"])");
  const FormEdit edit = with_entry(JsonDocument(text, "p.json"), "/flow/0/groups");
  EXPECT_EQ(edit.text, with_groups_of_screen(R"(["stroking", "pressing"])"));
}

TEST(Groups, AreAbsentFromThePlansOfOtherProtocols) {
  const Protocol grouped_protocol = read_grouped(grouped());
  const Protocol plain = read_grouped(test::example_selection());
  const Plan with = make_plan(grouped_protocol, {.seed = 5, .group = "stroking"});
  const Plan without = make_plan(plain, {.seed = 5});
  EXPECT_TRUE(groups_of(plain).empty());
  ASSERT_EQ(with.trials.size(), without.trials.size());
  for (std::size_t i = 0; i < with.trials.size(); ++i) {
    EXPECT_EQ(replaced(json_of(with.trials[i]), R"(,"training":"stroking")", ""),
              replaced(json_of(without.trials[i]), "", ""))
        << "the between-participants factor draws nothing";
  }
}

TEST(Groups, AreBoundLikeAnyFactorAlsoByForEach) {
  std::string text =
      replaced(grouped(), R"("model": {"levels")",
               R"("posture": {"levels": ["sitting", "standing"]}, "model": {"levels")");
  text = replaced(text, R"("run": "main",)", R"("run": "main", "for_each": "posture",)");
  const Plan plan = make_plan(read_grouped(text), {.seed = 1, .group = "pressing"});
  for (const Trial& trial : plan.trials) {
    EXPECT_EQ(text_of(trial.factors.at("training")), "pressing");
    EXPECT_TRUE(trial.factors.contains("posture"));
  }
}

TEST(Groups, AllOccurAmongThePossibleTrials) {
  std::map<std::string, int> trials{};
  for (const Trial& trial : possible_trials(read_grouped(grouped()))) {
    ++trials[text_of(trial.factors.at("training"))];
  }
  EXPECT_EQ(trials, (std::map<std::string, int>{{"stroking", 2}, {"pressing", 2}}));
}

TEST(Groups, MayBeNumbersToWhichAParameterIsBound) {
  std::string text = replaced(test::example_selection(), R"("factors": {)",
                              R"("groups": {"factor": "scale", "assigned": "by_experimenter"},
  "factors": {"scale": {"levels": [0.5, 2]},)");
  text = replaced(text, R"("equal_force": {"to_model": "height_map"})",
                  R"("parameters": {"height_scale": {"factor": "scale"}})");
  text = replaced(text, R"(["height_map", "sinusoid", "stochastic"])", R"(["height_map"])");
  text =
      replaced(text, R"(,
        {"stimulus": "rendered", "with": {"model": "sinusoid"}},
        {"stimulus": "rendered", "with": {"model": "stochastic"}})",
               R"(, {"stimulus": "rendered", "with": {"model": "height_map"}, "item": "again"})");
  const Protocol protocol = read_grouped(text);
  EXPECT_EQ(protocol.groups->assigned, Protocol::Groups::Assignment::by_experimenter);
  const Plan plan = make_plan(protocol, {.seed = 1, .group = "2"});
  EXPECT_EQ(plan.trials.at(0).factors.at("scale"), Level(2.0));
  EXPECT_EQ(plan.trials.at(0).presentations.at(0).stimulus.parameters.at("height_scale"),
            ParameterValue(2.0));
}

TEST(Groups, ThatDoNotExistAreRefused) {
  const Protocol protocol = read_grouped(grouped());
  EXPECT_THAT([&] { (void)make_plan(protocol, {.seed = 1, .group = "reading"}); },
              testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("has no group \"reading\"; use \"stroking\" or")));
  const Protocol plain = read_grouped(test::example_selection());
  EXPECT_THAT([&] { (void)make_plan(plain, {.seed = 1, .group = "stroking"}); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("has no groups")));
}

TEST(Groups, AreTheOnlyOnesToSetTheirFactor) {
  EXPECT_EQ(problems_in(grouped()), "");
  EXPECT_THAT(
      problems_in(replaced(grouped(), R"("factor": "training"})", R"("factor": "trainin"})")),
      HasSubstr("did you mean \"training\"?"));
  EXPECT_THAT(problems_in(replaced(grouped(), R"(["texture"],)", R"(["texture", "training"],)")),
              HasSubstr("\"training\" is the factor of the groups"));
  EXPECT_THAT(problems_in(replaced(grouped(), R"("run": "main",)",
                                   R"("run": "main", "for_each": "training",)")),
              HasSubstr("(/flow/2/for_each)"));
  EXPECT_THAT(problems_in(replaced(grouped(), R"(["stroking", "pressing"])", R"(["stroking"])")),
              HasSubstr("2 to 32 levels"));
  EXPECT_THAT(problems_in(replaced(grouped(), R"({"factor": "training"},)",
                                   R"({"factor": "training", "assigned": "by_age"},)")),
              HasSubstr("\"balanced\", \"permuted_blocks\" or \"by_experimenter\""));
  EXPECT_THAT(problems_in(replaced(grouped(), R"({"factor": "training"},)", R"({},)")),
              HasSubstr("\"factor\" is missing"));
}

TEST(Groups, AreWhatATestOfThemNeeds) {
  const std::string declared =
      R"("analysis": {"target": "sinusoid", "family": ["groups"]}, "flow")";
  EXPECT_EQ(problems_in(replaced(grouped(), "\"flow\"", declared)), "");
  EXPECT_THAT(problems_in(replaced(test::example_selection(), "\"flow\"", declared)),
              HasSubstr("add the key \"groups\""));
}

// Attributes of simulated participants alternate, their sex for one: it must not tell the groups.
TEST(Groups, OfSimulatedParticipantsAreEquallyOftenOfEitherSex) {
  for (const int levels : {2, 3, 4}) {
    std::string names{};
    for (int i = 0; i < levels; ++i) names += (i > 0 ? ", \"g" : "\"g") + std::to_string(i) + '"';
    std::string text = replaced(test::example_selection(), R"("factors": {)",
                                R"("groups": {"factor": "group"},
  "factors": {"group": {"levels": [)" +
                                    names + "]},");
    text = replaced(text, R"("model": {"levels")",
                    R"("posture": {"levels": ["sitting", "standing"]}, "model": {"levels")");
    text = replaced(text, R"("run": "main",)", R"("run": "main", "for_each": "posture",)");
    text = replaced(text, R"("flow")", R"("counterbalance": "latin", "flow")");
    const Protocol protocol = read_grouped(text);
    std::map<std::pair<std::string, int>, int> by_sex{};
    std::map<std::pair<std::string, int>, int> by_row{};
    for (int n = 0; n < 4 * levels; ++n) {
      const Allocation allocation = allocation_in_turn(protocol, n);
      ++by_sex[{allocation.group, n % 2}];
      ++by_row[{allocation.group, allocation.counterbalance_row}];
    }
    const auto is_two = [](const auto& cell) { return cell.second == 2; };
    EXPECT_EQ(by_sex.size(), 2U * static_cast<std::size_t>(levels));
    EXPECT_EQ(by_row.size(), 2U * static_cast<std::size_t>(levels));
    EXPECT_TRUE(std::all_of(by_sex.begin(), by_sex.end(), is_two)) << levels;
    EXPECT_TRUE(std::all_of(by_row.begin(), by_row.end(), is_two)) << levels;
  }
}

// A part of the places has the allocations of these places, however the study is divided.
TEST(Groups, AreAllocatedToPlacesAsToSimulatedParticipants) {
  const Protocol protocol = read_grouped(grouped());
  const std::vector<Allocation> places = allocations_in_turn(protocol, "run", 12);
  ASSERT_EQ(places.size(), 12U);
  for (int n = 0; n < 12; ++n) {
    const Allocation expected = allocation_in_turn(protocol, n);
    const Allocation& place = places[static_cast<std::size_t>(n)];
    EXPECT_EQ(place.group, expected.group) << n;
    EXPECT_EQ(place.counterbalance_row, expected.counterbalance_row) << n;
  }
}

std::string permuted(const std::string& further) {
  return replaced(grouped(), R"({"factor": "training"},)",
                  R"({"factor": "training", "assigned": "permuted_blocks")" + further + "},");
}

TEST(PermutedBlocks, ContainEveryGroupEquallyOften) {
  const Protocol protocol = read_grouped(permuted(R"(, "seed": 4, "block_sizes": [4])"));
  std::set<std::string> orders{};
  for (std::size_t block = 0; block < 40; ++block) {
    std::string order{};
    int stroking = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string group = permuted_group(protocol, "run", 4 * block + i);
      stroking += group == "stroking" ? 1 : 0;
      order += group.front();
    }
    EXPECT_EQ(stroking, 2) << block;
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 6U) << "4!/(2!·2!) orders";
}

TEST(PermutedBlocks, AllocateThePlacesOfAStudyInTheSequenceOfTheMode) {
  const Protocol protocol = read_grouped(permuted(R"(, "seed": 4, "block_sizes": [4])"));
  const std::vector<Allocation> places = allocations_in_turn(protocol, "run", 8);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(places[i].group, permuted_group(protocol, "run", i)) << i;
  }
  EXPECT_EQ(allocations_in_turn(protocol, "simulate", 8)[7].group,
            allocation_in_turn(protocol, 7).group);
}

TEST(PermutedBlocks, HaveRandomSizesUnlessOneIsStated) {
  const Protocol protocol = read_grouped(permuted(R"(, "seed": 4)"));
  EXPECT_THAT(permuted_blocks_of(protocol)->sizes, ElementsAre(4, 6));
  // Blocks of 4 or of 6 alone are balanced after every 12 participants; here the balance after 4 and 6 varies.
  int balanced_after_4 = 0;
  int balanced_after_10 = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Protocol other = protocol;
    other.groups->seed = seed;
    int stroking = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      stroking += permuted_group(other, "run", i) == "stroking" ? 1 : 0;
      if (i == 3 && stroking == 2) ++balanced_after_4;
    }
    if (stroking == 5) ++balanced_after_10;
  }
  EXPECT_LT(balanced_after_4, 100);
  EXPECT_GT(balanced_after_4, 50);
  EXPECT_GT(balanced_after_10, 50);
}

TEST(PermutedBlocks, AreDeterminedBySeedAndMode) {
  const Protocol protocol = read_grouped(permuted(R"(, "seed": 4)"));
  const auto sequence = [](const Protocol& of, const std::string& mode) {
    std::string groups{};
    for (std::size_t i = 0; i < 60; ++i) groups += permuted_group(of, mode, i).front();
    return groups;
  };
  EXPECT_EQ(sequence(protocol, "run"), sequence(protocol, "run"));
  EXPECT_NE(sequence(protocol, "run"), sequence(protocol, "pilot"));
  EXPECT_NE(sequence(protocol, "run"), sequence(read_grouped(permuted(R"(, "seed": 5)")), "run"));
}

TEST(PermutedBlocks, NeedASeedAndSizesThatFit) {
  EXPECT_EQ(problems_in(permuted(R"(, "seed": 4, "block_sizes": [2, 4])")), "");
  EXPECT_THAT(problems_in(permuted("")), HasSubstr("state its \"seed\""));
  EXPECT_THAT(problems_in(permuted(R"(, "seed": 4, "block_sizes": [4, 5])")),
              HasSubstr("does not contain the 2 groups equally often; use a multiple of 2 "
                        "(/groups/block_sizes/1)"));
  EXPECT_THAT(problems_in(replaced(grouped(), R"({"factor": "training"},)",
                                   R"({"factor": "training", "seed": 4},)")),
              HasSubstr("this key applies only where \"assigned\" is \"permuted_blocks\""));
}

}  // namespace
}  // namespace asperity
