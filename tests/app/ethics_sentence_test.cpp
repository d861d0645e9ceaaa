// Holds the sentence for an ethics form, and the planned sample that it states, to curves that are given.

#include "app/power/curve/ethics_sentence.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/power/curve/result_tables.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// 10, 20 and 30 participants with these powers, of 1000 studies each.
PowerCurve curve_of(const std::string& test, const std::vector<double>& powers) {
  PowerCurve curve{.effect = "pairs.rougher.order=0.5", .family = "pairs", .test = test};
  std::vector<StudiesOfSize> studies{};
  for (const double power : powers) {
    studies.push_back(
        {.participants = 10 * static_cast<int>(studies.size() + 1),
         .significant = {.hits = static_cast<std::uint64_t>(std::lround(1000.0 * power)),
                         .trials = 1000}});
  }
  for (const PowerOfSize& size : monotone_power(studies)) {
    curve.sizes.push_back({.power = size, .studies = 1000});
  }
  return curve;
}

PlannedStudy study_of(std::vector<PowerCurve> curves) {
  return {.protocol = "pairs 1.0",
          .program = "Asperity 0.2.0",
          .assumptions = {{.name = "pairs.rougher.order",
                           .part = Assumption::Part::effect,
                           .value = 0.5,
                           .unit = "log-odds",
                           .source = "smallest effect of interest",
                           .meaning = "the preference for the second interval",
                           .tests = "order, side"},
                          {.name = "pairs.rougher.order_sd",
                           .part = Assumption::Part::effect_sd,
                           .value = 0.25,
                           .unit = "log-odds",
                           .source = "assumed"},
                          {.name = "pairs.rougher.lapses", .value = 0.02, .source = "assumed"}},
          .stated_effects = {"pairs.rougher.order"},
          .curves = std::move(curves),
          .runs = 1000,
          .rules = {.multiple = 4, .attrition = {.dropout = 0.1, .exclusion = 0.05}}};
}

// Between 0.7 at 20 and 0.9 at 30 the power .8 is at 25, 28 with rounds of 4; 28/0.855 is 32.7.
TEST(EthicsSentence, StatesAllThatAReviewerAsksFor) {
  PowerCurve of_other_family = curve_of("ratings", {0.1, 0.1, 0.1});
  of_other_family.family = "ratings";
  const std::string sentence = ethics_sentence(
      study_of({curve_of("order rough", {0.3, 0.7, 0.9}), curve_of("fit", {0.1, 0.1, 0.1}),
                curve_of("", {0.4, 0.8, 0.95}), of_other_family}),
      0.8);
  EXPECT_THAT(
      sentence,
      HasSubstr("A sample of 28 participants has a power of at least 80 % to detect "
                "pairs.rougher.order = 0.5 log-odds (the preference for the second interval; 0 "
                "without an effect; source: smallest effect of interest) with the test order rough "
                "at α = .05 (Holm-corrected over the 2 tests of the family pairs); the smallest "
                "number with this power is 25.0, 95 % Monte-Carlo CI ["));
  EXPECT_THAT(sentence,
              HasSubstr("], from 1000 simulated studies per number of participants (Asperity "
                        "0.2.0, protocol pairs 1.0, with its plan, procedures, exclusions and "
                        "analysis), rounded up to whole rounds of 4 participants; standard "
                        "deviations of the effects: pairs.rougher.order_sd = 0.25 log-odds "
                        "(source: assumed); further assumptions: 1, listed with their sources in "
                        "the table of assumptions; with a dropout of 10 % and an exclusion of 5 % "
                        "of the participants, 33 are recruited so that this number is reached on "
                        "average, or 36 so that it is reached with a probability of 90 %."));
}

// Of the tests that the effect concerns, the one that needs most participants; not the test that it does not concern.
TEST(EthicsSentence, IsAboutTheTestThatNeedsMostParticipants) {
  const PlannedStudy study =
      study_of({curve_of("order rough", {0.3, 0.7, 0.9}), curve_of("side", {0.3, 0.6, 0.85}),
                curve_of("fit", {0.1, 0.1, 0.1})});
  ASSERT_NE(deciding_curve(study, 0.8), nullptr);
  EXPECT_EQ(deciding_curve(study, 0.8)->test, "side");
  EXPECT_THAT(ethics_sentence(study, 0.8),
              HasSubstr("of the 2 tests that the effect concerns, the one that needs most "
                        "participants)"));
}

TEST(EthicsSentence, OfATestThatDoesNotReachThePowerStatesWhatItReaches) {
  const PlannedStudy study = study_of({curve_of("order", {0.3, 0.5, 0.62})});
  EXPECT_THAT(ethics_sentence(study, 0.8),
              HasSubstr("No simulated number of participants has a power of 80 % to detect"));
  EXPECT_THAT(ethics_sentence(study, 0.8),
              HasSubstr("(uncorrected, as the only test of its family): 30 participants have a "
                        "power of 62 %, 95 % Monte-Carlo CI [58.9 %, 65 %], in 1000"));
}

