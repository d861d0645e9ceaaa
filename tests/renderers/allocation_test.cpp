// No tick touches the heap: not a model's, not the loop's, not in its worst moments.

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/servo/servo_loop.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/surfaces.h"
#include "tests/renderers/textured_bodies.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

/// A model of the registry, and parameters that choose one of its ways through the tick.
struct Case {
  const ForceModel* model = nullptr;
  ParameterValues parameters{};
};

/// By the model's name: the parameters of each law that has code of its own.
const std::map<std::string, std::vector<ParameterValues>>& laws() {
  static const std::map<std::string, std::vector<ParameterValues>> kLaws{
      {"height_map", {{{"lateral_gradient_gain", 1.0}}, {{"law", std::string("literal")}}}},
      {"sinusoid",
       {{},
        {{"force_direction", std::string("local_normal")}},
        {{"force_direction", std::string("gradient")}},
        {{"friction_law", std::string("bounded")}},
        {{"friction_law", std::string("proxy")}},
        {{"friction_law", std::string("elastoplastic")}},
        {{"friction_law", std::string("dahl")}},
        {{"friction_law", std::string("lugre")}}}},
      {"stochastic", {{}, {{"index", std::string("distance")}}}},
      {"lateral_gradient", {{}, {{"law", std::string("force")}}}},
      {"bump_map", {{}, {{"face", std::string("crest")}}}},
      {"normal_map", {{}, {{"law", std::string("physical")}}}},
      {"periodic",
       {{},
        {{"force_direction", std::string("local_normal")}},
        {{"force_direction", std::string("gradient")}}}},
      {"solid_noise", {{}, {{"octaves", 6.0}}}},
      {"filtered_noise", {{}, {{"peak_wavelength_m", 1e-3}}}},
      {"auto_regressive", {{}, {{"coefficient_3", 0.1}}}},
      {"recorded", {{}, {{"axis_of_spectrum", std::string("temporal")}}}},
      {"elastic_halfspace", {{}, {{"tip", std::string("flat")}, {"relaxation_ratio", 1.0}}}},
      {"winkler", {{}}},
      {"data_driven", {{}, {{"axis", std::string("motion")}, {"variance", std::string("linear")}}}},
      {"pd_gradient",
       {{},
        {{"coupling", std::string("none")}},
        {{"coupling", std::string("none")}, {"maximum", std::string("smooth")}}}}};
  return kLaws;
}

/// Of every model of the registry; one without a case in `laws` is a failure, since nobody would notice that its
/// tick allocates.
std::vector<Case> every_law(const ModelRegistry& registry) {
  std::vector<Case> cases;
  for (const ForceModel& model : registry.models()) {
    const auto found = laws().find(model.declaration.id);
    if (found == laws().end() || found->second.empty()) {
      ADD_FAILURE() << "the force model " << model.declaration.id << " has no case in laws()";
      continue;
    }
    for (const ParameterValues& parameters : found->second) cases.push_back({&model, parameters});
  }
  return cases;
}

std::unique_ptr<ForceRenderer> renderer_for(const Case& each) {
  static const auto kBall = shared(shifted(bare(ball(1.5e-3, 14, 20)), {0.0, 0.0, 1.5e-3}));
  static const auto kPlate = shared(grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3}));
  RendererInputs inputs;
  inputs.parameters = each.parameters;
  inputs.patch = wide_patch();
  if (each.model->declaration.needs_bodies) {
    inputs.tool = kBall;
    inputs.surface = kPlate;
  } else {
    inputs.height_field = grating();
    inputs.assets = files_of_models();
  }
  return make_renderer(*each.model, inputs);
}

TEST(Allocation, NoModelTouchesTheHeapInATick) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  const ModelRegistry registry = built_in_models();
  for (const Case& each : every_law(registry)) {
    const auto renderer = renderer_for(each);
    const std::vector<ProbeState> path = samples_of({.duration_s = 2.0});
    const AllocationGuard guard;
    renderer->reset(path.front());
    for (const ProbeState& probe : path) renderer->tick(probe, 0.001);
    EXPECT_EQ(guard.count(), 0) << each.model->declaration.id;
  }
}

TEST(Allocation, TheServoTickNeverTouchesTheHeap) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  ScriptedDevice device;
  RecordRing records(64);  // overflows: losing a record must not allocate either
  ServoLoop loop(device, records, {.misses_to_fault = 10});
  const ModelRegistry registry = built_in_models();
  std::int64_t now_ns = 0;
  std::int64_t touched = 0;
  const auto ticks = [&](int count, std::int64_t late_ns = 0) {
    const AllocationGuard guard;
    for (int i = 0; i < count; ++i) {
      now_ns += 1'000'000;
      loop.tick(now_ns + late_ns, now_ns);
    }
    touched += guard.count();
  };
  for (const Case& each : every_law(registry)) {
    loop.heartbeat();
    loop.present({.id = 1, .renderer = renderer_for(each)});
    device.probe.position_m.z = 0.01;
    ticks(60);
    device.probe.position_m.z = -0.001;
    ticks(60);
    loop.withdraw();
    ticks(60);
    EXPECT_NE(loop.collect().renderer, nullptr);
    loop.present({.id = 2, .renderer = renderer_for(each)});
    ticks(3000);  // the conductor falls silent
    loop.emergency_stop();
    ticks(2);
    loop.clear_fault(loop.status().fault);
    ticks(20, 5'000'000);  // misses
    loop.clear_fault(loop.status().fault);
    device.probe.position_m.x = std::numeric_limits<double>::quiet_NaN();
    ticks(2);
    device.probe.position_m.x = 0.0;
    loop.clear_fault(loop.status().fault);
    device.answers = false;
    ticks(2);
    device.answers = true;
    loop.clear_fault(loop.status().fault);
    loop.withdraw();
    ticks(60);
    EXPECT_NE(loop.collect().renderer, nullptr);
  }
  EXPECT_EQ(touched, 0);
}

}  // namespace
}  // namespace asperity
