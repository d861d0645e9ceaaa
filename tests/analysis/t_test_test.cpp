// Holds t tests to numbers that can be worked out on paper.

#include "analysis/tests/t_test.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// 1, 2, 3: mean 2, sd 1, t = 2·√3 with two degrees of freedom, whose tail is (1 − t/√(2 + t²))/2.
TEST(OneSampleT, IsTheMeanOverItsError) {
  constexpr std::array kSample{1.0, 2.0, 3.0};
  const OneSampleT t = one_sample_t(kSample);
  ASSERT_TRUE(t.test);
  EXPECT_NEAR(t.test->t, 2.0 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(t.test->p, 1.0 - std::sqrt(12.0 / 14.0), 1e-14);
  EXPECT_NEAR(one_sample_t(kSample, {.null_mean = 2.0}).test->p, 1.0, 1e-15);
}

TEST(OneSampleT, HasNoTestWithoutASpread) {
  EXPECT_FALSE(one_sample_t(std::array{4.0}).sd);
  const OneSampleT same = one_sample_t(std::array{0.3 - 0.2, 0.4 - 0.3, 0.1});
  EXPECT_EQ(same.sd, 0.0);
  EXPECT_FALSE(same.test);
  EXPECT_THROW(one_sample_t({}), std::invalid_argument);
  EXPECT_THROW(one_sample_t(std::array{1.0, std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
}

// Means 2 and 5, variances 1 and 4, three each: t = −3/√(5/3), df = (5/3)²/((1/9 + 16/9)/2).
TEST(WelchT, DoesNotPoolTheVariances) {
  constexpr std::array kFirst{1.0, 2.0, 3.0};
  constexpr std::array kSecond{3.0, 5.0, 7.0};
  const std::optional<WelchT> t = welch_t({.first = kFirst, .second = kSecond});
  ASSERT_TRUE(t);
  EXPECT_NEAR(t->t, -3.0 / std::sqrt(5.0 / 3.0), 1e-14);
  EXPECT_NEAR(t->df, 25.0 / 9.0 / (17.0 / 18.0), 1e-13);
  EXPECT_NEAR(t->d, -3.0 / std::sqrt(2.5), 1e-14);
  EXPECT_NEAR(t->difference, -3.0, 1e-14);
  // The interval at the confidence 1 − p ends at no difference.
  const std::optional<WelchT> wide = welch_t({.first = kFirst, .second = kSecond}, 1.0 - t->p);
  EXPECT_NEAR(wide->interval.low, -6.0, 1e-9);
  EXPECT_NEAR(wide->interval.high, 0.0, 1e-9);
  // J for four degrees of freedom: Γ(2)/(√2·Γ(3/2)) = √(2/π).
  EXPECT_NEAR(t->g / t->d, std::sqrt(2.0 / std::acos(-1.0)), 1e-14);
  EXPECT_FALSE(welch_t({.first = kFirst, .second = std::span(kSecond).first(1)}));
}

}  // namespace
}  // namespace asperity
