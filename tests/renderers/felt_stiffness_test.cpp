// How stiff stimuli are to a pressing hand, against closed forms.

#include "renderers/offline/felt_stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/force/surface_contact.h"
#include "renderers/models/height_map.h"
#include "renderers/models/lateral_gradient.h"
#include "renderers/models/periodic.h"
#include "renderers/models/sinusoid.h"
#include "renderers/models/stochastic.h"

namespace asperity {
namespace {

constexpr double kPlate_N_per_m = 500.0;

std::shared_ptr<const HeightField> surface_of(
    const std::function<double(double x_m, double y_m)>& height_m, std::size_t samples = 512,
    double pitch_m = 2.5e-5) {
  std::vector<float> heights_m(samples * samples);
  const double middle = 0.5 * static_cast<double>(samples - 1);
  for (std::size_t r = 0; r < samples; ++r) {
    for (std::size_t c = 0; c < samples; ++c) {
      heights_m[r * samples + c] =
          static_cast<float>(height_m((static_cast<double>(c) - middle) * pitch_m,
                                      (middle - static_cast<double>(r)) * pitch_m));
    }
  }
  return std::make_shared<const HeightField>(HeightField::Grid{samples, samples, pitch_m},
                                             std::move(heights_m));
}

/// 128 samples a wave: with fewer, the cubics between them are bent by more than half a per cent else.
constexpr double kGratingAmplitude_m = 1e-4;
constexpr double kGratingPerMetre = 2.0 * std::numbers::pi / 3.2e-3;
std::shared_ptr<const HeightField> fine_grating() {
  return surface_of(
      [](double x_m, double) { return kGratingAmplitude_m * std::sin(kGratingPerMetre * x_m); });
}

FeltStiffness felt_stiffness_of(const ForceModel& model, const ParameterValues& parameters,
                                std::shared_ptr<const HeightField> field = {},
                                double force_limit_N = 5.0, double motion_scale = 1.0) {
  RendererInputs inputs{.parameters = parameters, .height_field = std::move(field)};
  inputs.material = {.stiffness_N_per_m = kPlate_N_per_m, .friction = 0.4};
  inputs.patch.motion_scale = motion_scale;
  return felt_stiffness(model, inputs, {.force_limit_N = force_limit_N}).value();
}
double largest_N_per_m(const ForceModel& model, const ParameterValues& parameters,
                       std::shared_ptr<const HeightField> field = {}, double force_limit_N = 5.0) {
  return felt_stiffness_of(model, parameters, std::move(field), force_limit_N).stiffness_N_per_m;
}

/// Where the force points up whatever the slope: the symmetric part has k and −k·slope/2 in it.
double upright_N_per_m(double slope) {
  return 0.5 * kPlate_N_per_m * (1.0 + std::sqrt(1.0 + slope * slope));
}

TEST(FeltStiffness, OfAPlateWithNoiseIsThePlates) {
  for (const double threshold_m_per_s : {0.005, 0.0}) {
    EXPECT_NEAR(
        largest_N_per_m(stochastic_model(),
                        {{"noise_sd_N", 0.5}, {"velocity_threshold_m_per_s", threshold_m_per_s}}),
        kPlate_N_per_m, 1e-3)
        << threshold_m_per_s;
  }
}

TEST(FeltStiffness, OfAGratingThatPushesUpIsItsSlopesAtAnyForce) {
  const ParameterValues fixed{{"amplitude_m", 1e-4}, {"wavelength_m", 1e-3}};
  const double expected_N_per_m = upright_N_per_m(1e-4 * 2.0 * std::numbers::pi / 1e-3);
  for (const double limit_N : {1.0, 5.0}) {
    EXPECT_NEAR(largest_N_per_m(sinusoid_model(), fixed, {}, limit_N), expected_N_per_m, 0.1);
  }
}

TEST(FeltStiffness, OfAGratingThatPushesAlongItsNormalIsThatOfItsTroughs) {
  const double trough_N_per_m = 5.0 * 1e-4 * std::pow(2.0 * std::numbers::pi / 1e-3, 2);
  EXPECT_NEAR(largest_N_per_m(sinusoid_model(), {{"amplitude_m", 1e-4},
                                                 {"wavelength_m", 1e-3},
                                                 {"force_direction", std::string("local_normal")}}),
              trough_N_per_m, 0.005 * trough_N_per_m);
}

TEST(FeltStiffness, OfTheGradientOfAWaveIsThatOfItsTroughs) {
  const double trough_N_per_m = 5.0 * 1e-4 * std::pow(2.0 * std::numbers::pi / 1e-3, 2);
  const std::string gradient = "gradient";
  EXPECT_NEAR(largest_N_per_m(
                  sinusoid_model(),
                  {{"amplitude_m", 1e-4}, {"wavelength_m", 1e-3}, {"force_direction", gradient}}),
              trough_N_per_m, 0.005 * trough_N_per_m);
  EXPECT_NEAR(largest_N_per_m(periodic_model(), {{"sine_amplitude_1_m", 1e-4},
                                                 {"period_x_m", 1e-3},
                                                 {"force_direction", gradient}}),
              trough_N_per_m, 0.005 * trough_N_per_m);
}

TEST(FeltStiffness, OfForceAlongTheSurfaceIsItsGainTimesTheBendAtAnyForce) {
  const double bend_per_m = kGratingAmplitude_m * kGratingPerMetre * kGratingPerMetre;
  for (const double gain_N : {2.0, 20.0}) {
    for (const double limit_N : {1.0, 5.0}) {
      const double expected_N_per_m = std::max(gain_N * bend_per_m, kPlate_N_per_m);
      EXPECT_NEAR(
          largest_N_per_m(lateral_gradient_model(), {{"gain_N", gain_N}}, fine_grating(), limit_N),
          expected_N_per_m, 0.01 * expected_N_per_m);
    }
  }
}

TEST(FeltStiffness, OfAHeightMapIsItsSlopesUnlessItPushesSidewaysToo) {
  const double upright = upright_N_per_m(kGratingAmplitude_m * kGratingPerMetre);
  EXPECT_NEAR(largest_N_per_m(height_map_model(), {}, fine_grating()), upright, 0.005 * upright);
  EXPECT_NEAR(
      largest_N_per_m(height_map_model(), {{"law", std::string("literal")}}, fine_grating()),
      upright, 0.005 * upright);
}

// k(∇δ∇δᵀ + δ∇∇δ) of waves along x and y, at its largest: with p = ∇h and S = ∇∇h it is
// k[[ppᵀ + δS, −p], [−pᵀ, 1]].
TEST(FeltStiffness, OfTheGradientOfADepthIsTheFormulas) {
  constexpr double kAcross_per_m = 1.5 * kGratingPerMetre;
  for (const double limit_N : {0.1, 1.0, 5.0}) {
    double formula_N_per_m = 0.0;
    const double depth_m = limit_N / kPlate_N_per_m;
    constexpr int kPlaces = 160;
    for (int i = 0; i < kPlaces; ++i) {
      for (int j = 0; j < kPlaces; ++j) {
        const double u = 2.0 * std::numbers::pi * i / kPlaces;
        const double v = 2.0 * std::numbers::pi * j / kPlaces;
        const double px = kGratingAmplitude_m * kGratingPerMetre * std::cos(u) * std::cos(v);
        const double py = -kGratingAmplitude_m * kAcross_per_m * std::sin(u) * std::sin(v);
        const double sxx =
            -kGratingAmplitude_m * kGratingPerMetre * kGratingPerMetre * std::sin(u) * std::cos(v);
        const double syy =
            -kGratingAmplitude_m * kAcross_per_m * kAcross_per_m * std::sin(u) * std::cos(v);
        const double sxy =
            -kGratingAmplitude_m * kGratingPerMetre * kAcross_per_m * std::cos(u) * std::sin(v);
        // The largest eigenvalue by powers, shifted to be the largest in size too.
        const double shift = 1.0 + px * px + py * py + depth_m * (std::abs(sxx) + std::abs(syy));
        double m[3][3] = {{px * px + depth_m * sxx, px * py + depth_m * sxy, -px},
                          {px * py + depth_m * sxy, py * py + depth_m * syy, -py},
                          {-px, -py, 1.0}};
        double e[3] = {0.5, 0.6, 0.7};
        double length = 1.0;
        for (int n = 0; n < 100; ++n) {
          double f[3] = {};
          for (int r = 0; r < 3; ++r) {
            f[r] = shift * e[r];
            for (int c = 0; c < 3; ++c) f[r] += m[r][c] * e[c];
          }
          length = std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
          for (int r = 0; r < 3; ++r) e[r] = f[r] / length;
        }
        formula_N_per_m = std::max(formula_N_per_m, kPlate_N_per_m * (length - shift));
      }
    }
    const auto waves = surface_of([](double x_m, double y_m) {
      return kGratingAmplitude_m * std::sin(kGratingPerMetre * x_m) * std::cos(kAcross_per_m * y_m);
    });
    EXPECT_NEAR(
        largest_N_per_m(height_map_model(),
                        {{"lateral_gradient_gain", 1.0}, {"depth_limit_m", 0.05}}, waves, limit_N),
        formula_N_per_m, 0.01 * formula_N_per_m)
        << limit_N;
  }
}

TEST(FeltStiffness, IsTakenAtTheGreatestForceWhereTheLimitIsNeverReached) {
  const FeltStiffness felt =
      felt_stiffness_of(height_map_model(), {{"lateral_gradient_gain", 1.0}}, fine_grating());
  EXPECT_NEAR(felt.force_N, 1.5, 0.01) << "500 N/m and no deeper than 3 mm";
  const double trough_N_per_m = 1.5 * kGratingAmplitude_m * kGratingPerMetre * kGratingPerMetre;
  EXPECT_NEAR(felt.stiffness_N_per_m, trough_N_per_m, 0.01 * trough_N_per_m);
  EXPECT_EQ(felt_stiffness_of(height_map_model(), {}, fine_grating(), 1.0).force_N, 1.0);
}

TEST(FeltStiffness, IsOfTheDevicesMotion) {
  const ParameterValues sideways{{"gain_N", 20.0}};
  const double plain =
      felt_stiffness_of(lateral_gradient_model(), sideways, fine_grating()).stiffness_N_per_m;
  const double doubled =
      felt_stiffness_of(lateral_gradient_model(), sideways, fine_grating(), 5.0, 2.0)
          .stiffness_N_per_m;
  EXPECT_NEAR(doubled, 4.0 * plain, 0.01 * doubled);
}

// One sample of a million: Keys' cubics bend 5 heights by a pitch squared there.
TEST(FeltStiffness, FindsTheSharpestPlaceOfAFineTexture) {
  const auto pit = surface_of(
      [](double x_m, double y_m) {
        return std::hypot(x_m - 0.01015, y_m + 0.02025) < 4e-5 ? -1e-5 : 0.0;
      },
      1000, 1e-4);
  const double bend_per_m = 5.0 * 1e-5 / 1e-8;
  EXPECT_NEAR(largest_N_per_m(lateral_gradient_model(), {{"gain_N", 1.0}}, pit), bend_per_m,
              0.02 * bend_per_m);
}

// Where a texture meets itself again with a step down, Keys' cubic is bent by three times the step just
// before its foot.
TEST(FeltStiffness, FindsTheSeamOfATextureThatDoesNotRepeat) {
  constexpr std::size_t kSamples = 512;
  constexpr double kRampPitch_m = 2.5e-5;
  const auto ramp =
      surface_of([](double x_m, double) { return 1e-3 * x_m; }, kSamples, kRampPitch_m);
  const double step_m = 1e-3 * kRampPitch_m * kSamples;
  const double bend_per_m = 3.0 * step_m / (kRampPitch_m * kRampPitch_m);
  EXPECT_NEAR(largest_N_per_m(lateral_gradient_model(), {{"gain_N", 1.0}}, ramp), bend_per_m,
              0.05 * bend_per_m);
}

/// A plate that pushes harder on every other millimetre: its force jumps, and is no stiffer anywhere.
class Steps final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    const double depth_m = -probe.position_m.z;
    if (!(depth_m > 0.0)) return {};
    const bool is_higher = std::sin(1e3 * std::numbers::pi * probe.position_m.x) > 0.0;
    const double force_N = kPlate_N_per_m * depth_m + (is_higher ? 0.5 : 0.0);
    return {.wrench = {.force_N = {0.0, 0.0, force_N}}, .penetration_m = depth_m};
  }
};

