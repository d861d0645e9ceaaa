// Holds the statement for an ethics form, and the planned sample that it states, to curves that are given.

#include "app/power/curve/ethics_statement.h"

#include <cmath>
#include <cstdint>
#include <regex>
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
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

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
                           .source = "assumed",
                           .meaning = "SD over participants"},
                          {.name = "pairs.rougher.lapses", .value = 0.02, .source = "assumed"}},
          .stated_effects = {"pairs.rougher.order"},
          .curves = std::move(curves),
          .runs = 1000,
          .rules = {.multiple = 4, .attrition = {.dropout = 0.1, .exclusion = 0.05}}};
}

constexpr double kEighty = 0.8;

std::string statement_of(const PlannedStudy& study) { return ethics_statement(study, kEighty); }

const PowerCurve* deciding_curve(const PlannedStudy& study) {
  const std::vector<PlannedEffect> effects = planned_effects(study, kEighty);
  const PlannedEffect* const deciding = deciding_effect(effects, kEighty, study.rules);
  return deciding == nullptr ? nullptr : deciding->curve;
}

/// Of another family, with a test that it alone concerns.
Assumption ratio_of(double value) {
  return {.name = "pairs.rougher.ratio",
          .part = Assumption::Part::effect,
          .value = value,
          .unit = "ratio",
          .source = "Smith 2020",
          .meaning = "threshold at \"b\" divided by that at \"a\"",
          .null_value = 1.0,
          .tests = "ratio"};
}

// Between 0.7 at 20 and 0.9 at 30 the power .8 is at 25, 28 with rounds of 4, where it is .86; 28/0.855 is 32.7.
TEST(EthicsStatement, StatesAllThatAReviewerAsksFor) {
  PowerCurve of_other_family = curve_of("ratings", {0.1, 0.1, 0.1});
  of_other_family.family = "ratings";
  PowerCurve of_order = curve_of("order rough", {0.3, 0.7, 0.9});
  of_order.methods = {"wilcoxon"};
  const std::string statement =
      statement_of(study_of({of_order, curve_of("fit", {0.1, 0.1, 0.1}),
                             curve_of("", {0.4, 0.8, 0.95}), of_other_family}));
  EXPECT_THAT(statement,
              StartsWith("Sample size: 28 participants with data to be analysed, for an estimated "
                         "power of at least 80 %. The power was estimated with 1000 simulated "
                         "studies for each number of participants (Asperity 0.2.0, protocol pairs "
                         "1.0, with its plan, procedures, exclusion rules and analysis). The "
                         "sample size is a multiple of 4, the number of participants in one round "
                         "of counterbalancing and groups.\n"));
  EXPECT_THAT(statement,
              HasSubstr("\nEffect to be detected: pairs.rougher.order = 0.5 log-odds (the "
                        "preference for the second interval; without an effect 0 log-odds; "
                        "source: smallest effect of interest). Statistical test: Wilcoxon "
                        "signed-rank test, two-sided (\"order rough\"), at α = .05, "
                        "Holm-corrected over the 2 tests of the family \"pairs\". The smallest "
                        "number of participants with an estimated power of 80 % is 25 (95 % "
                        "Monte-Carlo CI ["));
  EXPECT_THAT(statement,
              HasSubstr("; with 28 participants, the power is estimated at 86 % (95 % Monte-Carlo "
                        "CI ["));
  EXPECT_THAT(statement, HasSubstr("], interpolated between the simulated numbers 20 and 30)."));
  EXPECT_THAT(
      statement,
      HasSubstr("\nStandard deviations of the effects over participants: pairs.rougher.order_sd = "
                "0.25 log-odds (SD over participants; source: usual value of Asperity, assumed and "
                "not measured). The simulation has 1 further assumption, which is listed with its "
                "source in the table of assumptions.\n"));
  EXPECT_THAT(
      statement,
      EndsWith("\nWith a dropout rate of 10 % and an exclusion rate of 5 %, 36 participants "
               "are recruited, of whom at least 28 can be analysed with a probability of "
               "at least 90 % (with 33 recruited, this number is reached on average)."));
}

