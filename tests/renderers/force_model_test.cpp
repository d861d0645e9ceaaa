// The registry, and what holds for every model in it.

#include "renderers/force/force_model.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

RendererInputs any_inputs() {
  RendererInputs inputs;
  inputs.patch = wide_patch();
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  return inputs;
}

TEST(ModelRegistry, KnowsTheBuiltInModels) {
  const ModelRegistry registry = built_in_models();
  RendererInputs inputs = any_inputs();
  inputs.surface = std::make_shared<const TexturedMesh>(
      body_mesh(PlateShape{{0.02, 0.02, 0.01}}, inputs.height_field.get()));
  inputs.tool =
      std::make_shared<const TexturedMesh>(body_mesh(SphereShape{.diameter_m = 0.004}, nullptr));
  for (const char* id :
       {"height_map", "sinusoid", "stochastic", "lateral_gradient", "pd_gradient", "bump_map",
        "normal_map", "periodic", "solid_noise", "filtered_noise", "auto_regressive", "recorded",
        "data_driven", "elastic_halfspace", "winkler"}) {
    ASSERT_NE(registry.find(id), nullptr) << id;
    EXPECT_NE(registry.make(id, inputs), nullptr);
  }
  EXPECT_EQ(registry.models().size(), 15U);
  EXPECT_EQ(registry.find("no_such_model"), nullptr);
}

TEST(ModelRegistry, RefusesATakenOrMalformedId) {
  ModelRegistry registry = built_in_models();
  ForceModel model = *registry.find("sinusoid");
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { registry.add(model); }),
              testing::HasSubstr("sinusoid"));
  for (const char* id : {"", "Sinusoid", "2d", "a-b", "_a"}) {
    model.declaration.id = id;
    EXPECT_NE(refusal_of<std::invalid_argument>([&] { registry.add(model); }), "") << id;
  }
}

TEST(ModelRegistry, NamesTheModelsThereAreWhenAskedForAnother) {
  const std::string said = refusal_of<std::invalid_argument>(
      [] { built_in_models().make("no_such_model", any_inputs()); });
  EXPECT_THAT(said, testing::HasSubstr("no_such_model"));
  EXPECT_THAT(said, testing::HasSubstr("lateral_gradient"));
}

TEST(ModelRegistry, RefusesAMissingHeightField) {
  RendererInputs inputs = any_inputs();
  inputs.height_field = nullptr;
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { built_in_models().make("height_map", inputs); }),
      testing::HasSubstr("height field"));
  EXPECT_NE(built_in_models().make("sinusoid", inputs), nullptr);
}

TEST(ModelRegistry, RefusesAMissingToolOrSurface) {
  const ModelRegistry registry = built_in_models();
  ForceModel model = *registry.find("sinusoid");
  model.declaration.needs_bodies = true;
  RendererInputs inputs = any_inputs();
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(model, inputs); }),
              testing::HasSubstr("give it both"));
  inputs.tool = std::make_shared<const TexturedMesh>();
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(model, inputs); }),
              testing::HasSubstr("give it the missing surface"));
  std::swap(inputs.tool, inputs.surface);
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(model, inputs); }),
              testing::HasSubstr("give it the missing tool"));
  inputs.tool = inputs.surface;
  EXPECT_NE(make_renderer(model, inputs), nullptr);
}

TEST(ModelRegistry, RefusesAMissingAsset) {
  const ModelRegistry registry = built_in_models();
  ForceModel model = *registry.find("sinusoid");
  model.declaration.assets = {{"vibrations", "recorded accelerations"}};
  RendererInputs inputs = any_inputs();
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { make_renderer(model, inputs); }),
              testing::HasSubstr("the force model sinusoid needs the asset \"vibrations\" "
                                 "(recorded accelerations); give it one"));
  inputs.assets["vibrations"] = std::make_shared<const std::string>("1 2 3");
  EXPECT_NE(make_renderer(model, inputs), nullptr);
}

TEST(ModelRegistry, RefusesATakenOrMalformedRoleOfAnAsset) {
  const ModelRegistry built_in = built_in_models();
  ForceModel model = *built_in.find("sinusoid");
  ModelRegistry registry{};
  for (const char* role : {"", "Vibrations", "height_field", "surface", "tool", "vibrations"}) {
    model.declaration.assets = {{"vibrations", "recorded"}, {role, "another"}};
    EXPECT_THAT(refusal_of<std::invalid_argument>([&] { registry.add(model); }),
                testing::HasSubstr("\"" + std::string(role) + "\""));
  }
  model.declaration.assets.pop_back();
  registry.add(model);
  EXPECT_EQ(registry.models().size(), 1U);
}

TEST(ModelRegistry, RefusesAParameterThatIsUnknownOrOutOfRange) {
  RendererInputs inputs = any_inputs();
  inputs.parameters = {{"amplitude_mm", 1.0}};
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { built_in_models().make("sinusoid", inputs); }),
      testing::HasSubstr("amplitude_mm"));
  inputs.parameters = {{"amplitude_m", 1.0}};
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { built_in_models().make("sinusoid", inputs); }),
      testing::HasSubstr("amplitude_m"));
}

