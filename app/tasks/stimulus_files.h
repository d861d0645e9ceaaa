// Declares what can be done with the stimulus files of a study: renamed, deleted, copied from another study.

#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/study.h"

namespace asperity {

// `path` is that of a file in `stimuli/`, relative to the study: "stimuli/brick.png". Its sidecar belongs to it.

/// What refers to a stimulus.
struct StimulusUses {
  std::vector<std::filesystem::path> protocols{};      ///< files of the study, never run
  std::vector<std::filesystem::path> protocols_run{};  ///< files of the study with sessions
  std::vector<std::filesystem::path> renderings{};
  std::vector<std::string> reliefs{};  ///< paths of the height fields whose photograph it is
  bool in_sessions = false;            ///< a stored session was begun with a protocol that names it

  /// Neither protocols nor renderings name it.
  bool is_unused() const noexcept {
    return protocols.empty() && protocols_run.empty() && renderings.empty() && !in_sessions;
  }
  /// Rows of the store, or texts that sessions refer to, name it.
  bool is_stored() const noexcept { return in_sessions || !protocols_run.empty(); }
};
/// Errors: ResultsError as for Study, and for a file that cannot be read.
StimulusUses uses_of_stimulus(const Study& study, const std::string& path);
/// Why a stimulus with these uses cannot be deleted; nothing where it can.
std::optional<Phrase> complaint_about_deletion(const StimulusUses& uses, const std::string& path);

/// What the renaming of a stimulus changes.
struct RenamePlan {
  /// Itself first, and of a height field its photograph NAME_photo.png if there is one.
  std::vector<std::string> stimuli{};
  std::vector<std::string> files{};  ///< those of the stimuli, with sidecars
  /// Protocols and renderings of which the references, and the notes of a rendering's name, are changed.
  std::vector<std::filesystem::path> changed{};
  /// Protocols with sessions that note the name of a rendering: they keep it.
  std::vector<std::filesystem::path> unchanged{};
  std::vector<std::string> reliefs{};  ///< those that lose their photograph
  std::optional<Phrase> complaint{};   ///< why it cannot be renamed
};
/// Errors: as for `uses_of_stimulus`.
RenamePlan plan_of_renaming(const Study& study, const std::string& path);

/// The files that are deleted with it, itself last, and its sidecar.
std::vector<std::string> files_of_stimulus(const std::filesystem::path& study,
                                           const std::string& path);

/// Gives the stimulus another stem, as its plan states, and returns its path. The old
/// files are removed last.
///
/// Errors: PhrasedError for a name that is not valid or that another file has, for a stimulus of a stored session, for a
/// protocol that names it and is not JSON, and for a text that is edited meanwhile; ResultsError for a file that cannot be
/// read, written or removed. Everything is as before then, except if an old file cannot be removed.
std::string rename_stimulus(const Study& study, const RenamePlan& plan, const std::string& stem);
std::string rename_stimulus(const Study& study, const std::string& path, const std::string& stem);

/// Errors: PhrasedError for a stimulus that something refers to; ResultsError as for Study, and for a file that cannot be
/// removed.
void delete_stimulus(const Study& study, const std::string& path);

/// A stimulus of another study, for the choice of those to copy.
struct ForeignStimulus {
  enum class State {
    can_be_copied,
    is_there,      ///< with the same content, as all its files
    name_is_taken  ///< one of its names, by another file
  };
  std::string path{};
  /// The files that are copied, itself last: also its sidecar, its photograph NAME_photo.png, and the texture of a rendering.
  std::vector<std::string> files{};
  State state = State::can_be_copied;
};
/// By path: what `is_stimulus_file` recognises, and what a protocol of the other study names. Errors: PhrasedError for a folder without a study.
std::vector<ForeignStimulus> foreign_stimuli(const std::filesystem::path& study,
                                             const std::filesystem::path& other);

/// Writes the files of these stimuli into the study, and returns their number; no file is replaced. When a stop is requested,
/// the remaining stimuli are left out. Errors: ResultsError naming the first file that exists with another content or
/// cannot be written; stimuli before it have been copied.
int copy_stimuli(const std::filesystem::path& study, const std::filesystem::path& other,
                 const std::vector<std::string>& paths, const std::stop_token& stop = {});

}  // namespace asperity
