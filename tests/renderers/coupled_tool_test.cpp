// The simulated tool between hand and surfaces.

#include "renderers/pd_gradient/contact/coupled_tool.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

glm::dquat rotation_by(double angle_rad, const glm::dvec3& axis) {
  return {std::cos(0.5 * angle_rad), std::sin(0.5 * angle_rad) * glm::normalize(axis)};
}

/// A plane at z = 0 under the point `point` of the tool [m, from its centre, turned with it].
struct PlaneUnderPoint {
  glm::dvec3 point_m{0.0};
  double stiffness_N_per_m = 1000.0;

  std::vector<PenaltyContact> contacts(const ToolPose& pose) const {
    const glm::dvec3 arm = pose.orientation * point_m;
    const double depth_m = -(pose.centre_m.z + arm.z);
    if (depth_m <= 0.0) return {};
    const glm::dvec3 down(0.0, 0.0, -1.0);
    return {{.stiffness_N_per_m = stiffness_N_per_m,
             .depth_m = depth_m,
             .depth_per_m = down,
             .depth_per_rad_m = glm::cross(arm, down)}};
  }
};

Wrench settled_wrench(CoupledTool& tool, const ProbeState& device, const PlaneUnderPoint& plane,
                      int ticks = 5000) {
  Wrench wrench{};
  for (int tick = 0; tick < ticks; ++tick) {
    wrench = tool.step(device, plane.contacts(tool.pose()), kTick_s);
  }
  return wrench;
}

TEST(CoupledTool, ComesToWhereTheDeviceIsAndThenPullsNoMore) {
  CoupledTool tool({.centre_in_tool_m = {0.0, 0.0, 0.03}});
  tool.reset(probe_at({0.0, 0.0, 0.05}));
  const ProbeState device{.position_m = {0.01, -0.02, 0.06},
                          .orientation = rotation_by(0.7, {1.0, 2.0, -1.0})};
  Wrench wrench{};
  for (int tick = 0; tick < 5000; ++tick) wrench = tool.step(device, {}, kTick_s);
  const glm::dvec3 centre_m = device.position_m + device.orientation * glm::dvec3(0.0, 0.0, 0.03);
  EXPECT_LT(glm::distance(tool.pose().centre_m, centre_m), 1e-9);
  EXPECT_NEAR(std::abs(glm::dot(tool.pose().orientation, device.orientation)), 1.0, 1e-12);
  EXPECT_LT(glm::length(wrench.force_N), 1e-6);
  EXPECT_LT(glm::length(wrench.torque_N_m), 1e-6);
}

TEST(CoupledTool, HasNoForceWhileItMovesAlongWithTheDevice) {
  CoupledTool tool({});
  ProbeState device{.velocity_m_per_s = {0.1, 0.0, 0.0}};
  tool.reset(device);
  for (int tick = 1; tick < 200; ++tick) {
    // The tool is where the device will be at the tick's end.
    device.position_m.x = 0.1 * kTick_s * tick;
    const Wrench wrench = tool.step(device, {}, kTick_s);
    ASSERT_LT(glm::length(wrench.force_N), 1e-9) << tick;
  }
}

TEST(CoupledTool, SharesAPressBetweenTheTwoSpringsInSeries) {
  const CoupledTool::Properties properties{.stiffness_N_per_m = 2000.0};
  CoupledTool tool(properties);
  tool.reset(probe_at({0.0, 0.0, 0.01}));
  const Wrench wrench =
      settled_wrench(tool, probe_at({0.0, 0.0, -0.003}), {.stiffness_N_per_m = 1000.0});
  // 3 mm over 1/(1/2000 + 1/1000) N/m.
  EXPECT_NEAR(wrench.force_N.z, 0.003 * 2000.0 * 1000.0 / 3000.0, 1e-9);
  EXPECT_NEAR(tool.pose().centre_m.z, -0.002, 1e-12);
  EXPECT_NEAR(wrench.force_N.x, 0.0, 1e-12);
}

