// The force model of two textured bodies: couplings, friction, patch, what it counts.

#include "renderers/pd_gradient/contact/pd_gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/small_turn.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kTipRadius_m = 1.5e-3;
constexpr Grating kPlateGrating{.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3};

/// The ball has facets, and no sample meets its lowest point: it is up to so much less deep.
constexpr double kSampled_N = 0.009;

/// A ball of 3 mm with its lowest point at the tip, on a grated plate.
RendererInputs ball_on_plate(ParameterValues parameters) {
  // Made once: what is const is shared.
  static const auto kBall = shared(shifted(bare(ball(kTipRadius_m, 14, 20)), {0, 0, kTipRadius_m}));
  static const auto kPlate = shared(grated_plate(kPlateGrating));
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.0};
  inputs.patch = wide_patch();
  inputs.tool = kBall;
  inputs.surface = kPlate;
  return inputs;
}

ParameterValues direct(ParameterValues more = {}) {
  more["coupling"] = std::string("none");
  return more;
}

std::unique_ptr<ForceRenderer> renderer_of(const RendererInputs& inputs) {
  return make_renderer(pd_gradient_model(), inputs);
}

std::uint64_t ticks_of(const ForceRenderer& renderer, std::string_view limit) {
  for (const NamedCount& count : renderer.limits()) {
    if (count.name == limit) return count.ticks;
  }
  ADD_FAILURE() << limit;
  return 0;
}

/// Ticks at one place, with one velocity.
RenderedTick held(ForceRenderer& renderer, const ProbeState& probe, int ticks) {
  RenderedTick tick{};
  for (int i = 0; i < ticks; ++i) tick = renderer.tick(probe, kTick_s);
  return tick;
}

/// Along x at one height and speed; the force of every tick.
std::vector<glm::dvec3> stroked(ForceRenderer& renderer, double height_m, double speed_m_per_s,
                                int ticks) {
  std::vector<glm::dvec3> forces_N;
  ProbeState probe = probe_at({-3e-3, 0.2e-3, height_m});
  probe.velocity_m_per_s.x = speed_m_per_s;
  renderer.reset(probe);
  for (int i = 0; i < ticks; ++i) {
    forces_N.push_back(renderer.tick(probe, kTick_s).wrench.force_N);
    probe.position_m.x += speed_m_per_s * kTick_s;
  }
  return forces_N;
}

/// Root mean square around the mean, of the later half.
double vibration_N(std::span<const glm::dvec3> forces_N, int axis) {
  forces_N = forces_N.subspan(forces_N.size() / 2);
  double sum_N = 0.0;
  double squares_N2 = 0.0;
  for (const glm::dvec3& force_N : forces_N) {
    sum_N += force_N[axis];
    squares_N2 += force_N[axis] * force_N[axis];
  }
  const auto count = static_cast<double>(forces_N.size());
  return std::sqrt(std::max(0.0, squares_N2 / count - sum_N * sum_N / (count * count)));
}

TEST(PdGradient, PushesAPlainBallOutOfAPlainPlateWithItsStiffness) {
  for (const char* maximum : {"hard", "smooth"}) {
    RendererInputs inputs =
        ball_on_plate(direct({{"texture_gain", 0.0}, {"maximum", std::string(maximum)}}));
    const auto renderer = renderer_of(inputs);
    const RenderedTick tick = answer(*renderer, probe_at({0.0, 0.0, -0.2e-3}));
    const double later_N = std::string(maximum) == "hard" ? 0.0 : 0.020;  // k·τ
    EXPECT_NEAR(tick.wrench.force_N.z, 0.2 - later_N, kSampled_N);
    EXPECT_NEAR(tick.wrench.force_N.x, 0.0, 1e-3);
    EXPECT_NEAR(tick.wrench.force_N.y, 0.0, 1e-3);
    EXPECT_NEAR(tick.penetration_m, tick.wrench.force_N.z / 1000.0, 1e-9);
    const RenderedTick free = answer(*renderer, probe_at({0.0, 0.0, 0.2e-3}));
    EXPECT_EQ(free.wrench.force_N, glm::dvec3(0.0));
    EXPECT_EQ(free.penetration_m, 0.0);
  }
}

