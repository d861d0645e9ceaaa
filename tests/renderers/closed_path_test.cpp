// The work of each force model on a closed path, against what the registry declares.

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/models/sinusoid.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/surfaces.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

constexpr Grating kWaves{.amplitude_m = 1e-4, .wavelength_m = 2e-3, .pitch_m = 2.5e-5, .rows = 16};
constexpr int kLoopPoints = 2000;
/// Of the gross work. What is no potential does more than the greater share, what is one less than the smaller.
constexpr double kOfAPotential = 1e-3;
constexpr double kOfNone = 5e-3;

/// On a grating, without friction, and as a tool a ball of 1 mm.
RendererInputs on_waves(const ForceModel& model, const ParameterValues& values) {
  RendererInputs inputs;
  inputs.patch.tiling = Tiling::repeat;
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.0};
  inputs.height_field = grating(kWaves);
  inputs.assets = files_of_models();
  inputs.seed = 3;
  if (model.declaration.needs_bodies) {
    inputs.tool = shared(shifted(bare(ball(0.5e-3, 40, 40)), {0.0, 0.0, 0.5e-3}));
    inputs.surface = shared(grated_plate(kWaves));
    inputs.parameters = {{"cell_m", 2.5e-5}, {"step_m", 2.5e-5}};
  } else if (model.suggested_by) {
    inputs.parameters = model.suggested_by(*inputs.height_field, inputs.material);
  }
  for (const auto& [name, value] : values) inputs.parameters[name] = value;
  return inputs;
}

struct LoopWork {
  double net_J = 0.0;
  double gross_J = 0.0;
  double share() const { return std::abs(net_J) / gross_J; }  // of what is done either way
};

/// Of the surface on a probe around a loop between a node of the grating and a crest, in contact all the way.
LoopWork around_a_loop(const ForceModel& model, const ParameterValues& values) {
  const auto renderer = make_renderer(model, on_waves(model, values));
  const auto place_m = [](int point) {
    const double angle_rad = 2.0 * std::numbers::pi * point / kLoopPoints;
    return glm::dvec3{0.00025 + 0.0003 * std::cos(angle_rad), 0.0002 * std::sin(angle_rad + 0.4),
                      -0.0006 + 0.0003 * std::sin(angle_rad + 0.4)};
  };
  LoopWork work{};
  renderer->reset({.position_m = {0.0, 0.0, 0.01}});
  for (int point = 0; point < kLoopPoints; ++point) {
    const glm::dvec3 way_m = place_m(point + 1) - place_m(point);
    const ProbeState probe{.time_ns = (point + 1) * 1'000'000LL,
                           .position_m = 0.5 * (place_m(point) + place_m(point + 1)),
                           .velocity_m_per_s = way_m / kTick_s};
    const RenderedTick felt = renderer->tick(probe, kTick_s);
    EXPECT_GT(felt.penetration_m, 0.0) << model.declaration.id;
    const double work_J = glm::dot(felt.wrench.force_N, way_m);
    work.net_J += work_J;
    work.gross_J += std::abs(work_J);
  }
  return work;
}

/// What makes the work of a law that is no potential large enough on this loop.
ParameterValues loud(const ForceModel& model) {
  if (model.declaration.id == "stochastic") {
    return {{"noise_sd_N", 1.0}, {"velocity_threshold_m_per_s", 0.0}};
  }
  if (model.declaration.id == "data_driven") return {{"gain", 30.0}};
  if (model.declaration.id == "bump_map") return {{"height_scale", 3.0}};
  return {};
}

TEST(ForceModels, DoNoWorkAroundALoopWithTheValuesThatAreDeclaredConservative) {
  const ModelRegistry registry = built_in_models();
  int declared = 0;
  for (const ForceModel& model : registry.models()) {
    if (!model.conservative_with) continue;
    ++declared;
    EXPECT_LT(around_a_loop(model, *model.conservative_with).share(), kOfAPotential)
        << model.declaration.id;
  }
  EXPECT_GE(declared, 4);
}

TEST(ForceModels, DoWorkAroundALoopWithoutTheValuesThatAreDeclaredConservative) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    const ParameterValues defaults = complete_values(model.declaration, {});
    if (!model.conservative_with) {
      EXPECT_GT(around_a_loop(model, loud(model)).share(), kOfNone) << model.declaration.id;
      continue;
    }
    // Each of the declared values is needed: with another choice, or at another gain, the law is no potential.
    for (const auto& [name, value] : *model.conservative_with) {
      if (defaults.at(name) == value || model.declaration.needs_bodies) continue;
      ParameterValues others = *model.conservative_with;
      others[name] = defaults.at(name);
      EXPECT_GT(around_a_loop(model, others).share(), kOfNone)
          << model.declaration.id << ' ' << name;
    }
  }
}

TEST(ForceModels, DoWorkAroundALoopInTheOtherLawsOfTheSources) {
  const ModelRegistry registry = built_in_models();
  EXPECT_GT(around_a_loop(*registry.find("height_map"), {{"law", std::string("literal")}}).share(),
            kOfNone);
  EXPECT_GT(
      around_a_loop(*registry.find("lateral_gradient"), {{"law", std::string("force")}}).share(),
      kOfNone);
  EXPECT_GT(
      around_a_loop(*registry.find("sinusoid"), {{"force_direction", std::string("local_normal")}})
          .share(),
      kOfNone);
}

// Down on a crest, up in a trough: the force is k·(h − z), and the two heights differ by 2A.
TEST(ForceModels, OfAFixedDirectionGiveTwoKTimesAmplitudeTimesDepthInEachHalfWave) {
  constexpr double kSurface_N_per_m = 1000.0;
  constexpr double kRidgeAmplitude_m = 1e-4;
  constexpr double kRidge_m = 2e-3;
  constexpr double kDeeper_m = 5e-4;
  const auto renderer =
      make_renderer(sinusoid_model(),
                    {.parameters = {{"amplitude_m", kRidgeAmplitude_m}, {"wavelength_m", kRidge_m}},
                     .material = {.stiffness_N_per_m = kSurface_N_per_m, .friction = 0.0}});
  renderer->reset({});
  constexpr double kShallow_m = -1e-4;
  const auto work_J = [&](double x_m, double from_m, double to_m) {
    constexpr int kParts = 100;
    double sum_J = 0.0;
    for (int i = 0; i < kParts; ++i) {
      const double z_m = from_m + (to_m - from_m) * (i + 0.5) / kParts;
      const ProbeState probe{.position_m = {x_m, 0.0, z_m}};
      sum_J += renderer->tick(probe, kTick_s).wrench.force_N.z * (to_m - from_m) / kParts;
    }
    return sum_J;
  };
  // Along the surface there is no force, so the ways between the two do none.
  const double given_J = work_J(-0.25 * kRidge_m, kShallow_m, kShallow_m - kDeeper_m) +
                         work_J(0.25 * kRidge_m, kShallow_m - kDeeper_m, kShallow_m);
  EXPECT_NEAR(given_J, 2.0 * kSurface_N_per_m * kRidgeAmplitude_m * kDeeper_m, 1e-12);
}

}  // namespace
}  // namespace asperity