TEST(CoupledTool, FeelsAnOffCentreContactAsATorqueAboutTheDevicesTip) {
  // Stiff in rotation, so that the contact stays where it is: 4 cm beside the tip.
  CoupledTool tool({.angular_stiffness_N_m_per_rad = 1e4, .centre_in_tool_m = {0.01, 0.0, 0.0}});
  tool.reset(probe_at({0.0, 0.0, 0.01}));
  const PlaneUnderPoint plane{.point_m = {0.03, 0.0, 0.0}};
  const Wrench wrench = settled_wrench(tool, probe_at({0.0, 0.0, -0.002}), plane, 20000);
  EXPECT_GT(wrench.force_N.z, 0.1);
  const glm::dvec3 expected = glm::cross(glm::dvec3(0.04, 0.0, 0.0), wrench.force_N);
  EXPECT_LT(glm::distance(wrench.torque_N_m, expected), 1e-4 * glm::length(expected));
}

TEST(CoupledTool, IsLetGoByAContactThatWouldPull) {
  CoupledTool tool({});
  tool.reset(probe_at({0.0, 0.0, -0.0001}));
  // The hand is gone within a tick: nothing holds the tool back.
  const ProbeState away = probe_at({0.0, 0.0, 0.5});
  CoupledTool unhindered({});
  unhindered.reset(probe_at({0.0, 0.0, -0.0001}));
  const PlaneUnderPoint sticky{.stiffness_N_per_m = 1e6};
  const Wrench wrench = tool.step(away, sticky.contacts(tool.pose()), kTick_s);
  EXPECT_EQ(wrench.force_N.z, unhindered.step(away, {}, kTick_s).force_N.z);
}

// Six contacts of which, without those before, each is just shallow enough to pull: with h·v the way in
// a tick, f = F/k and a the rest of the matrix by h·k, all n of them have h·v = (f + Σδ)/(a + n).
TEST(CoupledTool, IsLetGoByContactsThatSetEachOtherFreeOneByOne) {
  constexpr double kPlane_N_per_m = 1e4;
  constexpr std::size_t kContacts = 6;
  const CoupledTool::Properties properties{.mass_kg = 0.01};
  const double own = (properties.mass_kg / kTick_s + kTick_s * properties.stiffness_N_per_m +
                      properties.damping_N_s_per_m) /
                     (kTick_s * kPlane_N_per_m);
  std::vector<PenaltyContact> contacts;
  double way_m = 1e-3;
  double grown_m = 1e-3;
  double pull_m = way_m * (own + kContacts);
  for (std::size_t i = 0; i < kContacts; ++i) {
    const double depth_m = way_m - 0.9 * grown_m;  // less than the way, and more than that before
    contacts.push_back(
        {.stiffness_N_per_m = kPlane_N_per_m, .depth_m = depth_m, .depth_per_m = {0.0, 0.0, -1.0}});
    pull_m -= depth_m;
    grown_m = (way_m - depth_m) / (own + static_cast<double>(kContacts - i) - 1.0);
    way_m += grown_m;
  }
  const ProbeState device =
      probe_at({0.0, 0.0, pull_m * kPlane_N_per_m / properties.stiffness_N_per_m});
  CoupledTool tool(properties);
  CoupledTool unhindered(properties);
  tool.reset(probe_at({}));
  unhindered.reset(probe_at({}));
  tool.step(device, contacts, kTick_s);
  unhindered.step(device, {}, kTick_s);
  EXPECT_EQ(tool.pose().centre_m.z, unhindered.pose().centre_m.z);
  EXPECT_GT(tool.pose().centre_m.z, contacts.back().depth_m);
}

