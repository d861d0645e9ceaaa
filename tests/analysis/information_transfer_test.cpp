// Holds transmitted information to tables whose bits can be counted.

#include "analysis/information_transfer.h"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/equal_error_information.h"

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
  EXPECT_EQ(it.p, 1.0);
  EXPECT_THROW(information_transfer(ConfusionCounts::Zero(3, 3)), std::invalid_argument);
}

TEST(InformationTransfer, OfEquallyFrequentErrorsIsFanosBound) {
  ConfusionCounts counts = ConfusionCounts::Ones(4, 4);
  counts.diagonal().setConstant(7.0);
  EXPECT_NEAR(equal_error_bits(0.7, 4), information_transfer(counts).plug_in_bits, 1e-14);
}

}  // namespace
}  // namespace asperity
