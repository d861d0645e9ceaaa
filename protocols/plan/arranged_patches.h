// Declares the places of the surfaces of a trial in the workspace.

#pragma once

#include <cstddef>
#include <vector>

#include "protocols/design/arrangement.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The width of each of `surfaces` patches side by side: the workspace without the gaps between them, divided equally.
/// Not positive where the gaps leave no room. [m]
double width_side_by_side_m(const SurfacePatch& workspace, const Arrangement& arrangement,
                            std::size_t surfaces);

/// The patch of each surface of a trial, in the order of the trial: the whole workspace, or side by side from the lower
/// to the higher end of the axis.
std::vector<SurfacePatch> arranged_patches(const SurfacePatch& workspace,
                                           const Arrangement& arrangement, std::size_t surfaces);

}  // namespace asperity
