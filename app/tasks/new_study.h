// A new study, empty or with the demonstration in it.

#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

/// Makes the folder with an empty store. Errors: ResultsError when there is something already.
void new_study(const std::filesystem::path& folder);

/// The demonstration study: the chapter's protocols, and its textures as procedural surfaces of
/// known heights. Of each texture there are the true height field, a "photograph" of it, and the
/// height field made from that photograph, which is what is rendered; of the distractors only the
/// first two.
///
/// Works without a network, and gives the same files everywhere. `progress` may throw to end it. A folder that was not
/// there before appears when it is complete, or not at all.
void new_demo_study(const std::filesystem::path& folder,
                    const std::function<void(double)>& progress);

/// Whether a study-relative file is one that the demonstration study has in `stimuli/`.
bool is_of_demonstration(const std::string& study_path);

/// Whether the folder holds the whole demonstration study: one that was cut off in the making does
/// not. What was added or changed since does not matter.
bool holds_demo_study(const std::filesystem::path& folder);

}  // namespace asperity
