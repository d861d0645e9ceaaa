// The largest clean stiffness of simulated devices.

#include "renderers/offline/clean_stiffness.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <stop_token>
#include <string>

#include <gtest/gtest.h>

#include "device/simulated_models.h"
#include "renderers/built_in_models.h"
#include "renderers/offline/roughness_stroke.h"

namespace asperity {
namespace {

const ForceModel& model_on_device(const std::string& id) {
  static const ModelRegistry models = built_in_models();
  return *models.find(id);
}

RendererInputs grating_inputs(const std::string& id, double amplitude_m = 1e-4,
                              double wavelength_m = 0.004) {
  const TextureAtSpacing texture = texture_at_spacing(
      {.kind = "sinusoid", .values = {{"amplitude_m", amplitude_m}}}, wavelength_m);
  const RoughnessStroke stroke{.model = &model_on_device(id), .material = {.friction = 0.0}};
  return stroked_inputs(stroke, texture);
}

LoopStrokes loop_on(const std::string& device, double rate_Hz) {
  return {.device = simulated_settings(device).value(), .rate_Hz = rate_Hz, .strokes = 1};
}

CleanStiffness found_on(const std::string& device, double rate_Hz,
                        const std::string& id = "sinusoid") {
  return clean_stiffness(model_on_device(id), grating_inputs(id), loop_on(device, rate_Hz), {})
      .value();
}

Buzz buzz_at(double stiffness_N_per_m, double rate_Hz) {
  const ForceModel& model = model_on_device("sinusoid");
  RendererInputs inputs = grating_inputs("sinusoid");
  inputs.material.stiffness_N_per_m = stiffness_N_per_m;
  const auto records = loop_stroke(model, inputs, loop_on("simulated", rate_Hz), 0);
  return perceived_instability(model, inputs,
                               recorded_texture(model, inputs, {records, 1, rate_Hz}))
      .buzz.value();
}

TEST(CleanStiffness, LiesBetweenACleanStrokeAndOneThatIsNot) {
  const CleanStiffness found = found_on("simulated", 1000.0);
  ASSERT_EQ(found.status, CleanStatus::ok);
  EXPECT_LE(*found.unclean_N_per_m, 1.02 * *found.clean_N_per_m);
  EXPECT_GT(*found.unclean_N_per_m, *found.clean_N_per_m);
  const Buzz clean = buzz_at(*found.clean_N_per_m, 1000.0);
  EXPECT_LE(clean.ratio, 0.4);
  EXPECT_LE(clean.force_N, 0.020);
  EXPECT_DOUBLE_EQ(found.buzz_of_clean->ratio, clean.ratio);
  EXPECT_DOUBLE_EQ(found.buzz_of_clean->force_N, clean.force_N);
  if (found.buzz_of_unclean) {
    const Buzz unclean = buzz_at(*found.unclean_N_per_m, 1000.0);
    EXPECT_TRUE(unclean.ratio > 0.4 || unclean.force_N > 0.020);
    EXPECT_DOUBLE_EQ(found.buzz_of_unclean->ratio, unclean.ratio);
    EXPECT_DOUBLE_EQ(found.buzz_of_unclean->force_N, unclean.force_N);
  }
}

// A surface of stiffness K on a device with damping b is passive for K < 2b/T [Colgate 1997]: 2·10·f with the damping of the
// simulated hand across the surface. Above it the loop oscillates.
TEST(CleanStiffness, IsInProportionToTheRateAsTheLimitOfPassivity) {
  for (const double rate_Hz : {500.0, 1000.0, 2000.0}) {
    const CleanStiffness found = found_on("simulated", rate_Hz);
    ASSERT_EQ(found.status, CleanStatus::ok) << rate_Hz;
    const double passive_N_per_m = 2.0 * HandMechanics{}.normal_damping_N_s_per_m * rate_Hz;
    std::printf("%g Hz: %g N/m, limit of passivity %g N/m\n", rate_Hz, *found.clean_N_per_m,
                passive_N_per_m);
    EXPECT_GT(*found.clean_N_per_m, 0.5 * passive_N_per_m) << rate_Hz;
    EXPECT_LT(*found.clean_N_per_m, 2.0 * passive_N_per_m) << rate_Hz;
  }
}

// [Choi 2004b]: 0.325 to 0.904 kN/m, from 250 Hz to 40 kHz. The tolerance of the search is 2 %.
TEST(CleanStiffness, OfAnArmInALightHandLiesWhereParticipantsFoundIt) {
  for (const double amplitude_m : {1e-4, 5e-4}) {
    for (const double rate_Hz : {500.0, 1000.0, 2000.0}) {
      LoopStrokes loop = loop_on(kArmInLightHand, rate_Hz);
      loop.strokes = 3;
      const CleanStiffness found =
          clean_stiffness(model_on_device("sinusoid"), grating_inputs("sinusoid", amplitude_m),
                          loop, {})
              .value();
      ASSERT_EQ(found.status, CleanStatus::ok) << amplitude_m << ' ' << rate_Hz;
      std::printf("%g m, %g Hz: %g N/m, %g and %g N; not %g N/m\n", amplitude_m, rate_Hz,
                  *found.clean_N_per_m, found.buzz_of_clean->ratio, found.buzz_of_clean->force_N,
                  *found.unclean_N_per_m);
      EXPECT_GE(*found.clean_N_per_m, 325.0) << amplitude_m << ' ' << rate_Hz;
      EXPECT_LE(*found.clean_N_per_m, 1.02 * 904.0) << amplitude_m << ' ' << rate_Hz;
      EXPECT_LE(found.buzz_of_clean->force_N, 0.012) << "below the absolute limit";
    }
  }
}

// The rounding error of a position step of 38 µm is uniform: 20 mN RMS at √12·20 mN/38 µm = 1.82 kN/m. With the ratio alone
// 7.8 kN/m would be clean, where one step is 0.3 N.
TEST(CleanStiffness, EndsWhereThePositionStepIsFeltWhateverTheTexture) {
  const double felt_N_per_m = std::sqrt(12.0) * 0.020 / 38e-6;
  const CleanStiffness found = found_on("simulated:falcon", 1000.0);
  EXPECT_NEAR(*found.clean_N_per_m, felt_N_per_m, 0.1 * felt_N_per_m);
  const CleanStiffness relative =
      clean_stiffness(model_on_device("sinusoid"), grating_inputs("sinusoid"),
                      loop_on("simulated:falcon", 1000.0), {.buzz_force_limit_N = 100.0})
          .value();
  EXPECT_GT(*relative.clean_N_per_m, 5000.0);
  EXPECT_GT(relative.buzz_of_clean->force_N, 0.050);
}

TEST(CleanStiffness, IsLowerOnADeviceWithALatency) {
  const CleanStiffness ideal = found_on("simulated", 1000.0);
  const CleanStiffness late = found_on("simulated:ideal,latency_s=0.002", 1000.0);
  ASSERT_EQ(late.status, CleanStatus::ok);
  EXPECT_LT(*late.clean_N_per_m, 0.7 * *ideal.clean_N_per_m);
}

TEST(CleanStiffness, ReportsWhereTheRangeDoesNotContainIt) {
  const ForceModel& model = model_on_device("sinusoid");
  const RendererInputs inputs = grating_inputs("sinusoid");
  const LoopStrokes loop = loop_on("simulated", 1000.0);
  const auto soft =
      clean_stiffness(model, inputs, loop, {.least_N_per_m = 200, .most_N_per_m = 500});
  ASSERT_TRUE(soft);
  EXPECT_EQ(soft->status, CleanStatus::clean_everywhere);
  EXPECT_EQ(soft->clean_N_per_m, 500.0);
  EXPECT_FALSE(soft->unclean_N_per_m);
  const auto stiff =
      clean_stiffness(model, inputs, loop, {.least_N_per_m = 2e5, .most_N_per_m = 4e5});
  ASSERT_TRUE(stiff);
  EXPECT_TRUE(stiff->status == CleanStatus::clean_nowhere ||
              stiff->status == CleanStatus::not_judged);
  EXPECT_FALSE(stiff->clean_N_per_m);
  EXPECT_EQ(stiff->unclean_N_per_m, 2e5);
}

TEST(CleanStiffness, StopsAndRefuses) {
  const ForceModel& model = model_on_device("sinusoid");
  const RendererInputs inputs = grating_inputs("sinusoid");
  std::stop_source stop{};
  stop.request_stop();
  EXPECT_FALSE(clean_stiffness(model, inputs, loop_on("simulated", 1000.0), {}, stop.get_token()));
  const auto refused = [&](const LoopStrokes& loop, const CleanStiffnessSearch& search) {
    EXPECT_THROW(clean_stiffness(model, inputs, loop, search), std::invalid_argument);
  };
  refused(loop_on("simulated", 300.0), {});
  refused(loop_on("simulated", 1000.0), {.least_N_per_m = 500.0, .most_N_per_m = 500.0});
  refused(loop_on("simulated", 1000.0), {.tolerance = 0.0});
  refused(loop_on("simulated", 1000.0), {.buzz_limit = 0.0});
  refused(loop_on("simulated", 1000.0), {.buzz_force_limit_N = 0.0});
  LoopStrokes none = loop_on("simulated", 1000.0);
  none.strokes = 0;
  refused(none, {});
}

}  // namespace
}  // namespace asperity
