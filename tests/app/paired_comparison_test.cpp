// Paired comparisons, from the rows of a study to scores, tests, scale and consistency.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/tests/pooled_share.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kRougher = R"({"kind": "paired_comparison", "blocks": {"only": {
    "question": {"name": "rougher", "prompt": "Which is rougher?", "tie": {"text": "Neither"}}}},
    "analysis": {"family": ["pairs"]}})";

MadeUpTrial compared(const std::string& first, const std::string& second,
                     const std::string& chosen) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(first, "height_map", first),
                    surface_of(second, "height_map", second)};
  trial.answers = {chosen};
  trial.options = {first, second, "tie"};
  return trial;
}

/// One round of a, b and c in a participant's order, from the roughest; "a" over "c" is exchanged where it is circular.
std::vector<MadeUpTrial> round_of(const std::array<std::string, 3>& order, bool is_circular) {
  return {compared(order[0], order[1], order[0]), compared(order[2], order[1], order[1]),
          compared(order[0], order[2], is_circular ? order[2] : order[0])};
}

AnalysisOutcome outcome_of_pairs(MadeUpStudy& made) {
  std::vector<AnalysisOutcome> outcomes = analyze_study(made.study(), std::nullopt, {});
  EXPECT_EQ(outcomes.size(), 1U);
  return std::move(outcomes.front());
}

/// Six participants: five order a > b > c, the last is circular (a > b > c > a).
class Pairs : public testing::Test {
 protected:
  Pairs() {
    const std::int64_t protocol = made_.add_protocol("rougher", "paired_comparison", kRougher);
    for (int person = 0; person < 6; ++person) {
      const std::string label = "p" + std::to_string(person + 1);
      made_.add_person(label, "");
      made_.add_session(label, protocol, round_of({"a", "b", "c"}, person == 5));
    }
  }
  MadeUpStudy made_{};
};

TEST_F(Pairs, HaveTheProportionOfComparisonsThatEachItemWins) {
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const FoundNumbers found(outcome.findings);
  // a wins 2 of 2 for five participants, and 1 of 2 for the last.
  EXPECT_NEAR(found.value("mean.score", "a").value(), 11.0 / 12.0, 1e-12);
  EXPECT_NEAR(found.value("mean.score", "b").value(), 0.5, 1e-12);
  EXPECT_NEAR(found.value("mean.score", "c").value(), 1.0 / 12.0, 1e-12);
  const AnsweredQuestion& asked = question_of(outcome, "preference");
  EXPECT_THAT(asked.answer.english(), HasSubstr("a was chosen most often, in 92 %"));
  EXPECT_THAT(asked.answer.english(), HasSubstr("c least often, in 8 %"));
}

// ζ is 1 for the five participants without a circular triad and 0 for the last: 5/6.
TEST_F(Pairs, AreSummarisedInTheTextForAPaper) {
  const std::string text = estimate_sentence(outcome_of_pairs(made_)).text;
  EXPECT_THAT(text, HasSubstr("Log-worths of the Bradley–Terry model (mean 0) were "));
  EXPECT_THAT(text,
              HasSubstr("Mean proportions of comparisons in which an item was chosen were 92 %"));
  EXPECT_THAT(text, HasSubstr("The mean coefficient of consistence was ζ = .83"));
}

TEST_F(Pairs, AreTestedByTheParticipants) {
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const FoundNumbers found(outcome.findings);
  // All six prefer a to b: 2 of 2⁶ patterns of signs are as extreme; a to c five of six: 14 of 64.
  EXPECT_DOUBLE_EQ(found.value("signflip.p.two", "a|b").value(), 2.0 / 64.0);
  EXPECT_DOUBLE_EQ(found.value("signflip.p.two", "a|c").value(), 14.0 / 64.0);
  EXPECT_EQ(table_of(outcome, "tests").table.rows.size(), 5U) << "three pairs, items, positions";
  EXPECT_THAT(question_of(outcome, "pairs").answer.english(), HasSubstr("a / b"));
}

