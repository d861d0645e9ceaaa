// Discriminations and the parameter that the trials of a block vary: plans, measures of levels, and what a file cannot ask.

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/design/dimension.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

/// Not `json`, which names variables of other tests.
using ProtocolJson = nlohmann::json;
using ::testing::HasSubstr;

/// Two-interval forced choice: an amplitude of 50 µm, and 5, 10, 20, 30 and 50 % above.
ProtocolJson amplitude_jnd() {
  ProtocolJson protocol = test::library_file("amplitude_jnd");
  ProtocolJson& block = protocol["blocks"]["comparisons"];
  block.erase("procedure");
  block["vary"]["levels_percent"] = {5, 10, 20, 30, 50};
  block["repetitions"] = 16;
  return protocol;
}

ProtocolJson& main_block(ProtocolJson& protocol) { return protocol["blocks"]["comparisons"]; }

/// The same with levels on both sides and a judgement of comparison.
ProtocolJson comparison_of_amplitudes() {
  ProtocolJson protocol = amplitude_jnd();
  main_block(protocol)["vary"]["levels_percent"] = {-30, -10, 0, 10, 30};
  main_block(protocol)["question"]["judgement"] = "comparison";
  return protocol;
}

struct FaultOfBlock {
  const char* pointer = "";  ///< below the main block
  const char* message = "";
  std::function<void(ProtocolJson&)> change{};
};

void expect_faults(const ProtocolJson& valid, const std::vector<FaultOfBlock>& faults) {
  for (const FaultOfBlock& fault : faults) {
    SCOPED_TRACE(fault.message);
    ProtocolJson changed = valid;
    fault.change(changed);
    EXPECT_THAT(test::problems_at(changed, std::string("/blocks/comparisons") + fault.pointer),
                HasSubstr(fault.message));
  }
}

TEST(Discriminations, ArePlannedWithEveryLevelInBothOrders) {
  std::map<std::string, int> by_level{};
  std::map<std::string, int> comparison_first{};
  for (const Trial& trial : test::main_trials(test::valid(amplitude_jnd()))) {
    const std::string level = text_of(trial.factors.at("amplitude_m"));
    ++by_level[level];
    ASSERT_EQ(trial.presentations.size(), 2U);
    comparison_first[level] += trial.presentations[0].item == "comparison" ? 1 : 0;
    for (const PlannedPresentation& planned : trial.presentations) {
      EXPECT_EQ(planned.item, planned.role);
      const double amplitude_m = std::get<double>(planned.stimulus.parameters.at("amplitude_m"));
      EXPECT_EQ(text_of(Level(amplitude_m)), planned.role == "standard" ? "5e-05" : level);
    }
    EXPECT_EQ(trial.questions.front().correct, std::vector<std::string>{"comparison"});
  }
  ASSERT_EQ(by_level.size(), 5U);
  for (const auto& [level, trials] : by_level) {
    EXPECT_EQ(trials, 16) << level;
  }
  EXPECT_TRUE(by_level.contains("7.5e-05")) << "50 µm + 50 %";
  for (const auto& [level, first] : comparison_first) {
    EXPECT_EQ(first, 8) << level << ": 16 trials are a multiple of two surfaces";
  }
}

TEST(Discriminations, BalancePositionsOverTheBlockWhereALevelHasAnOddNumberOfTrials) {
  ProtocolJson protocol = amplitude_jnd();
  main_block(protocol)["vary"]["levels_percent"] = {5, 10, 20, 50};
  main_block(protocol)["repetitions"] = 7;
  int first = 0;
  for (const Trial& trial : test::main_trials(test::valid(protocol))) {
    first += trial.presentations[0].item == "comparison" ? 1 : 0;
  }
  EXPECT_EQ(first, 14) << "half of 28 trials";
}

TEST(Discriminations, ByComparisonHaveNoCorrectResponse) {
  for (const Trial& trial : test::main_trials(test::valid(comparison_of_amplitudes()))) {
    EXPECT_TRUE(trial.questions.front().correct.empty());
  }
}

