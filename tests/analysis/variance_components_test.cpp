// Holds the variance components to calculations by hand, and to the model that data are drawn from.

#include "analysis/models/variance_components.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

// Means 2 and 5 of the first participant, 6 and 10 of the second. Within cells the squares are 2 + 2 + 2 + 8 = 14 with 4 degrees of
// freedom. The deviations from the means of participants (3.5, 8) and cells (4, 7.5) are ±0.25, so that MS_I = 0.25, less than
// half the variance within cells. The means of the participants have the variance 4.5²/2 = 10.125.
TEST(VarianceComponents, AreThoseOfAHandCalculation) {
  const std::vector<CellNumber> numbers{{0, 0, 1.0}, {0, 0, 3.0}, {0, 1, 4.0}, {0, 1, 6.0},
                                        {1, 0, 5.0}, {1, 0, 7.0}, {1, 1, 8.0}, {1, 1, 12.0}};
  const auto found = variance_components(numbers);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->participants, 2U);
  EXPECT_NEAR(found->mean, 5.75, 1e-14);
  EXPECT_NEAR(found->within_sd, std::sqrt(3.5), 1e-14);
  EXPECT_EQ(found->interaction_sd, 0.0);
  EXPECT_NEAR(found->participant_sd, std::sqrt(10.125 - 0.25 / 2.0), 1e-13);
}

// Opposite participants: deviations of ±5, MS_I = 100; the variance within cells is 8/4 = 2, half of which is in each mean.
TEST(VarianceComponents, SeparateTheDeviationsOfParticipantsFromNoise) {
  const std::vector<CellNumber> numbers{{0, 0, -1.0}, {0, 0, 1.0},  {0, 1, 9.0},  {0, 1, 11.0},
                                        {1, 0, 9.0},  {1, 0, 11.0}, {1, 1, -1.0}, {1, 1, 1.0}};
  const auto found = variance_components(numbers);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->interaction_sd, std::sqrt(99.0), 1e-13);
  EXPECT_EQ(found->participant_sd, 0.0);
}

TEST(VarianceComponents, LeaveOutParticipantsWithAnEmptyCell) {
  std::vector<CellNumber> numbers{{0, 0, 1.0}, {0, 0, 3.0}, {0, 1, 4.0}, {0, 1, 6.0},
                                  {1, 0, 5.0}, {1, 0, 7.0}, {1, 1, 8.0}, {1, 1, 12.0}};
  const auto complete = variance_components(numbers);
  numbers.push_back({7, 0, 100.0});
  const auto with_incomplete = variance_components(numbers);
  ASSERT_TRUE(complete && with_incomplete);
  EXPECT_EQ(with_incomplete->participants, 2U);
  EXPECT_EQ(with_incomplete->within_sd, complete->within_sd);
}

TEST(VarianceComponents, NeedRepetitionsCellsAndParticipants) {
  EXPECT_FALSE(variance_components(std::vector<CellNumber>{}));
  EXPECT_FALSE(variance_components(
      std::vector<CellNumber>{{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 3.0}, {1, 1, 5.0}}));
  EXPECT_FALSE(variance_components(
      std::vector<CellNumber>{{0, 0, 1.0}, {0, 0, 2.0}, {1, 0, 3.0}, {1, 0, 5.0}}));
  EXPECT_FALSE(variance_components(
      std::vector<CellNumber>{{0, 0, 1.0}, {0, 0, 2.0}, {0, 1, 3.0}, {0, 1, 5.0}}));
}

// 400 participants, 4 cells, 6 numbers each. The standard errors are below 0.1, 0.06 and 0.03.
TEST(VarianceComponents, RecoverTheModel) {
  std::vector<CellNumber> numbers{};
  Random random(1);
  for (std::size_t participant = 0; participant < 400; ++participant) {
    const double own = 2.0 * random.normal();
    for (std::size_t cell = 0; cell < 4; ++cell) {
      const double deviation = 1.5 * random.normal();
      for (int i = 0; i < 6; ++i) {
        const double y = static_cast<double>(cell) + own + deviation + random.normal();
        numbers.push_back({participant, cell, y});
      }
    }
  }
  const auto found = variance_components(numbers);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 1.5, 0.5);
  EXPECT_NEAR(found->participant_sd, 2.0, 0.4);
  EXPECT_NEAR(found->interaction_sd, 1.5, 0.25);
  EXPECT_NEAR(found->within_sd, 1.0, 0.1);
}

}  // namespace
}  // namespace asperity