// a wins 11 of its 12 comparisons, and all of those with b.
TEST_F(Pairs, AreStatedWithTheMeansOfTheirOwnComparisons) {
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const auto sentence = std::find_if(outcome.test_sentences.begin(), outcome.test_sentences.end(),
                                     [](const TestSentence& each) {
                                       return each.about == TestSubject{"a", "b"};
                                     });
  ASSERT_NE(sentence, outcome.test_sentences.end());
  EXPECT_THAT(sentence->text, testing::ContainsRegex("means: 100 %.* for a and 0 %.* for b"));
}

// Each of six participants chooses a in 11 of 20 comparisons: all differences have one sign, so that p = 2/64, and 66 of 120 is not
// more than half of the choices.
TEST(PairedComparison, EstablishesNothingWhereTheIntervalOfAPairContainsChance) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials{};
    for (int i = 0; i < 20; ++i) {
      trials.push_back(i % 2 == 0 ? compared("a", "b", i < 11 ? "a" : "b")
                                  : compared("b", "a", i < 11 ? "a" : "b"));
    }
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = outcome_of_pairs(made);
  EXPECT_DOUBLE_EQ(*finding_of(outcome, "choice", "signflip.p.two", "a|b").value, 2.0 / 64.0);
  EXPECT_THAT(answer_to(outcome, "pairs"),
              testing::AllOf(testing::StartsWith("Not established: a over b (in 55 %"),
                             HasSubstr("but the 95 % CI of the mean contains the chance level.")));
  EXPECT_THAT(sentence_about(outcome, "pairs"),
              testing::StartsWith("It was not established that the item a was chosen more often "
                                  "than b: "));
}

TEST_F(Pairs, HaveCircularTriadsAndZetaForEveryParticipant) {
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const Table& table = table_of(outcome, "consistency").table;
  ASSERT_EQ(table.rows.size(), 6U);
  EXPECT_EQ(table.rows[0][0], Cell(std::string("p1")));
  EXPECT_EQ(table.rows[0][1], Cell(std::int64_t{1}));
  EXPECT_EQ(table.rows[0][2], Cell(0.0));
  EXPECT_EQ(table.rows[0][4], Cell(0.75)) << "6 of the 8 outcomes of a round are not circular";
  EXPECT_EQ(table.rows[5][2], Cell(1.0));
  EXPECT_EQ(table.rows[5][3], Cell(0.0));
  EXPECT_EQ(table.rows[5][4], Cell(1.0));
  EXPECT_THAT(question_of(outcome, "consistency").answer.english(), HasSubstr("ζ = .83"));
}

// The choices of the sixth participant lead from c back to a; without them a never loses, and its log-worth is infinite.
TEST_F(Pairs, HaveAScaleOnlyWhereEveryItemAlsoLoses) {
  // In the other order: an effect of the order can be told from the items.
  made_.add_person("p7", "");
  made_.add_session("p7", 1,
                    {compared("b", "a", "a"), compared("b", "c", "b"), compared("c", "a", "a")});
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const Table& scale = table_of(outcome, "scale").table;
  ASSERT_EQ(scale.rows.size(), 3U);
  EXPECT_GT(std::get<double>(scale.rows[0][1]), std::get<double>(scale.rows[1][1]));
  EXPECT_GT(std::get<double>(scale.rows[1][1]), std::get<double>(scale.rows[2][1]));
  // Each part of the model has the row of its own number.
  const FoundNumbers found(outcome.findings);
  const Table& model = table_of(outcome, "paired_model").table;
  ASSERT_EQ(model.rows.size(), 3U) << "without ties";
  EXPECT_EQ(model.rows[0][0], Cell(std::string("order_effect")));
  EXPECT_EQ(model.rows[0][1], cell_with(found.value("model.order")));
  const Finding& order = *found.find("model.order");
  EXPECT_NEAR(*order.high - *order.value, *order.value - *order.low, 1e-12);
  EXPECT_GT(*order.high, *order.value);
  EXPECT_EQ(model.rows[0][5], Cell(std::int64_t{1}));
  EXPECT_EQ(model.rows[1][0], Cell(std::string("equal_items")));
  EXPECT_EQ(model.rows[1][5], Cell(std::int64_t{2})) << "three items";
  EXPECT_EQ(model.rows[2][0], Cell(std::string("goodness_of_fit")));
  EXPECT_EQ(found.find("model.fit.lr")->n, 21U) << "responses";

  MadeUpStudy alike{};
  const std::int64_t protocol = alike.add_protocol("rougher", "paired_comparison", kRougher);
  for (const char* const label : {"p1", "p2", "p3"}) {
    alike.add_person(label, "");
    alike.add_session(label, protocol, round_of({"a", "b", "c"}, false));
  }
  const AnalysisOutcome unbounded = outcome_of_pairs(alike);
  EXPECT_EQ(find_table(unbounded, "scale"), nullptr);
  EXPECT_EQ(find_table(unbounded, "paired_model"), nullptr);
  EXPECT_TRUE(
      std::any_of(unbounded.remarks.begin(), unbounded.remarks.end(), [](const Phrase& one) {
        return one.english().find("cannot be placed on a scale") != std::string::npos;
      }));
}

