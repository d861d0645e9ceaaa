// The line that a command prints about a height field that it has written.

#pragma once

#include <filesystem>
#include <string>

#include "stimuli/heights/height_field.h"

namespace asperity {

/// "FILE.png: 512 × 512 samples, pitch 5.0 µm, height −3.0 to +4.1 µm, RMS 1.0 µm\n"
std::string height_field_line(const std::filesystem::path& out, const HeightField& field);

}  // namespace asperity
