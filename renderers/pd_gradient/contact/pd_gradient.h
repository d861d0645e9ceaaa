// The chapters' model: two textured bodies, and the gradient of their penetration depth.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "renderers/force/force_model.h"
#include "renderers/force/surface_contact.h"
#include "renderers/pd_gradient/contact/coupled_tool.h"
#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "renderers/pd_gradient/loops/instruction_set.h"

namespace asperity {

/// A tool in the hand against a surface, in six degrees of freedom: low-resolution meshes with
/// haptic textures [Otaduy 2004].
///
///   F = Σ −k·δᵢ·∇δᵢ      over the contacts with δᵢ > 0, as force and torque (penetration.h)
///
/// with k the Material's stiffness [N/m], δᵢ [m] the directional penetration depth of contact i along
/// its n, textures included, and ∇δᵢ its gradient over the tool's motion (TexturedContacts).
///
/// Where the bodies are: the origin of the tool's own frame is the probe's tip, and the tool turns
/// with the probe. The surface's own frame stands upright with its origin in `patch.centre_m`.
///
/// `coupling = none`: the tool is where the device is, and the hand feels F about the tip. Passive
/// only while b > K·T/2 + |B| with K the steepest stiffness, texture included, B the contact damping and b the
/// device's own (sampled_loop.h).
/// `coupling = virtual` (default): between the two is a tool of its own with mass, on springs and
/// dampers, integrated implicitly (CoupledTool); the hand feels the springs. K and B are then
/// `coupling_stiffness_N_per_m` and `coupling_damping_N_s_per_m`, however stiff the contacts: 1.5 N s/m with the
/// defaults at 1 kHz. The coupling softens the texture in return: a texture's vibration reaches the hand by the share k_t/(k_t + k) and up to about the frequency
/// √((k_t + k)/m)/2π.
///
/// Contact damping b (`contact_damping_N_s_per_m`, 0): the force of a contact is −(k·δ + b·δ̇)·∇δ
/// and never pulls. Friction: −μ·kδ·v_t/√(v_t² + v₀²) at the deepest point of each contact, v_t the
/// tool's velocity there across n, v₀ `friction_speed_m_per_s`; with the coupling as a damper
/// μ·kδ/√(v_t² + v₀²) in the implicit step. It has no part that resists turning on the spot.
///
/// The texture of the surface is `texture_gain` times as deep, that of the tool `tool_texture_gain`
/// times. What makes a cylinder or a sphere of `textured_shape` round is part of its texture: at
/// gain 0 it has facets.
///
/// The patch: outside its extent nothing is felt, a fading edge fades the wrench and a wall pushes
/// the tip back while there is contact, as in SurfaceContact, all measured at the device's tip.
/// Meshes are not tiled, `tiling` has no meaning.
///
/// Before the device has been clear of the surface once since `reset`, the penetration reported is
/// never 0, also for a tool that lies wholly inside and cuts nothing, which feels no force and is
/// counted (`wholly_inside`).
///
/// Errors: std::invalid_argument for meshes that are no bodies in contact (see TexturedBody), a
/// `motion_scale` other than 1, a step that is not 1, 2, 4 or 8 cells, a patch or Material that
/// SurfaceContact refuses.
///
/// Units and frame: SI, the device's.
///
/// Limits: those of TexturedContacts and of Penetration; see `limits`.
///
/// Real-time: `reset` and `tick` do not allocate, lock or throw.
class PdGradient final : public ForceRenderer {
 public:
  /// With complete, checked parameters.
  PdGradient(const RendererInputs& inputs, InstructionSet instructions);

  void reset(const ProbeState& first) noexcept override;
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override;

  /// In how many ticks, in this order:
  ///   contact        anything was touched: what the others are a part of
  ///   folded         a touching surface was no height field along n somewhere in the window
  ///   window_border  the deepest place lay at a window's border: the depth is a lower bound
  ///   fine_detail    a window's cell was longer than an eighth of the finest waves of a texture in
  ///                  contact (TexturedBody::finest_wave_m)
  ///   fast           the tool's point moved more than half of those waves in a tick
  ///   coarse_window  a contact was too wide for the declared step
  ///   left_out       pairs, contacts or triangles were more than there is room for, or a contact
  ///                  had no direction or a doubtful depth (LeftOut)
  ///   too_deep       a contact was deeper than the bodies are thick there, or steeper than 60°: both
  ///                  are bounded (TexturedContacts)
  ///   kept           a contact went on without a curve (TexturedContacts)
  ///   wholly_inside  a body was wholly in the other, nothing was cut and no force was felt: where the
  ///                  tool began there, or came there within a tick (TexturedContacts::is_inside)
  std::span<const NamedCount> limits() const noexcept override { return limits_; }

  /// Of the last tick, for the bench and for pictures of a contact.
  std::span<const TexturedContact> contacts() const noexcept { return found_; }

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
    wholly_inside
  };

  /// A contact that is felt, and how its deepest point moves.
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
  std::optional<CoupledTool> tool_{};  ///< none without a coupling
  double contact_damping_N_s_per_m_ = 0.0;
  double friction_speed_m_per_s_ = 0.0;
  double finest_wave_m_ = 0.0;  ///< of both textures
  bool has_been_clear_ = false;
  std::span<const TexturedContact> found_{};
  std::array<Touch, TexturedContacts::kMostContacts> touches_{};
  std::size_t touching_ = 0;
  std::array<NamedCount, 10> limits_;
};

/// Needs a tool and a surface.
ForceModel pd_gradient_model();

/// Whether the hand holds a simulated tool, with complete parameters of any model.
bool has_virtual_coupling(const ParameterValues& values);

}  // namespace asperity
