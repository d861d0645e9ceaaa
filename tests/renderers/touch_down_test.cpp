// The first ticks of a contact: no force begins with a step, wherever and on whatever a hand comes down.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/models/height_map.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/points_on_bodies.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kTouched_N_per_m = 1000.0;
constexpr double kHalf_m = 0.010;     // from the centre of the patch to its wall
constexpr double kOutside_m = 0.005;  // the place of the touch, beyond the wall

/// A hand that comes down outside the patch and then moves, and what differs between two renderers of its surface.
class WallAtTouchDown {
 public:
  WallAtTouchDown(ForceRenderer& walled, ForceRenderer& endless, double x_m, double top_m)
      : walled_(walled), endless_(endless) {
    probe_.position_m = {x_m, 0.0, top_m};
    walled_.reset(probe_);
    endless_.reset(probe_);
    move({}, 20);  // of free space
  }
  /// In steps of a tick; the largest difference, and that of the last one.
  double largest_N = 0.0;
  glm::dvec3 last_N{0.0};
  double depth_m = 0.0;

  void move(const glm::dvec3& by_m, int ticks) {
    largest_N = 0.0;
    for (int tick = 0; tick < ticks; ++tick) {
      probe_.time_ns += 1'000'000;
      probe_.position_m += by_m / static_cast<double>(ticks);
      probe_.velocity_m_per_s = by_m / static_cast<double>(ticks) / kTick_s;
      const RenderedTick with = walled_.tick(probe_, kTick_s);
      last_N = with.wrench.force_N - endless_.tick(probe_, kTick_s).wrench.force_N;
      largest_N = std::max(largest_N, glm::length(last_N));
      depth_m = with.penetration_m;
    }
  }

 private:
  ForceRenderer& walled_;
  ForceRenderer& endless_;
  ProbeState probe_{};
};

/// The wall begins at the touch and follows the hand inwards; the surface is otherwise that without a wall.
void expect_wall_from_the_touch(ForceRenderer& walled, ForceRenderer& endless, double x_m,
                                double top_m, double down_m, const std::string& what) {
  constexpr double kStep_N = 1e-9;
  constexpr double kBack_m = kOutside_m + 0.002;  // inside
  WallAtTouchDown hand(walled, endless, x_m - kBack_m, top_m);
  hand.move({0.0, 0.0, -down_m}, 40);
  EXPECT_GT(hand.depth_m, 0.0) << what << ": a touch inside";
  EXPECT_LT(hand.largest_N, kStep_N) << what << ": a touch inside";
  hand.move({0.0, 0.0, down_m}, 40);
  hand.move({kBack_m, 0.0, 0.0}, 40);
  EXPECT_EQ(hand.depth_m, 0.0) << what;
  EXPECT_LT(hand.largest_N, kStep_N) << what << ": in the air, beyond the border";
  hand.move({0.0, 0.0, -down_m}, 40);
  EXPECT_GT(hand.depth_m, 0.0) << what;
  EXPECT_LT(hand.largest_N, kStep_N) << what << ": the touch";
  hand.move({0.001, 0.0, 0.0}, 20);
  EXPECT_LT(glm::length(hand.last_N - glm::dvec3(-kTouched_N_per_m * 0.001, 0.0, 0.0)), kStep_N)
      << what << ": 1 mm further out";
  hand.move({-0.002, 0.0, 0.0}, 40);
  EXPECT_LT(glm::length(hand.last_N), kStep_N) << what << ": 1 mm further in than the touch";
  hand.move({0.0005, 0.0, 0.0}, 10);
  EXPECT_LT(glm::length(hand.last_N - glm::dvec3(-kTouched_N_per_m * 0.0005, 0.0, 0.0)), kStep_N)
      << what << ": the wall has followed";
}

RendererInputs touched_inputs(const ForceModel& model) {
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = kTouched_N_per_m, .friction = 0.2};
  inputs.patch = {.extent_m = {2.0 * kHalf_m, 0.05}, .edge = PatchEdge::wall};
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.seed = 1;
  if (model.declaration.needs_bodies) {
    inputs.surface = std::make_shared<const TexturedMesh>(
        body_mesh(PlateShape{{0.04, 0.012, 0.004}}, grating().get()));
    inputs.tool = std::make_shared<const TexturedMesh>(body_mesh(SphereShape{0.002}, nullptr));
    inputs.parameters = {{"coupling", std::string("none")}, {"most_halvings", 0.0}};
  }
  return inputs;
}

TEST(TouchDown, BeyondAWallIsTheSurfaceAloneInEveryModel) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    const RendererInputs inputs = touched_inputs(model);
    const auto walled = make_renderer(model, inputs);
    const auto endless = make_renderer(model, without_border(inputs));
    // A ball of 2 mm has its origin in its centre.
    const double top_m = model.declaration.needs_bodies ? 0.0015 : 0.001;
    const double down_m = model.declaration.needs_bodies ? 0.0008 : 0.002;
    expect_wall_from_the_touch(*walled, *endless, kHalf_m + kOutside_m, top_m, down_m,
                               model.declaration.id);
  }
}

TEST(TouchDown, BeyondAWallIsTheSurfaceAloneWithACoupledTool) {
  const ForceModel model = pd_gradient_model();
  RendererInputs inputs = touched_inputs(model);
  inputs.parameters = {{"most_halvings", 0.0}};
  const auto walled = make_renderer(model, inputs);
  const auto endless = make_renderer(model, without_border(inputs));
  expect_wall_from_the_touch(*walled, *endless, kHalf_m + kOutside_m, 0.0015, 0.0015, "coupled");
}