TEST(FeltStiffness, TakesNoJumpOfTheForceForStiffness) {
  ForceModel steps{};
  steps.declaration = {.id = "steps", .version = "1", .parameters = {friction_speed_parameter()}};
  steps.make = [](const RendererInputs&) { return std::make_unique<Steps>(); };
  RendererInputs inputs{};
  inputs.material.stiffness_N_per_m = kPlate_N_per_m;
  const auto felt = felt_stiffness(steps, inputs, {.step_m = 2e-5});
  ASSERT_TRUE(felt);
  EXPECT_NEAR(felt->stiffness_N_per_m, kPlate_N_per_m, 0.01);
}

/// The same force at every depth: it jumps at contact and has no stiffness anywhere.
class Blow final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    if (!(probe.position_m.z < 0.0)) return {};
    return {.wrench = {.force_N = {0.0, 0.0, 7.0}}, .penetration_m = -probe.position_m.z};
  }
};

TEST(FeltStiffness, IsNothingWhereNoPlaceHasOne) {
  ForceModel blow{};
  blow.declaration = {.id = "blow", .version = "1", .parameters = {friction_speed_parameter()}};
  blow.make = [](const RendererInputs&) { return std::make_unique<Blow>(); };
  RendererInputs inputs{};
  inputs.material.stiffness_N_per_m = kPlate_N_per_m;
  EXPECT_FALSE(felt_stiffness(blow, inputs, {.step_m = 2e-5}));
}

/// A plate that pushes less than its material says.
class Sponge final : public ForceRenderer {
 public:
  static constexpr double kStiffness_N_per_m = 6.0;
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    const double depth_m = -probe.position_m.z;
    if (!(depth_m > 0.0)) return {};
    return {.wrench = {.force_N = {0.0, 0.0, kStiffness_N_per_m * depth_m}},
            .penetration_m = depth_m};
  }
};

// 5 N at 0.83 m, where the material would have them at 0.5 m.
TEST(FeltStiffness, OfWhatIsVerySoftIsTakenAtTheLimitHoweverDeep) {
  ForceModel sponge{};
  sponge.declaration = {.id = "sponge", .version = "1", .parameters = {friction_speed_parameter()}};
  sponge.make = [](const RendererInputs&) { return std::make_unique<Sponge>(); };
  RendererInputs inputs{};
  inputs.material.stiffness_N_per_m = 10.0;
  const auto felt = felt_stiffness(sponge, inputs, {.step_m = 2e-5});
  ASSERT_TRUE(felt);
  EXPECT_NEAR(felt->stiffness_N_per_m, Sponge::kStiffness_N_per_m, 1e-3);
  EXPECT_EQ(felt->force_N, 5.0);
}

}  // namespace
}  // namespace asperity
