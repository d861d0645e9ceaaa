// Implements the placement, friction and borders of a patch.

#include "renderers/force/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "renderers/force/smoothstep.h"

namespace asperity {
namespace {

void refuse_unless(bool acceptable, const char* what, double value) {
  if (acceptable && std::isfinite(value)) return;
  throw std::invalid_argument(std::string(what) + ", but it is " + std::to_string(value));
}

// The signed distance of a coordinate beyond ±half; 0 inside.
double excess(double coordinate, double half) noexcept {
  return coordinate - std::clamp(coordinate, -half, half);
}

}  // namespace

glm::dvec2 on_texture(const SurfacePatch& patch, const glm::dvec3& position_m) noexcept {
  return patch.motion_scale * (glm::dvec2(position_m) - glm::dvec2(patch.centre_m)) +
         patch.texture_origin_m;
}

SurfaceContact::SurfaceContact(const SurfacePatch& patch, const Material& material,
                               const ParameterValues& parameters)
    : patch_(patch),
      material_(material),
      half_extent_m_(0.5 * patch.extent_m),
      friction_(material.friction, parameters) {
  for (int axis = 0; axis < 3; ++axis) {
    refuse_unless(true, "SurfacePatch::centre_m must be finite", patch.centre_m[axis]);
  }
  const double smaller_m = std::min(patch.extent_m.x, patch.extent_m.y);
  refuse_unless(smaller_m > 0.0, "SurfacePatch::extent_m must be positive", smaller_m);
  refuse_unless(std::isfinite(patch.extent_m.x + patch.extent_m.y),
                "SurfacePatch::extent_m must be finite", patch.extent_m.x + patch.extent_m.y);
  refuse_unless(patch.motion_scale > 0.0, "SurfacePatch::motion_scale must be positive",
                patch.motion_scale);
  refuse_unless(patch.edge_width_m >= 0.0, "SurfacePatch::edge_width_m must not be negative",
                patch.edge_width_m);
  refuse_unless(patch.edge == PatchEdge::wall || patch.edge_width_m <= 0.5 * smaller_m,
                "SurfacePatch::edge_width_m must be at most half the smaller extent",
                patch.edge_width_m);
  refuse_unless(material.stiffness_N_per_m > 0.0, "Material::stiffness_N_per_m must be positive",
                material.stiffness_N_per_m);
  refuse_unless(material.friction >= 0.0, "Material::friction must not be negative",
                material.friction);
}

PatchPoint SurfaceContact::locate(const glm::dvec3& position_m) const noexcept {
  const double x_m = position_m.x - patch_.centre_m.x;
  const double y_m = position_m.y - patch_.centre_m.y;
  const glm::dvec2 texture_m = on_texture(patch_, position_m);
  PatchPoint point{
      .x_m = texture_m.x, .y_m = texture_m.y, .height_m = position_m.z - patch_.centre_m.z};
  switch (patch_.edge) {
    case PatchEdge::wall:
      point.beyond_m = {excess(x_m, half_extent_m_.x), excess(y_m, half_extent_m_.y)};
      break;
    case PatchEdge::fade: {
      const double inside_x_m = half_extent_m_.x - std::abs(x_m);
      const double inside_y_m = half_extent_m_.y - std::abs(y_m);
      if (inside_x_m <= 0.0 || inside_y_m <= 0.0) {
        point.gain = 0.0;
      } else if (patch_.edge_width_m > 0.0) {
        point.gain = smoothstep(inside_x_m / patch_.edge_width_m) *
                     smoothstep(inside_y_m / patch_.edge_width_m);
      }
      break;
    }
  }
  return point;
}

RenderedTick SurfaceContact::force(const PatchPoint& point, const ProbeState& probe,
                                   const ContactForce& contact, double dt_s) noexcept {
  const glm::dvec2 drag_N =
      friction_.drag_N({.position_m = glm::dvec2(probe.position_m),
                        .velocity_m_per_s = glm::dvec2(probe.velocity_m_per_s),
                        .normal_N = contact.normal_N,
                        .dt_s = dt_s});
  const glm::dvec3 along_N(wall_N(point) - drag_N, 0.0);
  return {.wrench = {.force_N = point.gain * (contact.texture_N + along_N)},
          .penetration_m = contact.penetration_m};
}

RenderedTick SurfaceContact::no_contact() noexcept {
  reset();
  return {};
}

}  // namespace asperity
