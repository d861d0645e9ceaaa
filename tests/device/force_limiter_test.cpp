// The limiter's promises, by hand-worked cases and over random wrenches.

#include "device/force_limiter.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/random.h"
#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

// A slew so fast that only the magnitude limits act.
constexpr ForceLimits kMagnitudeOnly{
    .force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 1e9, .slew_N_m_per_s = 1e9};

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
        {.force_N = limit_N, .torque_N_m = 0.013, .slew_N_per_s = 2000.0, .slew_N_m_per_s = 20.0});
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

TEST(ForceLimiter, ChangesTheForceByNoMoreThanTheSlewAllows) {
  // 2000 N/s for 1 ms is 2 N per call: 0 → 5 N takes 2, 4, 5.
  ForceLimiter limiter({.force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 2000.0});
  LimitedWrench limited = limiter.limit(force(0.0, 0.0, 5.0), kDt_s);
  EXPECT_NEAR(limited.wrench.force_N.z, 2.0, 1e-13);
  EXPECT_TRUE(limited.has(LimitReason::slew));
  limited = limiter.limit(force(0.0, 0.0, 5.0), kDt_s);
  EXPECT_NEAR(limited.wrench.force_N.z, 4.0, 1e-13);
  limited = limiter.limit(force(0.0, 0.0, 5.0), kDt_s);
  EXPECT_EQ(limited.wrench.force_N.z, 5.0);
  EXPECT_EQ(limited.reasons, 0);
}

TEST(ForceLimiter, ChangesTheTorqueByNoMoreThanItsSlewAllowsAndLeavesTheForceAlone) {
  // 40 N·m/s for 1 ms is 0.04 N·m per call: −0.1 → 0.1 N·m takes five.
  ForceLimiter limiter(
      {.force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 1e9, .slew_N_m_per_s = 40.0});
  const auto torque = [&](double x) {
    return limiter.limit({.force_N = {5.0, 0.0, 0.0}, .torque_N_m = {x, 0.0, 0.0}}, kDt_s);
  };
  for (int i = 0; i < 3; ++i) torque(-0.1);
  for (const double expected_N_m : {-0.06, -0.02, 0.02, 0.06}) {
    const LimitedWrench limited = torque(0.1);
    EXPECT_NEAR(limited.wrench.torque_N_m.x, expected_N_m, 1e-15);
    EXPECT_TRUE(limited.has(LimitReason::slew));
    EXPECT_EQ(limited.wrench.force_N.x, 5.0);
  }
  EXPECT_NEAR(torque(0.1).wrench.torque_N_m.x, 0.1, 1e-15);
  EXPECT_EQ(torque(0.1).reasons, 0);
  limiter.reset();
  EXPECT_NEAR(torque(0.1).wrench.torque_N_m.x, 0.04, 1e-15);
}

TEST(ForceLimiter, ReachesTheLargestWrenchFromZeroWithinAMillisecondByDefault) {
  ForceLimiter limiter(ForceLimits{});
  const Wrench wanted{.force_N = {0.0, 3.0, 4.0}, .torque_N_m = {0.06, 0.0, 0.08}};
  EXPECT_EQ(limiter.limit(wanted, kDt_s).reasons, 0);
}

TEST(ForceLimiter, StaysOnTheLineFromTheLastForceToTheNewOne) {
  Random random(73);
  const ForceLimits limits{.force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 1500.0};
  ForceLimiter limiter(limits);
  ForceLimiter unslewed(kMagnitudeOnly);
  glm::dvec3 last_N{0.0};
  int slewed_count = 0;
  for (int i = 0; i < 50'000; ++i) {
    const Wrench wanted{.force_N = any_vector(random)};
    const double dt_s = kDt_s * (0.5 + random.uniform());
    const glm::dvec3 aim_N = unslewed.limit(wanted, kDt_s).wrench.force_N;
    const LimitedWrench limited = limiter.limit(wanted, dt_s);
    const glm::dvec3 force_N = limited.wrench.force_N;
    const double change_N = glm::length(force_N - last_N);
    ASSERT_LE(change_N, limits.slew_N_per_s * dt_s + 1e-12);
    ASSERT_LE(glm::length(force_N),
              std::max(glm::length(last_N), glm::length(aim_N)) * (1.0 + 1e-15));
    if (limited.has(LimitReason::slew)) {
      ++slewed_count;
      ASSERT_NEAR(change_N, limits.slew_N_per_s * dt_s, 1e-12);  // no slower than it has to be
      // On the line: the way done and the way left add up to the whole.
      ASSERT_NEAR(change_N + glm::length(aim_N - force_N), glm::length(aim_N - last_N), 1e-12);
    } else {
      ASSERT_EQ(force_N, aim_N);
    }
    last_N = force_N;
  }
  EXPECT_GT(slewed_count, 1000);
}

