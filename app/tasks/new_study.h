// Makes a new study, empty or with the demonstration.

#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

/// Makes the folder with an empty store. Errors: ResultsError when the folder already has content.
void new_study(const std::filesystem::path& folder);

/// The demo study: the chapter's protocols, and its textures as procedural surfaces of
/// known heights. Each texture has the true height field, a "photograph" of it, and the height
/// field made from that photograph, which is rendered; distractors have only the first two.
///
/// Requires no network, and gives the same files on every machine. `progress` may throw to cancel.
/// A folder that did not exist before appears only when it is complete.
void new_demo_study(const std::filesystem::path& folder,
                    const std::function<void(double)>& progress);

/// Whether a study-relative file is one of the demo study's files in `stimuli/`.
bool is_of_demonstration(const std::string& study_path);

/// Whether the folder contains the complete demo study: false for one whose making was
/// interrupted. Later additions and changes do not matter.
bool holds_demo_study(const std::filesystem::path& folder);

}  // namespace asperity