TEST(PdGradient, FeelsTheForceAsATorqueAboutTheTip) {
  // The ball's middle is 20 mm beside the tip and 10 mm below it.
  const glm::dvec3 middle_m{0.020, 0.0, -0.010};
  RendererInputs inputs = ball_on_plate(direct({{"texture_gain", 0.0}}));
  inputs.tool = shared(shifted(bare(ball(kTipRadius_m, 24, 32)), middle_m));
  for (const bool coupled : {false, true}) {
    if (coupled) {
      // Too stiff to turn away: the contact stays where it is.
      inputs.parameters = {{"texture_gain", 0.0},
                           {"coupling_angular_stiffness_N_m_per_rad", 100.0}};
    }
    const auto renderer = renderer_of(inputs);
    ProbeState probe = probe_at({});
    probe.orientation = glm::angleAxis(0.7, glm::dvec3{0.0, 0.0, 1.0});
    probe.position_m = glm::dvec3{0.0, 0.0, kTipRadius_m - 0.2e-3} - probe.orientation * middle_m;
    renderer->reset(probe);
    const Wrench wrench = held(*renderer, probe, 600).wrench;
    ASSERT_GT(wrench.force_N.z, 0.05);
    const glm::dvec3 deepest_m{0.0, 0.0, 0.0};
    const glm::dvec3 torque_N_m = glm::cross(deepest_m - probe.position_m, wrench.force_N);
    EXPECT_LT(glm::distance(wrench.torque_N_m, torque_N_m), 0.01 * glm::length(torque_N_m));
  }
}

TEST(PdGradient, FeelsAContactAtTheEndOfALongToolAsATorque) {
  for (const char* coupling : {"none", "virtual"}) {
    RendererInputs inputs = ball_on_plate({{"coupling", std::string(coupling)},
                                           {"texture_gain", 0.0},
                                           {"coupling_angular_stiffness_N_m_per_rad", 100.0}});
    inputs.tool = shared(bare(box({0.018, 0.003, 0.003})));
    const auto renderer = renderer_of(inputs);
    ProbeState probe = probe_at({});
    probe.orientation = glm::angleAxis(0.1, glm::dvec3{0.0, 1.0, 0.0});
    const glm::dvec3 end_m = probe.orientation * glm::dvec3{0.009, 0.0, -0.0015};
    probe.position_m.z = -end_m.z - 0.1e-3;
    renderer->reset(probe);
    const Wrench wrench = held(*renderer, probe, 600).wrench;
    ASSERT_GT(wrench.force_N.z, 0.03) << coupling;
    // Within a cell and a half of the edge that is deepest.
    EXPECT_NEAR(wrench.torque_N_m.y / wrench.force_N.z, -end_m.x, 0.15e-3) << coupling;
  }
}

// While contacts join, each is felt by its share.
TEST(PdGradient, FeelsContactsByTheirShares) {
  RendererInputs inputs = ball_on_plate(direct({{"step_m", 0.2e-3}, {"cell_m", 0.2e-3}}));
  inputs.parameters = complete_values(pd_gradient_model().declaration, inputs.parameters);
  inputs.tool = shared(bare(bumpy_torus(30, 20)));
  inputs.surface = shared(bare(box({0.1, 0.1, 0.1})));
  PdGradient renderer(inputs, instruction_sets_here().back());
  ProbeState probe = probe_at({});
  probe.orientation = glm::angleAxis(0.02, glm::normalize(glm::dvec3{1.0, 0.1, 0.2}));
  int shared_ticks = 0;
  for (int i = 0; i < 300; ++i) {
    probe.position_m.z = 0.05 + 0.0142 - 1e-5 * i;
    if (i == 0) renderer.reset(probe);
    const glm::dvec3 force_N = renderer.tick(probe, kTick_s).wrench.force_N;
    glm::dvec3 sum_N{0.0};
    bool is_shared = false;
    for (const TexturedContact& contact : renderer.contacts()) {
      if (!is_felt(contact)) continue;
      sum_N += contact_wrench(contact.penetration, contact.frame, contact.share * 1000.0).force_N;
      is_shared = is_shared || contact.share < 1.0;
    }
    ASSERT_LT(glm::distance(force_N, sum_N), 1e-9) << i;
    shared_ticks += is_shared ? 1 : 0;
  }
  EXPECT_GT(shared_ticks, 10);
}

