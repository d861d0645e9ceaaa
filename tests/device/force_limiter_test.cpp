// The limiter's promises, by hand-worked cases and over random wrenches.

#include "device/force_limiter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

// Only the limits of the magnitude act.
constexpr ForceLimits kMagnitudeOnly{
    .force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6, .slew_N_m = 1e6};

Wrench force(double x, double y, double z) { return {.force_N = glm::dvec3(x, y, z)}; }

// Components of any sign over many orders of magnitude.
glm::dvec3 any_vector(Random& random) {
  const auto component = [&random] {
    return random.normal() * std::pow(10.0, 4.0 * random.uniform() - 2.0);
  };
  const double x = component();
  const double y = component();
  return {x, y, component()};
}

TEST(ForceLimiter, PassesAWrenchWithinTheLimitsBitForBit) {
  ForceLimiter limiter(kMagnitudeOnly);
  const Wrench wanted{.force_N = {0.1, -0.2, 0.3}, .torque_N_m = {0.01, 0.02, -0.03}};
  const LimitedWrench limited = limiter.limit(wanted, kDt_s);
  EXPECT_EQ(limited.wrench.force_N, wanted.force_N);
  EXPECT_EQ(limited.wrench.torque_N_m, wanted.torque_N_m);
  EXPECT_EQ(limited.reasons, 0);
}

TEST(ForceLimiter, PassesAForceThatIsExactlyTheLimit) {
  ForceLimiter limiter(kMagnitudeOnly);
  const LimitedWrench limited = limiter.limit(force(3.0, 0.0, -4.0), kDt_s);  // √(9 + 16) = 5
  EXPECT_EQ(limited.wrench.force_N, glm::dvec3(3.0, 0.0, -4.0));
  EXPECT_EQ(limited.reasons, 0);
}

TEST(ForceLimiter, ShortensALongForceAndKeepsItsDirection) {
  ForceLimiter limiter(kMagnitudeOnly);
  const LimitedWrench limited = limiter.limit(force(30.0, 0.0, 40.0), kDt_s);
  EXPECT_NEAR(limited.wrench.force_N.x, 3.0, 1e-13);
  EXPECT_EQ(limited.wrench.force_N.y, 0.0);
  EXPECT_NEAR(limited.wrench.force_N.z, 4.0, 1e-13);
  EXPECT_TRUE(limited.has(LimitReason::force));
  EXPECT_FALSE(limited.has(LimitReason::slew));
}

TEST(ForceLimiter, ShortensALongTorqueAndLeavesTheForceAlone) {
  ForceLimiter limiter(kMagnitudeOnly);
  const LimitedWrench limited =
      limiter.limit({.force_N = {1.0, 2.0, 3.0}, .torque_N_m = {0.0, -0.4, 0.0}}, kDt_s);
  EXPECT_EQ(limited.wrench.force_N, glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(limited.wrench.torque_N_m.y, -0.1, 1e-15);
  EXPECT_TRUE(limited.has(LimitReason::torque));
  EXPECT_FALSE(limited.has(LimitReason::force));
}

TEST(ForceLimiter, KeepsTheDirectionOfAForceWhoseSquareOverflows) {
  ForceLimiter limiter(kMagnitudeOnly);
  const double huge = std::numeric_limits<double>::max();
  const LimitedWrench limited = limiter.limit(force(huge, -huge, 0.0), kDt_s);
  EXPECT_NEAR(limited.wrench.force_N.x, 5.0 / std::sqrt(2.0), 1e-13);
  EXPECT_NEAR(limited.wrench.force_N.y, -5.0 / std::sqrt(2.0), 1e-13);
}

TEST(ForceLimiter, IsNeverAboveTheLimitByOneUnitInTheLastPlace) {
  Random random(71);
  // 5 N, and limits that binary fractions cannot hold.
  for (const double limit_N : {5.0, 3.3, 0.1, 7.123456789}) {
    ForceLimiter limiter(
        {.force_N = limit_N, .torque_N_m = 0.013, .slew_N = 2.0, .slew_N_m = 0.02});
    int limited_count = 0;
    for (int i = 0; i < 50'000; ++i) {
      const Wrench wanted{.force_N = any_vector(random), .torque_N_m = any_vector(random)};
      const LimitedWrench limited = limiter.limit(wanted, kDt_s * random.uniform());
      ASSERT_LE(glm::length(limited.wrench.force_N), limit_N);
      ASSERT_LE(glm::length(limited.wrench.torque_N_m), 0.013);
      limited_count += limited.has(LimitReason::force) ? 1 : 0;
    }
    EXPECT_GT(limited_count, 1000);
  }
}

TEST(ForceLimiter, KeepsTheDirectionOfAnyForceAndTorque) {
  Random random(72);
  ForceLimiter limiter(kMagnitudeOnly);
  for (int i = 0; i < 50'000; ++i) {
    const Wrench wanted{.force_N = any_vector(random), .torque_N_m = any_vector(random)};
    const LimitedWrench limited = limiter.limit(wanted, kDt_s);
    const glm::dvec3 turned =
        glm::normalize(limited.wrench.force_N) - glm::normalize(wanted.force_N);
    ASSERT_LT(glm::length(turned), 1e-12);
    const glm::dvec3 twisted =
        glm::normalize(limited.wrench.torque_N_m) - glm::normalize(wanted.torque_N_m);
    ASSERT_LT(glm::length(twisted), 1e-12);
  }
}

// The distance of a point from the line from 0 to another one, by its definition: searched, not solved.
double growth_from(const glm::dvec3& held, const glm::dvec3& next) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double third = (high - low) / 3.0;
    const double nearer = glm::distance(next, (low + third) * held);
    const double farther = glm::distance(next, (high - third) * held);
    (nearer < farther ? high : low) = nearer < farther ? high - third : low + third;
  }
  return glm::distance(next, 0.5 * (low + high) * held);
}

