// No tick touches the heap: not a model's, not the loop's, not in its worst moments.

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/servo_loop.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

RendererInputs stimulus_with(ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.patch = wide_patch();
  inputs.height_field = grating();
  return inputs;
}

struct Case {
  const char* model = "";
  ParameterValues parameters{};
};

std::vector<Case> every_law() {
  return {{"height_map", {{"lateral_gradient_gain", 1.0}}},
          {"height_map", {{"law", std::string("literal")}}},
          {"sinusoid", {}},
          {"sinusoid", {{"force_direction", std::string("local_normal")}}},
          {"stochastic", {}},
          {"lateral_gradient", {}}};
}

TEST(Allocation, NoModelTouchesTheHeapInATick) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  const ModelRegistry registry = built_in_models();
  for (const Case& each : every_law()) {
    const auto renderer = registry.make(each.model, stimulus_with(each.parameters));
    const std::vector<ProbeState> path = samples_of({.duration_s = 2.0});
    const AllocationGuard guard;
    renderer->reset(path.front());
    for (const ProbeState& probe : path) renderer->tick(probe, 0.001);
    EXPECT_EQ(guard.count(), 0) << each.model;
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
  for (const Case& each : every_law()) {
    loop.heartbeat();
    loop.present({.id = 1, .renderer = registry.make(each.model, stimulus_with(each.parameters))});
    device.probe.position_m.z = 0.01;
    ticks(60);
    device.probe.position_m.z = -0.001;
    ticks(60);
    loop.withdraw();
    ticks(60);
    EXPECT_NE(loop.collect().renderer, nullptr);
    loop.present({.id = 2, .renderer = registry.make(each.model, stimulus_with(each.parameters))});
    ticks(3000);  // the conductor falls silent
    loop.emergency_stop();
    ticks(2);
    loop.clear_fault();
    ticks(20, 5'000'000);  // misses
    loop.clear_fault();
    device.probe.position_m.x = std::numeric_limits<double>::quiet_NaN();
    ticks(2);
    device.probe.position_m.x = 0.0;
    loop.clear_fault();
    device.answers = false;
    ticks(2);
    device.answers = true;
    loop.clear_fault();
    loop.withdraw();
    ticks(60);
    EXPECT_NE(loop.collect().renderer, nullptr);
  }
  EXPECT_EQ(touched, 0);
}

}  // namespace
}  // namespace asperity
