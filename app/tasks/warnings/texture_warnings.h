// Compares a protocol's height fields with the protocol's statements about them.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Warnings about the textures that a stimulus of the plan has as a height field, each with its
/// stimuli, from the files' sidecars (docs/formats/height_field.md):
///
///   spacing_m    the protocol's differs from that of the surface that was made by 1 % or more, both on the
///                device (divided by the motion scale). Not for a sinusoid at an angle, whose period
///                along a stroke is different
///   a seam       a tile that does not contain a whole number of spacings (seam_of) and is repeated under
///                the hand
///   few samples  fewer than eight per spacing (coarse_samples_of)
///
/// None for surfaces that were not made by a formula. The files have been checked before.
///
/// Errors: as `load_height_field`.
std::vector<Diagnostic> warnings_about_textures(const CheckedProtocol& checked,
                                                const std::filesystem::path& study);

}  // namespace asperity