// Numbers of people, and an estimate with its interval: no "25.0" participants, and no power without the word.
TEST(EthicsStatement, HasNoPartsOfAParticipant) {
  for (const double at_20 : {0.55, 0.63, 0.71, 0.79}) {
    const std::string statement = statement_of(study_of({curve_of("order", {0.3, at_20, 0.93})}));
    EXPECT_FALSE(std::regex_search(statement, std::regex(R"(\d\.\d+( participants|, \d|\]\)))")))
        << statement;
    EXPECT_THAT(statement, Not(HasSubstr("has a power")));
  }
}

// Between 0.55 at 20 and 0.93 at 30 the power .8 is at 26.6: 26 participants do not have it.
TEST(EthicsStatement, RoundsTheSmallestNumberUp) {
  EXPECT_THAT(statement_of(study_of({curve_of("order", {0.3, 0.55, 0.93})})),
              HasSubstr("with an estimated power of 80 % is 27 (95 % Monte-Carlo CI ["));
}

// Of the tests that the effect concerns, the one that needs most participants; not the test that it does not concern.
TEST(EthicsStatement, IsAboutTheTestThatNeedsMostParticipants) {
  const PlannedStudy study =
      study_of({curve_of("order rough", {0.3, 0.7, 0.9}), curve_of("side", {0.3, 0.6, 0.85}),
                curve_of("fit", {0.1, 0.1, 0.1})});
  ASSERT_NE(deciding_curve(study), nullptr);
  EXPECT_EQ(deciding_curve(study)->test, "side");
  EXPECT_THAT(statement_of(study), HasSubstr("; of the 2 tests that concern this effect, it needs "
                                             "the most participants. "));
}

// Each of several effects has its own test and power with the planned number, and the one that determines it is named.
TEST(EthicsStatement, HasAParagraphForEachEffect) {
  PlannedStudy study =
      study_of({curve_of("order", {0.3, 0.7, 0.9}), curve_of("ratio", {0.5, 0.9, 0.98})});
  study.assumptions.push_back(ratio_of(1.5));
  study.stated_effects.emplace_back("pairs.rougher.ratio");
  const std::string statement = statement_of(study);
  EXPECT_THAT(statement, HasSubstr("estimated power of at least 80 % for each effect."));
  EXPECT_THAT(statement, HasSubstr("The effect pairs.rougher.order determines the sample size"));
  EXPECT_THAT(statement, HasSubstr("\nEffect to be detected: pairs.rougher.order = 0.5 log-odds"));
  EXPECT_THAT(statement, HasSubstr("with 28 participants, the power is estimated at 86 %"));
  EXPECT_THAT(statement,
              HasSubstr("\nEffect to be detected: pairs.rougher.ratio = 1.5 (threshold"));
  EXPECT_THAT(statement, HasSubstr("without an effect 1; source: Smith 2020). Statistical test: "
                                   "\"ratio\", at α = .05, "));
  EXPECT_THAT(statement, HasSubstr("with 28 participants, the power is estimated at 96.4 %"));
}

// One effect without the power: there is no sample size, although the other effect has one.
TEST(EthicsStatement, PlansNothingIfAnEffectDoesNotReachThePower) {
  PlannedStudy study =
      study_of({curve_of("order", {0.3, 0.7, 0.9}), curve_of("ratio", {0.3, 0.5, 0.62})});
  study.assumptions.push_back(ratio_of(1.5));
  study.stated_effects.emplace_back("pairs.rougher.ratio");
  const std::string statement = statement_of(study);
  EXPECT_THAT(statement,
              StartsWith("Sample size: not determined, because no simulated number of participants "
                         "has an estimated power of 80 % for every effect. "));
  EXPECT_THAT(statement, HasSubstr("power of 80 % is 25 (95 % Monte-Carlo CI ["));
  EXPECT_THAT(statement,
              HasSubstr("No simulated number of participants has an estimated power of 80 %: with "
                        "30 participants, the power is estimated at 62 % (95 % Monte-Carlo CI "
                        "[58.9 %, 65 %])."));
  EXPECT_THAT(statement, Not(HasSubstr("recruited")));
}

TEST(EthicsStatement, StatesInHowManyStudiesThereWasNoP) {
  PowerCurve curve = curve_of("order", {0.3, 0.7, 0.9});
  curve.sizes.back().without_p = 12;
  EXPECT_THAT(statement_of(study_of({curve})),
              HasSubstr(" In 12 of the 1000 simulated studies with 30 participants, the analysis "
                        "gave no p for this test; they count as not significant."));
}