TEST(PdGradient, SharesAPressBetweenCouplingAndContact) {
  const auto renderer = renderer_of(ball_on_plate({{"texture_gain", 0.0}}));
  ProbeState probe = probe_at({0.0, 0.0, 0.5e-3});
  renderer->reset(probe);
  probe.position_m.z = -0.4e-3;
  const RenderedTick tick = held(*renderer, probe, 3000);
  // 1000 N/m and 1000 N/m in series; the tool is half way in.
  EXPECT_NEAR(tick.wrench.force_N.z, 0.2, kSampled_N);
  EXPECT_NEAR(tick.penetration_m, tick.wrench.force_N.z / 1000.0, 1e-7);
}

TEST(PdGradient, ReportsThePoseOfTheSimulatedTool) {
  // At rest the force on the hand is that of the spring, k_t·(p_tool − p_device), and the torque k_r times the rotation vector.
  RendererInputs inputs = ball_on_plate({{"texture_gain", 0.0}});
  inputs.tool = shared(bare(box({0.018, 0.003, 0.003})));
  std::vector<ProbeState> path(4000, probe_at({}));
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    path[i].orientation = glm::angleAxis(0.1, glm::dvec3{0.0, 1.0, 0.0});
    path[i].position_m.z = 3e-3 - 1e-6 * std::min(1500.0, static_cast<double>(i));
  }
  const auto coupled = renderer_of(inputs);
  const ToolAlongPath along = tool_along_path(*coupled, path, 1000.0);
  const Wrench wrench = along.ticks.back().wrench;
  const TipPose& tool = along.tools.back();
  ASSERT_GT(wrench.force_N.z, 0.05);
  EXPECT_NEAR(tool.position_m.z - path.back().position_m.z, wrench.force_N.z / 1000.0, 1e-6);
  const glm::dvec3 turn_rad = small_turn_rad(path.back().orientation, tool.orientation);
  EXPECT_LT(turn_rad.y, -1e-3);  // the end that is pressed up
  EXPECT_NEAR(wrench.torque_N_m.y, 0.3 * turn_rad.y, 0.02 * std::abs(wrench.torque_N_m.y));
  // Without a coupling the tool is where the path is.
  inputs.parameters["coupling"] = std::string("none");
  const auto direct_one = renderer_of(inputs);
  const ToolAlongPath same = tool_along_path(*direct_one, path, 1000.0);
  EXPECT_EQ(same.tools.back().position_m, path.back().position_m);
  EXPECT_EQ(same.tools.back().orientation, path.back().orientation);
}

TEST(PdGradient, StandsTheSurfaceInTheMiddleOfThePatch) {
  RendererInputs inputs = ball_on_plate(direct({{"texture_gain", 0.0}}));
  inputs.patch.centre_m = {0.03, -0.02, 0.05};
  const auto renderer = renderer_of(inputs);
  EXPECT_NEAR(answer(*renderer, probe_at({0.03, -0.02, 0.05 - 0.2e-3})).wrench.force_N.z, 0.2,
              kSampled_N);
  EXPECT_EQ(answer(*renderer, probe_at({0.0, 0.0, -0.2e-3})).penetration_m, 0.0);
}

// The seeds' first motion.
TEST(PdGradient, VibratesUnderTranslationWithTheTextureAndNotWithout) {
  for (const char* coupling : {"none", "virtual"}) {
    const auto vibrations = [&](double gain) {
      const auto renderer =
          renderer_of(ball_on_plate({{"coupling", std::string(coupling)}, {"texture_gain", gain}}));
      const auto forces_N = stroked(*renderer, -0.25e-3, 0.02, 300);
      return std::array{vibration_N(forces_N, 0), vibration_N(forces_N, 2)};
    };
    const auto textured = vibrations(1.0);
    const auto plain = vibrations(0.0);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_GT(textured[axis], 0.006) << coupling;
      EXPECT_LT(plain[axis], 0.05 * textured[axis]) << coupling;
    }
  }
}

