// The texture force against values worked out by hand, and the amplitudes solved from it.

#include "renderers/offline/force_matching.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

ForceModel model(std::string_view id) {
  const ModelRegistry registry = built_in_models();
  return *registry.find(id);
}

RendererInputs matched_stimulus() {
  RendererInputs inputs;
  inputs.patch = wide_patch();
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.seed = 11;
  return inputs;
}

/// With a friction that follows the normal force at once.
RendererInputs stimulus_with_rounded_friction(ParameterValues parameters) {
  RendererInputs inputs = matched_stimulus();
  inputs.parameters = std::move(parameters);
  inputs.parameters["friction_law"] = std::string("rounded");
  return inputs;
}

// 60 mm/s over L = 4 mm is 15 Hz: in the 1.8 s that are kept, 27 whole periods. Full contact at a
// mean of 1 N with k = 500 N/m and A = 0.2 mm: D_z = 500 · 0.2 mm · sin, RMS 0.1/√2 = 0.0707107 N.
// Friction 0.2 · 60/√(60² + 10²) = 0.197279 of the normal force: D_x has 0.0139498 N RMS.
constexpr double kNormalRms_N = 0.0707107;
constexpr double kWithFriction_N = 0.0720736;

TEST(TextureForce, OfASinusoidIsItsStiffnessTimesItsRms) {
  RendererInputs inputs =
      stimulus_with_rounded_friction({{"amplitude_m", 0.0002}, {"wavelength_m", 0.004}});
  EXPECT_NEAR(texture_force_rms_N(model("sinusoid"), inputs), kWithFriction_N, 1e-6);
  inputs.material.friction = 0.0;
  EXPECT_NEAR(texture_force_rms_N(model("sinusoid"), inputs), kNormalRms_N, 1e-6);
}

TEST(TextureForce, OfAHeightMapIsThatOfItsHeights) {
  RendererInputs inputs = matched_stimulus();
  inputs.material.friction = 0.0;
  EXPECT_NEAR(texture_force_rms_N(model("height_map"), inputs), kNormalRms_N, 1e-5);
}

TEST(TextureForce, CountsOnlyWhatLiesInItsBand) {
  const RendererInputs inputs =
      stimulus_with_rounded_friction({{"amplitude_m", 0.0002}, {"wavelength_m", 0.004}});
  EXPECT_NEAR(texture_force_rms_N(model("sinusoid"), inputs, {.low_Hz = 16.0}), 0.0, 1e-6);
  EXPECT_NEAR(texture_force_rms_N(model("sinusoid"), inputs, {.low_Hz = 14.0, .high_Hz = 16.0}),
              kWithFriction_N, 1e-6);
}

TEST(TextureForce, OfAPlateIsNothing) {
  for (const ForceModel& each : point_models()) {
    EXPECT_NEAR(texture_force_rms_N(each, without_texture(each.declaration, matched_stimulus())),
                0.0, 1e-12)
        << each.declaration.id;
  }
}

TEST(TextureForce, DoesNotDependOnThePatchsBorder) {
  RendererInputs inputs = matched_stimulus();
  const double wide_N = texture_force_rms_N(model("height_map"), inputs);
  inputs.patch.extent_m = {0.02, 0.02};
  inputs.patch.edge_width_m = 0.01;
  EXPECT_EQ(texture_force_rms_N(model("height_map"), inputs), wide_N);
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.patch.edge_width_m = 0.5;  // a border that reaches the middle
  EXPECT_EQ(texture_force_rms_N(model("height_map"), inputs), wide_N);
}

TEST(TextureForce, RefusesAMeanForceThatNoHeightGives) {
  RendererInputs inputs = matched_stimulus();
  inputs.parameters = {{"depth_limit_m", 0.001}};  // at most 500 N/m · 1 mm = 0.5 N
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { texture_force_rms_N(model("height_map"), inputs); }),
      testing::AllOf(testing::HasSubstr("height_map"),
                     testing::HasSubstr("mean normal force of 1 N"), testing::HasSubstr("0.5 N")));
}

TEST(TextureForce, RefusesAPathThatIsAllDropped) {
  EXPECT_THROW(texture_force_rms_N(model("sinusoid"), matched_stimulus(), {.dropped_s = 2.0}),
               std::invalid_argument);
}