TEST_F(Pairs, CountATieHalfAndLeaveItsRoundOutOfTheTriads) {
  made_.add_person("p7", "");
  made_.add_session("p7", 1,
                    {compared("a", "b", "tie"), compared("b", "c", "b"), compared("c", "a", "a")});
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(found.value("mean.score", "a").value(), (11.0 / 2.0 + 0.75) / 7.0, 1e-12);
  EXPECT_EQ(table_of(outcome, "consistency").table.rows[6][1], Cell(std::int64_t{0}));
  EXPECT_EQ(table_of(outcome, "consistency").table.rows[6][3], Cell{});
  const Table& ties = table_of(outcome, "ties").table;
  EXPECT_EQ(ties.rows[0], (std::vector<Cell>{std::string("a"), std::string("b"), std::int64_t{7},
                                             std::int64_t{1}}));
}

TEST_F(Pairs, LeaveAParticipantWithoutOneOfThePairsOutOfTheScores) {
  made_.add_person("p7", "");
  made_.add_session("p7", 1, {compared("c", "a", "c"), compared("c", "b", "c")});
  const AnalysisOutcome outcome = outcome_of_pairs(made_);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(found.value("mean.score", "a").value(), 11.0 / 12.0, 1e-12);
  EXPECT_DOUBLE_EQ(found.value("signflip.p.two", "a|b").value(), 2.0 / 64.0);
  EXPECT_EQ(found.find("mean.score", "a")->n, 6U);
}

// Three pairs, Holm-corrected: 3·2^(1 − n) is below .05 from n = 7 on.
TEST_F(Pairs, StateHowManyParticipantsAreRequiredWhereNoResultCouldBeSignificant) {
  const std::string six = question_of(outcome_of_pairs(made_), "pairs").answer.english();
  EXPECT_THAT(six, HasSubstr("No pair could differ significantly in these data: "));
  EXPECT_THAT(six,
              HasSubstr("the smallest attainable p is .094, so that no result could be "
                        "significant with 6 participants whose difference is not zero; at least 7 "
                        "such participants are required"));
  made_.add_person("p7", "");
  made_.add_session("p7", 1, round_of({"a", "b", "c"}, true));
  const std::string seven = question_of(outcome_of_pairs(made_), "pairs").answer.english();
  EXPECT_THAT(seven, HasSubstr("a over b"));
  EXPECT_THAT(seven, Not(HasSubstr("attainable")));
}