// The second: a grooved cylinder that lies on a plain plate turns about its own axis, which goes through
// the tip.
TEST(PdGradient, VibratesUnderRotationWithTheTextureAndNotWithout) {
  const CylinderShape shape{.diameter_m = 0.006, .length_m = 0.006};
  const auto grooved =
      shared(with_grating(shape, {.amplitude_m = 0.03e-3, .wavelength_m = 1.2e-3}, 0.001));
  const auto smooth = shared(textured_shape(shape, *level(0.0F), {.rim_m = 0.001}));
  const glm::dquat lying = glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3{0.0, 1.0, 0.0});
  for (const char* coupling : {"none", "virtual"}) {
    const auto turning = [&](const std::shared_ptr<const TexturedMesh>& cylinder) {
      RendererInputs inputs =
          ball_on_plate({{"coupling", std::string(coupling)}, {"texture_gain", 0.0}});
      inputs.tool = cylinder;
      const auto renderer = renderer_of(inputs);
      std::vector<glm::dvec3> forces_N;
      std::vector<glm::dvec3> torques_N_m;
      constexpr double kTurn_rad_per_s = 7.0;
      ProbeState probe = probe_at({0.3e-3, 0.1e-3, 0.003 - 0.25e-3});
      probe.angular_velocity_rad_per_s.x = kTurn_rad_per_s;
      for (int i = 0; i < 300; ++i) {
        probe.orientation =
            glm::angleAxis(kTurn_rad_per_s * kTick_s * i, glm::dvec3{1.0, 0.0, 0.0}) * lying;
        if (i == 0) renderer->reset(probe);
        const Wrench wrench = renderer->tick(probe, kTick_s).wrench;
        forces_N.push_back(wrench.force_N);
        torques_N_m.push_back(wrench.torque_N_m);
      }
      return std::array{vibration_N(forces_N, 2), vibration_N(torques_N_m, 0)};
    };
    const auto [textured_N, textured_N_m] = turning(grooved);
    const auto [plain_N, plain_N_m] = turning(smooth);
    EXPECT_GT(textured_N, 0.005) << coupling;
    EXPECT_LT(plain_N, 0.1 * textured_N) << coupling;
    EXPECT_GT(textured_N_m, 2e-5) << coupling;
    EXPECT_LT(plain_N_m, 0.1 * textured_N_m) << coupling;
  }
}

TEST(PdGradient, RubsWithTheCoefficientOfTheMaterial) {
  RendererInputs inputs = ball_on_plate(direct({{"texture_gain", 0.0}}));
  inputs.material.friction = 0.4;
  const auto renderer = renderer_of(inputs);
  ProbeState probe = probe_at({0.0, 0.0, -0.2e-3});
  probe.velocity_m_per_s = {0.03, 0.04, -0.01};
  const Wrench wrench = answer(*renderer, probe).wrench;
  // At 50 mm/s with v₀ of 10 mm/s, against the velocity along the plate.
  const double friction_N = 0.4 * wrench.force_N.z * 0.05 / std::hypot(0.05, 0.01);
  EXPECT_NEAR(wrench.force_N.x, -0.6 * friction_N, 1e-3);
  EXPECT_NEAR(wrench.force_N.y, -0.8 * friction_N, 1e-3);
  EXPECT_NEAR(wrench.force_N.z, 0.2, kSampled_N);
}

TEST(PdGradient, DragsItsSimulatedToolWithTheSameFriction) {
  RendererInputs inputs = ball_on_plate({{"texture_gain", 0.0}});
  inputs.material.friction = 0.4;
  const auto forces_N = stroked(*renderer_of(inputs), -0.4e-3, 0.02, 250);
  const double friction_N = 0.4 * 0.2 * 0.02 / std::hypot(0.02, 0.01);
  EXPECT_NEAR(forces_N.back().x, -friction_N, 0.05 * friction_N);
  EXPECT_NEAR(forces_N.back().z, 0.2, 0.01);
}

TEST(PdGradient, DampsAContactAndNeverPulls) {
  const auto renderer = renderer_of(
      ball_on_plate(direct({{"texture_gain", 0.0}, {"contact_damping_N_s_per_m", 5.0}})));
  ProbeState probe = probe_at({0.0, 0.0, -0.2e-3});
  probe.velocity_m_per_s.z = -0.01;
  EXPECT_NEAR(answer(*renderer, probe).wrench.force_N.z, 0.2 + 5.0 * 0.01, kSampled_N);
  probe.velocity_m_per_s.z = 0.5;
  EXPECT_EQ(answer(*renderer, probe).wrench.force_N.z, 0.0);
}

