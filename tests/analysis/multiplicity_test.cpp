// Adjusted p values, worked out by hand.

#include "analysis/tests/multiplicity.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// Ascending 0.01, 0.02, 0.03, 0.2: times 4, 3, 2, 1 is 0.04, 0.06, 0.06, 0.2.
TEST(HolmAdjusted, MultipliesByTheTestsThatAreLeftAndNeverFalls) {
  const std::vector<double> p{0.03, 0.01, 0.2, 0.02};
  const std::vector<double> adjusted = holm_adjusted(p);
  EXPECT_NEAR(adjusted[0], 0.06, 1e-15);
  EXPECT_NEAR(adjusted[1], 0.04, 1e-15);
  EXPECT_NEAR(adjusted[2], 0.2, 1e-15);
  EXPECT_NEAR(adjusted[3], 0.06, 1e-15);
  EXPECT_EQ(holm_adjusted(std::vector<double>{0.9, 0.8}), (std::vector<double>{1.0, 1.0}));
}

// Ascending 0.01, 0.04, 0.03 → 0.01·3, 0.03·3/2, 0.04: the second is pulled down to 0.04.
TEST(BenjaminiHochbergAdjusted, DividesByTheRankAndNeverRises) {
  const std::vector<double> adjusted =
      benjamini_hochberg_adjusted(std::vector<double>{0.01, 0.04, 0.03});
  EXPECT_NEAR(adjusted[0], 0.03, 1e-15);
  EXPECT_NEAR(adjusted[1], 0.04, 1e-15);
  EXPECT_NEAR(adjusted[2], 0.04, 1e-15);
}

TEST(AdjustedP, RefusesWhatIsNoProbability) {
  EXPECT_THROW(holm_adjusted(std::vector<double>{1.1}), std::invalid_argument);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace asperity
