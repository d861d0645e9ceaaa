// Compares the arrangement of trials with the strokes of the exploration and the textures of the surfaces.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every block side by side whose patches are narrower than
///
///   a stroke      the target of the exploration's stroke length, or else its minimum, if it strokes along the patches
///   ten periods   of a texture (texture_waves.h): fewer are felt as single ridges
///
/// or at whose sides the force changes by more than 20 mN in a tick (AdjacentPatches, at the greatest speed of the
/// exploration), and for every block whose visits end after more strokes than the contact time permits.
///
/// Textures are compared where their files are available (StimulusBuilder::can_make), and have been checked before.
std::vector<Diagnostic> warnings_about_arrangements(const CheckedProtocol& checked,
                                                    StimulusBuilder& builder);

}  // namespace asperity
