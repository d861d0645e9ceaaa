// What the registry declares of each model, against the model's forces.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/offline/along_path.h"
#include "renderers/offline/texture_waves.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/surfaces.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

RendererInputs declared_inputs(const ForceModel& model, const ParameterValues& values) {
  RendererInputs inputs;
  inputs.patch = wide_patch();
  inputs.material.friction = 0.0;
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.parameters = values;
  inputs.seed = 11;
  if (model.declaration.needs_bodies) {
    static const auto kTip = shared(shifted(bare(ball(1.5e-3, 14, 20)), {0.0, 0.0, 1.5e-3}));
    static const auto kRelief =
        shared(grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3}));
    inputs.tool = kTip;
    inputs.surface = kRelief;
  }
  return inputs;
}

/// The largest change of the force between two ticks of a probe that holds still, from 0.2 s after a stroke.
double change_at_rest_N(const ForceModel& model, const ParameterValues& values) {
  const auto renderer = make_renderer(model, declared_inputs(model, values));
  std::vector<ProbeState> path = samples_of({.height_m = -0.0005, .duration_s = 0.2});
  for (int tick = 0; tick < 600; ++tick) {
    ProbeState still = path.back();
    still.time_ns += 1'000'000;
    still.velocity_m_per_s = glm::dvec3(0.0);
    path.push_back(still);
  }
  const std::vector<RenderedTick> felt = along_path(*renderer, path, 1000.0);
  double change_N = 0.0;
  for (std::size_t i = 401; i < felt.size(); ++i) {
    change_N = std::max(change_N, glm::length(felt[i].wrench.force_N - felt[i - 1].wrench.force_N));
  }
  return change_N;
}

TEST(ModelDeclarations, HaveAPageAndARowOfMeasurementsEach) {
  const std::filesystem::path pages = std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/models";
  std::ifstream file(pages / "README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    const std::string& id = model.declaration.id;
    EXPECT_TRUE(std::filesystem::exists(pages / (id + ".md"))) << id;
    EXPECT_THAT(readme, testing::HasSubstr("| [" + id + "](" + id + ".md) | "))
        << "scripts/models-page writes it";
  }
}

TEST(ModelDeclarations, StateWhetherTheForceOnAStillProbeChanges) {
  const ModelRegistry registry = built_in_models();
  int moving = 0;
  for (const ForceModel& model : registry.models()) {
    const bool always = model.moves_by_itself_with && model.moves_by_itself_with->empty();
    if (!always) {
      EXPECT_LT(change_at_rest_N(model, {}), 1e-6) << model.declaration.id;
    }
    if (!model.moves_by_itself_with) continue;
    ++moving;
    EXPECT_GT(change_at_rest_N(model, *model.moves_by_itself_with), 1e-3) << model.declaration.id;
    EXPECT_TRUE(moves_by_itself(model, *model.moves_by_itself_with)) << model.declaration.id;
  }
  EXPECT_EQ(moving, 1);
}

TEST(ModelDeclarations, AreOfAPotentialWhereTheirConditionHolds) {
  const ModelRegistry registry = built_in_models();
  const ForceModel& sinusoid = *registry.find("sinusoid");
  EXPECT_FALSE(is_potential(sinusoid, {}));
  EXPECT_FALSE(is_potential(sinusoid, {{"force_direction", std::string("local_normal")}}));
  EXPECT_TRUE(is_potential(sinusoid, {{"force_direction", std::string("gradient")}}));
  EXPECT_FALSE(is_potential(*registry.find("height_map"), {}));
  EXPECT_TRUE(is_potential(*registry.find("height_map"), {{"lateral_gradient_gain", 1.0}}));
  EXPECT_TRUE(is_potential(*registry.find("lateral_gradient"), {}));
  EXPECT_FALSE(is_potential(*registry.find("lateral_gradient"), {{"law", std::string("force")}}));
  EXPECT_FALSE(is_potential(*registry.find("stochastic"), {}));
  EXPECT_FALSE(moves_by_itself(*registry.find("stochastic"), {}));
}