TEST(PdGradient, FadesAtThePatchsBorderAndPushesBackAtAWall) {
  RendererInputs inputs = ball_on_plate(direct({{"texture_gain", 0.0}}));
  inputs.patch = {.extent_m = {0.008, 0.008}, .edge_width_m = 0.002};
  const auto fading = renderer_of(inputs);
  EXPECT_NEAR(answer(*fading, probe_at({0.003, 0.0, -0.2e-3})).wrench.force_N.z, 0.1, kSampled_N);
  const RenderedTick outside = answer(*fading, probe_at({0.0041, 0.0, -0.2e-3}));
  EXPECT_EQ(outside.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(outside.penetration_m, 0.0);
  inputs.patch.edge = PatchEdge::wall;
  const auto walled = renderer_of(inputs);
  const ProbeState inside = probe_at({0.0039, 0.0, -0.2e-3});
  EXPECT_NEAR(answer_after(*walled, inside, probe_at({0.005, 0.0, -0.2e-3})).wrench.force_N.x, -1.0,
              1e-2);
  EXPECT_EQ(answer_after(*walled, inside, probe_at({0.005, 0.0, 0.2e-3})).wrench.force_N,
            glm::dvec3(0.0));
}

// A surface that appears around the probe has to stay silent until the probe has left it.
TEST(PdGradient, IsNeverAtDepthZeroBeforeTheDeviceHasBeenClear) {
  for (const char* coupling : {"none", "virtual"}) {
    const auto renderer = renderer_of(ball_on_plate({{"coupling", std::string(coupling)}}));
    ProbeState probe = probe_at({0.0, 0.0, -6e-3});  // wholly inside
    renderer->reset(probe);
    for (double z_m = -6e-3; z_m < -0.2e-3; z_m += 0.05e-3) {
      probe.position_m.z = z_m;
      EXPECT_GT(renderer->tick(probe, kTick_s).penetration_m, 0.0) << coupling << " " << z_m;
    }
    probe.position_m.z = 1e-3;
    EXPECT_EQ(held(*renderer, probe, 200).penetration_m, 0.0) << coupling;
    // Once clear, the hull is not the surface: above the texture nothing is touched.
    probe.position_m.z = 0.06e-3;
    EXPECT_EQ(held(*renderer, probe, 200).penetration_m, 0.0) << coupling;
  }
}

TEST(PdGradient, AnswersTheSameBitsToTheSameHand) {
  for (const char* coupling : {"none", "virtual"}) {
    RendererInputs inputs = ball_on_plate({{"coupling", std::string(coupling)}});
    inputs.material.friction = 0.3;
    const auto one = renderer_of(inputs);
    const auto other = renderer_of(inputs);
    const auto first = stroked(*one, -0.2e-3, 0.05, 100);
    EXPECT_EQ(stroked(*other, -0.2e-3, 0.05, 100), first);
    stroked(*one, -0.3e-3, 0.01, 30);
    EXPECT_EQ(stroked(*one, -0.2e-3, 0.05, 100), first);  // `reset` forgets
  }
}

TEST(PdGradient, AnswersTheSameBitsWithEveryInstructionSet) {
  RendererInputs inputs = ball_on_plate({});
  inputs.parameters = complete_values(pd_gradient_model().declaration, {});
  std::vector<std::vector<glm::dvec3>> answers;
  for (const InstructionSet set : instruction_sets_here()) {
    PdGradient renderer(inputs, set);
    answers.push_back(stroked(renderer, -0.2e-3, 0.05, 60));
  }
  for (const auto& forces_N : answers) EXPECT_EQ(forces_N, answers.front());
}

TEST(PdGradient, LeavesTheHeapAlone) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  for (const char* maximum : {"hard", "smooth"}) {
    for (const char* coupling : {"none", "virtual"}) {
      RendererInputs inputs =
          ball_on_plate({{"coupling", std::string(coupling)}, {"maximum", std::string(maximum)}});
      inputs.material.friction = 0.3;
      const auto renderer = renderer_of(inputs);
      ProbeState probe = probe_at({0.0, 0.0, 1e-3});
      const AllocationGuard guard;
      renderer->reset(probe);
      for (int i = 0; i < 100; ++i) {
        probe.position_m = {1e-5 * i, 0.0, 1e-3 - 5e-5 * i};  // wholly inside at the end
        renderer->tick(probe, kTick_s);
      }
      EXPECT_EQ(guard.count(), 0);
      EXPECT_GT(ticks_of(*renderer, "contact"), 50U);
    }
  }
}