TEST(Discriminations, RefuseSurfacesThatAreNotAStandardAndAComparison) {
  const ProtocolJson standard{{"role", "standard"}, {"stimulus", "grating"}};
  const ProtocolJson comparison{{"role", "comparison"}, {"stimulus", "grating"}};
  expect_faults(amplitude_jnd(),
                {{"/presented", "one surface with the role \"standard\"",
                  [&](ProtocolJson& p) { main_block(p)["presented"] = {comparison}; }},
                 {"/presented", "one surface with the role \"standard\"",
                  [&](ProtocolJson& p) {
                    main_block(p)["presented"] = {standard, standard, comparison};
                  }},
                 {"/presented/1/item", "the role names each surface",
                  [&](ProtocolJson& p) { main_block(p)["presented"][1]["item"] = "grating"; }},
                 {"/presented", "the same surface would always be presented first",
                  [&](ProtocolJson& p) { main_block(p)["positions"] = "as_listed"; }},
                 {"/question/correct_factor", "only a recognition", [&](ProtocolJson& p) {
                    main_block(p)["question"]["correct_factor"] = "amplitude_m";
                  }}});
}

TEST(Discriminations, MayHaveTheOptionCannotTell) {
  for (ProtocolJson protocol : {amplitude_jnd(), comparison_of_amplitudes()}) {
    main_block(protocol)["question"]["allow_cannot_tell"] = true;
    for (const Trial& trial : test::main_trials(test::valid(protocol))) {
      ASSERT_EQ(trial.questions.front().options.size(), 3U);
      EXPECT_EQ(trial.questions.front().options.back().value, kCannotTellOption);
    }
  }
}

/// Weighted up-down to 75 % with the option "cannot tell".
ProtocolJson unforced_weighted() {
  ProtocolJson protocol = amplitude_jnd();
  ProtocolJson& block = main_block(protocol);
  block.erase("repetitions");
  block["vary"]["levels_percent"] = {{"lowest", 5}, {"highest", 50}, {"step", 5}};
  block["procedure"] = {
      {"method", "weighted_up_down"}, {"start", 40}, {"steps", {5}}, {"stop", {{"trials", 20}}}};
  block["question"]["allow_cannot_tell"] = true;
  return protocol;
}

TEST(Discriminations, StateInTheWeightedMethodThatChoicesAreUnforced) {
  const auto alternatives = [](const ProcedureSettings& settings) {
    return std::get<WeightedUpDown>(settings).unforced_alternatives;
  };
  ProtocolJson protocol = unforced_weighted();
  const Protocol read = test::valid(protocol);
  EXPECT_EQ(alternatives(read.blocks.at("comparisons").procedure->tracks.front()), 2U);
  const Protocol stored = stored_protocol(protocol.dump()).protocol;
  ASSERT_EQ(stored.blocks.at("comparisons").procedure->tracks.size(), 1U);
  EXPECT_EQ(alternatives(stored.blocks.at("comparisons").procedure->tracks.front()), 2U);
  main_block(protocol)["question"].erase("allow_cannot_tell");
  EXPECT_FALSE(
      alternatives(test::valid(protocol).blocks.at("comparisons").procedure->tracks.front()));
}

TEST(Discriminations, RefuseCannotTellWhereAProcedureHasNoStepForIt) {
  expect_faults(
      unforced_weighted(),
      {{"/procedure/method", "use \"weighted_up_down\"",
        [](ProtocolJson& p) {
          main_block(p)["procedure"]["method"] = "transformed_up_down";
          main_block(p)["procedure"]["down"] = 2;
        }},
       {"/procedure/method", "receives correct and incorrect responses only",
        [](ProtocolJson& p) {
          main_block(p)["procedure"] = {{"method", "external"}, {"stop", {{"trials", 20}}}};
        }},
       {"/procedure/target", "is not above 1/2",
        [](ProtocolJson& p) { main_block(p)["procedure"]["target"] = 0.5; }},
       {"/question/judgement", "is defined where one response is correct", [](ProtocolJson& p) {
          main_block(p)["question"]["judgement"] = "comparison";
          main_block(p)["vary"]["levels_percent"] = {{"lowest", -50}, {"highest", 50}, {"step", 5}};
        }}});
}

