// Solves for the gap between two flanks in closed form for sinusoids, gratings and cones.

#include "renderers/offline/drop_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stimuli/heights/surface_declaration.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

namespace {

/// The two sides of the gap between neighbours, each of the height h.
struct Flank {
  double height_m = 0.0;
  double run_m = 0.0;  ///< its length along the ground
};

/// By how much a gap between tops must be wider than nothing.
double gap_between_tops_m(const Flank& flank, double radius_m) {
  const double angle_rad = std::atan2(flank.height_m, flank.run_m);
  if (radius_m * (1.0 - std::cos(angle_rad)) <= flank.height_m) {
    return 2.0 * (flank.run_m + radius_m * std::tan(0.5 * angle_rad));
  }
  return 2.0 * std::sqrt(flank.height_m * (2.0 * radius_m - flank.height_m));
}

}  // namespace

std::optional<double> drop_point_m(const SpacedTexture& texture, const RigidTip& tip) {
  if (texture.relief || tip.form == TipForm::point) return std::nullopt;
  const double radius_m = 0.5 * tip.diameter_m;
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    if (surface.kind != texture.kind) continue;
    const ParameterValues values =
        complete_values(surface.kind, surface.parameters, texture.values);
    if (texture.kind == "sinusoid") {
      return 2.0 * std::numbers::pi * std::sqrt(number_of(values, "amplitude_m") * radius_m);
    }
    if (texture.kind == "grating") {
      return number_of(values, "ridge_width_m") +
             gap_between_tops_m({.height_m = number_of(values, "height_m"),
                                 .run_m = number_of(values, "flank_width_m")},
                                radius_m);
    }
    if (texture.kind == "cones") {
      const double top_m = number_of(values, "top_diameter_m");
      return top_m +
             gap_between_tops_m({.height_m = number_of(values, "height_m"),
                                 .run_m = 0.5 * (number_of(values, "base_diameter_m") - top_m)},
                                radius_m);
    }
  }
  return std::nullopt;
}

}  // namespace asperity