// A hand of 50 g on springs holds the device's tip and strokes it over a fine texture that is five
// times as stiff as the coupling; the force acts on it explicitly, as a device's does.
TEST(PdGradient, KeepsAHandBoundedOnStiffFineTextureForAMinuteAtOneKilohertz) {
  RendererInputs inputs =
      ball_on_plate({{"texture_gain", 0.8}, {"step_m", 0.1e-3}, {"cell_m", 0.1e-3}});
  inputs.material = {.stiffness_N_per_m = 5000.0, .friction = 0.3};
  const auto renderer = renderer_of(inputs);
  constexpr double kMass_kg = 0.05;
  constexpr double kHold_N_per_m = 300.0;
  constexpr double kHold_N_s_per_m = 5.0;
  ProbeState probe = probe_at({0.0, 0.0, 1e-3});
  renderer->reset(probe);
  double largest_N = 0.0;
  // Under the sanitizers, which take ten times as long, a tenth.
  constexpr int kTicks = AllocationGuard::kCounts ? 60'000 : 6'000;
  constexpr int kThird = kTicks / 3;
  std::array<double, 2> squares_m2_per_s2{};  // of the velocity across, in the first and last third
  for (int i = 0; i < kTicks; ++i) {
    const double time_s = i * kTick_s;
    const glm::dvec3 wanted_m{5e-3 * std::sin(2.0 * time_s), 3e-3 * std::sin(1.3 * time_s),
                              -3e-3 + 1e-3 * std::sin(0.7 * time_s)};
    const glm::dvec3 force_N = renderer->tick(probe, kTick_s).wrench.force_N;
    largest_N = std::max(largest_N, glm::length(force_N));
    const glm::dvec3 pull_N =
        kHold_N_per_m * (wanted_m - probe.position_m) - kHold_N_s_per_m * probe.velocity_m_per_s;
    probe.velocity_m_per_s += kTick_s / kMass_kg * (force_N + pull_N);
    probe.position_m += kTick_s * probe.velocity_m_per_s;
    const double z_m_per_s = probe.velocity_m_per_s.z;
    if (i >= 1'000 && i < 1'000 + kThird) squares_m2_per_s2[0] += z_m_per_s * z_m_per_s;
    if (i >= kTicks - kThird) squares_m2_per_s2[1] += z_m_per_s * z_m_per_s;
  }
  // 300 N/m hold a hand that wants 4 mm into the plate: 1.2 N, and the drag of 0.3 of that.
  EXPECT_LT(largest_N, 3.0);
  EXPECT_LT(squares_m2_per_s2[1], 2.0 * squares_m2_per_s2[0]);
  EXPECT_LT(squares_m2_per_s2[1] / kThird, 0.01 * 0.01);
  EXPECT_GT(ticks_of(*renderer, "contact"), 0.95 * kTicks);
}

TEST(PdGradient, CountsWhereTheDetailIsFinerThanTheGrid) {
  for (const double wavelength_m : {0.6e-3, 1.2e-3}) {
    RendererInputs inputs = ball_on_plate(direct());
    inputs.surface = shared(grated_plate({.amplitude_m = 2e-5, .wavelength_m = wavelength_m}));
    const auto renderer = renderer_of(inputs);
    stroked(*renderer, -0.2e-3, 0.01, 10);
    // Cells of 0.1 mm stand for waves of 0.8 mm and more.
    EXPECT_EQ(ticks_of(*renderer, "fine_detail"), wavelength_m < 0.8e-3 ? 10U : 0U);
    EXPECT_EQ(ticks_of(*renderer, "contact"), 10U);
    EXPECT_EQ(ticks_of(*renderer, "coarse_window"), 0U);
  }
}

