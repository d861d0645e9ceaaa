// Discriminations in which one of three surfaces is chosen: plans, tracks, what a file cannot ask, and the virtual observer.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/proportion.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ThreeJson = nlohmann::json;
using ::testing::HasSubstr;

constexpr double kStandardOfThree_m = 50e-6;
constexpr std::array kDesignsOfThree{"three_alternatives", "oddity"};

ThreeJson& block_of_three(ThreeJson& protocol) { return protocol["blocks"]["comparisons"]; }

/// amplitude_jnd, with its staircases, and another design.
ThreeJson tracks_of_three(const std::string& design) {
  ThreeJson protocol = test::without_practice(test::library_file("amplitude_jnd"));
  block_of_three(protocol)["design"] = design;
  return protocol;
}

/// Five levels, 30 trials with balanced positions.
ThreeJson constant_of_three(const std::string& design) {
  ThreeJson protocol = tracks_of_three(design);
  ThreeJson& block = block_of_three(protocol);
  block.erase("procedure");
  block["vary"]["levels_percent"] = {5, 10, 20, 30, 50};
  block["repetitions"] = design == "oddity" ? 3 : 6;
  block["positions"] = "balanced";
  return protocol;
}

double amplitude_of_surface(const PlannedPresentation& planned) {
  return std::get<double>(planned.stimulus.parameters.at("amplitude_m"));
}

std::size_t comparisons_in(const Trial& trial) {
  return static_cast<std::size_t>(
      std::count_if(trial.presentations.begin(), trial.presentations.end(),
                    [](const auto& planned) { return planned.role == "comparison"; }));
}

/// The place of the surface whose item is the correct response; all others have the other amplitude.
std::size_t place_of_correct(const Trial& trial) {
  const std::string correct = trial.questions.front().correct.at(0);
  std::vector<std::size_t> places{};
  for (std::size_t i = 0; i < trial.presentations.size(); ++i) {
    if (trial.presentations[i].item == correct) places.push_back(i);
  }
  EXPECT_EQ(places.size(), 1U) << "items are unique";
  const double own_m = amplitude_of_surface(trial.presentations[places.at(0)]);
  for (std::size_t i = 0; i < trial.presentations.size(); ++i) {
    if (i == places[0]) continue;
    EXPECT_NE(amplitude_of_surface(trial.presentations[i]), own_m);
  }
  return places[0];
}

TEST(ChoiceOfThree, PresentsTheCorrectSurfaceAtEveryPlaceEquallyOften) {
  for (const char* const design : kDesignsOfThree) {
    SCOPED_TRACE(design);
    std::map<std::size_t, int> by_place{};
    std::map<std::string, std::map<std::size_t, int>> by_level{};
    for (const Trial& trial : test::main_trials(test::valid(constant_of_three(design)))) {
      ASSERT_EQ(trial.presentations.size(), 3U);
      EXPECT_EQ(trial.questions.front().options.size(), 3U);
      ++by_place[place_of_correct(trial)];
      ++by_level[text_of(trial.factors.at("amplitude_m"))][place_of_correct(trial)];
    }
    EXPECT_EQ(by_place, (std::map<std::size_t, int>{{0, 10}, {1, 10}, {2, 10}}));
    ASSERT_EQ(by_level.size(), 5U);
    for (const auto& [level, places] : by_level) {
      EXPECT_EQ(places, (std::map<std::size_t, int>{{0, 2}, {1, 2}, {2, 2}})) << level;
    }
  }
}

TEST(ChoiceOfThree, HasTheComparisonAsTheCorrectResponseOfThreeAlternatives) {
  for (const Trial& trial :
       test::main_trials(test::valid(constant_of_three("three_alternatives")))) {
    EXPECT_EQ(comparisons_in(trial), 1U);
    EXPECT_EQ(trial.questions.front().correct, std::vector<std::string>{"comparison"});
  }
}