// Every participant compares every pair once, half of them in the other order. Of 36 participants the expected counts of an
// ordered pair are about 12 and 6.
TEST(FitOfPairs, IsTestedOnlyWithSufficientExpectedCounts) {
  const auto study_of = [](MadeUpStudy& made, int participants) {
    const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
    for (int person = 0; person < participants; ++person) {
      const std::string label = "p" + std::to_string(100 + person);
      made.add_person(label, "");
      std::vector<MadeUpTrial> trials{compared("a", "b", person % 3 != 0 ? "a" : "b"),
                                      compared("c", "b", person % 3 != 1 ? "b" : "c"),
                                      compared("a", "c", person % 3 != 2 ? "a" : "c")};
      for (MadeUpTrial& trial : trials) {
        if (person % 2 == 1) std::swap(trial.surfaces[0], trial.surfaces[1]);
      }
      made.add_session(label, protocol, trials);
    }
  };
  MadeUpStudy few{};
  study_of(few, 6);
  const AnalysisOutcome unreliable = outcome_of_pairs(few);
  const AnsweredQuestion& untested = question_of(unreliable, "fit");
  EXPECT_THAT(
      untested.answer.english(),
      HasSubstr("This cannot be tested with so few comparisons: 100 % of the expected counts "
                "are below 5, and the smallest is "));
  EXPECT_FALSE(untested.finding.value);
  const Table& model = table_of(unreliable, "paired_model").table;
  EXPECT_EQ(model.rows.back()[0], Cell(std::string("goodness_of_fit")));
  EXPECT_EQ(model.rows.back()[6], Cell{});
  EXPECT_THAT(table_of(unreliable, "paired_model").note.english(),
              HasSubstr("Goodness of fit has no p: 100 %"));
  const FoundNumbers found(unreliable.findings);
  const Finding* const p = found.find("model.fit.p");
  ASSERT_NE(p, nullptr);
  EXPECT_FALSE(p->value);
  EXPECT_THAT(p->status, HasSubstr("expected counts too small"));
  EXPECT_TRUE(found.value("model.equal.p")) << "only the fit depends on the expected counts";

  MadeUpStudy many{};
  study_of(many, 36);
  const AnalysisOutcome reliable = outcome_of_pairs(many);
  EXPECT_THAT(question_of(reliable, "fit").answer.english(), HasSubstr("G²("));
  EXPECT_TRUE(FoundNumbers(reliable.findings).value("model.fit.p"));
  EXPECT_NE(table_of(reliable, "paired_model").table.rows.back()[6], Cell{});
}

// Each of three participants chose a in both of its comparisons, as in a selection the participants' 2 of 2 choices.
TEST(ScoresOfPairs, HaveTheIntervalOfProportionsWhereAllParticipantsAgree) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
  for (const char* const label : {"p1", "p2", "p3"}) {
    made.add_person(label, "");
    made.add_session(label, protocol, round_of({"a", "b", "c"}, false));
  }
  const AnalysisOutcome outcome = outcome_of_pairs(made);
  const FoundNumbers found(outcome.findings);
  const Finding* const a = found.find("mean.score", "a");
  ASSERT_TRUE(a != nullptr && a->low && a->high);
  const std::vector<HitCount> own(3, {.hits = 2, .trials = 2});
  const auto expected = mean_share_interval(own);
  EXPECT_NEAR(*a->low, expected->low, 1e-12);
  EXPECT_EQ(*a->high, 1.0);
  EXPECT_THAT(question_of(outcome, "preference").answer.english(), Not(HasSubstr("no CI")));
}

// A round is the k-th comparison of every pair, whatever the order of the trials.
TEST(RoundsOfPairs, AreTakenInTheOrderOfTheComparisonsOfEveryPair) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
  made.add_person("p1", "");
  made.add_session("p1", protocol,
                   {compared("a", "b", "a"), compared("b", "a", "b"), compared("b", "c", "b"),
                    compared("a", "c", "a"), compared("c", "a", "c"), compared("c", "b", "b")});
  // First a > b, b > c, a > c; then b > a, b > c, c > a: both without a circular triad.
  const AnalysisOutcome outcome = outcome_of_pairs(made);
  const Table& table = table_of(outcome, "consistency").table;
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][1], Cell(std::int64_t{2}));
  EXPECT_EQ(table.rows[0][3], Cell(1.0));
  EXPECT_EQ(table.rows[0][4], Cell(0.5625)) << "two rounds without one: 0.75²";
}

