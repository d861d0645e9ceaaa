// What a protocol's height fields are, against what the protocol takes them for.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Warnings about the textures that a stimulus of the plan has as a height field, each with the stimuli
/// it is felt in, by what the files' sidecars say (docs/formats/height_field.md):
///
///   spacing_m    the protocol's is another than that of the surface that was made, by 1 % or more, both on
///                the device (over the motion scale). Not of a sinusoid at an angle, whose distance along
///                a stroke is another one
///   a seam       a tile that holds no whole number of spacings (seam_of) and is repeated under the hand
///   few samples  fewer than eight for a spacing (coarse_samples_of)
///
/// Nothing of what was not made by a formula. The files have been looked at.
///
/// Errors: as `load_height_field`.
std::vector<Diagnostic> doubts_about_textures(const Protocol& protocol,
                                              const std::string& file_name,
                                              const std::filesystem::path& study);

}  // namespace asperity