TEST(ChoiceOfThree, HasBothTypesOfOddityTrialsEquallyOften) {
  int of_comparison = 0;
  int of_standard = 0;
  for (const Trial& trial : test::main_trials(test::valid(constant_of_three("oddity")))) {
    const bool is_comparison_odd = comparisons_in(trial) == 1;
    EXPECT_EQ(trial.questions.front().correct.at(0), is_comparison_odd ? "comparison" : "standard");
    ++(is_comparison_odd ? of_comparison : of_standard);
  }
  EXPECT_EQ(of_comparison, 15);
  EXPECT_EQ(of_standard, 15);
}

TEST(ChoiceOfThree, BalancesPositionsAndTypesInEveryTrack) {
  for (const char* const design : kDesignsOfThree) {
    SCOPED_TRACE(design);
    ThreeJson file = tracks_of_three(design);
    file["blocks"]["comparisons"]["positions"] = "balanced";
    const Protocol protocol = test::valid(file);
    const std::size_t types = find_design(design)->trials.size();
    std::map<int, std::vector<Trial>> by_track{};
    for (const Trial& trial : test::main_trials(protocol)) {
      if (trial.track) by_track[trial.track->track].push_back(trial);
    }
    EXPECT_EQ(by_track.size(), protocol.blocks.at("comparisons").procedure->tracks.size())
        << "types of trials have no tracks of their own";
    for (const auto& [track, trials] : by_track) {
      std::map<std::size_t, std::size_t> by_place{};
      std::map<std::size_t, std::size_t> by_type{};
      for (std::size_t i = 0; i < trials.size() / 6 * 6; ++i) {
        ++by_place[place_of_correct(trials[i])];
        ++by_type[comparisons_in(trials[i])];
      }
      for (std::size_t place = 0; place < 3; ++place) {
        EXPECT_EQ(by_place[place], trials.size() / 6 * 2) << track;
      }
      ASSERT_EQ(by_type.size(), types);
      for (const auto& [comparisons, count] : by_type) {
        EXPECT_EQ(count, trials.size() / 6 * 6 / types) << comparisons;
      }
    }
  }
}

TEST(ChoiceOfThree, CountsItsRowsAsItMakesThem) {
  for (const char* const design : kDesignsOfThree) {
    for (const ThreeJson& file : {constant_of_three(design), tracks_of_three(design)}) {
      const Protocol protocol = test::valid(file);
      const Protocol::Block& block = protocol.blocks.at("comparisons");
      EXPECT_EQ(row_count(protocol, block), rows_of(protocol, block).size());
    }
  }
}

TEST(ChoiceOfThree, IsStatedInTheDesignOfTheBlock) {
  const auto stated = [](const std::string& design) {
    const Protocol protocol = test::valid(constant_of_three(design));
    return design_of(protocol, protocol.blocks.at("comparisons"), make_plan(protocol, {1, 0}))
        .english();
  };
  EXPECT_THAT(stated("three_alternatives"),
              HasSubstr("three-alternative forced choice, one surface after the other"));
  EXPECT_THAT(stated("three_alternatives"), HasSubstr("5 levels × 6 presentations"));
  EXPECT_THAT(stated("oddity"), HasSubstr("oddity task"));
  EXPECT_THAT(stated("oddity"), HasSubstr("5 levels × 6 presentations"));
}

TEST(ChoiceOfThree, CanLieSideBySide) {
  ThreeJson file = constant_of_three("oddity");
  block_of_three(file)["arrangement"] = {{"surfaces", "side_by_side"}};
  file["environment"].erase("scene");
  for (const Trial& trial : test::main_trials(test::valid(file))) {
    EXPECT_LT(trial.presentations[0].patch.centre_m.x, trial.presentations[1].patch.centre_m.x);
    EXPECT_LT(trial.presentations[1].patch.centre_m.x, trial.presentations[2].patch.centre_m.x);
  }
}

