// Implements the blend of adjacent patches.

#include "renderers/force/adjacent_patches.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "renderers/force/smoothstep.h"

namespace asperity {
namespace {

// Two sides that are closer are the same: patches are computed from the same numbers on different ways.
constexpr double kSame_m = 1e-9;
// Beyond every workspace of a device.
constexpr double kUnbounded_m = 1e3;

glm::dvec2 lowest_of(const SurfacePatch& patch) {
  return glm::dvec2(patch.centre_m) - 0.5 * patch.extent_m;
}

glm::dvec2 highest_of(const SurfacePatch& patch) {
  return glm::dvec2(patch.centre_m) + 0.5 * patch.extent_m;
}

bool overlap(const SurfacePatch& a, const SurfacePatch& b) {
  for (int axis = 0; axis < 2; ++axis) {
    if (lowest_of(a)[axis] >= highest_of(b)[axis] - kSame_m ||
        lowest_of(b)[axis] >= highest_of(a)[axis] - kSame_m) {
      return false;
    }
  }
  return true;
}

void refuse(std::size_t patch, const std::string& problem) {
  throw std::invalid_argument("patch " + std::to_string(patch + 1) + ' ' + problem);
}

void require_place(std::span<const AdjacentPatch> patches, std::size_t index,
                   const SurfacePatch& workspace, double blend_m) {
  const SurfacePatch& patch = patches[index].inputs.patch;
  if (std::abs(patch.centre_m.z - workspace.centre_m.z) > kSame_m) {
    refuse(index, "does not lie in the plane of the workspace; give its centre the same z");
  }
  for (int axis = 0; axis < 2; ++axis) {
    if (lowest_of(patch)[axis] < lowest_of(workspace)[axis] - kSame_m ||
        highest_of(patch)[axis] > highest_of(workspace)[axis] + kSame_m) {
      refuse(index, "extends beyond the workspace; make it smaller");
    }
    if (2.0 * blend_m > patch.extent_m[axis]) {
      refuse(index,
             "is less than twice as wide as its blend; make it wider, or the blend narrower");
    }
  }
  for (std::size_t other = 0; other < index; ++other) {
    if (overlap(patch, patches[other].inputs.patch)) {
      refuse(index, "overlaps patch " + std::to_string(other + 1) + "; move them apart");
    }
  }
}

/// Of the flat surface. They must not depend on the order of the patches: the order decides which of the participant's
/// responses is correct, and the flat surface would feel different with it.
ParameterValues parameters_of_friction(std::span<const AdjacentPatch> patches) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  ParameterValues shared{};
  for (const Parameter& parameter : declared) {
    const auto value_of = [&parameter](const AdjacentPatch& patch) {
      const ParameterValues& values = patch.inputs.parameters;
      const auto found = values.find(parameter.name);
      return found == values.end() ? parameter.default_value : found->second;
    };
    const bool is_shared = std::all_of(
        patches.begin(), patches.end(),
        [&](const AdjacentPatch& patch) { return value_of(patch) == value_of(patches.front()); });
    shared[parameter.name] =
        is_shared && !patches.empty() ? value_of(patches.front()) : parameter.default_value;
  }
  return shared;
}

}  // namespace

RendererInputs without_border(RendererInputs inputs) {
  inputs.patch.edge = PatchEdge::fade;
  inputs.patch.edge_width_m = 0.0;
  inputs.patch.extent_m = glm::dvec2(kUnbounded_m);
  return inputs;
}

