// Implements the places of the surfaces of a trial.

#include "protocols/plan/arranged_patches.h"

namespace asperity {

namespace {

int axis_of(const Arrangement& arrangement) {
  return arrangement.axis == Arrangement::Axis::x ? 0 : 1;
}

}  // namespace

double width_side_by_side_m(const SurfacePatch& workspace, const Arrangement& arrangement,
                            std::size_t surfaces) {
  const auto count = static_cast<double>(surfaces);
  return (workspace.extent_m[axis_of(arrangement)] - (count - 1.0) * arrangement.gap_m) / count;
}

std::vector<SurfacePatch> arranged_patches(const SurfacePatch& workspace,
                                           const Arrangement& arrangement, std::size_t surfaces) {
  std::vector<SurfacePatch> patches(surfaces, workspace);
  if (arrangement.surfaces != Arrangement::Surfaces::side_by_side) return patches;
  const int axis = axis_of(arrangement);
  const double width_m = width_side_by_side_m(workspace, arrangement, surfaces);
  const double lowest_m = workspace.centre_m[axis] - 0.5 * workspace.extent_m[axis];
  for (std::size_t i = 0; i < surfaces; ++i) {
    patches[i].extent_m[axis] = width_m;
    patches[i].centre_m[axis] =
        lowest_m + static_cast<double>(i) * (width_m + arrangement.gap_m) + 0.5 * width_m;
  }
  return patches;
}

}  // namespace asperity
