// The chapter's selection, rebuilt answer by answer from its printed counts, and other selections.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/chapter_studies.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Selection, ReproducesTheChaptersFirstTable) {
  const Table& table = table_of(selections_of_the_chapter(), "table_1").table;
  EXPECT_THAT(table.columns,
              ElementsAre("item", "repetition_1", "repetition_2", "repetition_3", "all"));
  using Row = std::vector<Cell>;
  const auto n = [](std::int64_t count) { return Cell{count}; };
  EXPECT_THAT(table.rows, ElementsAre(Row{"height_map", n(12), n(11), n(13), n(36)},
                                      Row{"sinusoid", n(7), n(8), n(7), n(22)},
                                      Row{"stochastic", n(1), n(1), n(0), n(2)}));
}

// 12 of 20: Clopper–Pearson [0.36, 0.81], Wilson [0.39, 0.78]; against 1/3 the exact p is 0.016.
TEST(Selection, GivesSharesWithBothIntervalsAndTheExactTest) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& shares = table_of(outcome, "shares").table;
  const std::vector<std::string> keys{"1", "height_map"};
  EXPECT_DOUBLE_EQ(number(shares, keys, "share"), 0.60);
  EXPECT_NEAR(number(shares, keys, "clopper_pearson_low"), 0.36, 0.005);
  EXPECT_NEAR(number(shares, keys, "clopper_pearson_high"), 0.81, 0.005);
  EXPECT_NEAR(number(shares, keys, "wilson_low"), 0.39, 0.005);
  EXPECT_NEAR(number(shares, keys, "wilson_high"), 0.78, 0.005);
  EXPECT_DOUBLE_EQ(number(shares, keys, "chance"), 1.0 / 3.0);
  EXPECT_NEAR(number(shares, keys, "p"), 0.016, 0.0005);
  EXPECT_EQ(number(shares, {"all", "height_map"}, "of"), 60);
  EXPECT_EQ(number(shares, {"all", "height_map"}, "persons"), 20);
}

// 12 against 7 among 19: p = 0.36. The chapter's claim of superiority does not survive this row.
TEST(Selection, SetsTwoModelsAgainstEachOtherAmongTheChoicesOfEither) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& pairs = table_of(outcome, "pairs").table;
  const std::vector<std::string> keys{"1", "height_map", "sinusoid"};
  EXPECT_EQ(number(pairs, keys, "chosen"), 12);
  EXPECT_EQ(number(pairs, keys, "of"), 19);
  EXPECT_NEAR(number(pairs, keys, "p"), 0.36, 0.005);
}

TEST(Selection, CountsCannotTellButKeepsItOutOfTheShares) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_person("b", "M");
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  std::vector<MadeUpTrial> trials{choice_among_models("sinusoid", "wood"),
                                  choice_among_models("cannot_tell", "wood")};
  for (MadeUpTrial& trial : trials) trial.options.push_back("cannot_tell");
  made.add_session("a", protocol, {trials[0]});
  made.add_session("b", protocol, {trials[1]});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(number(table_of(outcome, "table_1").table, {"cannot_tell"}, "all"), 1);
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_EQ(number(shares, {"all", "sinusoid"}, "of"), 1);
  EXPECT_DOUBLE_EQ(number(shares, {"all", "sinusoid"}, "chance"), 1.0 / 3.0);
}

TEST(Selection, LeavesOutWhatSomebodyExcludedAndSaysSo) {
  MadeUpStudy made;
  made.add_person("p1", "F");
  made.add_person("p2", "F");
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  const std::vector<MadeUpTrial> trials{choice_among_models(kModels[0], kTextures[0]),
                                        choice_among_models(kModels[1], kTextures[0])};
  const std::int64_t first = made.add_session("p1", protocol, trials);
  const std::int64_t second = made.add_session("p2", protocol, trials);
  made.study().add_decision(
      first, {.trial = 2, .attempt = 1, .verdict = Verdict::exclude, .reason = "coughed"});
  EXPECT_EQ(analyze_study(made.study()).at(0).answers, 3U);
  made.study().add_decision(second, {.verdict = Verdict::exclude, .reason = "was asleep"});
  const AnalysisOutcome outcome = analyze_study(made.study()).at(0);
  EXPECT_EQ(outcome.answers, 1U);
  EXPECT_THAT(outcome.remarks, testing::Contains(says("3 excluded")));
}

TEST(Selection, WarnsWherePersonsArePooledAndGivesThePersonsAsUnit) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  EXPECT_THAT(outcome.remarks, testing::Contains(says("60 trials of 20 participants")));
  const Table& persons = table_of(outcome, "persons").table;
  EXPECT_EQ(number(persons, {"height_map"}, "persons"), 20);
  EXPECT_NEAR(number(persons, {"height_map"}, "mean"), 0.60, 1e-12);
  EXPECT_DOUBLE_EQ(number(persons, {"height_map"}, "minimum"), 0.0);
}

TEST(Selection, SetsTheAchievedTextureForceBesideTheOneAimedAt) {
  MadeUpStudy made;
  made.add_person("a", "F");
  MadeUpTrial trial = choice_among_models("sinusoid", "wood");
  for (PresentationRow& surface : trial.surfaces) {
    surface.matched_texture_force_N = 0.2;
    surface.achieved_texture_force_N = surface.model == "stochastic" ? 0.3 : 0.1;
  }
  made.add_session("a", made.add_protocol("selection", "selection"), {trial, trial});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& force = table_of(outcome, "texture_force").table;
  EXPECT_EQ(number(force, {"stochastic"}, "surfaces"), 2);
  EXPECT_DOUBLE_EQ(number(force, {"stochastic"}, "matched_mean_N"), 0.2);
  EXPECT_DOUBLE_EQ(number(force, {"stochastic"}, "achieved_mean_N"), 0.3);
}

