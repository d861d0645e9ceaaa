// Declares the textures of the demo study, which the protocols of the library use.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The names of all, in the order in which they are made.
std::vector<std::string> demo_stimuli();

/// The files that one of them has in `stimuli/`. Empty: there is none of this name.
std::vector<std::string> files_of_demo_stimulus(std::string_view name);

/// Computes one of them and writes its files into the folder: the same on every machine, without a network.
///
/// Errors: std::invalid_argument for another name; ResultsError if a file exists or cannot be written.
void make_demo_stimulus(std::string_view name, const std::filesystem::path& folder);

/// The demo stimulus that a study-relative file belongs to; empty for other files.
std::string demo_stimulus_of(std::string_view study_path);

}  // namespace asperity
