// Declares warnings about textures that nothing uses and about trials that are listed twice.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every
/// - texture that is declared, and that no stimulus, level, question or body names;
/// - listed trial of a block in random order that is listed before, unless the block states its number of repetitions.
/// Both are found where a level becomes another texture.
///
/// `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_texture_use(const Protocol& protocol,
                                                   const std::string& file_name);

}  // namespace asperity
