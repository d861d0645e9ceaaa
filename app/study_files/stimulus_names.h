// Declares the names that stimuli of a study can have, and the file of a photograph.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace asperity {

inline constexpr std::size_t kLongestStimulusName = 60;

/// Whether it can be the name of a file in `stimuli/`, without its ending: unaccented letters, digits, _ and -, which every
/// system and every protocol can write; not empty, and at most `kLongestStimulusName` long.
bool is_stimulus_name(std::string_view name);

/// The photograph that is stored with a height field: NAME_photo.png next to NAME.png.
std::filesystem::path photograph_of(const std::filesystem::path& png);

}  // namespace asperity