// Every person has the same choice in a column, so that the table of all is the chapter's.
TEST(Selection, AnswersItsQuestionWithThePersonAsTheUnit) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const AnsweredQuestion& preference = question_of(outcome, "preference");
  EXPECT_EQ(&preference, &outcome.questions.front());
  EXPECT_THAT(preference.answer.english(),
              testing::StartsWith("height_map was chosen most often: in 60 % of a participant's "
                                  "choices on average (95 % CI "));
  EXPECT_THAT(preference.answer.english(), HasSubstr("compared with a chance level of 33 %"));
  EXPECT_EQ(preference.finding.n, 20U);
  EXPECT_EQ(preference.finding.quantity, "subj.mean");
  EXPECT_TRUE(preference.finding.low.has_value());
}

// 1, 1, 1, 1, 1 and 0.5 of the choices: Student's interval of the mean goes to 1.13, that on the logit scale does not
// leave 0 to 1.
TEST(Selection, SaysTheIntervalOfAShareInSentenceAndTableAsFarAsSharesGo) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("pair", "selection");
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (int trial = 0; trial < 2; ++trial) {
      MadeUpTrial& one = trials.emplace_back();
      // What is second is always the one.
      one.options = {"old", "new"};
      for (const std::string& model : one.options) {
        one.surfaces.push_back(surface_of(model, model, "wood"));
      }
      one.answers = {person == 5 && trial == 1 ? "old" : "new"};
    }
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_GT(finding_of(outcome, "choice", "subj.ci.upper", "new").value.value(), 1.1);
  const double high = finding_of(outcome, "choice", "subj.mean", "new").high.value();
  EXPECT_GT(high, 0.95);
  EXPECT_LT(high, 1.0);
  EXPECT_EQ(number(table_of(outcome, "persons").table, {"new"}, "mean_high"), high);
  EXPECT_NEAR(number(table_of(outcome, "persons").table, {"old"}, "mean_low"), 1.0 - high, 1e-12);
  EXPECT_THAT(question_of(outcome, "preference").answer.english(), HasSubstr("(95 % CI "));
  // The position that stands out is named, not the first one alone.
  const AnsweredQuestion& position = question_of(outcome, "position");
  EXPECT_THAT(position.answer.english(),
              AllOf(testing::StartsWith("Test of equal proportions: p "),
                    HasSubstr("position 2 was chosen in 92 % of a participant's "
                              "choices on average (95 % CI ")));
  EXPECT_EQ(position.finding.key, "2");
}

// 20 people, each three times: whatever a table says of all of them, the family says too.
TEST(Selection, HasItsNumbersFromTheFamily) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_EQ(finding_of(outcome, "choice", "count", "POOLED|height_map").value, 36.0);
  EXPECT_EQ(finding_of(outcome, "choice", "prop", "POOLED|height_map").value,
            number(shares, {"all", "height_map"}, "share"));
  EXPECT_EQ(finding_of(outcome, "choice", "wilson.lower", "POOLED|height_map").value,
            number(shares, {"all", "height_map"}, "wilson_low"));
  const Table& persons = table_of(outcome, "persons").table;
  EXPECT_EQ(finding_of(outcome, "choice", "subj.mean", "sinusoid").value,
            number(persons, {"sinusoid"}, "mean"));
  EXPECT_LT(number(persons, {"sinusoid"}, "mean_low"), number(persons, {"sinusoid"}, "mean"));
}

// Luce's worths of the best of three are the shares: 36, 22 and 2 of 60.
TEST(Selection, PutsTheModelsOnAScale) {
  const Table& scale = table_of(selections_of_the_chapter(), "scale").table;
  EXPECT_NEAR(number(scale, {"height_map"}, "worth"), 0.6, 1e-9);
  EXPECT_NEAR(number(scale, {"stochastic"}, "worth"), 2.0 / 60.0, 1e-9);
  EXPECT_NEAR(number(scale, {"height_map"}, "log_worth") - number(scale, {"sinusoid"}, "log_worth"),
              std::log(36.0 / 22.0), 1e-9);
  EXPECT_LT(number(scale, {"sinusoid"}, "log_worth_low"), number(scale, {"sinusoid"}, "log_worth"));
}

// The differences are 4, 4, 2, 2, 0 and 4 of one sign: of 2⁵ patterns of signs two are as far.
TEST(Selection, FlipsSignsWithinPersons) {
  const AnalysisOutcome outcome = analyze_pairs("{}");
  EXPECT_DOUBLE_EQ(finding_of(outcome, "choice", "signflip.p.two", "new|old").value.value(),
                   2.0 / 32.0);
  EXPECT_DOUBLE_EQ(number(table_of(outcome, "tests").table, {"pairs", "", "new", "old"}, "p"),
                   2.0 / 32.0);
  // 20 wins to 4: Bradley and Terry's distance is ln 5.
  EXPECT_NEAR(number(table_of(outcome, "scale").table, {"new"}, "log_worth"), std::log(5.0) / 2.0,
              1e-9);
  EXPECT_NO_THROW(finding_of(outcome, "scale", "bt.order.beta", "first"));
}

// The sentence about positions has the mean of the persons, and so has a table for its figure.
TEST(Selection, GivesTheMeansOfPersonsByPosition) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& places = table_of(outcome, "persons_by_position").table;
  EXPECT_EQ(number(places, {"1"}, "persons"), 20);
  EXPECT_NEAR(number(places, {"1"}, "mean"),
              finding_of(outcome, "position", "subj.mean", "1").value.value(), 1e-12);
}

}  // namespace
}  // namespace asperity
