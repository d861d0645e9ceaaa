// Warns of strokes of a recorded texture that its format does not intend.

#pragma once

#include <string>

#include "renderers/recordings/texture_recording.h"

namespace asperity {

/// Prints the first `uneven_strokes` of the recording `name`, and the number of the others.
void warn_of_uneven_strokes(const TextureRecording& recording, const std::string& name);

}  // namespace asperity
