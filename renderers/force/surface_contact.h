// Declares what all force models share: the probe's position on the patch, friction and the border.

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"
#include "renderers/force/border_wall.h"
#include "renderers/force/friction.h"
#include "renderers/force/rendered_tick.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The position of the probe relative to a patch.
struct PatchPoint {
  double x_m = 0.0;  ///< on the texture: motion_scale · (device − centre) + texture_origin
  double y_m = 0.0;
  double height_m = 0.0;     ///< p_z − z_s, of the tip above the reference plane
  double gain = 1.0;         ///< of a fading border; 0 outside the patch
  glm::dvec2 beyond_m{0.0};  ///< e, beyond a walled border, with its sign; 0 inside
};

/// x_m and y_m of the PatchPoint.
glm::dvec2 on_texture(const SurfacePatch& patch, const glm::dvec3& position_m) noexcept;

/// The model-specific part of a contact force.
struct ContactForce {
  glm::dvec3 texture_N{0.0};  ///< all components except friction and walls
  double normal_N = 0.0;      ///< N, the normal force that friction is computed from; not negative
  double penetration_m = 0.0;
};

/// Computes the placement, friction and border of a stimulus's patch in the same way for every force model, so that
/// models that are compared do not differ in them.
///
///   friction   F_f = −D   the drag of the law `friction_law` (friction.h), from the motion of the hand along the
///                         plane, the normal force N and the Material's μ
///   wall       F_w = −k·(e − o)   e the distance beyond the border [m], o that at which contact began, or the least since
///                                 then (border_wall.h), k the Material's stiffness [N/m]
///   fade       F·s(b_x/w)·s(b_y/w)   b the distance inside each border, w its width [m],
///                                    s(u) = u²(3 − 2u) on [0, 1]
///
/// N = F·n of the model's force F and the normal n of the plane. Coulomb's law relates the two components of one contact
/// force: the one along the surface on which the contact slides, and the one perpendicular to it. The hand slides along the
/// plane, and D acts in the plane, so N is the component along its normal, also of a force that a texture has turned. A texture that
/// turns the force without changing its magnitude (normal_map, `local_normal`) therefore lowers the friction on its flanks.
///
/// The law `rounded` is D = μ·N·v_t/√(v_t² + v₀²): 99 % of μN at 7 v₀ and zero at rest, so that a hand on a slope is not
/// held. Near rest it is a damper of μN/v₀, on which the loop vibrates if it is too steep (offline/sampled_loop.h). Other
/// laws have a state: a model calls `force` in every tick of a contact and `no_contact` in every other one.
/// Extent and border are measured in the device's coordinates, independent of `motion_scale`.
///
/// Errors: the constructor throws std::invalid_argument, naming the field, for an extent, motion scale or stiffness
/// that is not positive, a negative friction, or a fading border that is wider than half the patch; as Friction for its
/// parameters.
///
/// Real-time: `locate`, `force`, `no_contact` and `reset` do not allocate, lock or throw.
class SurfaceContact final {
 public:
  SurfaceContact(const SurfacePatch& patch, const Material& material,
                 const ParameterValues& parameters);

  PatchPoint locate(const glm::dvec3& position_m) const noexcept;
  /// The complete result, from the model's contact force at `point`, `dt_s` after the previous sample.
  RenderedTick force(const PatchPoint& point, const ProbeState& probe, const ContactForce& contact,
                     double dt_s) noexcept;
  /// The result of a sample that is not in contact: no force, and the friction starts over.
  RenderedTick no_contact() noexcept;
  /// The force of the wall in a tick of contact, for a renderer that computes the other forces without `force`.
  glm::dvec2 wall_N(const PatchPoint& point) noexcept {
    return wall_.force_N(point.beyond_m, material_.stiffness_N_per_m);
  }
  /// At the start of a presentation.
  void reset() noexcept {
    friction_.reset();
    wall_.release();
  }

  Friction& friction() noexcept { return friction_; }
  const SurfacePatch& patch() const noexcept { return patch_; }
  const Material& material() const noexcept { return material_; }

 private:
  SurfacePatch patch_{};
  Material material_{};
  glm::dvec2 half_extent_m_{0.0};
  Friction friction_;
  BorderWall wall_{};
};

}  // namespace asperity