TEST(Discriminations, RefuseABlockWithoutAStandardOfAKnownValue) {
  expect_faults(
      amplitude_jnd(),
      {{"/question", "a discrimination needs \"judgement\"",
        [](ProtocolJson& p) { main_block(p)["question"].erase("judgement"); }},
       {"", "add \"vary\"", [](ProtocolJson& p) { main_block(p).erase("vary"); }},
       {"/vary/of", "varies the comparison",
        [](ProtocolJson& p) {
          main_block(p)["vary"] = {
              {"parameter", "amplitude_m"}, {"of", "standard"}, {"levels", {1e-5}}};
        }},
       {"/vary", "set \"relative_to\" to \"standard\"",
        [](ProtocolJson& p) {
          main_block(p)["vary"] = {
              {"parameter", "amplitude_m"}, {"of", "comparison"}, {"levels", {1e-5}}};
        }},
       {"/vary/relative_to", "does not state a number for \"amplitude_m\"", [](ProtocolJson& p) {
          p["stimuli"]["plain"] = {{"model", "sinusoid"},
                                   {"parameters", {{"wavelength_m", 0.0025}}}};
          main_block(p)["vary"].erase("levels_percent");
          main_block(p)["vary"]["levels"] = {1e-5};
          main_block(p)["presented"][0]["stimulus"] = "plain";
        }}});
}

TEST(Discriminations, RefuseLevelsThatDoNotSuitTheJudgement) {
  expect_faults(
      amplitude_jnd(),
      {{"/vary/levels_percent", "every level must be above the standard, or every level below",
        [](ProtocolJson& p) {
          main_block(p)["vary"]["levels_percent"] = {-10, 10};
        }},
       {"/vary/levels_percent", "every level must be above the standard, or every level below",
        [](ProtocolJson& p) {
          main_block(p)["vary"]["levels_percent"] = {0, 10};
        }}});
  expect_faults(comparison_of_amplitudes(),
                {{"/vary/levels_percent", "needs levels below and above the standard",
                  [](ProtocolJson& p) {
                    main_block(p)["vary"]["levels_percent"] = {0, 10};
                  }},
                 {"/feedback", "no response is correct or incorrect",
                  [](ProtocolJson& p) { main_block(p)["feedback"] = "correctness"; }}});
}

TEST(Discriminations, OfDecreasingLevelsAreValid) {
  ProtocolJson protocol = amplitude_jnd();
  for (const char* const block : {"practice", "comparisons"}) {
    protocol["blocks"][block]["vary"]["levels_percent"] = {-50, -20};
  }
  (void)test::valid(protocol);
}

TEST(VariedParameters, RefuseLevelsThatAreMissingOrStatedTwice) {
  expect_faults(
      amplitude_jnd(),
      {{"/vary", "write exactly one of the keys",
        [](ProtocolJson& p) { main_block(p)["vary"].erase("levels_percent"); }},
       {"/vary", "write exactly one of the keys",
        [](ProtocolJson& p) { main_block(p)["vary"]["levels_ratio"] = {1.1}; }},
       {"/vary/levels_percent", "a level is stated twice",
        [](ProtocolJson& p) {
          main_block(p)["vary"]["levels_percent"] = {5, 10, 5};
        }},
       {"/vary/levels_percent/highest", "",
        [](ProtocolJson& p) {
          main_block(p)["vary"]["levels_percent"] = {{"lowest", 50}, {"highest", 5}, {"step", 5}};
        }},
       {"/vary/levels_percent/step", "every level is checked before a session",
        [](ProtocolJson& p) {
          main_block(p)["vary"]["levels_percent"] = {
              {"lowest", 1}, {"highest", 51}, {"step", 0.00501}};
        }}});
}

TEST(VariedParameters, RefuseNamesThatAreTakenOrUnknown) {
  expect_faults(amplitude_jnd(),
                {{"/vary/parameter", "already declared under /factors",
                  [](ProtocolJson& p) {
                    p["factors"]["amplitude_m"] = {{"levels", {1, 2}}};
                  }},
                 {"/vary/factor", "already declared under /factors",
                  [](ProtocolJson& p) {
                    p["factors"]["size"] = {{"levels", {1, 2}}};
                    main_block(p)["vary"]["factor"] = "size";
                  }},
                 {"/vary/of", "surfaces of the block have the role \"target\"",
                  [](ProtocolJson& p) { main_block(p)["vary"]["of"] = "target"; }},
                 {"/vary/relative_to", "no other surface of the block has the role",
                  [](ProtocolJson& p) { main_block(p)["vary"]["relative_to"] = "comparison"; }},
                 {"/vary/parameter",
                  "there is no numeric parameter \"amplitude\"; did you mean \"amplitude_m\"?",
                  [](ProtocolJson& p) { main_block(p)["vary"]["parameter"] = "amplitude"; }},
                 {"/vary/parameter", "amplitude",
                  [](ProtocolJson& p) {
                    for (const char* const block : {"practice", "comparisons"}) {
                      p["blocks"][block]["vary"]["parameter"] = "amplitud_m";
                    }
                    p["stimuli"]["grating"]["parameters"]["amplitud_m"] = 5e-5;
                  }},
                 {"/vary/parameter", "equal_force",
                  [](ProtocolJson& p) {
                    p["stimuli"]["forced"] = p["stimuli"]["grating"];
                    p["stimuli"]["forced"]["parameters"].erase("amplitude_m");
                    p["stimuli"]["forced"]["equal_force"] = {{"rms_N", 0.3}};
                    main_block(p)["presented"][1]["stimulus"] = "forced";
                  }},
                 {"/vary/parameter", "binds this parameter to the factor", [](ProtocolJson& p) {
                    p["factors"]["size"] = {{"levels", {1e-5, 2e-5}}};
                    p["stimuli"]["bound"] = p["stimuli"]["grating"];
                    p["stimuli"]["bound"]["parameters"]["amplitude_m"] = {{"factor", "size"}};
                    main_block(p)["presented"][1]["stimulus"] = "bound";
                    main_block(p)["crossed"] = {"size"};
                  }}});
}

