// Paths of a tool on which contacts begin, divide, merge and end, for tests and for scripts/evidence pd_continuity.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tests/renderers/contact_scenes.h"

namespace asperity {

/// A tool whose pose is given for each tick, and a surface that does not move.
struct ContactPath {
  std::string name{};
  TexturedMesh tool{};
  TexturedMesh surface{};
  std::function<Pose(int tick)> pose{};
  int ticks = 0;
  WindowSampling sampling = hard(0.1e-3);
  /// At the first pose, before the first tick, so that forces have risen.
  int ticks_at_rest = 30;
};

/// A path of a tool that ends where it begins.
struct ClosedPath {
  std::string name{};
  TexturedMesh tool{};
  TexturedMesh surface{};
  std::function<Pose(double part)> pose{};  ///< the same at 0 and 1
  WindowSampling sampling = hard(0.1e-3);
};

inline TexturedContacts contacts_of(const ContactPath& path) {
  return between(path.tool, path.surface, path.sampling);
}

/// The z of a body's lowest vertex, if its origin is at zero.
inline double lowest_m(const TexturedMesh& body, const glm::dmat3& rotation) {
  double least_m = (rotation * body.vertices_m.front()).z;
  for (const glm::dvec3& vertex_m : body.vertices_m) {
    least_m = std::min(least_m, (rotation * vertex_m).z);
  }
  return least_m;
}

/// What the force does on the hand along a closed path, by the midpoint rule.
struct PathWork {
  double net_J = 0.0;
  double gross_J = 0.0;      ///< the sum of the magnitudes of all ticks
  std::size_t rendered = 0;  ///< contacts in all ticks, without fading ones
  std::size_t bounded = 0;   ///< of these, with a limited depth
};

/// The work around a path in that many ticks. A path that begins in contact is gone around once before, so that shares at its
/// beginning and at its end are the same.
///
/// In a tick A moves from pose 0 to pose 1, and the force F and the torque T about A's origin are those of the pose between them. With
/// R₁·R₀ᵀ, the rotation by the vector Δφ, the work is F·(x₁ − x₀) + T·Δφ, to the third order of the tick.
inline PathWork work_around(const ClosedPath& path, int ticks) {
  TexturedContacts contacts = between(path.tool, path.surface, path.sampling);
  const bool begins_apart = !contacts.touch(path.pose(0.0), {});
  PathWork work;
  for (int tick = begins_apart ? 0 : -ticks; tick < ticks; ++tick) {
    const auto pose_after = [&](double later) {
      const double part = (tick + later) / ticks;
      return path.pose(part - std::floor(part));
    };
    const Pose from = pose_after(0.0);
    const Pose to = pose_after(1.0);
    const Pose between_them = pose_after(0.5);
    const auto found = contacts.find(between_them, {}, kTick_s);
    if (tick < 0) continue;
    const glm::dquat turn = glm::quat_cast(to.rotation * glm::transpose(from.rotation));
    const Wrench wrench = wrench_about(between_them.position_m, found);
    const double work_J = glm::dot(wrench.force_N, to.position_m - from.position_m) +
                          glm::dot(wrench.torque_N_m, 2.0 * glm::dvec3{turn.x, turn.y, turn.z});
    work.net_J += work_J;
    work.gross_J += std::abs(work_J);
    for (const TexturedContact& contact : found) {
      if (!is_felt(contact) || contact.is_fading || contact.share == 0.0) continue;
      ++work.rendered;
      work.bounded += contact.is_bounded ? 1 : 0;
    }
  }
  return work;
}

/// A bumpy ring that lies on a block: bumps become one contact and separate.
struct RingOnBlock {
  TexturedMesh ring = bare(bumpy_torus(30, 20));
  TexturedMesh block = bare(box({0.1, 0.1, 0.1}));
  WindowSampling sampling{.law = HardMaximum{.step_m = 0.2e-3}, .cell_m = 0.2e-3};

