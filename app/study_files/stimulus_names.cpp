// Implements the rule for the names of stimuli.

#include "app/study_files/stimulus_names.h"

#include <algorithm>

namespace asperity {

bool is_stimulus_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestStimulusName &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-';
         });
}

std::filesystem::path photograph_of(const std::filesystem::path& png) {
  return png.parent_path() / (png.stem().string() + "_photo.png");
}

}  // namespace asperity
