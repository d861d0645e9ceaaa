// Strokes of a tool that turns about an axis normal to the surface, against closed forms.

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/offline/roughness_stroke.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr double kTurningAmplitude_m = 0.1e-3;
constexpr double kGain_N = 0.5;

/// A hand that no force of a texture moves by more than a micrometre.
constexpr HandModel kStiffHand{
    .mass_kg = 0.05, .damping_N_s_per_m = 300.0, .stiffness_N_per_m = 1e6};

const ForceModel& model_that_turns(const std::string& id) {
  static const ModelRegistry models = built_in_models();
  return *models.find(id);
}

RoughnessStroke turning_stroke(const std::string& id, const Turning& turning) {
  RoughnessStroke stroke{.model = &model_that_turns(id)};
  stroke.turning = turning;
  return stroke;
}

DragResult turned(const RoughnessStroke& stroke, double spacing_m,
                  const std::string& kind = "sinusoid") {
  SpacedTexture texture{.kind = kind};
  if (kind == "sinusoid") texture.values = {{"amplitude_m", kTurningAmplitude_m}};
  return dragged(stroke, texture_at_spacing(texture, spacing_m)).value();
}

/// The lateral force of lateral_gradient on h = A·sin(2πx/L) is F_x = −g·A·(2π/L)·cos(2πx/L), whatever the depth. Along the arc
/// x = r·sin φ with φ = Φ·sin(Ωt), T = r·cos φ·F_x.
struct TorqueMoments {
  double mean_N_m = 0.0;
  double rms_N_m = 0.0;
};
TorqueMoments exact_torque(const Turning& turning, double spacing_m) {
  constexpr int kSteps = 20000;
  const double wave_per_m = 2.0 * std::numbers::pi / spacing_m;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle_rad =
        turning.amplitude_rad * std::sin(2.0 * std::numbers::pi * (i + 0.5) / kSteps);
    const double x_m = turning.radius_m * std::sin(angle_rad);
    const double torque_N_m = -turning.radius_m * std::cos(angle_rad) * kGain_N *
                              kTurningAmplitude_m * wave_per_m * std::cos(wave_per_m * x_m);
    sum += torque_N_m;
    squares += torque_N_m * torque_N_m;
  }
  const double mean = sum / kSteps;
  return {mean, std::sqrt(squares / kSteps - mean * mean)};
}

RoughnessStroke gradient_stroke(const Turning& turning) {
  RoughnessStroke stroke = turning_stroke("lateral_gradient", turning);
  stroke.parameters = {{"gain_N", kGain_N}};
  stroke.hand = kStiffHand;
  return stroke;
}

TEST(TurningStroke, HasTheTorqueOfTheClosedFormOnASinusoid) {
  for (const Turning turning : {Turning{0.1, 0.02}, Turning{1.2, 0.005}}) {
    for (const double spacing_m : {0.001, 0.003}) {
      const DragResult result = turned(gradient_stroke(turning), spacing_m);
      ASSERT_TRUE(result.turning) << spacing_m;
      EXPECT_NEAR(result.turning->rms_torque_N_m / exact_torque(turning, spacing_m).rms_N_m, 1.0,
                  0.01)
          << turning.amplitude_rad << ' ' << spacing_m;
    }
  }
}

// For a small amplitude cos φ is 1 and x is rφ: with z = 2πrΦ/L, the mean of cos(z·sin Ωt) is J₀(z), and that of its square
// (1 + J₀(2z))/2.
TEST(TurningStroke, HasTheTorqueOfBesselFunctionsForASmallAmplitude) {
  const Turning turning{.amplitude_rad = 0.02, .radius_m = 0.1};
  for (const double spacing_m : {0.0015, 0.004}) {
    const double z = 2.0 * std::numbers::pi * turning.radius_m * turning.amplitude_rad / spacing_m;
    const double mean = std::cyl_bessel_j(0.0, z);
    const double rms_N_m = turning.radius_m * kGain_N * kTurningAmplitude_m * 2.0 *
                           std::numbers::pi / spacing_m *
                           std::sqrt(0.5 * (1.0 + std::cyl_bessel_j(0.0, 2.0 * z)) - mean * mean);
    const DragResult result = turned(gradient_stroke(turning), spacing_m);
    EXPECT_NEAR(result.turning.value().rms_torque_N_m / rms_N_m, 1.0, 0.01) << spacing_m;
  }
}

// On the same arc length the force is the same, and the torque is proportional to the radius.
TEST(TurningStroke, HasATorqueInProportionToTheRadius) {
  const DragResult near = turned(turning_stroke("pd_gradient", {0.05, 0.04}), 0.0015);
  const DragResult far = turned(turning_stroke("pd_gradient", {0.025, 0.08}), 0.0015);
  EXPECT_EQ(near.status, DragStatus::ok);
  EXPECT_NEAR(far.turning.value().rms_torque_N_m / near.turning.value().rms_torque_N_m, 2.0, 0.02);
  EXPECT_NEAR(far.turning->rms_force_N / near.turning->rms_force_N, 1.0, 0.01);
  EXPECT_NEAR(far.roughness.value().rms_accel_m_per_s2 / near.roughness.value().rms_accel_m_per_s2,
              1.0, 0.01);
}