// Where last and new force both have exactly the length of the limit, the rounded point between
// them may lie above it.
TEST(ForceLimiter, IsNotRoundedAboveTheLimitByTheSlew) {
  Random random(74);
  constexpr double kLimit_N = 5.0;
  int slewed_count = 0;
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 from_N = kLimit_N * glm::normalize(any_vector(random));
    const glm::dvec3 to_N = kLimit_N * glm::normalize(from_N + 1e-14 * any_vector(random));
    if (glm::length(from_N) != kLimit_N || glm::length(to_N) != kLimit_N || from_N == to_N) {
      continue;
    }
    ForceLimiter limiter({.force_N = kLimit_N, .torque_N_m = 0.1, .slew_N_per_s = 1.0});
    limiter.limit({.force_N = from_N}, 10.0);
    const LimitedWrench limited =
        limiter.limit({.force_N = to_N}, 0.5 * glm::distance(from_N, to_N));
    ASSERT_LE(glm::length(limited.wrench.force_N), kLimit_N);
    slewed_count += limited.has(LimitReason::slew) ? 1 : 0;
  }
  EXPECT_GT(slewed_count, 1000);
}

TEST(ForceLimiter, IsNotRoundedAboveTheLimitOfTorqueByItsSlew) {
  Random random(75);
  constexpr double kLimit_N_m = 0.1;
  int slewed_count = 0;
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 from_N_m = kLimit_N_m * glm::normalize(any_vector(random));
    const glm::dvec3 to_N_m = kLimit_N_m * glm::normalize(from_N_m + 1e-16 * any_vector(random));
    if (glm::length(from_N_m) > kLimit_N_m || glm::length(to_N_m) > kLimit_N_m ||
        from_N_m == to_N_m) {
      continue;
    }
    ForceLimiter limiter({.torque_N_m = kLimit_N_m, .slew_N_m_per_s = 1.0});
    limiter.limit({.torque_N_m = from_N_m}, 10.0);
    const LimitedWrench limited =
        limiter.limit({.torque_N_m = to_N_m}, 0.5 * glm::distance(from_N_m, to_N_m));
    ASSERT_LE(glm::length(limited.wrench.torque_N_m), kLimit_N_m);
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
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 force_N = vector();
    const double dt_s = kDt_s * (0.5 + 3.5 * random.uniform());
    const LimitedWrench limited = limiter.limit({.force_N = force_N, .torque_N_m = vector()}, dt_s);
    const Wrench& sent = limited.wrench;
    ASSERT_LE(glm::length(sent.force_N), limits.force_N);
    ASSERT_LE(glm::length(sent.torque_N_m), limits.torque_N_m);
    if (!limited.has(LimitReason::not_finite)) {
      ASSERT_LE(glm::distance(sent.force_N, last.force_N), limits.slew_N_per_s * dt_s + 1e-12);
      ASSERT_LE(glm::distance(sent.torque_N_m, last.torque_N_m),
                limits.slew_N_m_per_s * dt_s + 1e-14);
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
  ForceLimiter limiter({.force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 1000.0});
  for (int i = 0; i < 4; ++i) {
    limiter.limit(force(0.0, 0.0, 4.0), kDt_s);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(limiter.limit(force(0.0, nan, 4.0), kDt_s).wrench.force_N, glm::dvec3(0.0));
  EXPECT_NEAR(limiter.limit(force(0.0, 0.0, 4.0), kDt_s).wrench.force_N.z, 1.0, 1e-13);
}

TEST(ForceLimiter, CountsTheNextChangeFromZeroAfterAReset) {
  ForceLimiter limiter({.force_N = 5.0, .torque_N_m = 0.1, .slew_N_per_s = 1000.0});
  for (int i = 0; i < 4; ++i) {
    limiter.limit(force(4.0, 0.0, 0.0), kDt_s);
  }
  limiter.reset();
  EXPECT_NEAR(limiter.limit(force(4.0, 0.0, 0.0), kDt_s).wrench.force_N.x, 1.0, 1e-13);
}

TEST(ForceLimiter, AllowsNoChangeInATimeThatIsNotPositive) {
  ForceLimiter limiter(kMagnitudeOnly);
  const auto wrench = [](double size) {
    return Wrench{.force_N = {size, 0.0, 0.0}, .torque_N_m = {0.0, 0.01 * size, 0.0}};
  };
  limiter.limit(wrench(1.0), kDt_s);
  for (const double dt_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const LimitedWrench limited = limiter.limit(wrench(2.0), dt_s);
    EXPECT_EQ(limited.wrench.force_N, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(limited.wrench.torque_N_m, glm::dvec3(0.0, 0.01, 0.0));
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
  EXPECT_EQ(refusal({.slew_N_per_s = infinity}),
            "slew_N_per_s of the force limits is inf; it must be positive and finite.");
  EXPECT_EQ(refusal({.slew_N_m_per_s = 0.0}),
            "slew_N_m_per_s of the force limits is 0; it must be positive and finite.");
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