TEST(PdGradient, CountsWhereTheHandMovesMoreThanHalfAWaveInATick) {
  const auto renderer = renderer_of(ball_on_plate(direct()));
  stroked(*renderer, -0.2e-3, 0.5, 8);
  EXPECT_EQ(ticks_of(*renderer, "fast"), 0U);
  stroked(*renderer, -0.2e-3, 0.7, 8);
  EXPECT_EQ(ticks_of(*renderer, "fast"), 8U);
  EXPECT_EQ(ticks_of(*renderer, "contact"), 16U);  // `reset` clears nothing
}

TEST(PdGradient, CountsWindowsThatAreTooWideForTheStep) {
  RendererInputs inputs = ball_on_plate(direct({{"most_samples", 64.0}}));
  inputs.tool = shared(shifted(bare(box({0.012, 0.012, 0.004})), {0.0, 0.0, 0.002}));
  const auto renderer = renderer_of(inputs);
  answer(*renderer, probe_at({0.0, 0.0, -0.1e-3}));
  EXPECT_EQ(ticks_of(*renderer, "coarse_window"), 1U);
}

// A pen that leans and is pressed deeper than its own radius.
TEST(PdGradient, CountsWhereTheDeepestPlaceLiesAtTheWindowsBorder) {
  TriangleMesh pen = ball(0.6e-3, 12, 16);
  for (glm::dvec3& vertex_m : pen.vertices_m) {
    if (vertex_m.z > 0.0) vertex_m.z += 12e-3;
  }
  RendererInputs inputs = ball_on_plate(direct());
  inputs.tool = shared(bare(pen));
  const auto renderer = renderer_of(inputs);
  ProbeState probe = probe_at({0.0, 0.0, 0.2e-3});
  probe.orientation = glm::angleAxis(1.1, glm::dvec3{0.0, 1.0, 0.0});
  renderer->reset(probe);
  for (int i = 0; i < 100; ++i) {
    renderer->tick(probe, kTick_s);
    if (probe.position_m.z > -0.3e-3) {
      EXPECT_EQ(ticks_of(*renderer, "window_border"), 0U) << i;
    }
    probe.position_m.z -= 0.025e-3;
  }
  EXPECT_GT(ticks_of(*renderer, "window_border"), 10U);
}

TEST(PdGradient, CountsSheetsThatFoldOverEachOther) {
  // Two balls, the upper one's lower side above the lower one's: no height field along n.
  TriangleMesh two = ball(1e-3, 12, 16);
  for (const glm::dvec3& vertex_m : ball(1e-3, 12, 16).vertices_m) {
    two.vertices_m.push_back(vertex_m + glm::dvec3{0.0, 0.0, 1.2e-3});
  }
  const auto first = static_cast<std::uint32_t>(ball(1e-3, 12, 16).vertices_m.size());
  for (const auto& [a, b, c] : ball(1e-3, 12, 16).triangles) {
    two.triangles.push_back({a + first, b + first, c + first});
  }
  RendererInputs inputs = ball_on_plate(direct());
  inputs.tool = shared(shifted(bare(two), {0.0, 0.0, 1e-3}));
  const auto renderer = renderer_of(inputs);
  answer(*renderer, probe_at({0.0, 0.0, -0.3e-3}));
  EXPECT_EQ(ticks_of(*renderer, "folded"), 1U);
}

TEST(PdGradient, CountsTheTicksInWhichAThinPlateIsGoneThrough) {
  RendererInputs inputs = ball_on_plate(direct());
  inputs.surface = shared(bare(box({0.02, 0.02, 0.5e-3})));
  const auto renderer = renderer_of(inputs);
  double largest_N = 0.0;
  std::uint64_t until_then = 0;
  for (double z_m = 1e-3; z_m > -1.8 * kTipRadius_m; z_m -= 0.02e-3) {
    const RenderedTick tick = renderer->tick(probe_at({0.0, 0.0, z_m}), kTick_s);
    largest_N = std::max(largest_N, tick.wrench.force_N.z);
    if (z_m > -0.2e-3) until_then = ticks_of(*renderer, "too_deep");
  }
  EXPECT_EQ(until_then, 0U);
  EXPECT_GT(ticks_of(*renderer, "too_deep"), 10U);
  EXPECT_LT(largest_N, 1.05 * kTipRadius_m * inputs.material.stiffness_N_per_m);
}

