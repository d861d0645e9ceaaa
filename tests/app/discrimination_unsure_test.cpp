// Discriminations with the response "cannot tell": splits, rates, intervals, and tracks that are run again.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/unforced_bootstrap.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/outcome/found_numbers.h"
#include "protocols/file/stored_protocol.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// The response "cannot tell" instead of a choice.
MadeUpTrial unsure_at(double value_m, bool comparison_first) {
  MadeUpTrial trial = discriminated({.value_m = value_m, .comparison_first = comparison_first});
  trial.answers = {"cannot_tell"};
  return trial;
}

/// The responses of a performer whose guesses are replaced by "cannot tell" where the difference is not perceived:
/// ψ = D + (1 − D)/2 without lapses. `replaced`: the proportion of guesses.
std::vector<MadeUpTrial> unforced_trials(double replaced, int per_level, std::uint64_t seed) {
  std::vector<MadeUpTrial> trials{};
  Random random(seed);
  for (const double value_m : kAbove_m) {
    for (int i = 0; i < per_level; ++i) {
      const double perceived = 1.0 - std::exp(-std::pow((value_m - kStandard_m) / 10e-6, 2.0));
      const bool perceives = random.uniform() < perceived;
      const bool guesses_well = random.uniform() < 0.5;
      const bool first = i % 2 == 0;
      MadeUpTrial trial = !perceives && random.uniform() < replaced
                              ? unsure_at(value_m, first)
                              : discriminated({.value_m = value_m,
                                               .chose_comparison = perceives || guesses_well,
                                               .comparison_first = first});
      trial.options = {"standard", "comparison", "cannot_tell"};
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

AnalysisOutcome outcome_of_unforced(const std::vector<std::vector<MadeUpTrial>>& people,
                                    const std::string& judgement = "performance") {
  return analysed("discrimination", discrimination_protocol(judgement).dump(), {.first = 1},
                  people);
}

TEST(DiscriminationWithCannotTell, CountsHalfAHitPerResponseWithTwoAlternatives) {
  std::vector<MadeUpTrial> trials{};
  for (int i = 0; i < 8; ++i) {
    trials.push_back(discriminated(
        {.value_m = 55e-6, .chose_comparison = i < 4, .comparison_first = i % 2 == 0}));
    trials.push_back(discriminated(
        {.value_m = 65e-6, .chose_comparison = i < 7, .comparison_first = i % 2 == 0}));
  }
  trials[0] = unsure_at(55e-6, true);   // was a choice of the comparison
  trials[14] = unsure_at(55e-6, true);  // was a choice of the standard
  const AnalysisOutcome outcome = outcome_of_unforced({trials});
  const Table& levels = table_of(outcome, "psychometric").table;
  const auto cell = [&levels](std::size_t row, const char* column) {
    return *number_of(levels.rows[row][*column_of(levels, column)]);
  };
  EXPECT_EQ(cell(0, "responses"), 8.0);
  EXPECT_EQ(cell(0, "unsure"), 2.0);
  EXPECT_EQ(cell(0, "hits"), 4.0) << "3 hits and 2 halves";
  EXPECT_EQ(cell(0, "share"), 0.5);
  EXPECT_EQ(cell(1, "hits"), 7.0);
  const Table& rates = table_of(outcome, "cannot_tell").table;
  ASSERT_EQ(rates.rows.size(), 1U);
  EXPECT_EQ(rates.rows[0][*column_of(rates, "unsure")], Cell(std::int64_t{2}));
  EXPECT_EQ(rates.rows[0][*column_of(rates, "of")], Cell(std::int64_t{16}));
  EXPECT_EQ(rates.rows[0][*column_of(rates, "share")], Cell(0.125));
  const std::vector<Finding> findings = part_of(outcome, "cannot_tell");
  const FoundNumbers found(findings);
  EXPECT_EQ(found.value("rate", "p1|all"), 0.125);
  ASSERT_FALSE(outcome.remarks.empty());
  EXPECT_THAT(outcome.remarks.back().english(), HasSubstr("2 of 16 responses are “cannot tell”"));
}

TEST(DiscriminationWithCannotTell, ReportsARateOfZeroForAParticipantWithoutOne) {
  const AnalysisOutcome outcome =
      outcome_of_unforced({unforced_trials(1.0, 20, 1), unforced_trials(0.0, 20, 2)});
  const Table& rates = table_of(outcome, "cannot_tell").table;
  ASSERT_EQ(rates.rows.size(), 2U);
  EXPECT_GT(*number_of(rates.rows[0][*column_of(rates, "share")]), 0.2);
  EXPECT_EQ(rates.rows[1][*column_of(rates, "unsure")], Cell(std::int64_t{0}));
}

TEST(DiscriminationWithCannotTell, HasNoSuchTableWhereEveryResponseIsAChoice) {
  const AnalysisOutcome outcome = outcome_of_unforced({unforced_trials(0.0, 20, 2)});
  EXPECT_THROW(table_of(outcome, "cannot_tell"), std::runtime_error);
  const Table& levels = table_of(outcome, "psychometric").table;
  EXPECT_FALSE(column_of(levels, "unsure"));
}

// ψ(x) = ½ + ½·(1 − exp(−(x/10 µm)²)) has 75 % at 10 µm·√ln 2 = 8.33 µm, whichever proportion of guesses is replaced.
TEST(DiscriminationWithCannotTell, EstimatesTheThresholdOfAParticipantWhoGuesses) {
  for (const double replaced : {0.5, 1.0}) {
    SCOPED_TRACE(replaced);
    const AnalysisOutcome outcome = outcome_of_unforced({unforced_trials(replaced, 400, 7)});
    const std::vector<Finding> findings = part_of(outcome, "thresholds");
    const FoundNumbers found(findings);
    const Finding* const jnd = found.find("jnd", "p1|all");
    ASSERT_NE(jnd, nullptr);
    ASSERT_TRUE(jnd->value && jnd->low && jnd->high) << jnd->status;
    EXPECT_NEAR(*jnd->value, 8.326e-6, 0.6e-6);
    EXPECT_LT(*jnd->low, *jnd->value);
    EXPECT_GT(*jnd->high, *jnd->value);
    EXPECT_LT(*jnd->high - *jnd->low, 2e-6);
    EXPECT_THAT(jnd->method, HasSubstr("three outcomes"));
    EXPECT_FALSE(FoundNumbers(part_of(outcome, "psychometric")).value("deviance", "p1|all"));
  }
}

// Half a hit for each response: the order effect is that of 5 and 1 choices of 8, with two halves in each position.
TEST(DiscriminationWithCannotTell, SplitsResponsesInTheOrderEffect) {
  std::vector<MadeUpTrial> trials{};
  for (int i = 0; i < 16; ++i) {
    const bool first = i < 8;
    const int place = i % 8;
    trials.push_back(place < 2 ? unsure_at(55e-6, first)
                               : discriminated({.value_m = place % 2 == 0 ? 55e-6 : 65e-6,
                                                .chose_comparison = place < (first ? 7 : 3),
                                                .comparison_first = first}));
  }
  const AnalysisOutcome outcome = outcome_of_unforced({trials, trials});
  const Table& order = table_of(outcome, "order").table;
  EXPECT_DOUBLE_EQ(*number_of(order.rows[0][*column_of(order, "share_first")]), 6.0 / 8.0);
  EXPECT_DOUBLE_EQ(*number_of(order.rows[0][*column_of(order, "share_second")]), 2.0 / 8.0);
}

TEST(DiscriminationWithCannotTell, EstimatesThePointOfSubjectiveEqualityOfAComparison) {
  std::vector<MadeUpTrial> trials{};
  Random random(5);
  for (const double value_m : kAround_m) {
    for (int i = 0; i < 200; ++i) {
      const double felt_m = value_m - 54e-6 +
                            6e-6 *
                                (random.uniform() + random.uniform() + random.uniform() +
                                 random.uniform() + random.uniform() + random.uniform() - 3.0) *
                                std::sqrt(2.0);
      const bool first = i % 2 == 0;
      MadeUpTrial trial = std::abs(felt_m) < 2e-6 ? unsure_at(value_m, first)
                                                  : discriminated({.value_m = value_m,
                                                                   .chose_comparison = felt_m > 0.0,
                                                                   .comparison_first = first,
                                                                   .is_performance = false});
      trial.right.clear();
      trials.push_back(std::move(trial));
    }
  }
  const AnalysisOutcome outcome = outcome_of_unforced({trials}, "comparison");
  const std::vector<Finding> findings = part_of(outcome, "thresholds");
  const FoundNumbers found(findings);
  const Finding* const pse = found.find("pse", "p1|all");
  const Finding* const jnd = found.find("jnd", "p1|all");
  ASSERT_TRUE(pse != nullptr && pse->value && pse->low && pse->high);
  EXPECT_NEAR(*pse->value, 54e-6, 0.8e-6);
  EXPECT_LT(*pse->low, 54e-6 + 0.8e-6);
  EXPECT_LT(*pse->high - *pse->low, 3e-6);
  ASSERT_TRUE(jnd != nullptr && jnd->value && jnd->low && jnd->high);
  EXPECT_GT(*jnd->low, 2e-6);
  EXPECT_LT(*jnd->high, 7e-6);
}

/// Weighted up-down to 75 % with the option "cannot tell".
json unforced_protocol(int trials) {
  json protocol = discrimination_protocol("performance");
  json& block = protocol["blocks"]["only"];
  block["vary"].erase("levels");
  block["vary"]["levels_percent"] = {{"lowest", 2}, {"highest", 100}, {"step", 2}};
  block["procedure"] = {{"method", "weighted_up_down"},
                        {"start", 50},
                        {"steps", {4}},
                        {"stop", {{"trials", trials}}}};
  block["question"]["allow_cannot_tell"] = true;
  return protocol;
}

TEST(DiscriminationWithCannotTell, EstimatesThresholdsOfTheUnforcedWeightedUpDown) {
  const json protocol = unforced_protocol(120);
  const Protocol::Block block = stored_protocol(protocol.dump()).protocol.blocks.at("only");
  ASSERT_EQ(block.procedure->tracks.size(), 1U);
  const OutcomeOfObserver observer = [&](double level, Random& random) {
    const double x = block.vary->value_of(level) - kStandard_m;
    if (random.uniform() < 1.0 - std::exp(-std::pow(x / 10e-6, 2.0))) return LevelOutcome::correct;
    if (random.uniform() < 0.7) return LevelOutcome::unsure;
    return forced_outcome(random.uniform() < 0.5);
  };
  std::vector<MadeUpTrial> trials{};
  int step = 0;
  for (const LevelAnswer& answer :
       simulated_track(level_rule(block.procedure->tracks.front()), observer, Random(11))) {
    const double value_m = block.vary->value_of(answer.level);
    const bool first = step % 2 == 0;
    MadeUpTrial trial =
        answer.outcome == LevelOutcome::unsure
            ? unsure_at(value_m, first)
            : discriminated({.value_m = value_m,
                             .chose_comparison = answer.outcome == LevelOutcome::correct,
                             .comparison_first = first});
    trial.track = 1;
    trial.step = ++step;
    trials.push_back(std::move(trial));
  }
  ASSERT_EQ(trials.size(), 120U);
  const AnalysisOutcome outcome =
      outcome_of_choices(protocol, {.first = 1}, [&](int) { return trials; });
  const std::vector<Finding> findings = part_of(outcome, "thresholds");
  const FoundNumbers found(findings);
  const Finding* const jnd = found.find("jnd", "p1|all");
  ASSERT_TRUE(jnd != nullptr && jnd->value) << (jnd == nullptr ? "none" : jnd->status);
  EXPECT_NEAR(*jnd->value, 8.326e-6, 3e-6);
  ASSERT_TRUE(jnd->low && jnd->high);
  EXPECT_LT(*jnd->low, 8.326e-6);
  EXPECT_GT(*jnd->high, 8.326e-6);
  EXPECT_FALSE(found.find("unfinished.tracks", "p1|all")) << "the track is understood as finished";
}

TEST(DiscriminationWithCannotTell, RunsTracksAgainWithTheHitsOfTheFunction) {
  const Protocol::Block block =
      stored_protocol(unforced_protocol(400).dump()).protocol.blocks.at("only");
  DiscriminationTask task = *discrimination_task("only", block);
  PlacedTrials placed{.fixed = {{55e-6, 20000}}, .alternatives = 2, .unsure_share = 0.6};
  const PsychometricFunction observer{
      .shape = PsychometricShape::weibull, .alpha = 8e-6, .beta = 2.0, .gamma = 0.5, .lambda = 0.0};
  const std::vector<PsychometricBlock> blocks = run_again(task, placed, observer, Random(3));
  ASSERT_EQ(blocks.size(), 1U);
  const double psi = observer.value(5e-6);
  EXPECT_NEAR(hits_of(blocks[0]) / 20000.0, psi, 0.01);
  // P(cannot tell) = 0.6·(1 − ψ)·2, of which half are hits.
  EXPECT_NEAR(blocks[0].guessed_hits / 20000.0, 0.6 * (1.0 - psi), 0.01);
  // The proportion is found again: of 100 responses 12 are incorrect, and 36/2 of 36 are errors in expectation.
  EXPECT_DOUBLE_EQ(unsure_share_of_errors({.hits = 52, .trials = 100, .unsure = 36}, 2), 0.6);
  EXPECT_EQ(unsure_share_of_errors({.hits = 52, .trials = 100}, 2), 0.0);
}

}  // namespace
}  // namespace asperity