TEST(VariedParameters, AreReportedWithoutRoundingErrors) {
  expect_faults(
      amplitude_jnd(),
      {{"/procedure/target", "a step up is 2.33333333333 times the step down", [](ProtocolJson& p) {
          main_block(p).erase("repetitions");
          main_block(p)["vary"]["levels_percent"] = {{"lowest", 2}, {"highest", 80}, {"step", 2}};
          main_block(p)["procedure"] = {{"method", "weighted_up_down"},
                                        {"target", 0.7},
                                        {"steps_down", {2}},
                                        {"start", 40},
                                        {"stop", {{"trials", 20}}}};
        }}});
}

TEST(VariedParameters, RefuseLevelsRelativeToNoStandardOrToZero) {
  expect_faults(amplitude_jnd(),
                {{"/vary/levels_percent", "needs a standard; add \"relative_to\"",
                  [](ProtocolJson& p) { main_block(p)["vary"].erase("relative_to"); }},
                 {"/vary/relative_to", "to which the levels refer",
                  [](ProtocolJson& p) {
                    p["stimuli"]["plain"] = {{"model", "sinusoid"},
                                             {"parameters", {{"wavelength_m", 0.0025}}}};
                    main_block(p)["presented"][0]["stimulus"] = "plain";
                  }},
                 {"/vary/levels_percent", "needs a standard above 0", [](ProtocolJson& p) {
                    p["stimuli"]["smooth"] = p["stimuli"]["grating"];
                    p["stimuli"]["smooth"]["parameters"]["amplitude_m"] = 0;
                    main_block(p)["presented"][0]["stimulus"] = "smooth";
                  }}});
}

TEST(VariedParameters, RefuseValuesThatTheModelDoesNotPermit) {
  expect_faults(amplitude_jnd(),
                {{"/vary/levels_percent/4", "is a value of ",
                  [](ProtocolJson& p) {
                    main_block(p)["vary"]["levels_percent"] = {5, 10, 20, 30, 1e6};
                  }},
                 {"/vary/levels_percent/highest", "is a value of ", [](ProtocolJson& p) {
                    main_block(p)["vary"]["levels_percent"] = {
                        {"lowest", 100000}, {"highest", 900000}, {"step", 100000}};
                  }}});
}

TEST(VariedParameters, OfADetectionHaveDifferencesOrValues) {
  ProtocolJson protocol = amplitude_jnd();
  protocol["stimuli"]["smooth"] = protocol["stimuli"]["grating"];
  protocol["stimuli"]["smooth"]["parameters"]["amplitude_m"] = 0;
  for (const char* const block : {"practice", "comparisons"}) {
    ProtocolJson& vary = protocol["blocks"][block]["vary"];
    vary.erase("levels_percent");
    vary["levels"] = {1e-6, 2e-6, 5e-6};
    protocol["blocks"][block]["presented"][0]["stimulus"] = "smooth";
  }
  const Protocol read = test::valid(protocol);
  EXPECT_EQ(read.blocks.at("comparisons").vary->standard, 0.0);
  EXPECT_EQ(read.blocks.at("comparisons").vary->unit, "m");
}