TEST(EthicsSentence, NamesLimitsOutsideTheSimulatedNumbers) {
  const PlannedStudy study = study_of({curve_of("order", {0.79, 0.8, 0.81})});
  EXPECT_THAT(ethics_sentence(study, 0.8),
              HasSubstr("is 20.0, 95 % Monte-Carlo CI [at most 10, above 30]"));
}

// The smallest simulated number has the power already: a smaller one may have it too.
TEST(EthicsSentence, DoesNotTakeTheFirstNumberForTheSmallestOne) {
  const PlannedStudy study = study_of({curve_of("order", {0.9, 0.95, 0.99})});
  EXPECT_THAT(ethics_sentence(study, 0.8),
              HasSubstr("the smallest number with this power is at most 10.0, 95 % Monte-Carlo CI "
                        "[at most 10, 10.0], from"));
}

// A test without an effect is significant in 5 % of the studies with any number of participants.
TEST(EthicsSentence, IsNotAboutEffectsThatAreAbsent) {
  PlannedStudy study =
      study_of({curve_of("order", {0.3, 0.7, 0.9}), curve_of("ratio", {0.05, 0.05, 0.05})});
  study.assumptions.push_back({.name = "pairs.rougher.ratio",
                               .part = Assumption::Part::effect,
                               .value = 1.0,
                               .null_value = 1.0,
                               .tests = "ratio"});
  study.stated_effects.emplace_back("pairs.rougher.ratio");
  ASSERT_NE(deciding_curve(study, 0.8), nullptr);
  EXPECT_EQ(deciding_curve(study, 0.8)->test, "order");
  EXPECT_THAT(ethics_sentence(study, 0.8), Not(HasSubstr("pairs.rougher.ratio")));
  // Where only it was stated, the sentence is about the others, which the file of assumptions states.
  study.stated_effects = {"pairs.rougher.ratio"};
  EXPECT_EQ(deciding_curve(study, 0.8)->test, "order");
}

TEST(EthicsSentence, OfObserversStatesThatTheyDoNotDiffer) {
  PlannedStudy study = study_of({curve_of("order", {0.3, 0.7, 0.9})});
  study.assumptions.clear();
  study.stated_effects.clear();
  study.is_on_physics = true;
  EXPECT_THAT(
      ethics_sentence(study, 0.8),
      AllOf(
          HasSubstr("to detect the effect that the stimuli of the protocol have on its virtual "
                    "observers, who feel them on the full physics, with the test order"),
          HasSubstr("no effect differs between participants, as effects on human participants do"),
          Not(HasSubstr("assumptions"))));
}

TEST(EthicsSentence, WithoutATestIsEmpty) {
  EXPECT_EQ(ethics_sentence(study_of({}), 0.8), "");
  EXPECT_EQ(deciding_curve(study_of({curve_of("", {0.9})}), 0.8), nullptr);
}

TEST(EthicsSentence, WithoutLossesNamesNone) {
  PlannedStudy study = study_of({curve_of("order", {0.3, 0.7, 0.9})});
  study.rules = {};
  EXPECT_THAT(ethics_sentence(study, 0.8), Not(HasSubstr("recruited")));
  EXPECT_THAT(ethics_sentence(study, 0.8), Not(HasSubstr("whole rounds")));
  EXPECT_THAT(ethics_sentence(study, 0.8), HasSubstr("A sample of 25 participants"));
}

TEST(EthicsSentence, MarksEffectsOfAPilot) {
  Assumption effect{.part = Assumption::Part::effect, .source = "pilot of 8 participants"};
  EXPECT_TRUE(is_from_pilot(effect));
  effect.source = "smallest effect of interest";
  EXPECT_FALSE(is_from_pilot(effect));
  EXPECT_FALSE(is_from_pilot({.part = Assumption::Part::effect_sd, .source = "pilot"}));
}

TEST(SampleTable, HasARowForEachPowerWithItsStatus) {
  const Table table =
      sample_table(std::vector{curve_of("order", {0.3, 0.7, 0.9})},
                   {.multiple = 4, .attrition = {.dropout = 0.1, .exclusion = 0.05}});
  ASSERT_EQ(table.rows.size(), 2U);
  const std::vector<Cell>& of_80 = table.rows[0];
  EXPECT_EQ(of_80[3], Cell(0.8));
  EXPECT_EQ(of_80[4], Cell(std::string("ok")));
  EXPECT_EQ(of_80[5], Cell(25.0));
  EXPECT_THAT(std::vector(of_80.begin() + 8, of_80.end()),
              ElementsAre(Cell(std::int64_t{28}), Cell(std::int64_t{33}), Cell(std::int64_t{36})));
  const std::vector<Cell>& of_90 = table.rows[1];
  EXPECT_EQ(of_90[5], Cell(30.0));
  EXPECT_EQ(of_90[7], Cell{});  // the lower limit does not reach .9 within the sizes
}

}  // namespace
}  // namespace asperity