AdjacentPatches::AdjacentPatches(std::span<const AdjacentPatch> patches,
                                 const SurfacePatch& workspace, const Material& material,
                                 double blend_m)
    : flat_(workspace, material, parameters_of_friction(patches)), blend_m_(blend_m) {
  if (patches.empty())
    throw std::invalid_argument("patches is empty; at least one patch is needed");
  if (!(blend_m > 0.0)) {
    throw std::invalid_argument("blend_m is " + number_text(blend_m) + "; it must be positive");
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    require_place(patches, i, workspace, blend_m);
    const SurfacePatch& place = patches[i].inputs.patch;
    Patch patch{.renderer = make_renderer(*patches[i].model, without_border(patches[i].inputs)),
                .lowest_m = lowest_of(place),
                .highest_m = highest_of(place)};
    for (int axis = 0; axis < 2; ++axis) {
      patch.blends_below[axis] =
          lowest_of(place)[axis] > lowest_of(workspace)[axis] + kSame_m ? 1.0 : 0.0;
      patch.blends_above[axis] =
          highest_of(place)[axis] < highest_of(workspace)[axis] - kSame_m ? 1.0 : 0.0;
    }
    patches_.push_back(std::move(patch));
  }
}

void AdjacentPatches::reset(const ProbeState&) noexcept {
  entered_ = 0;
  flat_has_weight_ = true;
  flat_.reset();
  wall_.release();
}

double AdjacentPatches::weight_of(const Patch& patch, const glm::dvec3& position_m) const noexcept {
  double weight = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double below_m = position_m[axis] - patch.lowest_m[axis];
    const double above_m = patch.highest_m[axis] - position_m[axis];
    if (patch.blends_below[axis] > 0.0) weight *= smoothstep(below_m / blend_m_);
    if (patch.blends_above[axis] > 0.0) weight *= smoothstep(above_m / blend_m_);
  }
  return weight;
}

RenderedTick AdjacentPatches::tick(const ProbeState& probe, double dt_s) noexcept {
  PatchPoint point = flat_.locate(probe.position_m);
  // The wall belongs to the workspace, not to one of the surfaces.
  const glm::dvec2 beyond_m = std::exchange(point.beyond_m, glm::dvec2(0.0));
  double weight = 0.0;
  std::size_t entered = 0;
  for (std::size_t i = 0; i < patches_.size() && entered == 0; ++i) {
    weight = weight_of(patches_[i], probe.position_m);
    if (weight > 0.0) entered = i + 1;
  }
  // A contact is handed over while the surface that receives it still has no weight, so that the force has no step.
  const bool flat_has_weight = entered == 0 || weight < 1.0;
  if (flat_has_weight && !flat_has_weight_) {
    if (const Friction* const friction = patches_[entered_ - 1].renderer->friction()) {
      flat_.friction().continue_contact_of(*friction);
    }
  }
  if (entered != 0 && entered != entered_) {
    ForceRenderer& renderer = *patches_[entered - 1].renderer;
    renderer.reset(probe);
    if (Friction* const friction = renderer.friction()) {
      friction->continue_contact_of(flat_.friction());
    }
  }
  RenderedTick blend{};
  if (const double depth_m = -point.height_m; depth_m > 0.0 && point.gain > 0.0) {
    const double normal_N = flat_.material().stiffness_N_per_m * depth_m;
    blend = flat_.force(
        point, probe,
        {.texture_N = {0.0, 0.0, normal_N}, .normal_N = normal_N, .penetration_m = depth_m}, dt_s);
  } else {
    flat_.reset();
  }
  if (entered != 0) {
    ForceRenderer& renderer = *patches_[entered - 1].renderer;
    const RenderedTick of_patch = renderer.tick(probe, dt_s);
    const double share = weight * point.gain;
    blend.wrench.force_N = share * of_patch.wrench.force_N + (1.0 - weight) * blend.wrench.force_N;
    blend.wrench.torque_N_m = share * of_patch.wrench.torque_N_m;
    blend.penetration_m = (point.gain > 0.0 ? weight * of_patch.penetration_m : 0.0) +
                          (1.0 - weight) * blend.penetration_m;
  }
  entered_ = entered;
  flat_has_weight_ = flat_has_weight;
  if (blend.penetration_m > 0.0) {
    const double stiffness_N_per_m = flat_.material().stiffness_N_per_m;
    blend.wrench.force_N += glm::dvec3(wall_.force_N(beyond_m, stiffness_N_per_m), 0.0);
  } else {
    wall_.release();
  }
  blend.part = static_cast<std::uint32_t>(entered);
  return blend;
}

}  // namespace asperity