// What the motors held, with the time at which it ended: the windows before any moment.
class HeldForces final {
 public:
  // The most that `next`, sent `elapsed_s` after the last one, grows from what was held within the window before it.
  double growth_to(const glm::dvec3& next, double elapsed_s) {
    time_s_ += elapsed_s;
    double most = growth_from(last_, next);
    for (const auto& [vector, ended_s] : ended_) {
      if (time_s_ - ended_s < ForceLimiter::kWindow_s - 1e-7) {
        most = std::max(most, growth_from(vector, next));
      }
    }
    ended_.emplace_back(last_, time_s_);
    last_ = next;
    if (ended_.size() > 64) ended_.erase(ended_.begin());
    return most;
  }

 private:
  double time_s_ = 0.0;
  glm::dvec3 last_{0.0};
  std::vector<std::pair<glm::dvec3, double>> ended_{};
};

TEST(ForceLimiter, GrowsByNoMoreThanOneNewtonInAMillisecondAtEveryRate) {
  // Of 0.25 ms, four steps together grow by 1 N: 1, 1, 1, 1, 2; of 2 ms, each one does.
  const std::vector<std::pair<double, std::vector<double>>> rises{
      {2e-3, {1, 2, 3, 4}},
      {1e-3, {1, 2, 3, 4}},
      {0.5e-3, {1, 1, 2, 2, 3, 3}},
      {333'333e-9, {1, 1, 1, 2, 2, 2, 3}},
      {0.25e-3, {1, 1, 1, 1, 2, 2, 2, 2, 3}}};
  for (const auto& [period_s, expected_N] : rises) {
    ForceLimiter limiter(ForceLimits{});
    for (const double force_N : expected_N) {
      const LimitedWrench limited = limiter.limit(force(0.0, 0.0, 5.0), period_s);
      EXPECT_NEAR(limited.wrench.force_N.z, force_N, 1e-13) << period_s;
      EXPECT_TRUE(limited.has(LimitReason::slew));
    }
  }
}

TEST(ForceLimiter, SpreadsASteadyRiseOverTheWindow) {
  ForceLimiter limiter(ForceLimits{});
  for (int i = 1; i <= 20; ++i) {
    EXPECT_EQ(limiter.limit(force(0.0, 0.0, 0.25 * i), 0.25e-3).reasons, 0);
  }
}

TEST(ForceLimiter, NeverDelaysAFall) {
  ForceLimiter limiter(ForceLimits{});
  for (int i = 0; i < 5; ++i) limiter.limit(force(0.0, 3.0, 4.0), kDt_s);
  LimitedWrench limited = limiter.limit(force(0.0, 0.6, 0.8), kDt_s);
  EXPECT_EQ(limited.wrench.force_N, glm::dvec3(0.0, 0.6, 0.8));
  EXPECT_EQ(limited.reasons, 0);
  limited = limiter.limit(force(0.0, 0.0, 0.0), kDt_s);
  EXPECT_EQ(limited.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(limited.reasons, 0);
  // The part along the last force falls at once, the rest grows.
  for (int i = 0; i < 5; ++i) limiter.limit(force(0.0, 0.0, 5.0), kDt_s);
  limited = limiter.limit(force(3.0, 0.0, 2.0), kDt_s);
  EXPECT_NEAR(glm::distance(limited.wrench.force_N, glm::dvec3(1.0, 0.0, 2.0)), 0.0, 1e-13);
  EXPECT_TRUE(limited.has(LimitReason::slew));
}

TEST(ForceLimiter, GrowsAnewAfterAFallWithinTheWindow) {
  ForceLimiter limiter(ForceLimits{});
  for (int i = 0; i < 20; ++i) limiter.limit(force(0.0, 0.0, 5.0), 0.25e-3);
  EXPECT_EQ(limiter.limit(force(0.0, 0.0, 0.0), 0.25e-3).wrench.force_N.z, 0.0);
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, 5.0), 0.25e-3).wrench.force_N.z, 1.0, 1e-13);
}