TEST(PdGradient, CountsTheTicksInWhichAContactIsKept) {
  const auto renderer = renderer_of(ball_on_plate(direct()));
  ProbeState probe = probe_at({0.0, 0.0, 0.5e-3});
  renderer->reset(probe);
  for (int i = 0; i < 100; ++i) {
    probe.position_m.z -= 0.05e-3;
    renderer->tick(probe, kTick_s);
  }
  EXPECT_GT(ticks_of(*renderer, "kept"), 20U);
}

TEST(PdGradient, CountsTheTicksInWhichAToolLiesWhollyInsideAndIsNotFelt) {
  for (const char* coupling : {"none", "virtual"}) {
    const auto renderer = renderer_of(ball_on_plate({{"coupling", std::string(coupling)}}));
    const ProbeState inside = probe_at({0.0, 0.0, -5e-3});
    const ProbeState above = probe_at({0.0, 0.0, 1e-3});
    renderer->reset(inside);
    EXPECT_EQ(held(*renderer, inside, 20).wrench.force_N, glm::dvec3(0.0)) << coupling;
    EXPECT_EQ(ticks_of(*renderer, "wholly_inside"), 20U) << coupling;
    EXPECT_EQ(ticks_of(*renderer, "contact"), 0U) << coupling;
    held(*renderer, above, 300);
    const std::uint64_t until_then = ticks_of(*renderer, "wholly_inside");
    held(*renderer, above, 100);
    EXPECT_EQ(ticks_of(*renderer, "wholly_inside"), until_then) << coupling;
    // Deeper than its size in a tick; the simulated tool of a coupling does not jump.
    renderer->reset(above);
    held(*renderer, above, 3);
    held(*renderer, inside, 5);
    if (std::string(coupling) == "none") {
      EXPECT_EQ(ticks_of(*renderer, "wholly_inside"), until_then + 5U);
    }
    // Pressed in from above it is felt all the way.
    renderer->reset(above);
    const std::uint64_t before = ticks_of(*renderer, "wholly_inside");
    for (double z_m = 1e-3; z_m > -5e-3; z_m -= 0.05e-3) {
      renderer->tick(probe_at({0.0, 0.0, z_m}), kTick_s);
    }
    EXPECT_EQ(ticks_of(*renderer, "wholly_inside"), before) << coupling;
  }
}

TEST(PdGradient, RefusesWhatItCannotRender) {
  const auto said = [](auto change) {
    RendererInputs inputs = ball_on_plate({});
    change(inputs);
    return refusal_of<std::invalid_argument>([&] { renderer_of(inputs); });
  };
  EXPECT_THAT(said([](auto& inputs) { inputs.patch.motion_scale = 2.0; }),
              testing::HasSubstr("motion_scale"));
  EXPECT_THAT(said([](auto& inputs) { inputs.parameters["step_m"] = 0.15e-3; }),
              testing::HasSubstr("step_m"));
  EXPECT_THAT(said([](auto& inputs) { inputs.tool = nullptr; }),
              testing::HasSubstr("give it the missing tool"));
  EXPECT_THAT(said([](auto& inputs) { inputs.material.stiffness_N_per_m = 0.0; }),
              testing::HasSubstr("stiffness_N_per_m"));
  EXPECT_THAT(said([](auto& inputs) { inputs.surface = shared(TexturedMesh{}); }),
              testing::HasSubstr("atlas"));
  EXPECT_EQ(said([](auto&) {}), "");
}

TEST(PdGradient, DeclaresDefaultsThatItAccepts) {
  const ModelDeclaration declaration = pd_gradient_model().declaration;
  for (const Parameter& parameter : declaration.parameters) {
    EXPECT_EQ(complaint_about(parameter, parameter.default_value), std::nullopt) << parameter.name;
  }
  EXPECT_TRUE(declaration.needs_bodies);
  // Without texture and friction there is a plain plate.
  RendererInputs inputs = ball_on_plate(direct());
  inputs.material.friction = 0.5;
  const auto plain = renderer_of(without_texture(declaration, inputs));
  ProbeState probe = probe_at({0.4e-3, 0.0, -0.2e-3});
  probe.velocity_m_per_s.x = 0.1;
  EXPECT_NEAR(answer(*plain, probe).wrench.force_N.x, 0.0, 1e-3);
}

}  // namespace
}  // namespace asperity