TEST(BuiltInModels, DeclareDefaultsThatTheyAcceptThemselves) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    for (const Parameter& parameter : model.declaration.parameters) {
      EXPECT_EQ(complaint_about(parameter, parameter.default_value), std::nullopt)
          << model.declaration.id << " " << parameter.name;
      EXPECT_FALSE(parameter.meaning.is_verbatim())
          << "windows translate " << model.declaration.id << " " << parameter.name;
    }
    EXPECT_TRUE(model.declaration.summary.can_be_translated()) << model.declaration.id;
    ASSERT_TRUE(model.declaration.amplitude_parameter.has_value());
  }
}

TEST(BuiltInModels, SuggestValuesThatTheyAccept) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    if (!model.suggested_by) continue;
    EXPECT_NO_THROW(
        complete_values(model.declaration, model.suggested_by(*grating({.rows = 32}), Material{})));
  }
}

TEST(BuiltInModels, TouchNothingBeyondAFadingBorder) {
  for (const ForceModel& model : point_models()) {
    RendererInputs inputs = any_inputs();
    inputs.patch.extent_m = {0.05, 0.05};
    const auto renderer = make_renderer(model, inputs);
    const RenderedTick tick = answer(*renderer, probe_at({0.026, 0.0, -0.002}));
    EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0)) << model.declaration.id;
    EXPECT_EQ(tick.penetration_m, 0.0) << model.declaration.id;
  }
}

TEST(BuiltInModels, MeetTheWallOnlyBelowTheSurface) {
  for (const ForceModel& model : point_models()) {
    RendererInputs inputs = any_inputs();
    inputs.patch.extent_m = {0.05, 0.05};
    inputs.patch.edge = PatchEdge::wall;
    inputs = without_texture(model.declaration, inputs);
    const auto renderer = make_renderer(model, inputs);
    // 2 mm beyond the wall, 1 mm below the plane: −500 · 2 mm = −1 N.
    const ProbeState inside = probe_at({0.024, 0.0, -0.001});
    EXPECT_NEAR(answer_after(*renderer, inside, probe_at({0.027, 0.0, -0.001})).wrench.force_N.x,
                -1.0, 1e-9)
        << model.declaration.id;
    EXPECT_EQ(answer_after(*renderer, inside, probe_at({0.027, 0.0, 0.001})).wrench.force_N,
              glm::dvec3(0.0))
        << model.declaration.id;
  }
}

/// Every value of each choice of a model's own parameters, one at a time.
std::vector<ParameterValues> choices_of(const ForceModel& model) {
  std::vector<ParameterValues> choices{{}};
  for (const Parameter& parameter : model.declaration.parameters) {
    if (parameter.name == "friction_law") continue;
    for (const std::string& choice : parameter.choices) {
      choices.push_back({{parameter.name, choice}});
    }
  }
  return choices;
}

// On flanks of the grating, μ times the component along the normal of the plane of the force without friction: also where the
// texture turns the force.
TEST(BuiltInModels, DragInProportionToTheNormalComponentOfTheirForce) {
  constexpr double kCoefficient = 0.4;
  ProbeState probe = probe_at({0.0, 0.0, -0.001});
  probe.velocity_m_per_s = {0.06, 0.08, 0.0};
  const glm::dvec2 direction = glm::dvec2(0.06, 0.08) / std::hypot(0.06, 0.08, 0.010);
  for (const ForceModel& model : point_models()) {
    for (ParameterValues values : choices_of(model)) {
      if (values.contains("law") && choice_of(values, "law") == "literal") continue;  // has none
      RendererInputs inputs = any_inputs();
      inputs.height_field = grating({.amplitude_m = 1e-3});
      if (model.declaration.id == "sinusoid") values["amplitude_m"] = 1e-3;
      if (model.declaration.id == "periodic") values["sine_amplitude_1_m"] = 1e-3;
      values["friction_law"] = std::string("rounded");
      inputs.parameters = values;
      inputs.material.friction = kCoefficient;
      const auto rough = make_renderer(model, inputs);
      inputs.material.friction = 0.0;
      const auto smooth = make_renderer(model, inputs);
      for (const double x_m : {0.0001, 0.0004, 0.0012}) {
        probe.position_m.x = x_m;
        const glm::dvec3 free_N = answer(*smooth, probe).wrench.force_N;
        const glm::dvec3 drag_N = free_N - answer(*rough, probe).wrench.force_N;
        EXPECT_NEAR(drag_N.x, kCoefficient * free_N.z * direction.x, 1e-12)
            << model.declaration.id << ' ' << condition_text(values) << ' ' << x_m;
        EXPECT_NEAR(drag_N.y, kCoefficient * free_N.z * direction.y, 1e-12)
            << model.declaration.id << ' ' << condition_text(values) << ' ' << x_m;
        EXPECT_EQ(drag_N.z, 0.0) << model.declaration.id;
      }
    }
  }
}

}  // namespace
}  // namespace asperity
