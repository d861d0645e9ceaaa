// What the finer cells of contacts on many crests cost in a tick of pd_gradient at 1 kHz.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "renderers/offline/tick_times.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "stimuli/meshes/textured_shape.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kTickOfServo_s = 1e-3;
constexpr TickCount kTicksOfScene{.warm_up = 200, .counted = 3'000};
constexpr int kRounds = 3;
constexpr double kHalfHeight_m = 2e-3;

std::shared_ptr<const TexturedMesh> made(const Shape& shape, const HeightField& field) {
  return std::make_shared<const TexturedMesh>(
      textured_shape(shape, field, {.rim_m = 0.5e-3, .samples_per_wavelength = 8.0}));
}

/// A tool that slides to and fro over a plate of 40 mm, turns and rocks.
struct SlidScene {
  std::string name{};
  std::shared_ptr<const TexturedMesh> tool{};
  std::shared_ptr<const TexturedMesh> surface{};
  double height_m = 0.0;  ///< of its middle
  double turned_rad = 0.0;
};

ProbeState probe_at(const SlidScene& scene, double speed_m_per_s, int tick) {
  constexpr double kFarthest_m = 8e-3;
  const double way = std::fmod(speed_m_per_s * kTickOfServo_s * tick / kFarthest_m, 4.0);
  const double along = way < 1.0 ? way : way < 3.0 ? 2.0 - way : way - 4.0;
  const double phase = 2.0 * std::numbers::pi * kTickOfServo_s * tick;
  const glm::dquat turn =
      glm::angleAxis(scene.turned_rad + 0.1 * std::sin(phase), glm::dvec3{0.0, 0.0, 1.0});
  const glm::dquat rock = glm::angleAxis(0.005 * std::sin(1.7 * phase), glm::dvec3{0.0, 1.0, 0.0});
  return {.position_m = {kFarthest_m * along, 0.1 * kFarthest_m * along, scene.height_m},
          .orientation = rock * turn,
          .velocity_m_per_s = {speed_m_per_s, 0.0, 0.0}};
}

struct Refined {
  double most_halvings = 0.0;
  double most_samples = 256.0;
};

nlohmann::ordered_json measured(const SlidScene& scene, double speed_m_per_s,
                                const Refined& refined) {
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.0};
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.tool = scene.tool;
  inputs.surface = scene.surface;
  inputs.parameters =
      complete_values(pd_gradient_model().declaration, {{"coupling", std::string("none")},
                                                        {"most_halvings", refined.most_halvings},
                                                        {"most_samples", refined.most_samples}});
  PdGradient renderer(inputs, instruction_sets_here().back());
  int fine_ticks = 0;
  int ticks = 0;
  const auto restart = [&] {
    renderer.reset({.position_m = {0.0, 0.0, 0.1}});
    renderer.tick({.position_m = {0.0, 0.0, 0.1}}, kTickOfServo_s);
  };
  const TickTimes times =
      shortest_of_ticks(kTicksOfScene, kRounds,
                        {.restart = restart, .tick = [&](int tick) {
                           renderer.tick(probe_at(scene, speed_m_per_s, tick), kTickOfServo_s);
                         }});
  restart();
  double samples = 0.0;
  for (; ticks < kTicksOfScene.counted; ++ticks) {
    renderer.tick(probe_at(scene, speed_m_per_s, ticks), kTickOfServo_s);
    bool is_refined = false;
    for (const TexturedContact& contact : renderer.contacts()) {
      is_refined = is_refined || contact.grid.spacing_m() < 0.9e-4;
      samples = std::max(samples, static_cast<double>(contact.grid.samples));
    }
    fine_ticks += is_refined ? 1 : 0;
  }
  return {{"name", scene.name},
          {"speed_m_per_s", speed_m_per_s},
          {"most_halvings", refined.most_halvings},
          {"most_samples", refined.most_samples},
          {"unit", "ns"},
          {"p50", times.quantile_ns(0.5).value_or(0)},
          {"p99", times.quantile_ns(0.99).value_or(0)},
          {"longest", times.quantile_ns(1.0).value_or(0)},
          {"preempted", times.preempted},
          {"refined", static_cast<double>(fine_ticks) / ticks},
          {"window_samples", samples}};
}

std::vector<SlidScene> scenes() {
  const auto waves = grating({.amplitude_m = 1e-4, .wavelength_m = 2e-3, .pitch_m = 1e-4});
  const auto plate = made(PlateShape{{0.04, 0.04, 0.008}}, *waves);
  const auto box = [](double width_m) { return BoxShape{{width_m, width_m, 2.0 * kHalfHeight_m}}; };
  const double over_crests_m = kHalfHeight_m + 1e-4 - 5e-5;
  return {{.name = "a ball of 6 mm on a grating",
           .tool = made(SphereShape{.diameter_m = 6e-3}, *level(0.0F)),
           .surface = plate,
           .height_m = 3e-3},
          {.name = "a flat box of 4 mm on a grating",
           .tool = made(box(4e-3), *level(0.0F)),
           .surface = plate,
           .height_m = over_crests_m},
          {.name = "a flat box of 8 mm on a grating",
           .tool = made(box(8e-3), *level(0.0F)),
           .surface = plate,
           .height_m = over_crests_m},
          {.name = "a box of 8 mm with a grating on the same grating",
           .tool = made(box(8e-3), *waves),
           .surface = plate,
           .height_m = over_crests_m + 5e-5,
           .turned_rad = 0.3}};
}

}  // namespace
}  // namespace asperity

int main() {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (const asperity::SlidScene& scene : asperity::scenes()) {
    for (const double speed_m_per_s : {0.01, 0.03, 0.1}) {
      for (const asperity::Refined& refined : std::initializer_list<asperity::Refined>{
               {}, {.most_halvings = 2.0}, {.most_halvings = 2.0, .most_samples = 512.0}}) {
        cases.push_back(asperity::measured(scene, speed_m_per_s, refined));
      }
    }
  }
  std::puts(nlohmann::ordered_json{
      {"machine", asperity::machine()}, {"commit", ASPERITY_COMMIT}, {"cases", cases}}
                .dump(2)
                .c_str());
}
