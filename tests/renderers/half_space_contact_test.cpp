// The elastic half-space: its kernel, and the closed forms of contacts. Lengths are in cells and pressures in E*, so that a load
// is a pressure and the sum of the loads is the force.

#include "renderers/elastic/half_space_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "renderers/elastic/love_kernel.h"
#include "tests/renderers/elastic_cells.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOutOfReach = -1e3;

class HalfSpace : public ::testing::Test {
 protected:
  const CellField& solved(const CellField& overlap) {
    contact_->clear();
    EXPECT_LE(contact_->solve(overlap, kConverged), kConverged.residual);
    return contact_->load_m();
  }
  std::unique_ptr<HalfSpaceContact> contact_ = std::make_unique<HalfSpaceContact>();
};

TEST(LoveKernel, HasTheValueOfASquareOnItselfAndOfAPointFarAway) {
  EXPECT_NEAR(love_displacement(0.0, 0.0), 4.0 * std::log(1.0 + std::numbers::sqrt2) / kPi, 1e-14);
  for (const double r : {6.0, 12.0, 24.0}) {
    EXPECT_NEAR(kPi * r * love_displacement(0.6 * r, -0.8 * r), 1.0, 0.05 / (r * r));
  }
}

TEST(LoveKernel, IsTheIntegralOfPointLoads) {
  constexpr int kPoints = 400;
  for (const auto& [x, y] : {std::pair{1.0, 0.0}, {1.0, 1.0}, {0.7, 2.3}}) {
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      for (int j = 0; j < kPoints; ++j) {
        sum += 1.0 / std::hypot(x - (i + 0.5) / kPoints + 0.5, y - (j + 0.5) / kPoints + 0.5);
      }
    }
    EXPECT_NEAR(love_displacement(x, y), sum / (kPoints * kPoints * kPi), 2e-6) << x << ' ' << y;
  }
}

TEST(HalfSpaceDisplacement, IsTheSumOverTheCellsWithoutPeriodicImages) {
  const auto displacement = std::make_unique<HalfSpaceDisplacement>();
  CellField load{};
  for (std::size_t i = 0; i < kCells; ++i) load[i] = static_cast<double>(i * 7919 % 101);
  CellField found{};
  displacement->of(load, found);
  for (const std::size_t cell : {std::size_t{0}, std::size_t{31}, std::size_t{500}, kCells - 1}) {
    const double sum = sum_of(load, [cell](double x, double y) {
      return love_displacement(from_centre(cell % kCellsAcross) - x,
                               from_centre(cell / kCellsAcross) - y);
    });
    EXPECT_NEAR(found[cell], sum, 1e-12 * sum);
  }
}

TEST_F(HalfSpace, HasTheForceAndTheRadiusOfHertzUnderABall) {
  for (const double radius : {2.5, 4.0, 6.0, 9.0, 12.0, 14.0}) {
    const double ball_radius = 3.0 * radius;
    const double depth = radius * radius / ball_radius;
    const CellField& load = solved(paraboloid(ball_radius, depth));
    const double force = 4.0 / 3.0 * std::sqrt(ball_radius) * std::pow(depth, 1.5);
    EXPECT_NEAR(force_of(load), force, 0.02 * force) << radius;
    const auto in_contact = static_cast<double>(
        std::count_if(load.begin(), load.end(), [](double each) { return each > 0.0; }));
    EXPECT_NEAR(std::sqrt(in_contact / kPi), radius, 1.0);
    const double greatest = 1.5 * force / (kPi * radius * radius);
    EXPECT_NEAR(*std::max_element(load.begin(), load.end()), greatest, 0.05 * greatest);
  }
}

TEST_F(HalfSpace, HasTheDisplacementOfAPointLoadOutsideTheContact) {
  const CellField& load = solved(paraboloid(16.0, 1.0));
  const double force = force_of(load);
  for (const std::size_t column : {std::size_t{24}, std::size_t{31}}) {
    const double r = std::hypot(from_centre(column), 0.5);
    // A Hertz contact of radius a adds the factor 1 + a²/(10 r²).
    EXPECT_NEAR(contact_->displacement_m()[16 * kCellsAcross + column],
                force / (kPi * r) * (1.0 + 1.6 / (r * r)), 0.01 * force / (kPi * r));
  }
}

