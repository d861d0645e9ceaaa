// How far the forces and torques of pd_gradient are from the truth, in the scenes that docs/models/pd_gradient.md names.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench/evidence/evidence.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "stimuli/meshes/textured_shape.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kPressed_N_per_m = 1000.0;
constexpr int kTruthSamples = 800;
constexpr int kPoses = 17;

/// What a scene has at one pose, once rendered and once true, in the contact's frame.
struct Sample {
  Penetration found{};
  Penetration truth{};
  double cell_m = 0.0;  ///< with which it was found
};

/// A tool over a surface, and where it is at each of the poses.
struct ErrorScene {
  std::string name{};
  std::shared_ptr<const TexturedMesh> tool{};
  std::shared_ptr<const TexturedMesh> surface{};
  std::function<Pose(double share)> pose{};  ///< of the tool, from −1 to 1
  /// The depth of a tool that is moved by these, where a formula has it; the densely sampled meshes otherwise.
  std::function<double(const glm::dvec3& tool_m)> depth_m{};
};

std::vector<std::uint32_t> all_of(const TexturedMesh& mesh) {
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = static_cast<std::uint32_t>(i);
  return triangles;
}

/// By a formula: the same differences as the model's, of the depth alone. Torques are not compared.
Penetration formula_truth(const ErrorScene& scene, const glm::dvec3& tool_m, double step_m) {
  const auto slope = [&](const glm::dvec3& way_m) {
    return (scene.depth_m(tool_m + way_m) - scene.depth_m(tool_m - way_m)) / (2.0 * step_m);
  };
  return {.depth_m = scene.depth_m(tool_m),
          .slope = {slope({step_m, 0.0, 0.0}), slope({0.0, step_m, 0.0})}};
}

/// How a contact is sampled: 40 ticks are enough for new heights, and 60 for those of finer cells after them.
struct Sampling {
  double cell_m = 1e-4;
  double most_halvings = 0.0;
  double most_samples = 512.0;
  const char* maximum = "hard";
};
constexpr int kTicks = 100;

std::vector<Sample> samples_of(const ErrorScene& scene, const Sampling& sampling) {
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = kPressed_N_per_m, .friction = 0.0};
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.tool = scene.tool;
  inputs.surface = scene.surface;
  inputs.parameters =
      complete_values(pd_gradient_model().declaration, {{"coupling", std::string("none")},
                                                        {"maximum", std::string(sampling.maximum)},
                                                        {"cell_m", sampling.cell_m},
                                                        {"step_m", 1e-4},
                                                        {"most_halvings", sampling.most_halvings},
                                                        {"most_samples", sampling.most_samples}});
  PdGradient renderer(inputs, instruction_sets_here().back());
  const std::vector<std::uint32_t> of_tool = all_of(*scene.tool);
  const std::vector<std::uint32_t> of_surface = all_of(*scene.surface);
  std::vector<Sample> samples;
  for (int i = 0; i < kPoses; ++i) {
    const Pose a = scene.pose(2.0 * i / (kPoses - 1.0) - 1.0);
    const ProbeState probe{.position_m = a.position_m, .orientation = glm::quat_cast(a.rotation)};
    renderer.reset({.position_m = {0.0, 0.0, 0.1}});
    renderer.tick({.position_m = {0.0, 0.0, 0.1}}, kTick_s);
    for (int again = 0; again < kTicks; ++again) renderer.tick(probe, kTick_s);
    const auto contacts = renderer.contacts();
    const auto deepest =
        std::max_element(contacts.begin(), contacts.end(),
                         [](const TexturedContact& one, const TexturedContact& two) {
                           return one.penetration.depth_m < two.penetration.depth_m;
                         });
    if (deepest == contacts.end()) continue;
    Sample sample{.found = deepest->penetration, .cell_m = deepest->grid.spacing_m()};
    if (scene.depth_m) {
      sample.truth = formula_truth(scene, a.position_m, 1e-4);
    } else {
      const auto truth = reference_penetration(
          {.mesh = *scene.tool, .triangles = of_tool, .pose = a},
          {.mesh = *scene.surface, .triangles = of_surface, .pose = {}}, deepest->frame,
          {.width_m = deepest->grid.width_m, .samples = kTruthSamples},
          sampling.maximum == std::string("hard") ? MaximumLaw(HardMaximum{.step_m = 1e-4})
                                                  : MaximumLaw(SmoothMaximum{.tau_m = 2e-5}));
      if (!truth) continue;
      sample.truth = *truth;
    }
    samples.push_back(sample);
  }
  return samples;
}

