// Surfaces side by side: their forces, the flat surface between them, and the blend.

#include "renderers/force/adjacent_patches.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kBlendOfTest_m = 0.002;
constexpr double kPeriod_s = 1e-3;

/// Two patches of 47 mm with a gap of 6 mm on a workspace of 100 mm, with a friction that does not depend on the path.
class TwoPatches : public testing::Test {
 protected:
  AdjacentPatch patch(double centre_x_m, ParameterValues parameters,
                      const std::string& model = "sinusoid") const {
    const ForceModel* const found = models_.find(model);
    parameters["friction_law"] = std::string("rounded");
    RendererInputs inputs{.parameters = complete_values(found->declaration, std::move(parameters)),
                          .material = material_,
                          .patch = workspace_};
    inputs.patch.centre_m.x = centre_x_m;
    inputs.patch.extent_m.x = 0.047;
    inputs.seed = 7;
    return {found, inputs};
  }
  std::vector<AdjacentPatch> two() const {
    return {patch(-0.0265, {{"amplitude_m", 5e-5}, {"wavelength_m", 0.0025}}),
            patch(0.0265, {{"amplitude_m", 1e-4}, {"wavelength_m", 0.004}})};
  }
  std::unique_ptr<AdjacentPatches> made(const std::vector<AdjacentPatch>& patches) const {
    return std::make_unique<AdjacentPatches>(patches, workspace_, material_, kBlendOfTest_m);
  }

  static ProbeState probe_at(double x_m, double depth_m, double speed_m_per_s = 0.1) {
    ProbeState probe{};
    probe.position_m = {x_m, 0.001, -depth_m};
    probe.velocity_m_per_s = {speed_m_per_s, 0.0, 0.0};
    return probe;
  }

  ModelRegistry models_ = built_in_models();
  Material material_{.stiffness_N_per_m = 500.0, .friction = 0.2};
  SurfacePatch workspace_{.extent_m = {0.1, 0.1}, .edge_width_m = 0.005};
};

TEST_F(TwoPatches, RendersEachSurfaceInItsPatch) {
  const std::vector<AdjacentPatch> patches = two();
  const auto renderer = made(patches);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto alone = make_renderer(*patches[i].model, without_border(patches[i].inputs));
    for (const double from_centre_m : {-0.015, -0.003, 0.0, 0.0071, 0.0154}) {
      const ProbeState probe = probe_at(patches[i].inputs.patch.centre_m.x + from_centre_m, 0.002);
      renderer->reset(probe);
      alone->reset(probe);
      const RenderedTick together = renderer->tick(probe, kPeriod_s);
      const RenderedTick separate = alone->tick(probe, kPeriod_s);
      EXPECT_EQ(together.wrench.force_N, separate.wrench.force_N) << from_centre_m;
      EXPECT_EQ(together.penetration_m, separate.penetration_m);
      EXPECT_EQ(together.part, i + 1);
    }
  }
}