ThreeJson psi_of_three(const std::string& design) {
  ThreeJson file = tracks_of_three(design);
  block_of_three(file)["procedure"] = {{"method", "psi"}, {"stop", {{"trials", 12}}}};
  return file;
}

TEST(ChoiceOfThree, DeterminesTheGuessRateOfAPriorAndItsTarget) {
  const auto prior_of = [](const std::vector<ProcedureSettings>& tracks) {
    return posterior_track_of(tracks.at(0))->prior;
  };
  for (const char* const design : kDesignsOfThree) {
    const ThreeJson file = psi_of_three(design);
    const Protocol protocol = test::valid(file);
    for (const ThresholdPrior& prior :
         {prior_of(protocol.blocks.at("comparisons").procedure->tracks),
          prior_of(
              stored_protocol(file.dump()).protocol.blocks.at("comparisons").procedure->tracks)}) {
      EXPECT_DOUBLE_EQ(prior.guess_rate, 1.0 / 3.0) << design;
      EXPECT_DOUBLE_EQ(prior.performance, 2.0 / 3.0) << design;
    }
  }
  const ThresholdPrior of_two = prior_of(
      test::valid(psi_of_three("two_alternatives")).blocks.at("comparisons").procedure->tracks);
  EXPECT_EQ(of_two.guess_rate, 0.5);
  EXPECT_EQ(of_two.performance, 0.75);
}

struct FaultOfThree {
  const char* design = "";
  const char* pointer = "";
  const char* message = "";
  std::function<void(ThreeJson& protocol)> change{};
};

TEST(ChoiceOfThree, RefusesWhatItCannotAsk) {
  const std::vector<FaultOfThree> faults{
      {"three_alternatives", "/blocks/comparisons/question/judgement",
       "in a three-alternative forced choice one response is correct",
       [](ThreeJson& p) { block_of_three(p)["question"]["judgement"] = "comparison"; }},
      {"oddity", "/blocks/comparisons/question/options",
       "in an oddity task the options are the surfaces felt",
       [](ThreeJson& p) {
         block_of_three(p)["question"]["options"] = {{{"value", "a"}, {"text", "A"}},
                                                     {{"value", "b"}, {"text", "B"}}};
       }},
      {"oddity", "/blocks/comparisons/presented", "the same surface would always be presented",
       [](ThreeJson& p) { block_of_three(p).erase("positions"); }},
      {"oddity", "/blocks/comparisons/positions", "need a multiple of 3 trials",
       [](ThreeJson& p) { block_of_three(p)["repetitions"] = 2; }},
      {"oddity", "/blocks/comparisons/arrangement/gap_m", "the patches would be",
       [](ThreeJson& p) {
         block_of_three(p)["arrangement"] = {{"surfaces", "side_by_side"}, {"gap_m", 0.045}};
       }},
      {"three_alternatives", "/blocks/comparisons/question/allow_cannot_tell",
       "the analysis of a three-alternative forced choice needs a choice in every trial",
       [](ThreeJson& p) { block_of_three(p)["question"]["allow_cannot_tell"] = true; }}};
  for (const FaultOfThree& fault : faults) {
    SCOPED_TRACE(fault.message);
    ThreeJson protocol = constant_of_three(fault.design);
    fault.change(protocol);
    EXPECT_THAT(test::problems_at(protocol, fault.pointer), HasSubstr(fault.message));
  }
}

struct JudgedCounts {
  HitCount correct{};
  std::array<int, 3> chosen{};
};