using Component = std::function<double(const Wrench&)>;

/// The RMS of the truth and of the error, and their ratio.
void print_compared(const std::vector<Sample>& samples, const Component& component) {
  double truth2 = 0.0;
  double error2 = 0.0;
  for (const Sample& sample : samples) {
    const double truth = component(contact_wrench(sample.truth, {}, kPressed_N_per_m));
    const double found = component(contact_wrench(sample.found, {}, kPressed_N_per_m));
    truth2 += truth * truth;
    error2 += (found - truth) * (found - truth);
  }
  const double count = static_cast<double>(samples.size());
  std::printf("\t%.3g\t%.3g\t%.4f", std::sqrt(truth2 / count), std::sqrt(error2 / count),
              std::sqrt(error2 / truth2));
}

void print_errors(const ErrorScene& scene, const Sampling& sampling) {
  const std::vector<Sample> samples = samples_of(scene, sampling);
  double depth_m = 0.0;
  double error_m = 0.0;
  double sampled_m = 0.0;
  for (const Sample& sample : samples) {
    sampled_m += sample.cell_m / static_cast<double>(samples.size());
    depth_m += sample.truth.depth_m / static_cast<double>(samples.size());
    error_m += (sample.found.depth_m - sample.truth.depth_m) / static_cast<double>(samples.size());
  }
  std::printf("%s\t%g\t%g\t%g\t%s\t%.3g\t%zu\t%.4g\t%.3g", scene.name.c_str(), sampling.cell_m,
              sampling.most_halvings, sampling.most_samples, sampling.maximum, sampled_m,
              samples.size(), depth_m, error_m);
  print_compared(samples, [](const Wrench& w) { return w.force_N.x; });
  print_compared(samples, [](const Wrench& w) { return w.force_N.z; });
  if (!scene.depth_m) {
    print_compared(samples, [](const Wrench& w) { return w.torque_N_m.x; });
    print_compared(samples, [](const Wrench& w) { return w.torque_N_m.y; });
    print_compared(samples, [](const Wrench& w) { return w.torque_N_m.z; });
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::shared_ptr<const TexturedMesh> made(const Shape& shape, const HeightField& field) {
  return std::make_shared<const TexturedMesh>(
      textured_shape(shape, field, {.rim_m = 0.5e-3, .samples_per_wavelength = 8.0}));
}

glm::dmat3 about(const glm::dvec3& axis, double angle_rad) {
  return glm::mat3_cast(glm::angleAxis(angle_rad, axis));
}

std::vector<ErrorScene> scenes() {
  constexpr double kHalfBox_m = 2e-3;
  constexpr double kDeep_m = 1e-4;
  const auto waves = grating({.amplitude_m = 1e-4, .wavelength_m = 2e-3, .pitch_m = 1e-4});
  const auto plate = made(PlateShape{{0.03, 0.03, 0.008}}, *waves);
  const BoxShape box{{0.008, 0.008, 2.0 * kHalfBox_m}};
  const glm::dvec3 over_crests_m{0.0, 0.0, kHalfBox_m + 2e-4 - kDeep_m};

  constexpr double kRadius_m = 2e-3;
  constexpr double kGroove_m = 1e-3;
  constexpr double kGrooveWave_m = 8e-3;
  const auto groove = [](double x_m) {
    return kGroove_m * std::sin(2.0 * std::numbers::pi * x_m / kGrooveWave_m);
  };
  const auto groove_depth_m = [groove](const glm::dvec3& tool_m) {
    constexpr int kPlaces = 200'000;
    double deepest_m = -1.0;
    for (int i = 0; i <= kPlaces; ++i) {
      const double aside_m = kRadius_m * (2.0 * i / kPlaces - 1.0);
      const double lower_m = tool_m.z - std::sqrt(kRadius_m * kRadius_m - aside_m * aside_m);
      deepest_m = std::max(deepest_m, groove(tool_m.x + aside_m) - lower_m);
    }
    return deepest_m;
  };

  std::vector<ErrorScene> all{
      {.name = "a flat box of 8 mm, tilted by 0.01 rad, slid over a grating by 1 mm either way",
       .tool = made(box, *level(0.0F)),
       .surface = plate,
       .pose =
           [=](double share) {
             return Pose{.rotation = about({0, 1, 0}, 0.01),
                         .position_m = {1e-3 * share, 0.0, kHalfBox_m + 1e-4 + 4e-5 - kDeep_m}};
           }},
      {.name = "a cylinder of 4 mm in a groove, 1 mm aside of its ground either way",
       .tool = made(CylinderShape{.diameter_m = 2.0 * kRadius_m, .length_m = 0.01}, *level(0.0F)),
       .surface = made(
           PlateShape{{0.03, 0.03, 0.008}},
           *grating({.amplitude_m = kGroove_m, .wavelength_m = kGrooveWave_m, .pitch_m = 1e-4})),
       .pose =
           [=](double share) {
             // Lying along y, pressed 0.2 mm in where it is.
             const double x_m = -0.25 * kGrooveWave_m + 1e-3 * share;
             const double touching_m = groove_depth_m({x_m, 0.0, 0.0});
             return Pose{.rotation = about({1, 0, 0}, 0.5 * std::numbers::pi),
                         .position_m = {x_m, 0.0, touching_m - 2e-4}};
           },
       .depth_m = groove_depth_m}};
  for (const double aside_m : {0.0, 0.5e-3, 1e-3}) {
    all.push_back(
        {.name = "a box of 8 mm with a grating on the same grating, turned about n by up to "
                 "0.4 rad, aside by " +
                 std::to_string(1e3 * aside_m) + " mm",
         .tool = made(box, *waves),
         .surface = plate,
         .pose = [=](double share) {
           return Pose{.rotation = about({0, 0, 1}, 0.4 * share),
                       .position_m = over_crests_m + glm::dvec3{aside_m, 0.0, 0.0}};
         }});
  }
  return all;
}

}  // namespace

void print_pd_errors() {
  std::printf(
      "scene\tcell_m\tmost_halvings\tmost_samples\tmaximum\tmean_sampled_cell_m\tposes\tdepth_m\t"
      "depth_error_m");
  for (const char* component :
       {"force_u_N", "force_n_N", "torque_u_N_m", "torque_v_N_m", "torque_n_N_m"}) {
    std::printf("\t%s\terror\terror/truth", component);
  }
  std::printf("\n");
  for (const ErrorScene& scene : scenes()) {
    for (const Sampling& sampling :
         std::initializer_list<Sampling>{{},
                                         {.maximum = "smooth"},
                                         {.cell_m = 2.5e-5, .maximum = "smooth"},
                                         {.cell_m = 2.5e-5},
                                         {.most_halvings = 2.0},
                                         {.most_halvings = 2.0, .most_samples = 256.0}}) {
      // The formula is that of the hard maximum.
      if (scene.depth_m && sampling.maximum != std::string("hard")) continue;
      print_errors(scene, sampling);
    }
  }
}

}  // namespace asperity