TEST_F(HalfSpace, IsASpringUnderAFlatEndAndTurnsItBack) {
  constexpr double kRadius = 15.0;
  constexpr double kDepth = 1.0;
  const auto punch = [](double tilt) {
    return field_of([=](double x, double y) {
      return std::hypot(x, y) < kRadius ? kDepth + tilt * x : kOutOfReach;
    });
  };
  const double force = 2.0 * kRadius * kDepth;
  EXPECT_NEAR(force_of(solved(punch(0.0))), force, 0.03 * force);
  EXPECT_NEAR(contact_->load_m()[15 * kCellsAcross + 15], kDepth / (kPi * kRadius),
              0.02 * kDepth / (kPi * kRadius));
  constexpr double kTilt = 0.01;
  const double torque = 4.0 / 3.0 * kRadius * kRadius * kRadius * kTilt;
  EXPECT_NEAR(sum_of(solved(punch(kTilt)), [](double x, double) { return x; }), torque,
              0.05 * torque);
}

// F/l = πa²/(4R) and p₀ = a/(2R), so that F/l = πR·p₀², whatever the width in cells.
TEST_F(HalfSpace, HasTheLineLoadOfACylinder) {
  constexpr double kRadius = 40.0;
  const CellField& load =
      solved(field_of([](double x, double) { return 0.45 - 0.5 * x * x / kRadius; }));
  double per_length = 0.0;
  double greatest = 0.0;
  for (std::size_t column = 0; column < kCellsAcross; ++column) {
    per_length += load[15 * kCellsAcross + column];
    greatest = std::max(greatest, load[15 * kCellsAcross + column]);
  }
  EXPECT_NEAR(per_length, kPi * kRadius * greatest * greatest, 0.05 * per_length);
  EXPECT_NEAR(greatest, 0.5 * std::sqrt(4.0 * kRadius * per_length / kPi) / kRadius,
              0.05 * greatest);
}

/// The loads of a wide flat end with waves along x, with a crest in the middle.
CellField waves(double depth, double amplitude, double wavelength) {
  return field_of(
      [=](double x, double) { return depth + amplitude * std::cos(2.0 * kPi * x / wavelength); });
}

// In full contact the waves add p*·cos(2πx/λ) with p* = πE*A/λ to the pressure.
TEST_F(HalfSpace, HasThePressureOfWestergaardUnderWaves) {
  constexpr double kAmplitude = 0.05;
  constexpr double kCrestToCrest = 16.0;
  constexpr std::size_t kMiddle = 15 * kCellsAcross + 15;
  const double flat = solved(waves(4.0, 0.0, kCrestToCrest))[kMiddle];
  const double crest = solved(waves(4.0, kAmplitude, kCrestToCrest))[kMiddle];
  const double trough = solved(waves(4.0, -kAmplitude, kCrestToCrest))[kMiddle];
  const double amplitude = kPi * kAmplitude / kCrestToCrest * std::cos(kPi / kCrestToCrest);
  EXPECT_NEAR(crest - flat, amplitude, 0.05 * amplitude);
  EXPECT_NEAR(flat - trough, amplitude, 0.05 * amplitude);
}

// On the crests only: strips of half-width a with the mean pressure p* sin²(πa/λ) over a wave.
TEST_F(HalfSpace, HasTheMeanPressureOfWestergaardOnPartOfTheWaves) {
  constexpr double kAmplitude = 0.3;
  constexpr double kCrestToCrest = 10.0;
  for (const double depth : {1.2, 1.6, 2.8}) {
    const CellField& load = solved(waves(depth, kAmplitude, kCrestToCrest));
    double mean = 0.0;
    double in_contact = 0.0;
    for (std::size_t column = 11; column < 21; ++column) {
      mean += load[15 * kCellsAcross + column] / kCrestToCrest;
      in_contact += load[15 * kCellsAcross + column] > 0.0 ? 1.0 : 0.0;
    }
    ASSERT_GT(in_contact, 3.0);
    ASSERT_LT(in_contact, 9.0);
    const double full = kPi * kAmplitude / kCrestToCrest;
    const double squared_sine = mean / full;
    const double half_width = kCrestToCrest / kPi * std::asin(std::sqrt(squared_sine));
    EXPECT_NEAR(0.5 * in_contact, half_width, 0.6) << depth;
    const double off = std::sin(0.5 * kPi / kCrestToCrest);  // of the cells next to the crest
    const double next =
        2.0 * full * std::sqrt(squared_sine - off * off) * std::cos(0.5 * kPi / kCrestToCrest);
    EXPECT_NEAR(load[15 * kCellsAcross + 15], next, 0.05 * next) << depth;
  }
}