TEST(ModelDeclarations, GiveTheBandAtASpeed) {
  const ModelRegistry registry = built_in_models();
  const auto band = [&](const char* id, const ParameterValues& values) {
    const ForceModel& model = *registry.find(id);
    return band_Hz(model, declared_inputs(model, values), 0.06);
  };
  EXPECT_NEAR(band("sinusoid", {{"wavelength_m", 0.0015}}), 40.0, 1e-9);
  EXPECT_NEAR(band("stochastic", {{"noise_rate_Hz", 800.0}}), 400.0, 1e-9);
  EXPECT_NEAR(band("stochastic", {{"index", std::string("distance")}, {"noise_length_m", 1e-4}}),
              300.0, 1e-9);
  // Samples of 50 µm: waves of 0.1 mm. Cells of 0.1 mm: waves of 0.2 mm.
  EXPECT_NEAR(band("height_map", {}), 600.0, 1e-9);
  EXPECT_NEAR(band("lateral_gradient", {}), 600.0, 1e-9);
  EXPECT_NEAR(band("bump_map", {}), 600.0, 1e-9);
  EXPECT_NEAR(band("normal_map", {}), 600.0, 1e-9);
  EXPECT_NEAR(band("periodic", {{"sine_amplitude_2_m", 1e-5}}), 60.0, 1e-9);  // two waves in 2 mm
  EXPECT_NEAR(band("solid_noise", {}), 480.0, 1e-9);  // eight half waves in 1 mm
  EXPECT_NEAR(band("filtered_noise", {}), 300.0, 1e-9);
  EXPECT_NEAR(band("auto_regressive", {}), 300.0, 1e-9);
  EXPECT_NEAR(band("recorded", {}), 15.0, 4.0);  // waves of 4 mm, in lines of 62.5/m
  EXPECT_NEAR(band("data_driven", {}), 500.0, 1e-9);
  EXPECT_NEAR(band("pd_gradient", {}), 300.0, 1e-9);
  const ForceModel& sinusoid = *registry.find("sinusoid");
  RendererInputs scaled = declared_inputs(sinusoid, {{"wavelength_m", 0.0015}});
  scaled.patch.motion_scale = 2.0;
  EXPECT_NEAR(band_Hz(sinusoid, scaled, 0.06), 80.0, 1e-9);
}

TEST(ModelDeclarations, GiveTheWavelengthOfATextureOfParameters) {
  const ModelRegistry registry = built_in_models();
  const auto waves = [&](const char* id, const ParameterValues& values) {
    const ForceModel& model = *registry.find(id);
    RendererInputs inputs = declared_inputs(model, values);
    inputs.parameters = complete_values(model.declaration, inputs.parameters);
    inputs.patch.motion_scale = 2.0;
    return texture_waves(model, inputs, registry).wavelength_m;
  };
  // The finest of its waves: 3 and 4 in 2 mm are 5 in 2 mm; on the device half of it.
  EXPECT_NEAR(
      waves("periodic", {{"waves_x_2", 3.0}, {"waves_y_2", -4.0}, {"cosine_amplitude_2_m", 1e-5}})
          .value_or(0.0),
      2e-4, 1e-12);
  EXPECT_EQ(waves("periodic", {{"height_scale", 0.0}}), std::nullopt);
  EXPECT_NEAR(waves("stochastic", {{"index", std::string("distance")}}).value_or(0.0), 1e-4, 1e-12);
  EXPECT_EQ(waves("stochastic", {}), std::nullopt);
}

TEST(ModelDeclarations, HaveABandForEveryModelAndItsFormulaInTermsOfItsParameters) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    ASSERT_TRUE(model.band) << model.declaration.id;
    EXPECT_GT(band_Hz(model, declared_inputs(model, {}), 0.06), 0.0) << model.declaration.id;
    bool names_one = model.declaration.needs_height_field || !model.declaration.assets.empty();
    for (const Parameter& parameter : model.declaration.parameters) {
      names_one = names_one || model.band_formula.find(parameter.name) != std::string::npos;
    }
    EXPECT_TRUE(names_one) << model.declaration.id << ": " << model.band_formula;
  }
}

/// Texture of the path passes a low-pass that belongs to the rate, and is the same in third octaves (the models' own tests).
bool is_low_passed(const ForceModel& model) {
  const std::string& id = model.declaration.id;
  return id == "filtered_noise" || id == "auto_regressive" || id == "recorded" ||
         id == "data_driven";
}

// What no noise drawn in every tick passes, and no filter whose coefficients belong to one rate.
TEST(ModelDeclarations, GiveTheSameForceAtTwiceTheBandAndFaster) {
  for (const ForceModel& model : point_models()) {
    if (is_low_passed(model)) continue;
    const RendererInputs inputs = declared_inputs(model, {});
    ASSERT_LE(2.0 * band_Hz(model, inputs, 0.04), 1000.0) << model.declaration.id;
    const auto felt = [&](double rate_Hz) {
      const auto renderer = make_renderer(model, inputs);
      return along_path(*renderer, samples_of({.speed_m_per_s = 0.04, .rate_Hz = rate_Hz}),
                        rate_Hz);
    };
    const std::vector<RenderedTick> slow = felt(1000.0);
    const std::vector<RenderedTick> fast = felt(5000.0);
    for (std::size_t i = 0; i < slow.size(); ++i) {
      EXPECT_LT(glm::length(slow[i].wrench.force_N - fast[5 * i].wrench.force_N), 1e-9)
          << model.declaration.id << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace asperity
