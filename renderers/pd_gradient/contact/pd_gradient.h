// Declares the force model of [Otaduy 2004]: two textured bodies and the gradient of their penetration depth.

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "renderers/compute/compute_device.h"
#include "renderers/force/force_model.h"
#include "renderers/force/simulated_tool.h"
#include "renderers/force/surface_contact.h"
#include "renderers/pd_gradient/contact/coupled_tool.h"
#include "renderers/pd_gradient/contact/prepared_bodies.h"
#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "renderers/pd_gradient/loops/instruction_set.h"

namespace asperity {

/// Renders a tool in the hand against a surface, in six degrees of freedom, from low-resolution meshes with haptic
/// textures [Otaduy 2004].
///
///   F = Σ −k·δᵢ·∇δᵢ      over the contacts with δᵢ > 0, as force and torque (penetration.h)
///
/// with k the Material's stiffness [N/m], δᵢ [m] the directional penetration depth of contact i along
/// its n, textures included, and ∇δᵢ its gradient over the tool's motion (TexturedContacts).
///
/// Frames: the origin of the tool's own frame is the probe's tip, and the tool turns with the probe. The surface's own
/// frame has the orientation of the device's frame, with its origin in `patch.centre_m`.
///
/// `coupling = none`: the tool has the device's pose, and the hand feels F about the tip. This is passive only while b
/// > K·T/2 + |B|, with K the steepest stiffness, texture included, B the contact damping and b the device's own damping
/// (sampled_loop.h).
/// `coupling = virtual` (default): between device and surface there is a simulated tool with mass, on springs and
/// dampers, integrated implicitly (CoupledTool); the hand feels the springs. K and B are then
/// `coupling_stiffness_N_per_m` and `coupling_damping_N_s_per_m`, independent of the stiffness of the contacts: 1.5 N
/// s/m with the defaults at 1 kHz. In return the coupling attenuates the texture: the fraction k_t/(k_t + k) of a
/// texture's vibration reaches the hand, up to approximately the frequency √((k_t + k)/m)/2π.
///
/// Contact damping b (`contact_damping_N_s_per_m`, 0): the force of a contact is −(k·δ + b·δ̇)·∇δ and never pulls.
/// Friction: −μ·kδ·v_t/√(v_t² + v₀²) at the deepest point of each contact, with v_t the component of the tool's
/// velocity there perpendicular to n and v₀ `friction_speed_m_per_s`; with the coupling, a damper μ·kδ/√(v_t² + v₀²) in
/// the implicit step. There is no friction against rotation about the contact point.
///
/// The displacements of the surface's texture are multiplied by `texture_gain`, those of the tool's by
/// `tool_texture_gain`. The roundness of a cylinder or a sphere of `textured_shape` is part of its texture: at gain 0
/// it has facets.
///
/// The patch: there is no force outside its extent, a fading edge fades the wrench and a wall pushes the tip back
/// from where contact began (border_wall.h), as in SurfaceContact, all measured at the device's tip. Meshes are not tiled, and `tiling` has no
/// effect.
///
/// Until the device has been clear of the surface once since `reset`, the reported penetration is never 0. This
/// includes a tool that is completely inside and intersects no surface: it produces no force and is counted
/// (`wholly_inside`).
///
/// Errors: std::invalid_argument for meshes that are not valid bodies (see TexturedBody), a `motion_scale` other than
/// 1, a step that is not 1, 2, 4 or 8 cells, and a patch or Material that SurfaceContact rejects.
///
/// Units and frame: SI, the device's.
///
/// Limits: those of TexturedContacts and of Penetration; see `limits`.
///
/// Real-time: `reset` and `tick` do not allocate, lock or throw.
class PdGradient final : public ForceRenderer, public SimulatesTool {
 public:
  /// What renderers share: what takes long to make and does not change the forces.
  struct SharedParts {
    PreparedBodies bodies{};
    SpareSamplers samplers{};
  };

