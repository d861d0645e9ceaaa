// Makes a new study, empty or with the demonstration.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "results_schema/rows.h"

namespace asperity {

struct NewStudySettings {
  StudyMetadata metadata{};
  /// The group that the study is shared with; empty: the group of its folder. Absent: it is not shared.
  std::optional<std::string> group{};
};

/// Whether an existing folder can become a study (`is_free`). False for one that cannot be read.
bool may_become_study(const std::filesystem::path& folder);

enum class NewStudy {
  made,
  /// It was there as the same call makes it, and unused: a call that was interrupted at its end made it.
  found,
};

/// Makes the folder with an empty store. A folder that did not exist before appears only when it is complete, so that the
/// same call can be repeated after an error or a crash; a folder that was free (`is_free`) is as before after an error.
/// Errors: ResultsError when the folder already has content.
NewStudy new_study(const std::filesystem::path& folder, const NewStudySettings& settings = {});

/// The demo study: the chapter's protocols, and its textures as procedural surfaces of
/// known heights. Each texture has the true height field, a "photograph" of it, and the height
/// field made from that photograph, which is rendered; distractors have only the first two.
///
/// Requires no network, and gives the same files on every machine. `progress` may throw to cancel.
/// For the rest like `new_study`.
NewStudy new_demo_study(const std::filesystem::path& folder,
                        const std::function<void(double)>& progress,
                        const NewStudySettings& settings = {});

/// What applies to every study until 1.0.0, from which on formats are kept: for the places where a study is made. README.md
/// contains its second sentence.
Phrase one_version_per_study();

/// Whether the folder contains the complete demo study: false for one whose making was
/// interrupted. Later additions and changes do not matter.
bool holds_demo_study(const std::filesystem::path& folder);

}  // namespace asperity
