// The measurement of ticks, and the scenes that are measured.

#include "renderers/offline/tick_times.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/offline/two_body_scenes.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

TEST(TickTimes, CallsTheTicksInOrderAndCountsThoseAfterTheWarmUp) {
  std::vector<int> called;
  const TickTimes times = time_ticks({.warm_up = 3, .counted = 5, .evicted_bytes = 4096},
                                     [&called](int tick) { called.push_back(tick); });
  EXPECT_EQ(called, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(static_cast<std::int64_t>(times.undisturbed_ns.size()) + times.preempted, 5);
}

TEST(TickTimes, EndAtTheLongestTimeButCountOneTick) {
  int called = 0;
  const TickTimes times = time_ticks({.warm_up = 1000,
                                      .counted = 1000,
                                      .longest = std::chrono::nanoseconds(0),
                                      .waits = TickCount::Waits::for_device},
                                     [&called](int) { ++called; });
  EXPECT_LE(called, 2);
  EXPECT_EQ(times.undisturbed_ns.size(), 1U);
}

TEST(TickTimes, EndAtARequestedStop) {
  std::stop_source source;
  int called = 0;
  time_ticks(
      {.warm_up = 2, .counted = 10},
      [&](int tick) {
        ++called;
        if (tick == 4) source.request_stop();
      },
      source.get_token());
  EXPECT_EQ(called, 5);
}

TEST(TickTimes, HaveQuantiles) {
  TickTimes times;
  EXPECT_FALSE(times.quantile_ns(0.5));
  for (std::int64_t i = 0; i <= 100; ++i) times.undisturbed_ns.push_back(10 * i);
  EXPECT_EQ(times.quantile_ns(0.5), 500);
  EXPECT_EQ(times.quantile_ns(0.99), 990);
  EXPECT_EQ(times.quantile_ns(1.0), 1000);
}

TEST(TickTimes, CountTheTicksLongerThanMedians) {
  TickTimes times;
  EXPECT_EQ(times.longer_than_medians(5.0), 0);
  times.undisturbed_ns = {1, 2, 10, 50, 50, 51, 260};
  EXPECT_EQ(times.longer_than_medians(1.0), 2);
  EXPECT_EQ(times.longer_than_medians(5.0), 1);
}

// In each repetition another tick is disturbed.
TEST(TickTimes, AreTheShortestOfEachTickOverRepetitions) {
  constexpr auto kDisturbance = std::chrono::milliseconds(50);
  int repetition = -1;
  std::vector<int> called;
  const TickTimes times = shortest_of_ticks(
      {.warm_up = 1, .counted = 3}, 3,
      {.restart = [&repetition] { ++repetition; },
       .tick =
           [&](int tick) {
             called.push_back(tick);
             const auto until = std::chrono::steady_clock::now() + kDisturbance;
             while (tick == repetition + 1 && std::chrono::steady_clock::now() < until) {
             }
           }});
  EXPECT_EQ(called, (std::vector<int>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}));
  EXPECT_EQ(static_cast<std::int64_t>(times.undisturbed_ns.size()) + times.preempted, 3);
  for (const std::int64_t took_ns : times.undisturbed_ns) {
    EXPECT_LT(std::chrono::nanoseconds(took_ns), kDisturbance);
  }
}

TwoBodyScene ball_over_plate(double plate_m) {
  const auto mesh = [](const Shape& shape) {
    return std::make_shared<const TexturedMesh>(body_mesh(shape, nullptr));
  };
  return two_body_scene("ball on plate", mesh(SphereShape{.diameter_m = 0.006}),
                        mesh(PlateShape{{plate_m, plate_m, 0.004}}));
}

TEST(TwoBodyScene, PressesItsToolIntoTheSurface) {
  TwoBodyScene scene = ball_over_plate(0.03);
  scene.above_m.z -= 0.0015;  // for fewer steps
  const auto start = pressed_tool(scene);
  ASSERT_TRUE(start);
  const auto renderer =
      make_renderer(pd_gradient_model(), inputs_of(scene, {{"coupling", std::string("none")}}));
  start_clear(*renderer, scene, *start);
  const double force_N =
      renderer->tick(moved_tool(scene, *start, 0), kSceneTick_s).wrench.force_N.z;
  EXPECT_NEAR(force_N, 0.16, 0.015);  // 0.15 mm to 0.17 mm, a step more, into 1 N/mm
}

TEST(TwoBodyScene, HasNoStartWhereTheToolPassesTheSurface) {
  TwoBodyScene scene = ball_over_plate(0.002);
  scene.above_m.x = 0.02;
  EXPECT_FALSE(pressed_tool(scene));
}

}  // namespace
}  // namespace asperity
