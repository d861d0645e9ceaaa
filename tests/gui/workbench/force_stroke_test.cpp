// Holds the forces of a stroke to offline rendering, and the mouse hand to its path.

#include "app/gui/workbench/force_stroke.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/offline/along_path.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {
namespace {

constexpr double kDepth_m = 0.001;

std::shared_ptr<const HeightField> brick() {
  return std::make_shared<const HeightField>(
      make_surface("brick", {}, {.width_m = 0.05, .pixels = 256, .seed = 3}));
}

std::vector<StrokedModel> every_model(const ModelRegistry& registry) {
  std::vector<StrokedModel> models{};
  FieldPlate plate(brick());
  for (const ForceModel& model : registry.models()) {
    StrokedModel stroked{.id = model.declaration.id,
                         .inputs = stroke_inputs(plate.field(), {}, {})};
    if (model.declaration.needs_bodies) add_bodies(stroked.inputs, plate, 0.005);
    add_files_of_relief(stroked.inputs, model, *stroked.inputs.height_field);
    stroked.renderer = make_renderer(model, stroked.inputs);
    models.push_back(std::move(stroked));
  }
  return models;
}

TEST(ForceStroke, GivesTheForcesOfTheOfflineRenderingOfItsPath) {
  const ModelRegistry registry = built_in_models();
  ForceStroke stroke{};
  stroke.set_models(every_model(registry), MouseHand(kDepth_m));
  stroke.begin({0.003, -0.004});
  stroke.advance(100'000'000);
  stroke.begin({-0.01, 0.002});  // knows nothing of the stroke before
  // Frames of uneven length, as they come.
  std::int64_t now_ns = 0;
  for (int frame = 0; frame < 40; ++frame) {
    now_ns += 11'000'000 + 3'700'000 * (frame % 4);
    stroke.aim({-0.01 + 0.0006 * frame, 0.002 + 0.0002 * (frame % 7)});
    stroke.advance(now_ns);
  }
  ASSERT_GT(stroke.path().size(), 600U);
  for (std::size_t m = 0; m < stroke.models().size(); ++m) {
    const StrokedModel& stroked = stroke.models()[m];
    const auto renderer = make_renderer(*registry.find(stroked.id), stroked.inputs);
    const std::vector<RenderedTick> offline = along_path(*renderer, stroke.path(), 1000.0);
    ASSERT_EQ(stroke.forces_N()[m].size(), offline.size());
    double strongest_N = 0.0;
    for (std::size_t i = 0; i < offline.size(); ++i) {
      ASSERT_EQ(stroke.forces_N()[m][i], offline[i].wrench.force_N) << stroked.id << " at " << i;
      strongest_N = std::max(strongest_N, std::abs(offline[i].wrench.force_N.z));
    }
    EXPECT_GT(strongest_N, 0.1) << stroked.id;
  }
}

TEST(ForceStroke, SamplesThePathOnceEveryMillisecond) {
  ForceStroke stroke{};
  stroke.begin({0.0, 0.0});
  stroke.advance(16'400'000);
  stroke.advance(33'000'000);
  ASSERT_EQ(stroke.path().size(), 34U);
  for (std::size_t i = 0; i < stroke.path().size(); ++i) {
    EXPECT_EQ(stroke.path()[i].time_ns, static_cast<std::int64_t>(i) * 1'000'000);
  }
}

TEST(MouseHand, ArrivesWhereTheMouseRestsAndStops) {
  MouseHand hand(kDepth_m);
  hand.begin({0.0, 0.0});
  hand.aim({0.02, -0.01});
  const ProbeState last = hand.advance(500'000'000).back();
  EXPECT_NEAR(last.position_m.x, 0.02, 1e-9);
  EXPECT_NEAR(last.position_m.y, -0.01, 1e-9);
  EXPECT_DOUBLE_EQ(last.position_m.z, -kDepth_m);
  EXPECT_NEAR(last.velocity_m_per_s.x, 0.0, 1e-9);
}

TEST(MouseHand, HasTheVelocityOfItsPath) {
  MouseHand hand(kDepth_m);
  hand.begin({0.0, 0.0});
  hand.aim({0.02, 0.01});
  const std::vector<ProbeState> path = hand.advance(200'000'000);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_NEAR((path[i].position_m.x - path[i - 1].position_m.x) / 0.001,
                path[i].velocity_m_per_s.x, 1e-9);
  }
}

}  // namespace
}  // namespace asperity