TEST(ForceLimiter, TurnsAroundThroughZero) {
  ForceLimiter limiter(ForceLimits{});
  for (int i = 0; i < 5; ++i) limiter.limit(force(0.0, 0.0, 5.0), kDt_s);
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, -5.0), kDt_s).wrench.force_N.z, -1.0, 1e-13);
}

TEST(ForceLimiter, GrowsTheTorqueByAFifthOfItsLimitAndLeavesTheForceAlone) {
  ForceLimiter limiter(ForceLimits{});
  const auto torque = [&](double x) {
    return limiter.limit({.force_N = {0.5, 0.0, 0.0}, .torque_N_m = {x, 0.0, 0.0}}, kDt_s);
  };
  for (const double expected_N_m : {-0.02, -0.04, -0.06, -0.08}) {
    EXPECT_NEAR(torque(-0.1).wrench.torque_N_m.x, expected_N_m, 1e-15);
  }
  const LimitedWrench limited = torque(0.1);
  EXPECT_NEAR(limited.wrench.torque_N_m.x, 0.02, 1e-15);
  EXPECT_TRUE(limited.has(LimitReason::slew));
  EXPECT_EQ(limited.wrench.force_N.x, 0.5);
  limiter.reset();
  EXPECT_NEAR(torque(-0.1).wrench.torque_N_m.x, -0.02, 1e-15);
}

