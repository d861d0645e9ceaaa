// The gates in small: some two hundred trials of each kind, judged by exact intervals.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/magnitude/magnitude_analysis.h"
#include "protocols/observer/virtual_observer.h"
#include "tests/app/stored_tables.h"
#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

// With two hundred trials an exact interval is wider than the gate; chance has to lie in it.
constexpr double kNoMargin = 1.0;
// Enough to be judged: 2.5 s of contact are 150 mm, and 51 mm give features.
constexpr int kFewStrokes = 2;

TEST(DeafObserver, AnswersByChanceInEveryKind) {
  SimulatedStudy study;
  const GateCounts selection =
      study.run({"chapter_selection", GateObserver::deaf, 8, 3, {101}, kFewStrokes});
  EXPECT_EQ(selection.trials, 72U);
  expect_no_model_preferred(selection, kNoMargin);
  expect_all_marked_as_guesses(selection);

  const GateCounts matching =
      study.run({"improved_matching", GateObserver::deaf, 24, 3, {102}, kFewStrokes});
  EXPECT_EQ(matching.trials, 72U);
  expect_items_by_chance(matching, 4, kNoMargin);
  expect_by_chance("matched wholly", {matching.whole, matching.trials}, whole_chance(4), kNoMargin);
  expect_all_marked_as_guesses(matching);

  const GateCounts recognition =
      study.run({"improved_recognition", GateObserver::deaf, 5, 4, {103}, kFewStrokes});
  EXPECT_EQ(recognition.trials, 80U);
  expect_by_chance("recognised", {recognition.right, recognition.trials}, 1.0 / 6.0, kNoMargin);
  expect_all_marked_as_guesses(recognition);

  const GateCounts tools =
      study.run({"tools_matching", GateObserver::deaf, 6, 1, {107}, kFewStrokes});
  EXPECT_EQ(tools.trials, 6U);
  expect_items_by_chance(tools, 3, kNoMargin);
  expect_all_marked_as_guesses(tools);
}

/// p of the analysis of variance, by effect, of eight people who give numbers for two conditions and
/// four spacings, three times each. The coarser a surface is, the more it shakes the tool.
std::map<std::string, double> effects_in_a_study(const ObserverDeclaration& declared,
                                                 const Random& study) {
  constexpr std::array kSpacings{"0.001", "0.002", "0.003", "0.004"};
  constexpr std::array kConditions{"large", "small"};
  GatheredAnswers gathered{};
  gathered.kind = "magnitude";
  gathered.estimation = {.spacing = "texture", .condition = "tip"};
  gathered.words.place("");
  for (std::uint32_t person = 0; person < 8; ++person) {
    gathered.people.push_back({.label = "P" + std::to_string(person)});
    const Random of_person = study.split(person);
    const NumberHabit habit = number_habit_of(of_person.split("numbers"));
    for (std::uint64_t trial = 0; trial < 24; ++trial) {
      const std::uint64_t spacing = trial % 4;
      const std::uint64_t condition = trial / 4 % 2;
      ForceFeatures felt{};
      felt.shaking_m_per_s2 = 1.0 + static_cast<double>(spacing) + static_cast<double>(condition);
      VirtualObserver observer(declared, of_person.split("trial").split(trial));
      GatheredAnswer answer{.person = person, .reply_count = 1};
      answer.factors = static_cast<std::uint32_t>(gathered.factor_levels.size());
      gathered.factor_levels.push_back({{"tip", gathered.words.place(kConditions.at(condition))},
                                        {"texture", gathered.words.place(kSpacings.at(spacing))}});
      answer.first_reply = gathered.replies.size();
      gathered.replies.push_back(
          {gathered.words.place(number_text(observer.estimate(felt, habit))), {}});
      gathered.answers.push_back(answer);
    }
  }
  AnalysisOutcome outcome{};
  analyze_magnitude(gathered, outcome);
  std::map<std::string, double> effects{};
  for (const ResultTable& each : outcome.tables) {
    const StoredTable named = stored(each);
    if (named.name != "anova") continue;
    for (const auto& row : named.table.rows) {
      effects[std::get<std::string>(row.at(0))] = std::get<double>(row.at(5));
    }
  }
  return effects;
}

// Whoever is deaf says numbers that have nothing to do with the surface: each effect is found in one
// study of twenty. Epsilon makes the test of the interaction careful, and what is careful finds less.
TEST(DeafObserver, GivesNumbersInWhichAnEffectIsFoundByChanceOnly) {
  ObserverDeclaration declared{.deaf = true};
  declared.magnitude_of = ObserverDeclaration::MagnitudeOf::held_tool;
  constexpr std::uint64_t kStudies = 400;
  std::map<std::string, std::size_t> found{{"condition", 0}, {"spacing", 0}, {"interaction", 0}};
  for (std::uint64_t i = 0; i < kStudies; ++i) {
    const std::map<std::string, double> effects = effects_in_a_study(declared, Random(i));
    ASSERT_EQ(effects.size(), found.size());
    for (const auto& [effect, p] : effects) found.at(effect) += p < 0.05 ? 1 : 0;
  }
  for (const auto& [effect, times] : found) {
    expect_by_chance("deaf numbers: " + effect, {times, kStudies}, 0.05, kGateMargin);
  }

  declared.deaf = false;
  for (const auto& [effect, p] : effects_in_a_study(declared, Random(1))) {
    EXPECT_LT(p, 0.05) << "who is not deaf shows the effect of " << effect;
  }
}

TEST(NoiselessObserver, GetsMostItemsRightOnTexturesWithKnownHeights) {
  SimulatedStudy study;
  expect_most_items_right(
      "matched", study.run({"improved_matching", GateObserver::noiseless, 24, 2, {104}, {}}));
  expect_most_items_right(
      "recognised", study.run({"improved_recognition", GateObserver::noiseless, 10, 5, {105}, {}}));
  // Expected are the same bodies, felt by another hand.
  expect_every_item_right(
      "matched tools",
      study.run({"tools_matching", GateObserver::noiseless, 3, 1, {106}, kFewStrokes}));
}

}  // namespace
}  // namespace asperity
