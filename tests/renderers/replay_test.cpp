// A recorded hand gives the recorded forces again, bit for bit.

#include "renderers/offline/replay.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/servo/servo_loop.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

RendererInputs made_stimulus() {
  RendererInputs inputs;
  inputs.patch = wide_patch();
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.surface = std::make_shared<const TexturedMesh>(
      body_mesh(PlateShape{{0.08, 0.02, 0.01}}, grating({.pitch_m = 0.0002}).get()));
  inputs.tool = std::make_shared<const TexturedMesh>(
      placed(body_mesh(SphereShape{.diameter_m = 0.006}, nullptr), BodyRole::tool));
  inputs.seed = 3;
  return inputs;
}

const RendererInputs& replayed_stimulus() {
  static const RendererInputs kInputs = made_stimulus();
  return kInputs;
}

// A hand that comes down, strokes to and fro at odd times, and meets a fault on the way.
std::vector<TickRecord> recorded(const ForceModel& model) {
  ScriptedDevice device;
  RecordRing ring(4096);
  ServoLoop loop(device, ring, {});
  std::int64_t now_ns = 77'000'000'000;
  for (int i = 0; i < 2000; ++i) {
    loop.heartbeat();
    if (i == 100) loop.present({.id = 1, .renderer = make_renderer(model, replayed_stimulus())});
    if (i == 1000) loop.emergency_stop();
    if (i == 1100) loop.clear_fault(loop.status().fault);
    now_ns += 1'000'000 + (i * 7919) % 400'000;  // late by up to 0.4 ms
    const double t = 0.001 * i;
    device.probe.position_m = {0.03 * std::sin(3.0 * t), 0.001 * t,
                               i < 300 || i == 1500 ? 0.01 : -0.001 + 0.0005 * std::sin(20.0 * t)};
    device.probe.velocity_m_per_s = {0.09 * std::cos(3.0 * t), 0.001, 0.01 * std::cos(20.0 * t)};
    loop.tick(now_ns);
  }
  std::vector<TickRecord> records;
  TickRecord record;
  while (ring.pop(record)) records.push_back(record);
  return records;
}

TEST(Replay, GivesTheRecordedForcesBitForBit) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    const std::vector<TickRecord> records = recorded(model);
    ASSERT_EQ(records.size(), 2000U);
    const auto renderer = make_renderer(model, replayed_stimulus());
    const std::vector<RenderedTick> again = replay(*renderer, records, 1000.0);
    ASSERT_EQ(again.size(), records.size());
    std::size_t touching = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      ASSERT_EQ(again[i].wrench.force_N, records[i].rendered.force_N)
          << model.declaration.id << " " << i;
      ASSERT_EQ(again[i].penetration_m, records[i].penetration_m);
      if (records[i].penetration_m > 0.0) ++touching;
    }
    EXPECT_GT(touching, 1000U) << model.declaration.id;
  }
}

TEST(Replay, RendersNothingWhereNothingWasPresented) {
  const ModelRegistry registry = built_in_models();
  const std::vector<TickRecord> records = recorded(*registry.find("sinusoid"));
  const auto renderer = make_renderer(*registry.find("sinusoid"), replayed_stimulus());
  const std::vector<RenderedTick> again = replay(*renderer, records, 1000.0);
  EXPECT_FALSE(records[1050].has(TickFlag::presenting));  // the fault
  EXPECT_EQ(again[1050].wrench.force_N, glm::dvec3(0.0));
  EXPECT_GT(again[1200].wrench.force_N.z, 0.0);
}

}  // namespace
}  // namespace asperity
