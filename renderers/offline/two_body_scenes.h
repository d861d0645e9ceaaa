// Declares scenes of two textured bodies for measurements of time: what is moved over what, and how.

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"
#include "renderers/force/force_model.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The duration of a tick of these scenes.
inline constexpr double kSceneTick_s = 1e-4;
inline constexpr double kSceneStiffness_N_per_m = 1000.0;

/// The motion of a tool about the place where it begins: to and fro by this distance, and into and out of the surface.
struct ToolMotion {
  double way_m = 1e-3;
  double in_m = 0.0;
  double out_m = 0.0;
};

/// The bodies of a scene by their names (stimuli/meshes/detailed_bodies.h).
struct SceneBodies {
  std::string_view scene{};
  std::string_view tool{};
  std::string_view surface{};
  std::string_view meaning{};  ///< for people
};

/// simple, ten_contacts, hammer, file, part and comb.
std::span<const SceneBodies> two_body_scenes() noexcept;

/// A tool and a surface, and where the tool begins.
struct TwoBodyScene {
  std::string name{};
  std::shared_ptr<const TexturedMesh> tool{};
  std::shared_ptr<const TexturedMesh> surface{};
  ToolMotion motion{};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 above_m{0.0};  ///< a place of the tool at which it does not touch the surface
};

/// The scene of this name with its bodies; with another name a tool that keeps its orientation and moves to and fro.
TwoBodyScene two_body_scene(std::string name, std::shared_ptr<const TexturedMesh> tool,
                            std::shared_ptr<const TexturedMesh> surface);

/// What a renderer of the scene is made from, without friction, and with the declared cells unless `parameters` has
/// `most_halvings`.
RendererInputs inputs_of(const TwoBodyScene& scene, ParameterValues parameters);

/// The tool lowered until it is 0.15 mm deep in the surface; nullopt if it passes it without a contact. Takes some hundred ticks of
/// `pd_gradient`.
std::optional<ProbeState> pressed_tool(const TwoBodyScene& scene);

/// The tool in a tick: to and fro by 10 µm per tick at most, drifting sideways, rocking and turning a little; in and out no faster
/// than to and fro.
ProbeState moved_tool(const TwoBodyScene& scene, const ProbeState& start, int tick);

/// Moves a tool of a new renderer from outside of the surface, where the renderer sees that it is clear, to its start, and lets a
/// coupled tool follow for 1000 ticks or for `longest`.
void start_clear(ForceRenderer& renderer, const TwoBodyScene& scene, const ProbeState& start,
                 std::chrono::nanoseconds longest = std::chrono::hours(24));

}  // namespace asperity
