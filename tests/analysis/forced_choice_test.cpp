// Holds the sensitivity of a choice to what two alternatives and guessing give in closed form.

#include "analysis/choices/forced_choice.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// The larger of two normal numbers d′ apart: P = Φ(d′/√2).
TEST(ForcedChoice, AmongTwoIsTheNormalDistribution) {
  const ForcedChoice choice{.alternatives = 2};
  for (const double d : {-3.0, -0.5, 0.0, 1.0, 4.5}) {
    EXPECT_NEAR(choice.share(d), 0.5 * std::erfc(-0.5 * d), 1e-14);
    EXPECT_NEAR(choice.slope(d), std::exp(-0.25 * d * d) / std::sqrt(4.0 * std::acos(-1.0)), 1e-14);
  }
}

TEST(ForcedChoice, WithoutSensitivityIsGuessing) {
  for (const std::size_t m : {2U, 3U, 6U, 12U}) {
    const ForcedChoice choice{.alternatives = m};
    EXPECT_NEAR(choice.share(0.0), 1.0 / static_cast<double>(m), 1e-14);
    EXPECT_NEAR(choice.dprime(1.0 / static_cast<double>(m)), 0.0, 1e-12);
  }
}

TEST(ForcedChoice, FindsTheSensitivityOfEveryShare) {
  const ForcedChoice choice{.alternatives = 6};
  for (const double d : {-2.5, 0.3, 2.0, 5.5}) {
    EXPECT_NEAR(choice.dprime(choice.share(d)), d, 1e-8);
  }
  EXPECT_EQ(choice.dprime(0.0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(choice.dprime(1.0), std::numeric_limits<double>::infinity());
}

TEST(ForcedChoice, RefusesWhatIsNoChoice) {
  EXPECT_EQ(ForcedChoice{.alternatives = 3}.dprime(1.0 / 3.0), 0.0) << "and not the rounding of it";
  EXPECT_THROW(ForcedChoice{.alternatives = 1}.share(1.0), std::invalid_argument);
  EXPECT_THROW(ForcedChoice{.alternatives = 3}.dprime(1.5), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
