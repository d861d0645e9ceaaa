// The placement of a session in the workspace: as in the protocol, or mirrored for a left hand.

#pragma once

#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The layout of a session. Where it is mirrored, x is negated, for the position of the surface and
/// for the strokes. The texture itself is not mirrored: its features stay at the same places of the
/// patch.
struct Layout {
  bool mirrored = false;

  /// The patch with its centre at (−x, y, z).
  SurfacePatch of(SurfacePatch patch) const;
  /// The patch of a surface of a trial. Surfaces side by side keep their order from left to right, which the participant's
  /// screen shows.
  SurfacePatch of(const PlannedPresentation& surface) const;
  /// The exploration with its strokes along π − θ.
  Exploration of(Exploration exploration) const;
};

}  // namespace asperity