// a > b and b > c with one texture, c > a with another: that is no circular triad.
TEST(RoundsOfPairs, AreOfOneLevelOfEveryOtherFactor) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
  made.add_person("p1", "");
  std::vector<MadeUpTrial> trials{compared("a", "b", "a"), compared("b", "c", "b"),
                                  compared("a", "c", "c"), compared("a", "b", "b"),
                                  compared("b", "c", "b"), compared("a", "c", "a")};
  const std::array kTexturesOfTrials{"wood", "wood", "metal", "metal", "metal", "wood"};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].factors_json = std::string(R"({"texture": ")") + kTexturesOfTrials[i] + "\"}";
  }
  made.add_session("p1", protocol, trials);
  const AnalysisOutcome outcome = outcome_of_pairs(made);
  const Table& table = table_of(outcome, "consistency").table;
  EXPECT_EQ(table.rows[0][1], Cell(std::int64_t{2}));
  EXPECT_EQ(table.rows[0][2], Cell(0.0));
}

TEST_F(Pairs, StateWhyAPairOrTheItemsAreNotTested) {
  MadeUpStudy tied{};
  const std::int64_t protocol = tied.add_protocol("rougher", "paired_comparison", kRougher);
  for (const char* const label : {"p1", "p2"}) {
    tied.add_person(label, "");
    tied.add_session(label, protocol, {compared("a", "b", "tie"), compared("b", "c", "b")});
  }
  const AnalysisOutcome outcome = outcome_of_pairs(tied);
  const Table& tests = table_of(outcome, "tests").table;
  std::string reasons{};
  for (const std::vector<Cell>& row : tests.rows) {
    for (const Cell& cell : row) {
      if (const auto* text = std::get_if<std::string>(&cell)) reasons += *text + '\n';
    }
  }
  EXPECT_THAT(reasons, HasSubstr("only_ties"));
  EXPECT_THAT(reasons, HasSubstr("pairs_incomplete"));
  EXPECT_THAT(question_of(outcome, "preference").answer.english(),
              HasSubstr("fewer than two participants compared every pair"));
  EXPECT_EQ(find_table(outcome, "consistency"), nullptr);
}

// A participant whose only comparison of b and c was a tie contributes nothing to the test of b and c.
TEST_F(Pairs, CountWhoIsLeftOutOfATest) {
  made_.add_person("p7", "");
  made_.add_session("p7", 1,
                    {compared("a", "b", "a"), compared("b", "c", "tie"), compared("c", "a", "a"),
                     compared("b", "a", "a")});
  const std::string note = table_of(outcome_of_pairs(made_), "tests").note.english();
  EXPECT_THAT(note, HasSubstr("Participants who tied b and c in every comparison are left out of "
                              "the test of this pair: 1 of 7."));
  EXPECT_THAT(note,
              HasSubstr("did not compare every pair equally often are left out of the test of "
                        "the choices of the items: 1 of 7."));
}

// With two items the comparisons of everybody for one of them are all won: the interval ends at 1.
TEST(PairedScores, LieBetweenZeroAndOne) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("rougher", "paired_comparison", kRougher);
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    made.add_session(label, protocol,
                     {compared("a", "b", "a"), compared("b", "a", person == 0 ? "b" : "a")});
  }
  const AnalysisOutcome outcome = outcome_of_pairs(made);
  const FoundNumbers found(outcome.findings);
  EXPECT_EQ(found.find("mean.score", "a")->high, 1.0);
  EXPECT_EQ(found.find("mean.score", "b")->low, 0.0);
  EXPECT_TRUE(std::none_of(outcome.questions.begin(), outcome.questions.end(),
                           [](const AnsweredQuestion& each) { return each.name == "fit"; }))
      << "two items always lie on one scale";
  for (const AnsweredQuestion& each : outcome.questions) {
    EXPECT_TRUE(each.table.empty() || find_table(outcome, each.table) != nullptr) << each.name;
  }
}

}  // namespace
}  // namespace asperity