// What the header says, for forces of any size and direction and at any rate; the window is followed separately.
TEST(ForceLimiter, GrowsInNoWindowByMoreThanTheLimitAndFallsAsWanted) {
  Random random(73);
  const ForceLimits limits{};
  ForceLimiter unslewed(kMagnitudeOnly);
  for (const double rate_Hz : {500.0, 1000.0, 1700.0, 4000.0, 10'000.0}) {
    ForceLimiter limiter(limits);
    HeldForces held{};
    glm::dvec3 last_N{0.0};
    int slewed_count = 0;
    for (int i = 0; i < 4000; ++i) {
      const double elapsed_s = (0.5 + 0.5 * random.uniform()) / rate_Hz;
      const Wrench wanted{.force_N = random.uniform() < 0.5 ? any_vector(random)
                                                            : last_N + 0.3 * any_vector(random)};
      const glm::dvec3 aim_N = unslewed.limit(wanted, elapsed_s).wrench.force_N;
      const LimitedWrench limited = limiter.limit(wanted, elapsed_s);
      const glm::dvec3 force_N = limited.wrench.force_N;
      ASSERT_LE(held.growth_to(force_N, elapsed_s), limits.slew_N + 1e-7) << rate_Hz;
      if (limited.has(LimitReason::slew)) {
        ++slewed_count;
      } else {
        ASSERT_EQ(force_N, aim_N);
      }
      if (glm::length(last_N) > 1e-3) {
        const glm::dvec3 along = glm::normalize(last_N);
        const double wanted_N = glm::dot(aim_N, along);
        if (wanted_N >= 0.0 && wanted_N <= glm::length(last_N)) {
          ASSERT_NEAR(glm::dot(force_N, along), wanted_N, 1e-12);
        }
      }
      last_N = force_N;
    }
    EXPECT_GT(slewed_count, 200) << rate_Hz;
  }
}

TEST(ForceLimiter, OfOneStepInTheWindowIsAsNearToTheWantedForceAsItMayBe) {
  Random random(77);
  ForceLimiter limiter(ForceLimits{});
  ForceLimiter unslewed(kMagnitudeOnly);
  glm::dvec3 last_N{0.0};
  for (int i = 0; i < 2000; ++i) {
    const Wrench wanted{.force_N = last_N + any_vector(random)};
    const glm::dvec3 aim_N = unslewed.limit(wanted, kDt_s).wrench.force_N;
    const glm::dvec3 force_N = limiter.limit(wanted, kDt_s).wrench.force_N;
    const double distance_N = glm::distance(force_N, aim_N);
    for (int other = 0; other < 50; ++other) {
      const glm::dvec3 near_N = force_N + 0.01 * any_vector(random);
      if (glm::length(near_N) > 5.0 || growth_from(last_N, near_N) > 1.0) continue;
      ASSERT_GE(glm::distance(near_N, aim_N), distance_N - 1e-6);
    }
    last_N = force_N;
  }
}

// More calls in a window than are remembered.
TEST(ForceLimiter, GrowsNotAtAllWithMoreCallsThanItRemembers) {
  ForceLimiter limiter(ForceLimits{});
  limiter.limit(force(0.0, 0.0, 0.5), 1e-6);
  for (int i = 0; i < 100; ++i) limiter.limit(force(0.0, 0.0, 0.5), 1e-6);
  EXPECT_EQ(limiter.limit(force(0.0, 0.0, 0.6), 1e-6).wrench.force_N.z, 0.5);
  EXPECT_EQ(limiter.limit(force(0.0, 0.0, 0.1), 1e-6).wrench.force_N.z, 0.1);
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, 5.0), 1e-6).wrench.force_N.z, 0.1, 1e-13);
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, 5.0), kDt_s).wrench.force_N.z, 1.1, 1e-13);
}

// Where the ends of a line have exactly the length of the limit, the rounded point between them may lie above it.
TEST(ForceLimiter, IsNotRoundedAboveTheLimitWhileItTurns) {
  Random random(74);
  const ForceLimits limits{};
  ForceLimiter limiter(limits);
  int slewed_count = 0;
  for (int i = 0; i < 200'000; ++i) {
    const LimitedWrench limited =
        limiter.limit({.force_N = limits.force_N * glm::normalize(any_vector(random)),
                       .torque_N_m = limits.torque_N_m * glm::normalize(any_vector(random))},
                      kDt_s);
    ASSERT_LE(glm::length(limited.wrench.force_N), limits.force_N);
    ASSERT_LE(glm::length(limited.wrench.torque_N_m), limits.torque_N_m);
    slewed_count += limited.has(LimitReason::slew) ? 1 : 0;
  }
  EXPECT_GT(slewed_count, 1000);
}

