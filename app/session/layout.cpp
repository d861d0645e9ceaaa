// Mirrors patches and directions about the plane x = 0.

#include "app/session/layout.h"

#include <numbers>

namespace asperity {

SurfacePatch Layout::of(SurfacePatch patch) const {
  if (mirrored) patch.centre_m.x = -patch.centre_m.x;
  return patch;
}

SurfacePatch Layout::of(const PlannedPresentation& surface) const {
  const SurfacePatch& workspace = surface.stimulus.patch;
  SurfacePatch patch = surface.patch;
  patch.centre_m.x += of(workspace).centre_m.x - workspace.centre_m.x;
  return patch;
}

Exploration Layout::of(Exploration exploration) const {
  if (mirrored) exploration.direction_rad = std::numbers::pi - exploration.direction_rad;
  return exploration;
}

}  // namespace asperity