// The force along the tangent is F_s = T/r; a stiff hand's tool is not moved by it.
TEST(TurningStroke, AcceleratesNothingOnAPlainPlate) {
  RoughnessStroke stroke = turning_stroke("pd_gradient", {});
  stroke.parameters = {{"texture_gain", 0.0}};
  const DragResult result = turned(stroke, 0.002);
  EXPECT_EQ(result.status, DragStatus::ok);
  EXPECT_EQ(result.roughness.value().max_accel_m_per_s2, 0.0);
  EXPECT_NEAR(result.turning.value().rms_torque_N_m, 0.0, 1e-12);
}

// Of a ball the torque about its own tip has no part along the axis, and the mesh is turned with the tip.
TEST(TurningStroke, OfAMeshHasTheForceOfItsTipAlongTheArc) {
  RoughnessStroke stroke = turning_stroke("pd_gradient", {0.2, 0.02});
  const TextureAtSpacing texture = texture_at_spacing(
      {.kind = "sinusoid", .values = {{"amplitude_m", kTurningAmplitude_m}}}, 0.003);
  const auto tip = stroked_renderer(stroke, texture);
  stroke.tool = std::make_shared<const TexturedMesh>(
      placed(body_mesh(SphereShape{.diameter_m = 0.002}, nullptr), BodyRole::tool));
  const auto mesh = stroked_renderer(stroke, texture);
  const TurningGuide guide(stroke.turning->radius_m);
  double difference_N2 = 0.0;
  double sum_N2 = 0.0;
  for (int i = -40; i <= 40; ++i) {
    const GuidePlace place = guide.at(1e-4 * i);
    ProbeState probe{.time_ns = 1'000'000LL * (i + 41),
                     .position_m = place.origin_m - 2e-4 * place.normal,
                     .orientation = place.orientation};
    if (i == -40) {
      tip->reset(probe);
      mesh->reset(probe);
    }
    const Wrench one = tip->tick(probe, 1e-3).wrench;
    const Wrench other = mesh->tick(probe, 1e-3).wrench;
    const double along_N = glm::dot(one.force_N, place.along);
    const double along_of_mesh_N =
        glm::dot(other.force_N, place.along) + guide.turn_rad_per_m() * other.torque_N_m.z;
    difference_N2 += (along_N - along_of_mesh_N) * (along_N - along_of_mesh_N);
    sum_N2 += along_N * along_N;
  }
  ASSERT_GT(sum_N2, 1e-3);
  EXPECT_LT(std::sqrt(difference_N2 / sum_N2), 0.04);
}

TEST(TurningStroke, RefusesWhatCannotTurn) {
  EXPECT_THROW(turned(turning_stroke("pd_gradient", {0.0, 0.02}), 0.002), std::invalid_argument);
  EXPECT_THROW(turned(turning_stroke("pd_gradient", {4.0, 0.02}), 0.002), std::invalid_argument);
  EXPECT_THROW(turned(turning_stroke("pd_gradient", {0.2, 0.0}), 0.002), std::invalid_argument);
  EXPECT_THROW(turned(turning_stroke("pd_gradient", {0.2, 0.02}), 0.002, "cones"),
               std::invalid_argument);
}

TEST(BodyStroke, OnABoxAndALargeSphereIsThatOfThePlane) {
  RoughnessStroke stroke{.model = &model_that_turns("height_map"),
                         .mode = DragMode::constant_force};
  const DragResult plane = turned(stroke, 0.002);
  stroke.body =
      std::make_shared<const BodySurface>(body_mesh(BoxShape{{0.12, 0.02, 0.01}}, nullptr));
  const DragResult box = turned(stroke, 0.002);
  EXPECT_EQ(box.status, DragStatus::ok);
  EXPECT_NEAR(box.roughness.value().rms_accel_m_per_s2 / plane.roughness.value().rms_accel_m_per_s2,
              1.0, 0.01);
  EXPECT_FALSE(box.turning);
  stroke.body =
      std::make_shared<const BodySurface>(body_mesh(SphereShape{.diameter_m = 0.1}, nullptr));
  const DragResult sphere = turned(stroke, 0.002);
  std::printf("sphere relative to plane: %.4f\n",
              sphere.roughness.value().rms_accel_m_per_s2 / plane.roughness->rms_accel_m_per_s2);
  EXPECT_NEAR(sphere.roughness->rms_accel_m_per_s2 / plane.roughness->rms_accel_m_per_s2, 1.0,
              0.05);
  EXPECT_NE(sphere.roughness->rms_accel_m_per_s2, plane.roughness->rms_accel_m_per_s2);

  stroke.turning = Turning{};
  EXPECT_THROW(turned(stroke, 0.002), std::invalid_argument);
  RoughnessStroke bodies{.model = &model_that_turns("pd_gradient")};
  bodies.body = stroke.body;
  EXPECT_THROW(turned(bodies, 0.002), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
