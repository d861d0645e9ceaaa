// Where a session lies in the workspace: as the protocol specifies, or mirrored for a left hand.

#pragma once

#include "protocols/design/protocol.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The layout of a session: x is negated where it is mirrored, of the surface's place and of the
/// strokes. What is on a surface is not mirrored: it is felt at the same places of the patch.
struct Layout {
  bool mirrored = false;

  /// The patch with its centre at (−x, y, z).
  SurfacePatch of(SurfacePatch patch) const;
  /// The exploration with its strokes along π − θ.
  Exploration of(Exploration exploration) const;
};

}  // namespace asperity