// Pulled along a plane at a steady speed v, the coupling carries b·v along the plane, and the torque of
// the point that rubs.
TEST(CoupledTool, IsHeldBackByTheFrictionOfAContact) {
  CoupledTool tool({.angular_stiffness_N_m_per_rad = 1e4});
  ProbeState device = probe_at({0.0, 0.0, -0.001});
  device.velocity_m_per_s.x = 0.05;
  tool.reset(device);
  const glm::dvec3 arm_m{0.01, 0.02, 0.0};
  Wrench wrench{};
  for (int tick = 0; tick < 3000; ++tick) {
    std::vector<PenaltyContact> contacts = PlaneUnderPoint{}.contacts(tool.pose());
    ASSERT_FALSE(contacts.empty());
    contacts[0].friction_N_s_per_m = 4.0;
    contacts[0].arm_m = arm_m;
    wrench = tool.step(device, contacts, kTick_s);
    device.position_m.x += device.velocity_m_per_s.x * kTick_s;
  }
  EXPECT_NEAR(wrench.force_N.x, -4.0 * 0.05, 1e-3);
  EXPECT_NEAR(wrench.torque_N_m.z, -arm_m.y * wrench.force_N.x, 1e-4);
  EXPECT_NEAR(tool.velocity_m_per_s(arm_m).x, 0.05, 1e-6);
}

TEST(CoupledTool, FeelsNoFrictionAcrossTheContactsNormal) {
  CoupledTool rubbed({});
  CoupledTool free({});
  const ProbeState device = probe_at({0.0, 0.0, -0.002});
  rubbed.reset(probe_at({}));
  free.reset(probe_at({}));
  for (int tick = 0; tick < 20; ++tick) {
    std::vector<PenaltyContact> contacts = PlaneUnderPoint{}.contacts(rubbed.pose());
    for (PenaltyContact& contact : contacts) contact.friction_N_s_per_m = 50.0;
    rubbed.step(device, contacts, kTick_s);
    free.step(device, PlaneUnderPoint{}.contacts(free.pose()), kTick_s);
  }
  EXPECT_NEAR(rubbed.pose().centre_m.z, free.pose().centre_m.z, 1e-12);
}

TEST(CoupledTool, IsNeverStifferToTheHandThanItsCoupling) {
  CoupledTool tool({.stiffness_N_per_m = 800.0});
  tool.reset(probe_at({0.0, 0.0, 0.0}));
  const PlaneUnderPoint rock{.stiffness_N_per_m = 1e9};
  const Wrench wrench = settled_wrench(tool, probe_at({0.0, 0.0, -0.004}), rock);
  EXPECT_NEAR(wrench.force_N.z, 800.0 * 0.004, 1e-4);
}

TEST(CoupledTool, StaysBoundedAtOneKilohertzOnContactsFarStifferThanAnExplicitStepBears) {
  CoupledTool tool({.mass_kg = 0.01, .inertia_kg_m2 = 1e-6});
  Random random(3);
  ProbeState device = probe_at({0.0, 0.0, 0.001});
  tool.reset(device);
  const PlaneUnderPoint plane{.point_m = {0.02, 0.01, 0.0}, .stiffness_N_per_m = 1e6};
  double largest_m = 0.0;
  for (int tick = 0; tick < 60000; ++tick) {
    const double time_s = tick * kTick_s;
    device.position_m = {0.01 * std::sin(3.0 * time_s), 0.01 * std::cos(2.0 * time_s),
                         -0.002 + 0.003 * std::sin(7.0 * time_s) + 1e-5 * random.uniform()};
    device.orientation = rotation_by(0.2 * std::sin(5.0 * time_s), {1.0, 0.3, 0.1});
    tool.step(device, plane.contacts(tool.pose()), kTick_s);
    largest_m = std::max(largest_m, glm::distance(tool.pose().centre_m, device.position_m));
  }
  EXPECT_LT(largest_m, 0.02);
}

TEST(CoupledTool, RefusesPropertiesThatNoBodyHas) {
  const auto refusal = [](const CoupledTool::Properties& properties) {
    return refusal_of<std::invalid_argument>([&] { CoupledTool tool(properties); });
  };
  EXPECT_THAT(refusal({.mass_kg = 0.0}), testing::HasSubstr("mass_kg"));
  EXPECT_THAT(refusal({.inertia_kg_m2 = std::nan("")}), testing::HasSubstr("inertia_kg_m2"));
  EXPECT_THAT(refusal({.damping_N_s_per_m = -1.0}), testing::HasSubstr("damping_N_s_per_m"));
  EXPECT_EQ(refusal({}), "");
}

}  // namespace
}  // namespace asperity
