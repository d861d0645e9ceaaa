// The placement of a session in the workspace: as in the protocol, or mirrored for a left hand.

#pragma once

#include "protocols/design/protocol.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The layout of a session. Where it is mirrored, x is negated, for the position of the surface and
/// for the strokes. The texture itself is not mirrored: its features stay at the same places of the
/// patch.
struct Layout {
  bool mirrored = false;

  /// The patch with its centre at (−x, y, z).
  SurfacePatch of(SurfacePatch patch) const;
  /// The exploration with its strokes along π − θ.
  Exploration of(Exploration exploration) const;
};

}  // namespace asperity