/// An observer whose magnitude is proportional to the amplitude.
JudgedCounts judged_of_three(const Protocol& protocol, std::uint64_t seed) {
  const ExperimentKind& kind = kind_named("discrimination");
  VirtualObserver observer(protocol.observer, Random(seed));
  JudgedCounts counts{};
  for (const Trial& trial : test::main_trials(protocol)) {
    std::vector<ForceFeatures> felt{};
    for (const PlannedPresentation& planned : trial.presentations) {
      felt.push_back(
          {.size = std::log(amplitude_of_surface(planned) / kStandardOfThree_m), .roughness = 0.0});
    }
    const Expectations none{};
    const Question& question = trial.questions.front();
    const VirtualResponse response = kind.judge({.protocol = protocol,
                                                 .trial = trial,
                                                 .question = question,
                                                 .felt = felt,
                                                 .expectations = none,
                                                 .observer = observer,
                                                 .of_attempt = Random(seed),
                                                 .of_participant = Random(seed)});
    const std::size_t option = std::get<ChosenOption>(response.answer).option;
    ++counts.chosen.at(option);
    ++counts.correct.trials;
    counts.correct.hits += question.options.at(option).value == question.correct.at(0) ? 1 : 0;
  }
  return counts;
}

/// With levels of one relative difference of the amplitudes, in percent.
Protocol observed_protocol(const std::string& design, double percent, double noise) {
  ThreeJson file = constant_of_three(design);
  file["observer"]["magnitude_of"] = "normal_force";
  file["observer"]["feature_noise"] = noise;
  file["observer"]["lapse"] = 0.0;
  block_of_three(file)["vary"]["levels_percent"] = {percent};
  block_of_three(file)["repetitions"] = design == "oddity" ? 300 : 600;
  return test::valid(file);
}

TEST(ChoiceOfThree, IsJudgedWithoutErrorByANoiselessObserver) {
  for (const char* const design : kDesignsOfThree) {
    for (const double percent : {5.0, -5.0}) {
      const JudgedCounts counts = judged_of_three(observed_protocol(design, percent, 0.0), 1);
      EXPECT_EQ(counts.correct.hits, counts.correct.trials) << design << ' ' << percent;
    }
  }
}

// A proportion of 600 trials is within 3.29 standard errors of the expected one with a probability of 99.9 %.
TEST(ChoiceOfThree, IsJudgedByTheRuleOfTheDesign) {
  constexpr double kNoise = 0.2;
  for (const char* const design : kDesignsOfThree) {
    const Protocol protocol = observed_protocol(design, 30.0, kNoise);
    const JudgedCounts counts = judged_of_three(protocol, 2);
    const double expected =
        correct_proportion(protocol.observer, std::log(1.3), *find_design(design));
    EXPECT_GT(expected, 0.4) << "above chance";
    EXPECT_LT(expected, 0.9) << "below certainty";
    EXPECT_NEAR(proportion(counts.correct), expected,
                3.29 * std::sqrt(expected * (1.0 - expected) / 600.0))
        << design;
  }
}

TEST(ChoiceOfThree, IsGuessedByADeafObserver) {
  for (const char* const design : kDesignsOfThree) {
    Protocol protocol = observed_protocol(design, 50.0, 0.0);
    protocol.observer.deaf = true;
    const JudgedCounts counts = judged_of_three(protocol, 3);
    const double error = std::sqrt(2.0 / 9.0 / 600.0);
    EXPECT_NEAR(proportion(counts.correct), 1.0 / 3.0, 3.29 * error) << design;
    for (const int chosen : counts.chosen) EXPECT_NEAR(chosen / 600.0, 1.0 / 3.0, 3.29 * error);
  }
}

TEST(ChoiceOfThree, ShowsABiasForTheFirstPosition) {
  for (const char* const design : kDesignsOfThree) {
    Protocol protocol = observed_protocol(design, 5.0, 0.2);
    protocol.observer.position_bias = 0.2;
    const JudgedCounts counts = judged_of_three(protocol, 4);
    EXPECT_GT(counts.chosen[0], counts.chosen[1] + 60) << design;
    EXPECT_GT(counts.chosen[0], counts.chosen[2] + 60) << design;
  }
}

}  // namespace
}  // namespace asperity