  /// That much deeper than where it touches first.
  Pose pressed(double phase, double depth_m) const {
    const glm::dmat3 rocked = turn_about({1, 0.1, 0.2}, 0.02 + 0.05 * std::sin(phase)) *
                              turn_about({0, 1, 0}, 0.04 * std::sin(1.7 * phase)) *
                              turn_about({0, 0, 1}, 0.1 * phase);
    return {.rotation = rocked,
            .position_m = {0.3e-3 * phase, 0.0, 0.05 - lowest_m(ring, rocked) - depth_m}};
  }
};

/// It rocks, and is pressed and lifted between 0.2 and 1.8 mm.
inline ContactPath ring_that_rocks() {
  constexpr int kTicks = 1000;
  const RingOnBlock scene;
  return {.name = "ring of bumps that rocks on a block",
          .tool = scene.ring,
          .surface = scene.block,
          .pose =
              [scene](int tick) {
                const double phase = 2.0 * std::numbers::pi * (0.45 + 0.5 * tick / kTicks);
                return scene.pressed(phase, 1e-3 + 0.8e-3 * std::sin(7.0 * phase));
              },
          .ticks = kTicks,
          .sampling = scene.sampling};
}

/// It is pressed from 0.2 to 1.8 mm and lifted, without rocking.
inline ClosedPath ring_that_is_pressed() {
  const RingOnBlock scene;
  return {.name = "ring of bumps, pressed by 1.6 mm and lifted",
          .tool = scene.ring,
          .surface = scene.block,
          .pose =
              [scene](double part) {
                return scene.pressed(0.0, 1e-3 - 0.8e-3 * std::cos(2.0 * std::numbers::pi * part));
              },
          .sampling = scene.sampling};
}

/// Two balls in one body; the lower one enters the block completely.
inline ContactPath one_of_two_balls_enters() {
  return {.name = "two balls, one enters",
          .tool = balls_at({{-4e-3, 0.0, 1e-3}, {4e-3, 0.0, 2e-3}}, 1e-3),
          .surface = bare(box({0.03, 0.03, 0.01})),
          .pose =
              [](int tick) {
                return pose_at({0.0, 0.0, 0.005 - 1e-5 * tick});
              },
          .ticks = 281};
}

/// The lower one of two small balls enters completely, for 0.12 s, and comes out 0.4 mm deep, which is not too deep to be credible.
inline ContactPath small_ball_enters_and_leaves() {
  constexpr double kBall_m = 0.2e-3;
  constexpr int kDown = 120;
  return {.name = "two small balls, one enters and leaves",
          .tool = balls_at({{-4e-3, 0.0, kBall_m}, {4e-3, 0.0, 2.5 * kBall_m}}, kBall_m),
          .surface = bare(box({0.03, 0.03, 0.01})),
          .pose =
              [](int tick) {
                const int down = std::min(tick, std::max(2 * kDown - tick, 0));
                return pose_at({0.0, 0.0, 0.005 - 5e-6 * down});
              },
          .ticks = 2 * kDown + 31};
}

/// A needle that is 3 mm deep from the first tick on, which is not credible for 25 ms.
inline ContactPath needle_that_is_suddenly_deep() {
  return {.name = "needle that is suddenly 3 mm deep",
          .tool = bare(needle()),
          .surface = bare(box({0.02, 0.02, 0.01})),
          .pose =
              [](int) {
                return pose_at({0.0, 0.0, 0.005 + kNeedle_m - 3e-3});
              },
          .ticks = 200,
          .ticks_at_rest = 0};
}

/// A ball that is pressed on the floor and moves into a wall.
struct BallAtWall {
  double angle_rad = 0.0;
  double radius_m = 2e-3;
  double in_floor_m = 0.8e-3;

  Pose pose(double in_wall_m) const {
    const double z_m = radius_m - in_floor_m;
    const double x_m = (std::cos(angle_rad) * z_m - (radius_m - in_wall_m)) / std::sin(angle_rad);
    return pose_at({x_m, 0.0, z_m});
  }
};

/// From 0.1 mm before the wall to 0.8 mm inside.
inline ContactPath ball_at_foot_of_wall(double angle_rad) {
  const BallAtWall at{.angle_rad = angle_rad};
  return {.name = "ball at the foot of a wall",
          .tool = bare(ball(at.radius_m, 24, 32)),
          .surface = bare(floor_and_wall(angle_rad)),
          .pose = [at](int tick) { return at.pose(5e-6 * (tick - 20)); },
          .ticks = 180};
}

/// The height and the angle of a step in the surface, and how deep a tool is pressed in that slides against it.
struct LowStep {
  double high_m = 0.0;
  double angle_rad = 0.0;
  double pressed_m = 0.0;
};

inline ContactPath ball_against(const LowStep& step) {
  return {.name = "ball against a low step",
          .tool = bare(ball(2e-3, 24, 32)),
          .surface = bare(floor_and_wall(step.angle_rad, step.high_m)),
          .pose =
              [step](int tick) {
                return pose_at({-3e-3 + 5e-6 * tick, 0.1e-3, 2e-3 - step.pressed_m});
              },
          .ticks = 1200};
}

inline ContactPath box_against(const LowStep& step) {
  return {.name = "box against a low step",
          .tool = bare(box({4e-3, 4e-3, 4e-3})),
          .surface = bare(floor_and_wall(step.angle_rad, step.high_m)),
          .pose =
              [step](int tick) {
                return pose_at({-4e-3 + 5e-6 * tick, 0.1e-3, 2e-3 - step.pressed_m});
              },
          .ticks = 1400};
}

/// Through the plate and back, with motions to the side.
inline ClosedPath ball_through_thin_plate() {
  return {.name = "ball through a plate of 0.5 mm and back",
          .tool = bare(ball(2e-3, 24, 32)),
          .surface = bare(box({0.02, 0.02, 0.5e-3})),
          .pose = [](double part) {
            const double phase = 2.0 * std::numbers::pi * part;
            return pose_at({0.5e-3 * std::sin(phase + 0.4), 0.3e-3 * std::sin(2.0 * phase),
                            0.6e-3 + 1.75e-3 * std::cos(phase)});
          }};
}

}  // namespace asperity