TEST(VariedParameters, HaveLevelsOnAGrid) {
  ProtocolJson protocol = amplitude_jnd();
  main_block(protocol)["vary"]["levels_percent"] = {{"lowest", 10}, {"highest", 50}, {"step", 20}};
  const Protocol read = test::valid(protocol);
  EXPECT_THAT(read.blocks.at("comparisons").vary->values(),
              testing::ElementsAre(5.5e-5, 6.5e-5, 7.5e-5));
  EXPECT_EQ(read.factors.at("amplitude_m").unit, "m");
}

TEST(VariedParameters, KeepTheirMeasureInTheStoredProtocol) {
  const Protocol stored = stored_protocol(amplitude_jnd().dump()).protocol;
  const Protocol::Block& block = stored.blocks.at("comparisons");
  ASSERT_TRUE(block.vary);
  EXPECT_EQ(block.vary->parameter, "amplitude_m");
  EXPECT_EQ(block.vary->factor, "amplitude_m");
  EXPECT_EQ(block.vary->measure, LevelMeasure::percent);
  EXPECT_EQ(block.vary->standard, 5e-5);
  EXPECT_EQ(block.questions.front().judgement(), DiscriminationJudgement::performance);
  EXPECT_FALSE(block.questions.front().own_as<DiscriminationQuestion>()->asks_for) << "not stated";
  EXPECT_FALSE(chooses_levels_from_answers(block));
  EXPECT_EQ(block.arrangement.surfaces, Arrangement::Surfaces::sequential);
  ProtocolJson smoother = comparison_of_amplitudes();
  main_block(smoother)["question"]["asks_for"] = "less";
  main_block(smoother)["arrangement"] = {{"surfaces", "side_by_side"}};
  const Protocol::Block other = stored_protocol(smoother.dump()).protocol.blocks.at("comparisons");
  EXPECT_TRUE(other.questions.front().asks_for_less());
  EXPECT_EQ(other.arrangement.surfaces, Arrangement::Surfaces::side_by_side);
  ProtocolJson protocol = amplitude_jnd();
  const auto has_procedure = [&protocol](const char* method) {
    main_block(protocol)["procedure"] = {{"method", method}};
    return chooses_levels_from_answers(
        stored_protocol(protocol.dump()).protocol.blocks.at("comparisons"));
  };
  EXPECT_TRUE(has_procedure("weighted_up_down"));
  EXPECT_FALSE(has_procedure("constant_stimuli")) << "does not depend on the responses";
}

TEST(Dimensions, ReturnFromEveryMeasureToTheSameLevel) {
  constexpr double kStandard = 5e-5;
  for (const LevelMeasure measure :
       {LevelMeasure::value, LevelMeasure::difference, LevelMeasure::percent, LevelMeasure::ratio,
        LevelMeasure::decibels}) {
    for (const double level : {0.25, 1.0, 3.0, 12.5}) {
      const double value = value_at(measure, level, kStandard);
      EXPECT_NEAR(level_at_value(measure, value, kStandard), level, 1e-6 * level)
          << key_of(measure);
    }
  }
  EXPECT_DOUBLE_EQ(value_at(LevelMeasure::difference, -1e-5, kStandard), 4e-5);
  EXPECT_DOUBLE_EQ(value_at(LevelMeasure::percent, 50.0, kStandard), 7.5e-5);
  EXPECT_DOUBLE_EQ(value_at(LevelMeasure::ratio, 2.0, kStandard), 1e-4);
  EXPECT_NEAR(value_at(LevelMeasure::decibels, 20.0, kStandard), 5e-4, 1e-15);
  EXPECT_DOUBLE_EQ(value_at(LevelMeasure::value, 3e-5, kStandard), 3e-5);
}

TEST(Dimensions, ListLevelsInAscendingOrderWithTheirValues) {
  const Dimension dimension{
      .measure = LevelMeasure::percent, .list = {30, -10, 5}, .standard = 1e-4};
  EXPECT_THAT(dimension.levels(), testing::ElementsAre(-10.0, 5.0, 30.0));
  EXPECT_THAT(dimension.values(), testing::ElementsAre(9e-5, 1.05e-4, 1.3e-4));
  EXPECT_EQ(dimension.value_of(0.0), 1e-4);
  EXPECT_NEAR(dimension.level_of(2e-4), 100.0, 1e-9);
  EXPECT_FALSE(is_relative(LevelMeasure::value));
  EXPECT_TRUE(is_relative(LevelMeasure::difference));
  EXPECT_FALSE(needs_positive_standard(LevelMeasure::difference));
  EXPECT_TRUE(needs_positive_standard(LevelMeasure::decibels));
}

}  // namespace
}  // namespace asperity