TEST(EthicsStatement, NamesLimitsOutsideTheSimulatedNumbers) {
  EXPECT_THAT(statement_of(study_of({curve_of("order", {0.79, 0.8, 0.81})})),
              HasSubstr("is 20 (95 % Monte-Carlo CI [at most 10, above 30])"));
}

// The smallest simulated number has the power already: a smaller one may have it too.
TEST(EthicsStatement, DoesNotTakeTheFirstNumberForTheSmallestOne) {
  EXPECT_THAT(statement_of(study_of({curve_of("order", {0.9, 0.95, 0.99})})),
              HasSubstr("is at most 10, the smallest simulated number (95 % Monte-Carlo CI [at "
                        "most 10, 10]);"));
}

// Whole rounds can exceed the largest simulated number, whose power is then stated as such.
TEST(EthicsStatement, DoesNotExtrapolateThePower) {
  PlannedStudy study = study_of({curve_of("order", {0.3, 0.5, 0.8})});
  study.rules.multiple = 16;
  EXPECT_THAT(statement_of(study),
              AllOf(HasSubstr("with 32 participants, the power is estimated at 80 % ("),
                    HasSubstr(", simulated with 30 participants).")));
}

// A test without an effect is significant in 5 % of the studies with any number of participants.
TEST(EthicsStatement, IsNotAboutEffectsThatAreAbsent) {
  PlannedStudy study =
      study_of({curve_of("order", {0.3, 0.7, 0.9}), curve_of("ratio", {0.05, 0.05, 0.05})});
  study.assumptions.push_back(ratio_of(1.0));
  study.stated_effects.emplace_back("pairs.rougher.ratio");
  ASSERT_NE(deciding_curve(study), nullptr);
  EXPECT_EQ(deciding_curve(study)->test, "order");
  EXPECT_THAT(statement_of(study), Not(HasSubstr("pairs.rougher.ratio")));
  // Where only it was stated, the statement is about the others, which the file of assumptions states.
  study.stated_effects = {"pairs.rougher.ratio"};
  EXPECT_EQ(deciding_curve(study)->test, "order");
}

TEST(EthicsStatement, OfObserversStatesThatTheyDoNotDiffer) {
  PlannedStudy study = study_of({curve_of("order", {0.3, 0.7, 0.9})});
  study.assumptions.clear();
  study.stated_effects.clear();
  study.is_on_physics = true;
  EXPECT_THAT(statement_of(study),
              AllOf(HasSubstr("Effect to be detected: the effect that the stimuli of the protocol "
                              "have on its virtual observers, who feel them on the full physics."),
                    HasSubstr("no effect differs between them"), Not(HasSubstr("assumption"))));
}

TEST(EthicsStatement, WithoutATestIsEmpty) {
  EXPECT_EQ(statement_of(study_of({})), "");
  EXPECT_EQ(deciding_curve(study_of({curve_of("", {0.9})})), nullptr);
}

TEST(EthicsStatement, WithoutLossesRecruitsWhoIsAnalysed) {
  PlannedStudy study = study_of({curve_of("order", {0.3, 0.7, 0.9})});
  study.rules = {};
  EXPECT_THAT(
      statement_of(study),
      EndsWith("\nNo dropout and no exclusion of participants are assumed (rates of 0 %): 25 "
               "participants are recruited."));
  EXPECT_THAT(statement_of(study), Not(HasSubstr("multiple")));
}

TEST(EthicsStatement, MarksEffectsOfAPilot) {
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
  EXPECT_EQ(of_80[5], Cell(std::int64_t{25}));
  EXPECT_THAT(std::vector(of_80.begin() + 8, of_80.end()),
              ElementsAre(Cell(std::int64_t{28}), Cell(std::int64_t{33}), Cell(std::int64_t{36})));
  const std::vector<Cell>& of_90 = table.rows[1];
  EXPECT_EQ(of_90[5], Cell(std::int64_t{30}));
  EXPECT_EQ(of_90[7], Cell{});  // the lower limit does not reach .9 within the sizes
}

}  // namespace
}  // namespace asperity
