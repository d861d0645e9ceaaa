// Declares warnings about textures that nothing uses, as after a level that became another texture.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every texture that is declared, and that no stimulus, level, question or body names. `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_texture_use(const Protocol& protocol,
                                                   const std::string& file_name);

}  // namespace asperity