TEST(SolvedAmplitude, MakesEveryModelEquallyStrong) {
  constexpr double kTarget_N = 0.05;
  for (const ForceModel& each : point_models()) {
    RendererInputs inputs = matched_stimulus();
    const SolvedAmplitude solved = solve_amplitude(each, inputs, kTarget_N);
    EXPECT_EQ(solved.parameter, *each.declaration.amplitude_parameter);
    inputs.parameters[solved.parameter] = solved.value;
    const double reached_N = texture_force_rms_N(each, inputs);
    EXPECT_NEAR(reached_N / kTarget_N, 1.0, 1e-6) << each.declaration.id;
    EXPECT_EQ(reached_N, solved.texture_force_rms_N);
  }
}

TEST(SolvedAmplitude, MakesTheOtherLawsEquallyStrong) {
  constexpr double kTarget_N = 0.05;
  const std::vector<std::pair<std::string, ParameterValues>> laws{
      {"sinusoid", {{"force_direction", std::string("gradient")}}},
      {"lateral_gradient", {{"law", std::string("force")}}},
      {"stochastic", {{"index", std::string("distance")}}},
      {"bump_map", {{"face", std::string("crest")}}},
      {"normal_map", {{"law", std::string("physical")}}},
      {"normal_map", {{"bits", 4.0}}},
      {"periodic", {{"force_direction", std::string("gradient")}, {"cosine_amplitude_2_m", 2e-5}}}};
  for (const auto& [id, parameters] : laws) {
    RendererInputs inputs = matched_stimulus();
    inputs.parameters = parameters;
    const SolvedAmplitude solved = solve_amplitude(model(id), inputs, kTarget_N);
    inputs.parameters[solved.parameter] = solved.value;
    EXPECT_NEAR(texture_force_rms_N(model(id), inputs) / kTarget_N, 1.0, 1e-6)
        << id << ' ' << solved.value;
  }
}

TEST(SolvedAmplitude, RefusesMoreThanAModelReaches) {
  for (const char* const id : {"bump_map", "normal_map"}) {
    EXPECT_THAT(refusal_of<std::invalid_argument>(
                    [&] { solve_amplitude(model(id), matched_stimulus(), 1000.0); }),
                testing::AllOf(testing::HasSubstr(id),
                               testing::HasSubstr("height_scale ranges from 0 to 100")));
  }
}

TEST(SolvedAmplitude, IsTheOneWorkedOutByHand) {
  // Twice the RMS of 0.2 mm needs 0.4 mm.
  const RendererInputs inputs = stimulus_with_rounded_friction({{"wavelength_m", 0.004}});
  EXPECT_NEAR(solve_amplitude(model("sinusoid"), inputs, 2.0 * kWithFriction_N).value, 0.0004,
              1e-8);
}

TEST(SolvedAmplitude, SolvesTheLiteralLawToo) {
  RendererInputs inputs = matched_stimulus();
  inputs.parameters = {{"law", std::string("literal")}};
  // No friction: s · 0.0707107 N = 0.05 N.
  EXPECT_NEAR(solve_amplitude(model("height_map"), inputs, 0.05).value, 0.05 / kNormalRms_N, 1e-4);
}

TEST(SolvedAmplitude, SaysWhatCanBeReachedWhenTheTargetCannot) {
  const std::string said = refusal_of<std::invalid_argument>([] {
    solve_amplitude(model("lateral_gradient"), stimulus_with_rounded_friction({}), 1000.0);
  });
  EXPECT_THAT(said, testing::HasSubstr("lateral_gradient"));
  EXPECT_THAT(said, testing::HasSubstr("gain_N ranges from 0 to 50 N"));
  EXPECT_THAT(said, testing::HasSubstr("1000 N"));
  // 50 N · 2πA/L/√2 = 50 · 0.314159 · 0.707107 = 11.1072 N; interpolation costs a little.
  EXPECT_THAT(said, testing::HasSubstr("0 and 11.1"));
}

TEST(SolvedAmplitude, RefusesATargetOfNothing) {
  EXPECT_THROW(solve_amplitude(model("sinusoid"), matched_stimulus(), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
