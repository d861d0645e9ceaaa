// Window samplers that renderers leave to later ones: to which requests they are given, how many are kept, and that forces do not
// depend on who used them before.

#include "renderers/pd_gradient/sampling/spare_samplers.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

constexpr WindowSampling kSampling{
    .law = HardMaximum{.step_m = 0.1e-3}, .cell_m = 0.1e-3, .most_samples = 64};

std::shared_ptr<WindowSamplers> taken(SpareSamplers& spare,
                                      const WindowSampling& sampling = kSampling) {
  return spare.take(sampling, 5e-3, 100, InstructionSet::sse2);
}

TEST(SpareSamplers, AreGivenToTheNextRequestForTheSameWindows) {
  SpareSamplers spare;
  auto first = taken(spare);
  const WindowSamplers* const used = first.get();
  const auto second = taken(spare);
  EXPECT_NE(second.get(), used);  // still in use
  first.reset();
  WindowSampling finer = kSampling;
  finer.most_halvings = 1;
  EXPECT_NE(taken(spare, finer).get(), used);
  WindowSampling smooth = kSampling;
  smooth.law = SmoothMaximum{.tau_m = 0.1e-3};
  EXPECT_NE(taken(spare, smooth).get(), used);
  EXPECT_NE(spare.take(kSampling, 6e-3, 100, InstructionSet::sse2).get(), used);
  EXPECT_NE(spare.take(kSampling, 5e-3, 101, InstructionSet::sse2).get(), used);
  EXPECT_EQ(taken(spare).get(), used);
}

TEST(SpareSamplers, AreReleasedBeyondTheirMemoryTheOldestFirst) {
  const std::size_t bytes = taken(*std::make_unique<SpareSamplers>())->bytes();
  EXPECT_GT(bytes, std::size_t{2} * 12 * 4 * 64 *
                       64);  // both bodies at twelve places, for the widest window
  SpareSamplers spare(2 * bytes);
  auto first = taken(spare);
  auto second = taken(spare);
  auto third = taken(spare);
  const WindowSamplers* const last = third.get();
  const WindowSamplers* const before = second.get();
  first.reset();
  second.reset();
  third.reset();
  const auto newest = taken(spare);
  const auto older = taken(spare);
  EXPECT_EQ(newest.get(), last);
  EXPECT_EQ(older.get(), before);
}

TEST(SpareSamplers, MayBeUsedAfterTheirOrigin) {
  auto spare = std::make_unique<SpareSamplers>();
  const auto used = taken(*spare);
  spare.reset();
  EXPECT_NEAR(used->window_for(3e-3).sampler.grid().width_m, 3.2e-3, 1e-12);
}

/// The forces and torques along a stroke at this y.
std::vector<double> stroke_N(ForceRenderer& renderer, double y_m) {
  std::vector<double> forces_N;
  ProbeState probe = probe_at({-3e-3, y_m, 0.5e-3});
  renderer.reset(probe);
  for (int i = 0; i < 150; ++i) {
    probe.velocity_m_per_s = {0.04, 0.0, i < 50 ? -0.013 : 0.0};
    probe.position_m += probe.velocity_m_per_s * kTick_s;
    const RenderedTick tick = renderer.tick(probe, kTick_s);
    for (const glm::dvec3& each : {tick.wrench.force_N, tick.wrench.torque_N_m}) {
      forces_N.insert(forces_N.end(), {each.x, each.y, each.z});
    }
  }
  return forces_N;
}

TEST(SpareSamplers, GiveTheForcesOfNewOnes) {
  RendererInputs inputs;
  inputs.parameters = complete_values(pd_gradient_model().declaration, {});
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.2};
  inputs.patch = wide_patch();
  inputs.tool = shared(shifted(bare(ball(1.5e-3, 14, 20)), {0, 0, 1.5e-3}));
  inputs.surface = shared(grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1e-3}));
  const InstructionSet set = instruction_sets_here().back();
  PdGradient own(inputs, set);
  const std::vector<double> expected_N = stroke_N(own, 0.2e-3);
  EXPECT_GT(*std::max_element(expected_N.begin(), expected_N.end()), 0.05);

  PdGradient::SharedParts parts;
  std::optional<PdGradient> earlier(std::in_place, inputs, set, nullptr, &parts);
  EXPECT_NE(stroke_N(*earlier, 0.3e-3), expected_N);
  earlier.reset();
  // The same bodies at a place that is near those of the kept heights.
  PdGradient later(inputs, set, nullptr, &parts);
  EXPECT_EQ(stroke_N(later, 0.2e-3), expected_N);
}

}  // namespace
}  // namespace asperity
