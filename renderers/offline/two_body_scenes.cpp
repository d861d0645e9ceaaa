// Holds the table of scenes, and moves the tool by sliding, turning and combing.

#include "renderers/offline/two_body_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "device/monotonic_clock.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"

namespace asperity {

namespace {

constexpr double kDepth_m = 0.15e-3;
constexpr double kSlide_m = 10e-6;  // from tick to tick: 0.1 m/s at 10 kHz
constexpr double kClear_m = 0.002;

constexpr std::array kScenes{
    SceneBodies{"simple", "ball", "block", "a ball on a block, one contact"},
    SceneBodies{"ten_contacts", "ten_balls", "wide_block", "ten balls on a block, ten contacts"},
    SceneBodies{"hammer", "hammer", "block", "a hammer on a block"},
    SceneBodies{"file", "file", "part", "a file on a CAD part"},
    SceneBodies{"part", "part", "block", "a CAD part on a block"},
    SceneBodies{"comb", "comb", "ribs",
                "a comb over ribs: contacts begin, merge, separate and fade"}};

/// Over its teeth into the ribs and out into the air.
constexpr ToolMotion kCombing{.way_m = 6e-3, .in_m = 5e-3, .out_m = 0.5e-3};

/// Half the body's height about its own origin.
double half_height_m(const TexturedMesh& mesh, const glm::dquat& orientation) {
  double half_m = 0.0;
  for (const glm::dvec3& vertex_m : mesh.vertices_m) {
    half_m = std::max(half_m, std::abs((orientation * vertex_m).z));
  }
  return half_m;
}

double top_m(const TexturedMesh& mesh) {
  double highest_m = mesh.vertices_m.front().z;
  for (const glm::dvec3& vertex_m : mesh.vertices_m) highest_m = std::max(highest_m, vertex_m.z);
  return highest_m;
}

}  // namespace

std::span<const SceneBodies> two_body_scenes() noexcept { return kScenes; }

TwoBodyScene two_body_scene(std::string name, std::shared_ptr<const TexturedMesh> tool,
                            std::shared_ptr<const TexturedMesh> surface) {
  const glm::dquat lying = glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3{0.0, 1.0, 0.0});
  const glm::dquat across = glm::angleAxis(1.2, glm::dvec3{0.0, 0.0, 1.0}) * lying;
  TwoBodyScene scene{
      .name = std::move(name), .tool = std::move(tool), .surface = std::move(surface)};
  if (scene.name == "comb") scene.motion = kCombing;
  if (scene.name == "hammer") scene.orientation = lying;
  if (scene.name == "file" || scene.name == "part") scene.orientation = across;
  scene.above_m.z = std::max(0.0, top_m(*scene.surface)) +
                    half_height_m(*scene.tool, scene.orientation) + kClear_m;
  return scene;
}

RendererInputs inputs_of(const TwoBodyScene& scene, ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.parameters.try_emplace("most_halvings", 0.0);
  inputs.material = {.stiffness_N_per_m = kSceneStiffness_N_per_m, .friction = 0.0};
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.tool = scene.tool;
  inputs.surface = scene.surface;
  return inputs;
}

std::optional<ProbeState> pressed_tool(const TwoBodyScene& scene) {
  constexpr double kDown_m = 20e-6;
  const auto renderer =
      make_renderer(pd_gradient_model(), inputs_of(scene, {{"coupling", std::string("none")}}));
  ProbeState probe{.position_m = scene.above_m, .orientation = scene.orientation};
  renderer->reset(probe);
  const double lowest_m = -scene.above_m.z - 0.05;  // past the whole tool
  while (renderer->tick(probe, kSceneTick_s).penetration_m < kDepth_m) {
    if (probe.position_m.z < lowest_m) return std::nullopt;
    probe.position_m.z -= kDown_m;
  }
  return probe;
}

ProbeState moved_tool(const TwoBodyScene& scene, const ProbeState& start, int tick) {
  constexpr double kAside_m = 1e-3;
  const ToolMotion& motion = scene.motion;
  const double phase_rad = kSlide_m * tick / motion.way_m;
  ProbeState probe = start;
  probe.position_m +=
      glm::dvec3{motion.way_m * std::sin(phase_rad), kAside_m * std::sin(0.37 * phase_rad),
                 0.02e-3 * std::sin(0.7 * phase_rad)};
  const double half_m = 0.5 * (motion.in_m + motion.out_m);
  if (half_m > 0.0) {
    probe.position_m.z += motion.out_m - half_m * (1.0 - std::cos(kSlide_m * tick / half_m));
  }
  probe.velocity_m_per_s.x = kSlide_m / kSceneTick_s * std::cos(phase_rad);
  probe.orientation = glm::angleAxis(0.03 * std::sin(0.11 * phase_rad), glm::dvec3{1, 0, 0}) *
                      glm::angleAxis(0.05 * std::sin(0.07 * phase_rad), glm::dvec3{0, 0, 1}) *
                      start.orientation;
  return probe;
}

void start_clear(ForceRenderer& renderer, const TwoBodyScene& scene, const ProbeState& start,
                 std::chrono::nanoseconds longest) {
  constexpr int kSettling = 1000;
  const ProbeState above{.position_m = scene.above_m, .orientation = scene.orientation};
  renderer.reset(above);
  renderer.tick(above, kSceneTick_s);
  const std::int64_t begun_ns = monotonic_now_ns();
  for (int i = 0; i < kSettling && monotonic_now_ns() - begun_ns < longest.count(); ++i) {
    renderer.tick(start, kSceneTick_s);
  }
}

}  // namespace asperity
