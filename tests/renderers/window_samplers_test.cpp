// Windows of every width with the declared cell and step.

#include "renderers/pd_gradient/sampling/window_samplers.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

WindowSamplers samplers(const WindowSampling& sampling, double widest_m = 0.05) {
  return {sampling, widest_m, 100, InstructionSet::sse2};
}

constexpr WindowSampling kFourCells{
    .law = HardMaximum{.step_m = 0.2e-3}, .cell_m = 0.05e-3, .most_samples = 256};

TEST(WindowSamplers, KeepTheCellWhileTheSamplesGrowWithTheContact) {
  auto windows = samplers({.law = HardMaximum{.step_m = 0.1e-3}, .cell_m = 0.1e-3});
  for (const double width_m : {1e-3, 3.1e-3, 3.3e-3, 10e-3, 25.5e-3}) {
    const auto& window = windows.window_for(width_m);
    const SamplingGrid& grid = window.sampler.grid();
    EXPECT_NEAR(grid.spacing_m(), 0.1e-3, 1e-12);
    EXPECT_GE(grid.width_m, width_m);
    EXPECT_LE(grid.width_m, width_m + 32 * 0.1e-3);
    EXPECT_FALSE(window.is_coarse);
  }
}

TEST(WindowSamplers, GiveAWiderContactLongerCellsAndTheSameStepForAsLongAsItHoldsOne) {
  auto windows = samplers(kFourCells);
  // 256 cells of 0.05, 0.1 and 0.2 mm.
  EXPECT_NEAR(windows.window_for(12.8e-3).sampler.grid().spacing_m(), 0.05e-3, 1e-12);
  EXPECT_NEAR(windows.window_for(12.9e-3).sampler.grid().spacing_m(), 0.1e-3, 1e-12);
  EXPECT_NEAR(windows.window_for(26e-3).sampler.grid().spacing_m(), 0.2e-3, 1e-12);
  EXPECT_FALSE(windows.window_for(26e-3).is_coarse);
  EXPECT_FALSE(windows.window_for(51.2e-3).is_coarse);
}

TEST(WindowSamplers, SayWhereTheStepCannotBeKept) {
  auto windows = samplers({.law = HardMaximum{.step_m = 0.1e-3}, .cell_m = 0.1e-3});
  EXPECT_TRUE(windows.window_for(25.7e-3).is_coarse);
  EXPECT_NEAR(windows.window_for(25.7e-3).sampler.grid().spacing_m(), 0.2e-3, 1e-12);
  auto smooth = samplers({.law = SmoothMaximum{.tau_m = 1e-5}, .cell_m = 0.1e-3});
  EXPECT_FALSE(smooth.window_for(25e-3).is_coarse);
  EXPECT_TRUE(smooth.window_for(26e-3).is_coarse);
}

TEST(WindowSamplers, HaveFinerCellsOfTheSameWindowAsFarAsAskedAndPermitted) {
  WindowSampling sampling{.law = HardMaximum{.step_m = 0.1e-3}, .cell_m = 0.1e-3};
  EXPECT_TRUE(samplers(sampling).window_for(3e-3).finer.empty());
  sampling.most_halvings = 3;
  auto windows = samplers(sampling);
  auto& narrow = windows.window_for(3e-3);  // 32 samples, and up to 256
  ASSERT_EQ(narrow.finer.size(), 3U);
  for (int halvings = 0; halvings <= 3; ++halvings) {
    const SamplingGrid& grid = narrow.with(halvings).grid();
    EXPECT_NEAR(grid.width_m, 3.2e-3, 1e-12);
    EXPECT_EQ(grid.samples, 32 << halvings);
  }
  EXPECT_EQ(windows.window_for(6e-3).finer.size(), 2U);
  EXPECT_EQ(windows.window_for(12e-3).finer.size(), 1U);
  EXPECT_EQ(windows.window_for(13e-3).finer.size(), 0U);
  EXPECT_EQ(windows.window_for(26e-3).finer.size(), 0U);
  sampling.fine_enough_m = 0.06e-3;
  EXPECT_EQ(samplers(sampling).window_for(3e-3).finer.size(), 1U);
  WindowSampling four = kFourCells;
  four.most_halvings = 3;
  four.most_samples = 512;
  EXPECT_EQ(samplers(four).window_for(3e-3).finer.size(), 1U);  // 8 cells in a step
  sampling.law = SmoothMaximum{.tau_m = 1e-5};
  EXPECT_TRUE(samplers(sampling).window_for(3e-3).finer.empty());
}

TEST(WindowSamplers, HoldEveryContactOfBodiesOfThatSize) {
  auto windows = samplers(kFourCells, 0.3);
  EXPECT_GE(windows.window_for(0.3).sampler.grid().width_m, 0.3);
}

TEST(WindowSamplers, RefuseAStepThatDoesNotFitTheCell) {
  const auto refuses = [](const WindowSampling& sampling) {
    EXPECT_THROW(samplers(sampling), std::invalid_argument);
  };
  refuses({.law = HardMaximum{.step_m = 0.15e-3}, .cell_m = 0.1e-3});
  refuses({.law = HardMaximum{.step_m = 0.3e-3}, .cell_m = 0.1e-3});
  refuses({.law = HardMaximum{.step_m = 0.05e-3}, .cell_m = 0.1e-3});
  refuses({.law = HardMaximum{.step_m = 0.8e-3}, .cell_m = 0.1e-3, .most_samples = 128});
  refuses({.law = SmoothMaximum{.tau_m = 1e-5}, .cell_m = 0.0});
  refuses({.law = SmoothMaximum{.tau_m = 0.0}, .cell_m = 1e-4});
}

}  // namespace
}  // namespace asperity