TEST_F(HalfSpace, AddsTheDisplacementsOfTwoDistantPunches) {
  constexpr double kDistance = 24.0;
  const auto square = [](double x, double y, double at) {
    return std::abs(x - at) < 2.0 && std::abs(y) < 2.0;
  };
  const double alone = force_of(solved(field_of(
      [&](double x, double y) { return square(x, y, 0.5 * kDistance) ? 1.0 : kOutOfReach; })));
  const double both = force_of(solved(field_of([&](double x, double y) {
    return square(x, y, 0.5 * kDistance) || square(x, y, -0.5 * kDistance) ? 1.0 : kOutOfReach;
  })));
  EXPECT_NEAR(0.5 * both, 1.0 / (1.0 / alone + 1.0 / (kPi * kDistance)), 0.005 * alone);
  EXPECT_LT(0.5 * both, 0.97 * alone);
}

/// Work of the contact on a ball that is led around a loop over waves, relative to the work done either way.
double work_around_a_loop(const HalfSpaceContact::Effort& effort, int steps) {
  const auto contact = std::make_unique<HalfSpaceContact>();
  constexpr double kCrestToCrest = 10.0;
  constexpr double kHeight = 0.5;
  double net = 0.0;
  double gross = 0.0;
  for (int step = 0; step < steps; ++step) {
    const double angle = 2.0 * kPi * (step + 0.5) / steps;
    const double at = 3.0 * std::cos(angle);
    const CellField overlap = field_of([=](double x, double y) {
      return 2.0 + 0.8 * std::sin(angle + 0.4) - 0.5 * (x * x + y * y) / 15.0 +
             kHeight * std::cos(2.0 * kPi * (x + at) / kCrestToCrest);
    });
    contact->solve(overlap, effort);
    const CellField& load = contact->load_m();
    const double along = -sum_of(load, [=](double x, double) {
      return -kHeight * 2.0 * kPi / kCrestToCrest * std::sin(2.0 * kPi * (x + at) / kCrestToCrest);
    });
    const double step_of = 2.0 * kPi / steps;
    const double work = along * -3.0 * std::sin(angle) * step_of -
                        force_of(load) * 0.8 * std::cos(angle + 0.4) * step_of;
    net += work;
    gross += std::abs(work);
  }
  return net / gross;
}

TEST_F(HalfSpace, HasThePotentialOfItsCells) {
  // The midpoints of the loop add an error with the square of the step.
  EXPECT_LT(std::abs(work_around_a_loop(kConverged, 4000)), 1e-6);
}

TEST_F(HalfSpace, GivesNoEnergyWithTheIterationsOfATick) {
  const double share = work_around_a_loop({.most_iterations = 8, .residual = 1e-6}, 400);
  EXPECT_LT(std::abs(share), 0.01);
}

TEST_F(HalfSpace, ContinuesUnfinishedIterationsInTheNextTick) {
  const CellField overlap = paraboloid(30.0, 3.0);
  const double force = force_of(solved(overlap));
  contact_->clear();
  const HalfSpaceContact::Effort of_a_tick{.most_iterations = 2, .residual = 1e-6};
  double residual = contact_->solve(overlap, of_a_tick);
  EXPECT_GT(residual, 1e-3);
  int ticks = 1;
  for (; residual > of_a_tick.residual && ticks < 40; ++ticks) {
    residual = contact_->solve(overlap, of_a_tick);
  }
  EXPECT_LT(ticks, 40);
  EXPECT_NEAR(force_of(contact_->load_m()), force, 1e-5 * force);
}

TEST_F(HalfSpace, HasNoLoadWithoutOverlapAndCanBeLoadedAgain) {
  (void)solved(paraboloid(30.0, 1.0));
  EXPECT_EQ(contact_->solve(paraboloid(30.0, -0.01), kConverged), 0.0);
  EXPECT_EQ(force_of(contact_->load_m()), 0.0);
  const double again = force_of(solved(paraboloid(30.0, 1.0)));
  EXPECT_NEAR(again, 4.0 / 3.0 * std::sqrt(30.0), 0.02 * again);
}

TEST_F(HalfSpace, DoesNotAllocate) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  const CellField overlap = paraboloid(30.0, 3.0);
  const AllocationGuard guard;
  contact_->solve(overlap, kConverged);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