// Whatever the bits of a double say: infinities, denormals, numbers whose square overflows.
TEST(ForceLimiter, HoldsEveryLimitForWrenchesOfRandomBits) {
  Random random(76);
  const ForceLimits limits{};
  ForceLimiter limiter(limits);
  const auto any = [&random] {
    const auto bits = std::bit_cast<double>(random.bits());
    // Half of them of a size that is felt, so that a change is more than from limit to limit.
    return random.uniform() < 0.5 ? bits : 0.2 * random.normal();
  };
  const auto vector = [&any] {
    const double x = any();
    const double y = any();
    return glm::dvec3(x, y, any());
  };
  Wrench last{};
  int slewed_count = 0;
  for (int i = 0; i < 50'000; ++i) {
    const glm::dvec3 force_N = vector();
    const LimitedWrench limited =
        limiter.limit({.force_N = force_N, .torque_N_m = vector()}, kDt_s);
    const Wrench& sent = limited.wrench;
    ASSERT_LE(glm::length(sent.force_N), limits.force_N);
    ASSERT_LE(glm::length(sent.torque_N_m), limits.torque_N_m);
    if (!limited.has(LimitReason::not_finite)) {
      ASSERT_LE(growth_from(last.force_N, sent.force_N), limits.slew_N + 1e-7);
      ASSERT_LE(growth_from(last.torque_N_m, sent.torque_N_m), limits.slew_N_m + 1e-9);
    }
    slewed_count += limited.has(LimitReason::slew) ? 1 : 0;
    last = sent;
  }
  EXPECT_GT(slewed_count, 1000);
}

TEST(ForceLimiter, SendsZeroForAnyComponentThatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int component = 0; component < 6; ++component) {
      ForceLimiter limiter(kMagnitudeOnly);
      Wrench wanted{.force_N = glm::dvec3(1.0), .torque_N_m = glm::dvec3(0.01)};
      (component < 3 ? wanted.force_N[component] : wanted.torque_N_m[component - 3]) = bad;
      const LimitedWrench limited = limiter.limit(wanted, kDt_s);
      EXPECT_EQ(limited.wrench.force_N, glm::dvec3(0.0));
      EXPECT_EQ(limited.wrench.torque_N_m, glm::dvec3(0.0));
      EXPECT_TRUE(limited.has(LimitReason::not_finite));
    }
  }
}

TEST(ForceLimiter, FallsToZeroAtOnceAndRisesAgainFromZeroAfterANan) {
  ForceLimiter limiter({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1.0});
  for (int i = 0; i < 4; ++i) {
    limiter.limit(force(0.0, 0.0, 4.0), kDt_s);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(limiter.limit(force(0.0, nan, 4.0), kDt_s).wrench.force_N, glm::dvec3(0.0));
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, 4.0), kDt_s).wrench.force_N.z, 1.0, 1e-13);
}

TEST(ForceLimiter, CountsTheNextChangeFromZeroAfterAReset) {
  ForceLimiter limiter({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1.0});
  for (int i = 0; i < 4; ++i) {
    limiter.limit(force(4.0, 0.0, 0.0), kDt_s);
  }
  limiter.reset();
  EXPECT_NEAR(limiter.limit(force(4.0, 0.0, 0.0), kDt_s).wrench.force_N.x, 1.0, 1e-13);
}

TEST(ForceLimiter, TakesATimeThatIsNotPositiveForNone) {
  for (const double elapsed_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    ForceLimiter limiter(ForceLimits{});
    limiter.limit(force(1.0, 0.0, 0.0), kDt_s);
    const LimitedWrench limited = limiter.limit(force(2.0, 0.0, 0.0), elapsed_s);
    EXPECT_NEAR(limited.wrench.force_N.x, 1.0, 1e-13);
    EXPECT_TRUE(limited.has(LimitReason::slew));
  }
}

TEST(ForceLimiter, RefusesALimitThatIsNotPositiveAndFiniteByName) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](const ForceLimits& limits) {
    return refusal_of<std::invalid_argument>([&] { ForceLimiter limiter(limits); });
  };
  EXPECT_EQ(refusal({.force_N = 0.0}),
            "force_N of the force limits is 0; it must be positive and finite.");
  EXPECT_EQ(refusal({.torque_N_m = -1.5}),
            "torque_N_m of the force limits is -1.5; it must be positive and finite.");
  EXPECT_EQ(refusal({.slew_N = infinity}),
            "slew_N of the force limits is inf; it must be positive and finite.");
  EXPECT_EQ(refusal({.slew_N_m = 0.0}),
            "slew_N_m of the force limits is 0; it must be positive and finite.");
}

TEST(ForceLimiter, DoesNotTouchTheHeap) {
  ForceLimiter limiter(ForceLimits{});
  AllocationGuard guard;
  limiter.limit(force(100.0, 0.0, 0.0), kDt_s);
  limiter.limit(force(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), kDt_s);
  limiter.reset();
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
