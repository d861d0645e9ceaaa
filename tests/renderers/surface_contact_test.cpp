// Placement, borders and friction of a patch.

#include "renderers/force/surface_contact.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

const ParameterValues kFriction{{"friction_speed_m_per_s", 0.010}};

SurfacePatch small_patch(PatchEdge edge) {
  return {.centre_m = {0.01, -0.02, 0.005},
          .extent_m = {0.10, 0.06},
          .edge = edge,
          .edge_width_m = 0.010};
}

TEST(SurfaceContact, MapsTheDeviceToTheTexture) {
  SurfacePatch patch = small_patch(PatchEdge::wall);
  patch.motion_scale = 0.5;
  const PatchPoint point = SurfaceContact(patch, {}, kFriction).locate({0.03, 0.0, 0.004});
  EXPECT_NEAR(point.x_m, 0.010, 1e-15);        // 0.5 · (0.03 − 0.01)
  EXPECT_NEAR(point.y_m, 0.010, 1e-15);        // 0.5 · (0.00 + 0.02)
  EXPECT_NEAR(point.height_m, -0.001, 1e-15);  // never scaled
}

TEST(SurfaceContact, FadesAsASmoothstepInsideItsBorder) {
  const SurfaceContact contact(small_patch(PatchEdge::fade), {}, kFriction);
  const auto gain_at = [&](double x_m, double y_m) {
    return contact.locate({0.01 + x_m, -0.02 + y_m, 0.0}).gain;
  };
  EXPECT_EQ(gain_at(0.0, 0.0), 1.0);
  EXPECT_EQ(gain_at(0.0399, 0.0), 1.0);
  EXPECT_NEAR(gain_at(0.045, 0.0), 0.5, 1e-12);        // half way through 40 … 50 mm
  EXPECT_NEAR(gain_at(-0.0475, 0.0), 0.15625, 1e-12);  // u = ¼: 3/16 − 2/64
  EXPECT_NEAR(gain_at(0.045, -0.025), 0.25, 1e-12);    // a corner fades both ways
  EXPECT_EQ(gain_at(0.0501, 0.0), 0.0);
  EXPECT_EQ(gain_at(0.0, 0.031), 0.0);
}

TEST(SurfaceContact, ScalesTheWholeForceByTheFade) {
  SurfaceContact contact(small_patch(PatchEdge::fade), {}, kFriction);
  ProbeState probe;
  probe.position_m = {0.055, -0.02, 0.004};
  const RenderedTick tick = contact.force(contact.locate(probe.position_m), probe,
                                          {.texture_N = {0.2, 0.0, 1.0}, .normal_N = 1.0}, 1e-3);
  EXPECT_NEAR(tick.wrench.force_N.z, 0.5, 1e-12);
  EXPECT_NEAR(tick.wrench.force_N.x, 0.1, 1e-12);
}

TEST(SurfaceContact, PushesBackInsideFromAWall) {
  SurfaceContact contact(small_patch(PatchEdge::wall), {}, kFriction);
  EXPECT_EQ(contact.wall_N(contact.locate({0.0599, -0.02, 0.0})), glm::dvec2(0.0));
  // 2 mm beyond +x: −500 · 2 mm = −1 N; 1 mm beyond −y: +0.5 N.
  const PatchPoint point = contact.locate({0.062, -0.051, 0.0});
  const glm::dvec2 wall_N = contact.wall_N(point);
  EXPECT_NEAR(wall_N.x, -1.0, 1e-12);
  EXPECT_NEAR(wall_N.y, 0.5, 1e-12);
  EXPECT_EQ(point.gain, 1.0);
}

TEST(SurfaceContact, BeginsItsWallWhereContactBegins) {
  SurfaceContact contact(small_patch(PatchEdge::wall), {}, kFriction);
  const auto force_N = [&](double x_m) {
    ProbeState probe;
    probe.position_m = {x_m, -0.02, 0.004};
    return contact.force(contact.locate(probe.position_m), probe, {.penetration_m = 1e-3}, 1e-3)
        .wrench.force_N.x;
  };
  EXPECT_EQ(force_N(0.062), 0.0);
  EXPECT_NEAR(force_N(0.063), -0.5, 1e-12);
  contact.no_contact();
  EXPECT_EQ(force_N(0.063), 0.0);
  contact.reset();
  EXPECT_EQ(force_N(0.064), 0.0);
}

TEST(SurfaceContact, HasNoFrictionAtRest) {
  SurfaceContact contact(small_patch(PatchEdge::wall), {}, kFriction);
  const RenderedTick tick =
      contact.force(contact.locate({0.01, -0.02, 0.0}), {}, {.normal_N = 3.0}, 1e-3);
  EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0));
}

TEST(SurfaceContact, RefusesAPatchThatCannotBe) {
  const auto refuses = [](auto change) {
    SurfacePatch patch = small_patch(PatchEdge::fade);
    Material material;
    change(patch, material);
    EXPECT_THROW(SurfaceContact(patch, material, kFriction), std::invalid_argument);
  };
  refuses([](SurfacePatch& patch, Material&) { patch.extent_m.y = 0.0; });
  refuses([](SurfacePatch& patch, Material&) { patch.motion_scale = 0.0; });
  refuses([](SurfacePatch& patch, Material&) { patch.edge_width_m = 0.031; });
  refuses([](SurfacePatch& patch, Material&) { patch.edge_width_m = -0.001; });
  refuses([](SurfacePatch& patch, Material&) {
    patch.centre_m.z = std::numeric_limits<double>::quiet_NaN();
  });
  refuses([](SurfacePatch&, Material& material) { material.stiffness_N_per_m = 0.0; });
  refuses([](SurfacePatch&, Material& material) { material.friction = -0.1; });
}

}  // namespace
}  // namespace asperity
