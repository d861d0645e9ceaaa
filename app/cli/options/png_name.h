// The name of a picture that is to be written.

#pragma once

#include <filesystem>
#include <stdexcept>

namespace asperity {

/// Pictures and height fields are PNGs: refuses a name that says anything else.
///
/// Errors: std::invalid_argument with the name and one that would be right.
inline void require_png(const std::filesystem::path& file) {
  if (file.extension() == ".png") return;
  std::filesystem::path right = file;
  right.replace_extension(".png");
  throw std::invalid_argument(file.string() + ": the output is a PNG; name it " + right.string());
}

}  // namespace asperity
