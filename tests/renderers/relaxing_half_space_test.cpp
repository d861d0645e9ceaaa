// The relaxing half-space: its force after a step, its dent, and the energy that it takes. Lengths are in cells and pressures in E*.

#include "renderers/elastic/relaxing_half_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderers/elastic_cells.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kRelaxation = 1.5;
constexpr double kTime_s = 0.02;
constexpr HalfSpaceContact::Effort kOfATick{.most_iterations = 8, .residual = 1e-6};
constexpr double kInstant_s = 1e-9;
constexpr double kRadiusInCells = 30.0;

std::unique_ptr<RelaxingHalfSpace> body_of(double ratio) {
  return std::make_unique<RelaxingHalfSpace>(
      RelaxingHalfSpace::Material{.ratio = ratio, .time_s = kTime_s});
}

double elastic_force(double depth) {
  const auto elastic = body_of(1.0);
  elastic->advance(paraboloid(kRadiusInCells, depth), {}, 0.001, kConverged);
  return force_of(elastic->load_m());
}

TEST(RelaxingHalfSpace, RelaxesAsTheModulusAfterAStep) {
  for (const double period_s : {0.001, 0.0002, 0.004}) {
    const auto body = body_of(kRelaxation);
    const CellField overlap = paraboloid(kRadiusInCells, 2.0);
    body->advance(overlap, {}, kInstant_s, kConverged);
    const double relaxed = elastic_force(2.0);
    EXPECT_NEAR(force_of(body->load_m()) / relaxed, kRelaxation, 1e-5);
    for (int tick = 1; tick * period_s < 0.1; ++tick) {
      body->advance(overlap, {}, period_s, kConverged);
      const double expected = 1.0 + (kRelaxation - 1.0) * std::exp(-tick * period_s / kTime_s);
      EXPECT_NEAR(force_of(body->load_m()) / relaxed, expected, 2e-3) << period_s << ' ' << tick;
    }
  }
}

TEST(RelaxingHalfSpace, IsElasticWithTheRatioOne) {
  const auto body = body_of(1.0);
  body->advance(paraboloid(kRadiusInCells, 2.0), {}, 0.001, kConverged);
  body->advance(paraboloid(kRadiusInCells, 1.0), {0.4, 0.0}, 0.001, kConverged);
  EXPECT_EQ(*std::max_element(body->dent_m().begin(), body->dent_m().end()), 0.0);
  EXPECT_NEAR(force_of(body->load_m()), 4.0 / 3.0 * std::sqrt(kRadiusInCells),
              0.02 * 4.0 / 3.0 * std::sqrt(kRadiusInCells));
}

// The dent of a load that has lasted long is the delayed part of its displacement, and vanishes as e^(−t/ρτ).
TEST(RelaxingHalfSpace, KeepsADentThatVanishes) {
  const auto body = body_of(kRelaxation);
  for (int tick = 0; tick < 400; ++tick)
    body->advance(paraboloid(kRadiusInCells, 2.0), {}, 0.001, kConverged);
  const auto deepest = [&] {
    return *std::max_element(body->dent_m().begin(), body->dent_m().end());
  };
  body->advance(paraboloid(kRadiusInCells, -1.0), {}, kInstant_s, kConverged);
  EXPECT_FALSE(body->is_loaded());
  EXPECT_NEAR(deepest(), (1.0 - 1.0 / kRelaxation) * 2.0, 0.01);
  const double before = deepest();
  for (int tick = 0; tick < 30; ++tick)
    body->advance(paraboloid(kRadiusInCells, -1.0), {}, 0.001, kConverged);
  EXPECT_NEAR(deepest() / before, std::exp(-0.03 / (kRelaxation * kTime_s)), 1e-6);
  body->advance(paraboloid(kRadiusInCells, 0.1), {}, 0.001, kConverged);
  EXPECT_FALSE(body->is_loaded()) << "the tip is in the dent";
}

TEST(RelaxingHalfSpace, LeavesItsDentBehindABallThatSlides) {
  const auto body = body_of(kRelaxation);
  for (int tick = 0; tick < 200; ++tick)
    body->advance(paraboloid(kRadiusInCells, 2.0), {0.2, 0.0}, 0.001, kConverged);
  const auto dent = [&](std::size_t column) { return body->dent_m()[16 * kCellsAcross + column]; };
  for (std::size_t off = 1; off < 12; ++off) EXPECT_GT(dent(16 - off), dent(15 + off)) << off;
  // Twice as slow over half the time constant is the same.
  const auto slower = std::make_unique<RelaxingHalfSpace>(
      RelaxingHalfSpace::Material{.ratio = kRelaxation, .time_s = 2.0 * kTime_s});
  for (int tick = 0; tick < 400; ++tick)
    slower->advance(paraboloid(kRadiusInCells, 2.0), {0.1, 0.0}, 0.001, kConverged);
  EXPECT_NEAR(force_of(slower->load_m()), force_of(body->load_m()),
              0.005 * force_of(body->load_m()));
}

TEST(RelaxingHalfSpace, TakesEnergyWhereItIsPressedAndReleased) {
  for (const double frequency_Hz : {0.5, 8.0, 60.0}) {
    const auto body = body_of(kRelaxation);
    double net = 0.0;
    double gross = 0.0;
    constexpr int kTicksPerPeriod = 400;
    const double step_s = 1.0 / (kTicksPerPeriod * frequency_Hz);
    double last = -0.3;
    for (int tick = 1; tick <= 2 * kTicksPerPeriod; ++tick) {
      const double now = 1.0 - 1.3 * std::cos(2.0 * std::numbers::pi * tick / kTicksPerPeriod);
      body->advance(paraboloid(kRadiusInCells, 0.5 * (now + last)), {}, step_s, kOfATick);
      const double work = -force_of(body->load_m()) * (now - last);  // on the hand
      net += work;
      gross += std::abs(work);
      last = now;
    }
    EXPECT_LT(net, 0.0) << frequency_Hz;
    EXPECT_GT(net, -0.5 * gross) << frequency_Hz;
  }
}

TEST(RelaxingHalfSpace, DoesNotAllocate) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  const auto body = body_of(kRelaxation);
  const CellField overlap = paraboloid(kRadiusInCells, 2.0);
  const AllocationGuard guard;
  body->reset();
  for (int tick = 0; tick < 20; ++tick) body->advance(overlap, {0.3, -0.2}, 0.001, kOfATick);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