TEST(TouchDown, BeyondAWallIsTheSurfaceAloneOnABody) {
  for (const ForceModel& model : point_models()) {
    RendererInputs inputs = touched_inputs(model);
    inputs.body = flat_plate();
    const auto walled = make_renderer(model, inputs);
    const auto endless = make_renderer(model, without_border(inputs));
    expect_wall_from_the_touch(*walled, *endless, kHalf_m + kOutside_m, 0.001, 0.002,
                               model.declaration.id);
  }
}

TEST(TouchDown, BeyondAWallIsTheSurfaceAloneOnAdjacentPatches) {
  const ModelRegistry registry = built_in_models();
  const ForceModel& model = *registry.find("sinusoid");
  const SurfacePatch workspace{.extent_m = {0.1, 0.1}, .edge = PatchEdge::wall};
  std::vector<AdjacentPatch> patches{};
  for (const double side : {-1.0, 1.0}) {
    RendererInputs inputs = touched_inputs(model);
    inputs.parameters = complete_values(model.declaration, {});
    inputs.patch = workspace;
    inputs.patch.centre_m.x = 0.0265 * side;
    inputs.patch.extent_m.x = 0.047;
    patches.push_back({&model, inputs});
  }
  AdjacentPatches walled(patches, workspace, patches[0].inputs.material, 0.002);
  const auto endless = make_renderer(model, without_border(patches[1].inputs));
  expect_wall_from_the_touch(walled, *endless, 0.05 + kOutside_m, 0.001, 0.002, "patches");
}

/// Choices and values with which the law of the source has a force at depth 0.
std::vector<ParameterValues> abrupt_values(const std::string& model) {
  if (model == "lateral_gradient") return {{{"gain_N", 5.0}}};
  if (model == "stochastic") {
    return {{{"noise_mean_N", 1.0}},
            {{"noise_sd_N", 1.0}, {"velocity_threshold_m_per_s", 0.0}},
            {{"noise_mean_N", 1.0}, {"index", std::string("distance")}}};
  }
  if (model == "recorded") {
    return {{{"gain", 5.0}, {"force_exponent", 0.0}},
            {{"gain", 5.0}, {"force_exponent", 0.0}, {"axis", std::string("normal")}},
            {{"gain", 5.0}, {"force_exponent", 0.1}}};
  }
  if (model == "data_driven") {
    return {{{"gain", 5.0}},
            {{"gain", 5.0}, {"axis", std::string("normal")}},
            {{"gain", 5.0}, {"axis", std::string("binormal")}}};
  }
  return {{}};
}

/// The largest force per depth in contacts of less than 20 µm, of a hand that strokes and sinks by 0.2 µm in a tick.
double steepest_touch_N_per_m(ForceRenderer& renderer) {
  double steepest_N_per_m = 0.0;
  int touching = 0;
  ProbeState probe = probe_at({0.0, 0.0, 0.0006});
  probe.velocity_m_per_s = {0.06, 0.0, -0.0002};
  renderer.reset(probe);
  for (; probe.position_m.z > -4e-4; probe.position_m += probe.velocity_m_per_s * kTick_s) {
    const RenderedTick tick = renderer.tick(probe, kTick_s);
    probe.time_ns += 1'000'000;
    if (!(tick.penetration_m > 0.0)) {
      EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0));
    } else if (tick.penetration_m < 2e-5) {
      ++touching;
      steepest_N_per_m =
          std::max(steepest_N_per_m, glm::length(tick.wrench.force_N) / tick.penetration_m);
    }
  }
  EXPECT_GT(touching, 20);
  return steepest_N_per_m;
}

// A force of 1 N at depth 0 would have 50 kN/m at 20 µm and 5 MN/m in the first tick. What fades in over w₀ = 0.1 mm has at most
// 3·w/w₀² of its force per depth, 60 kN/m for 10 N at 20 µm, and vanishes at the touch.
TEST(TouchDown, BeginsWithoutAStepInEveryModel) {
  for (const ForceModel& model : point_models()) {
    for (const ParameterValues& values : abrupt_values(model.declaration.id)) {
      RendererInputs inputs = touched_inputs(model);
      inputs.patch = wide_patch();
      inputs.parameters = values;
      EXPECT_LT(steepest_touch_N_per_m(*make_renderer(model, inputs)), 1e5)
          << model.declaration.id << ' ' << condition_text(values);
      inputs.parameters["resonance_ratio"] = 2.0;
      inputs.parameters["resonance_threshold_N"] = 0.5;
      EXPECT_LT(steepest_touch_N_per_m(*make_renderer(model, inputs)), 1.5e5)
          << model.declaration.id << " with noise";
    }
  }
}

// Equations as printed are kept as they are: the 0.4 N of a crest are there at any depth.
TEST(TouchDown, IsAStepInTheLiteralLawOfTheHeightMap) {
  RendererInputs inputs = touched_inputs(height_map_model());
  inputs.patch = wide_patch();
  inputs.parameters = {{"law", std::string("literal")}, {"offset", std::string("subtract_min")}};
  EXPECT_GT(steepest_touch_N_per_m(*make_renderer(height_map_model(), inputs)), 2e4);
}

}  // namespace
}  // namespace asperity