  /// Requires complete, checked parameters.
  /// `compute`: the device that evaluates contacts; null for the processor.
  /// `shared`: used by the constructor only; null to make all parts for this renderer.
  PdGradient(const RendererInputs& inputs, InstructionSet instructions,
             const Compute* compute = nullptr, SharedParts* shared = nullptr);

  void reset(const ProbeState& first) noexcept override;
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override;

  /// The number of ticks with each condition, in this order:
  ///   contact        there was a contact; the other conditions are a part of these ticks
  ///   folded         a touching surface was not a height field along n somewhere in the window
  ///   window_border  the deepest place was at a window's border: the depth is a lower bound
  ///   fine_detail    a window's cell was longer than an eighth of the finest waves of a texture in
  ///                  contact (TexturedBody::finest_wave_m)
  ///   fast           the tool's point moved more than half of those waves in a tick
  ///   coarse_window  a contact was too wide for the declared step
  ///   left_out       there were more pairs, contacts or triangles than there is room for, or a contact
  ///                  had no direction or an unreliable depth (LeftOut)
  ///   too_deep       a contact was deeper than the local thickness of the bodies, or steeper than 60°:
  ///                  both are bounded (TexturedContacts)
  ///   kept           a contact continued without a curve (TexturedContacts)
  ///   wholly_inside  a body was completely inside the other one, no surfaces intersected and there was
  ///                  no force: the tool began there, or moved there within a tick
  ///                  (TexturedContacts::is_inside)
  ///   no_compute     with a compute device only: it had no answer within its deadline, and the processor evaluated the
  ///                  contacts (ComputedContacts)
  std::span<const NamedCount> limits() const noexcept override;

  std::optional<TipPose> simulated_tool() const noexcept override;

  /// The contacts of the last tick, for the benchmark and for pictures of a contact.
  std::span<const TexturedContact> contacts() const noexcept { return found_; }

  const TexturedBody& tool_body() const noexcept { return contacts_.a(); }
  const TexturedBody& surface_body() const noexcept { return contacts_.b(); }

 private:
  enum class Limit : std::size_t {
    contact,
    folded,
    window_border,
    fine_detail,
    fast,
    coarse_window,
    left_out,
    too_deep,
    kept,
    wholly_inside,
    no_compute
  };

  /// A contact with a force, and the motion of its deepest point.
  struct Touch {
    const TexturedContact* contact = nullptr;
    glm::dvec3 deepest_m{0.0};
    glm::dvec3 velocity_m_per_s{0.0};
  };

  Pose pose_of(const ProbeState& probe) const noexcept;
  void find_touches(const ProbeState& probe) noexcept;
  Wrench direct(const ProbeState& probe) const noexcept;
  Wrench coupled(const ProbeState& probe, double dt_s) noexcept;
  double friction_N_s_per_m(const Touch& touch) const noexcept;
  void count(Limit limit, bool is_so) noexcept;
  void watch(double dt_s) noexcept;

  SurfaceContact patch_;
  TexturedContacts contacts_;
  glm::dvec3 centre_in_tool_m_{0.0};
  std::optional<CoupledTool> tool_{};  ///< empty without a coupling
  double contact_damping_N_s_per_m_ = 0.0;
  double friction_speed_m_per_s_ = 0.0;
  double finest_wave_m_ = 0.0;  ///< of both textures
  bool has_compute_device_ = false;
  bool has_been_clear_ = false;
  std::span<const TexturedContact> found_{};
  std::array<Touch, kMostContacts> touches_{};
  std::size_t touching_ = 0;
  std::array<NamedCount, 11> limits_;
};

/// The model's declaration; it requires a tool and a surface. `compute` as for PdGradient. The renderers of this model and of its
/// copies share their parts (PdGradient::SharedParts).
ForceModel pd_gradient_model(std::shared_ptr<const Compute> compute = {});

/// Whether the hand holds a simulated tool; takes complete parameters of any model.
bool has_virtual_coupling(const ParameterValues& values);

}  // namespace asperity
