// The paths of the evidence pd_continuity that no test shares, by formula and from seeded random numbers.

#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"
#include "stimuli/meshes/detailed_bodies.h"
#include "tests/renderers/contact_paths.h"

namespace asperity {

/// A comb of six teeth over ribs, moved to and fro, that is pressed in by 5 mm and lifted, and turns by up to 0.05 rad.
inline ContactPath comb_in_ribs() {
  constexpr double kWay_m = 5e-6;  // of a tick
  constexpr double kAside_m = 6e-3;
  constexpr double kHalfLift_m = 2.75e-3;
  const TexturedMesh comb = bare(make_detailed_body("comb", 1500));
  const TexturedMesh ribs = bare(make_detailed_body("ribs", 3000));
  const double begins_m = -lowest_m(ribs, turn_about({1, 0, 0}, std::numbers::pi)) -
                          lowest_m(comb, glm::dmat3(1.0)) + 0.35e-3;
  return {.name = "comb of six teeth in ribs",
          .tool = comb,
          .surface = ribs,
          .pose =
              [=](int tick) {
                const double phase = kWay_m * tick / kAside_m;
                const double down_m = kHalfLift_m * (1.0 - std::cos(kWay_m * tick / kHalfLift_m));
                return Pose{.rotation = turn_about({1, 0, 0}, 0.03 * std::sin(0.11 * phase)) *
                                        turn_about({0, 0, 1}, 0.05 * std::sin(0.07 * phase)),
                            .position_m = {kAside_m * std::sin(phase),
                                           1e-3 * std::sin(0.37 * phase), begins_m - down_m}};
              },
          .ticks = 6000};
}

/// A number between two others.
inline double drawn(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

/// A block or a ball that leans and rocks, and the axis of both.
struct LeaningTool {
  glm::dvec3 size_m{0.0};
  glm::dvec3 axis{0.0};
  double leaning_rad = 0.0;
  double rocking_rad = 0.0;

  static LeaningTool draw(Random& random) {
    LeaningTool tool;
    for (int i = 0; i < 2; ++i) tool.size_m[i] = drawn(random, 2e-3, 4e-3);
    tool.size_m.z = drawn(random, 2e-3, 4.5e-3);
    for (int i = 0; i < 2; ++i) tool.axis[i] = drawn(random, 0.1, 1.1);
    tool.axis.z = drawn(random, 0.0, 0.4);
    tool.leaning_rad = drawn(random, 0.0, 0.17);
    tool.rocking_rad = drawn(random, 0.0, 0.05);
    return tool;
  }
  glm::dmat3 rotation(double rocked) const {
    return turn_about(axis, leaning_rad + rocking_rad * rocked);
  }
};

/// A tool and two sheets of 0.3 to 0.9 mm with a gap of 0.4 to 1.8 mm, and the heights between which the tool moves: above the upper
/// sheet without a contact, and with its upper side in the lower sheet.
struct ThroughSheets {
  LeaningTool tool{};
  TexturedMesh sheets{};
  double begins_m = 0.0;
  double ends_m = 0.0;

  static ThroughSheets draw(std::uint64_t number) {
    Random random = Random(7).split(number);
    ThroughSheets scene{.tool = LeaningTool::draw(random)};
    const double thickness_m = drawn(random, 0.3e-3, 0.9e-3);
    const double apart_m = thickness_m + drawn(random, 0.4e-3, 1.8e-3);
    scene.sheets = bare(two_sheets(thickness_m, apart_m));
    scene.begins_m = 0.5 * thickness_m + 0.5 * glm::length(scene.tool.size_m) + 0.1e-3;
    scene.ends_m = -apart_m - 0.5 * scene.tool.size_m.z;
    return scene;
  }
};

inline ContactPath through_sheets(std::uint64_t number, bool is_ball) {
  constexpr int kTicks = 900;
  const ThroughSheets scene = ThroughSheets::draw(number);
  return {.name = is_ball ? "ball through two sheets" : "block through two sheets",
          .tool = bare(is_ball ? ball(0.5 * scene.tool.size_m.z, 24, 32) : box(scene.tool.size_m)),
          .surface = scene.sheets,
          .pose =
              [scene](int tick) {
                const double part = static_cast<double>(tick) / kTicks;
                return Pose{
                    .rotation = scene.tool.rotation(std::sin(9.0 * part)),
                    .position_m = {1e-3 * std::sin(5.4 * part), 0.3e-3,
                                   scene.begins_m + part * (scene.ends_m - scene.begins_m)}};
              },
          .ticks = kTicks};
}

/// On the way down it leans in another way and at another place than on the way up, so that errors do not cancel.
inline ClosedPath block_through_sheets_and_back(std::uint64_t number) {
  const ThroughSheets scene = ThroughSheets::draw(number);
  return {.name = "blocks through two sheets and back",
          .tool = bare(box(scene.tool.size_m)),
          .surface = scene.sheets,
          .pose = [scene](double part) {
            const double phase = 2.0 * std::numbers::pi * part;
            const double down = 0.5 * (1.0 - std::cos(phase));
            return Pose{.rotation = scene.tool.rotation(std::sin(phase + 0.4)),
                        .position_m = {1e-3 * std::sin(phase + 0.4), 0.3e-3 * std::sin(2.0 * phase),
                                       scene.begins_m + down * (scene.ends_m - scene.begins_m)}};
          }};
}

/// Its lowest corner is between 0.1 mm above the thick block and 0.5 to 1.5 mm inside.
inline ClosedPath block_that_rocks(std::uint64_t number) {
  constexpr double kHigh_m = 0.02;
  Random random = Random(8).split(number);
  const LeaningTool tool = LeaningTool::draw(random);
  const double pressed_m = drawn(random, 0.5e-3, 1.5e-3);
  const TexturedMesh block = bare(box(tool.size_m));
  return {.name = "blocks that lean and rock in a thick block",
          .tool = block,
          .surface = bare(box({0.02, 0.02, kHigh_m})),
          .pose = [=](double part) {
            const double phase = 2.0 * std::numbers::pi * part;
            const glm::dmat3 rotation = tool.rotation(std::sin(phase + 0.4));
            const double down_m = 0.5 * (1.0 - std::cos(phase)) * (pressed_m + 0.1e-3);
            return Pose{
                .rotation = rotation,
                .position_m = {1e-3 * std::sin(phase + 0.4), 0.3e-3 * std::sin(2.0 * phase),
                               0.5 * kHigh_m - lowest_m(block, rotation) + 0.1e-3 - down_m}};
          }};
}

/// All angles, heights and depths of low steps.
inline std::vector<LowStep> low_steps() {
  std::vector<LowStep> steps;
  for (const double high_m : {0.2e-3, 0.5e-3, 1e-3}) {
    for (const double angle_degrees : {45.0, 75.0, 90.0}) {
      for (const double pressed_m : {0.3e-3, 0.8e-3}) {
        steps.push_back({.high_m = high_m,
                         .angle_rad = angle_degrees * std::numbers::pi / 180.0,
                         .pressed_m = pressed_m});
      }
    }
  }
  return steps;
}

}  // namespace asperity