TEST_F(TwoPatches, IsFlatBetweenThem) {
  const auto renderer = made(two());
  for (const double x_m : {-0.0029, 0.0, 0.0025}) {
    const ProbeState probe = probe_at(x_m, 0.002);
    renderer->reset(probe);
    const RenderedTick tick = renderer->tick(probe, kPeriod_s);
    EXPECT_NEAR(tick.wrench.force_N.z, 1.0, 1e-12);  // 500 N/m · 2 mm
    EXPECT_NEAR(tick.wrench.force_N.x, -0.2 * 0.1 / std::hypot(0.1, 0.01), 1e-12);
    EXPECT_EQ(tick.penetration_m, 0.002);
    EXPECT_EQ(tick.part, 0U);
  }
  const RenderedTick above = renderer->tick(probe_at(0.0, -0.001), kPeriod_s);
  EXPECT_EQ(above.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(above.penetration_m, 0.0);
}

TEST_F(TwoPatches, FadesAtTheBorderOfTheWorkspaceAsOneSurface) {
  const auto renderer = made(two());
  const auto force_at = [&](double x_m) {
    return renderer->tick(probe_at(x_m, 0.002, 0.0), kPeriod_s).wrench.force_N.z;
  };
  EXPECT_GT(force_at(-0.0449), 0.9);
  const double half = force_at(-0.0475) / (500.0 * 0.002);
  EXPECT_NEAR(half, 0.5, 0.03) << "half way through the border, within the texture";
  EXPECT_EQ(force_at(-0.0501), 0.0);
}

/// The force of a hand that crosses everything at 0.2 m/s, with a constant depth.
TEST_F(TwoPatches, ChangesTheForceByLessThan20MillinewtonInATick) {
  std::vector<AdjacentPatch> patches = two();
  for (AdjacentPatch& each : patches) {
    each.inputs.parameters["amplitude_m"] = 1e-4;
    each.inputs.parameters["wavelength_m"] = 0.01;  // its own steps are small
  }
  const auto renderer = made(patches);
  constexpr double kSpeed_m_per_s = 0.2;
  double last_N = 0.0;
  double largest_N = 0.0;
  bool is_first = true;
  for (double x_m = -0.044; x_m < 0.044; x_m += kSpeed_m_per_s * kPeriod_s) {
    const ProbeState probe = probe_at(x_m, 0.002, kSpeed_m_per_s);
    if (is_first) renderer->reset(probe);
    const double force_N = glm::length(renderer->tick(probe, kPeriod_s).wrench.force_N);
    if (!is_first) largest_N = std::max(largest_N, std::abs(force_N - last_N));
    last_N = force_N;
    is_first = false;
  }
  EXPECT_GT(largest_N, 0.001) << "there is a blend";
  EXPECT_LT(largest_N, 0.020);
}

/// A model that depends on past samples has a state for each patch, which begins when the patch is entered.
TEST_F(TwoPatches, HasAStateForEachPatch) {
  const std::vector<AdjacentPatch> patches{patch(-0.0265, {}, "stochastic"),
                                           patch(0.0265, {}, "stochastic")};
  const auto renderer = made(patches);
  const auto alone = make_renderer(*patches[1].model, without_border(patches[1].inputs));
  renderer->reset(probe_at(-0.02, 0.002));
  for (int i = 0; i < 200; ++i) renderer->tick(probe_at(-0.02 + 1e-5 * i, 0.002), kPeriod_s);
  alone->reset(probe_at(0.02, 0.002));
  for (int i = 0; i < 200; ++i) {
    const ProbeState probe = probe_at(0.02 + 1e-5 * i, 0.002);
    EXPECT_EQ(renderer->tick(probe, kPeriod_s).wrench.force_N,
              alone->tick(probe, kPeriod_s).wrench.force_N)
        << i;
  }
}

/// Also beyond the border the probe stays on the patch: the wall is the only force that changes.
TEST_F(TwoPatches, ContinuesThroughAWall) {
  workspace_.edge = PatchEdge::wall;
  const auto renderer = made(two());
  renderer->reset(probe_at(-0.045, 0.002));
  double last_N = 0.0;
  for (double x_m = -0.049; x_m > -0.052; x_m -= 2e-4) {
    const RenderedTick tick = renderer->tick(probe_at(x_m, 0.002), kPeriod_s);
    EXPECT_EQ(tick.part, 1U) << x_m;
    if (last_N != 0.0) {
      EXPECT_NEAR(tick.wrench.force_N.z, last_N, 0.02);
    }
    last_N = tick.wrench.force_N.z;
    const double beyond_m = std::max(0.0, -0.05 - x_m);
    EXPECT_NEAR(tick.wrench.force_N.x,
                500.0 * beyond_m - 0.2 * last_N * 0.1 / std::hypot(0.1, 0.01), 1e-9);
  }
}

TEST_F(TwoPatches, DoesNotAllocateInATick) {
  const auto renderer = made(two());
  renderer->reset(probe_at(-0.03, 0.002));
  const AllocationGuard guard;
  for (double x_m = -0.044; x_m < 0.044; x_m += 2e-4) {
    renderer->tick(probe_at(x_m, 0.002), kPeriod_s);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST_F(TwoPatches, RefusesPatchesThatDoNotFit) {
  const auto refuses = [this](auto change) {
    std::vector<AdjacentPatch> patches = two();
    change(patches);
    EXPECT_THROW(made(patches), std::invalid_argument);
  };
  refuses([](auto& patches) { patches.clear(); });
  refuses([](auto& patches) { patches[1].inputs.patch.centre_m.x = 0.0; });
  refuses([](auto& patches) { patches[1].inputs.patch.centre_m.x = 0.05; });
  refuses([](auto& patches) { patches[1].inputs.patch.centre_m.z = 0.001; });
  refuses([](auto& patches) { patches[1].inputs.patch.extent_m.x = 0.003; });
  EXPECT_THROW(AdjacentPatches(two(), workspace_, material_, 0.0), std::invalid_argument);
}

TEST(TextureOrigin, ShiftsTheTextureOfEveryModel) {
  const ModelRegistry models = built_in_models();
  const ForceModel* const model = models.find("sinusoid");
  RendererInputs inputs{.parameters = complete_values(
                            model->declaration, {{"amplitude_m", 1e-4}, {"wavelength_m", 0.004}})};
  const auto force_at = [&](double x_m) {
    ProbeState probe{};
    probe.position_m = {x_m, 0.0, -0.001};
    return make_renderer(*model, inputs)->tick(probe, kPeriod_s).wrench.force_N.z;
  };
  const double at_origin_N = force_at(0.0);
  inputs.patch.texture_origin_m = {0.001, 0.0};  // a quarter of the wave: a crest
  EXPECT_NEAR(force_at(0.0) - at_origin_N, 500.0 * 1e-4, 1e-9);
  EXPECT_NEAR(force_at(-0.001), at_origin_N, 1e-12);
}

}  // namespace
}  // namespace asperity
