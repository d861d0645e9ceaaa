// Holds transmitted information to tables whose bits can be counted.

#include "analysis/choices/information_transfer.h"

#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/choices/equal_error_information.h"

namespace asperity {
namespace {

TEST(InformationTransfer, OfPerfectAnswersIsThatOfTheStimuli) {
  const InformationTransfer it = information_transfer(5.0 * ConfusionCounts::Identity(4, 4));
  EXPECT_NEAR(it.plug_in_bits, 2.0, 1e-14);
  EXPECT_NEAR(*it.relative, 1.0, 1e-14);
  EXPECT_NEAR(it.miller_bits, 2.0 - 9.0 / (40.0 * std::numbers::ln2), 1e-14);
  EXPECT_FALSE(it.enough_trials);
}

TEST(InformationTransfer, OfAnswersThatDoNotDependIsNone) {
  const InformationTransfer it = information_transfer(ConfusionCounts::Constant(3, 3, 20.0));
  EXPECT_NEAR(it.plug_in_bits, 0.0, 1e-14);
  EXPECT_NEAR(*it.p, 1.0, 1e-6);
  EXPECT_TRUE(it.enough_trials);
}

TEST(InformationTransfer, NeedsMoreThanOneAnswerForATest) {
  ConfusionCounts counts = ConfusionCounts::Zero(3, 3);
  counts.col(1).setConstant(4.0);
  const InformationTransfer it = information_transfer(counts);
  EXPECT_EQ(it.df, 0.0);
  EXPECT_FALSE(it.p);
  EXPECT_THROW(information_transfer(ConfusionCounts::Zero(3, 3)), std::invalid_argument);
}

using Everyone = std::vector<std::vector<LabelPair>>;

std::vector<LabelPair> trials_of(const std::vector<std::size_t>& stimuli,
                                 const std::vector<std::size_t>& answers) {
  std::vector<LabelPair> trials{};
  for (std::size_t i = 0; i < stimuli.size(); ++i) trials.push_back({stimuli[i], answers[i]});
  return trials;
}

// Two of the six orders of two answers each give this G, of each participant's two orders every one; of
// two participants, half of the four pairs of orders (and of the orders of all four trials a third).
TEST(InformationTest, CountsTheOrdersOfEachParticipantsAnswers) {
  const Everyone one{trials_of({0, 0, 1, 1}, {0, 0, 1, 1})};
  EXPECT_NEAR(information_test(one, 2)->p, 1.0 / 3.0, 0.02);
  EXPECT_EQ(information_test(one, 2)->drawn, 9999U);
  const Everyone two{trials_of({0, 1}, {0, 1}), trials_of({0, 1}, {0, 1})};
  EXPECT_NEAR(information_test(two, 2)->p, 0.5, 0.02);
}

// Whatever order was observed: the largest G of the six orders is that of two of them.
TEST(InformationTest, EstimatesTheSmallestAttainableP) {
  for (const std::vector<std::size_t>& answers :
       std::vector<std::vector<std::size_t>>{{0, 0, 1, 1}, {0, 1, 0, 1}}) {
    const auto test = information_test(Everyone{trials_of({0, 0, 1, 1}, answers)}, 2);
    EXPECT_NEAR(test->smallest, 1.0 / 3.0, 0.02);
    EXPECT_GE(test->p, test->smallest);
  }
}

TEST(InformationTest, IsNotMisledByParticipantsWhoAreAskedDifferentlyAndPreferAnAnswer) {
  std::vector<std::size_t> shown(40, 0);
  std::vector<std::size_t> more(40, 1);
  for (std::size_t i = 0; i < 4; ++i) shown[10 * i] = more[10 * i] = i % 2 == 0 ? 1 : 0;
  const std::vector<std::size_t> always(40, 1);
  std::vector<std::size_t> never(40, 0);
  never[3] = 1;
  const Everyone trials{trials_of(shown, never), trials_of(more, always)};
  ConfusionCounts counts = confusion_counts(trials[0], 2) + confusion_counts(trials[1], 2);
  EXPECT_LT(*information_transfer(counts).p, 1e-6);
  EXPECT_GT(information_test(trials, 2)->p, 0.1);
}

TEST(InformationTest, NeedsTwoStimuliAndTwoAnswers) {
  EXPECT_FALSE(information_test(Everyone{trials_of({0, 1, 1}, {1, 1, 1})}, 2));
  EXPECT_FALSE(information_test(Everyone{trials_of({1, 1, 1}, {0, 1, 1})}, 2));
  EXPECT_FALSE(information_test({}, 2));
  // Of these two nothing can be permuted, though the pool has two of both.
  EXPECT_FALSE(information_test(Everyone{trials_of({0, 0}, {0, 0}), trials_of({1, 1}, {1, 0})}, 2));
  EXPECT_THROW(information_test(Everyone{trials_of({0, 2}, {1, 1})}, 2), std::invalid_argument);
}

TEST(InformationTest, DrawsFewerOrdersOfManyTrials) {
  std::vector<LabelPair> many{};
  for (std::size_t i = 0; i < 200000; ++i) many.push_back({i % 3, i % 7 % 3});
  const auto test = information_test(Everyone{many}, 3);
  EXPECT_EQ(test->drawn, 199U);
  EXPECT_GE(test->p, 1.0 / 200.0);
}

TEST(InformationTransfer, OfEquallyFrequentErrorsIsFanosBound) {
  ConfusionCounts counts = ConfusionCounts::Ones(4, 4);
  counts.diagonal().setConstant(7.0);
  EXPECT_NEAR(equal_error_bits(0.7, 4), information_transfer(counts).plug_in_bits, 1e-14);
}

}  // namespace
}  // namespace asperity
