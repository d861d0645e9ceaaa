// Declares what can be done with the stimulus files of a study: renamed, deleted, copied from another study.

#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

// `path` is that of a file in `stimuli/`, relative to the study: "stimuli/brick.png". Its sidecar belongs to it.

/// What refers to a stimulus.
struct StimulusUses {
  std::vector<std::filesystem::path> protocols{};      ///< files of the study, never run
  std::vector<std::filesystem::path> protocols_run{};  ///< files of the study with sessions
  std::vector<std::filesystem::path> renderings{};
  bool in_sessions = false;  ///< a stored session was begun with a protocol that names it

  bool is_unused() const noexcept {
    return protocols.empty() && protocols_run.empty() && renderings.empty() && !in_sessions;
  }
  /// Rows of the store, or texts that sessions refer to, name it.
  bool is_stored() const noexcept { return in_sessions || !protocols_run.empty(); }
};
/// Errors: ResultsError as for Study, and for a file that cannot be read.
StimulusUses uses_of_stimulus(const Study& study, const std::string& path);
/// Why a stimulus with these uses cannot be renamed, or deleted; nothing where it can.
std::optional<Phrase> complaint_about_renaming(const StimulusUses& uses, const std::string& path);
std::optional<Phrase> complaint_about_deletion(const StimulusUses& uses, const std::string& path);

/// The files that are renamed with a stimulus, relative to the study: itself, its sidecar, and of NAME.png the photograph
/// NAME_photo.png if there is one.
std::vector<std::string> files_renamed_with(const std::filesystem::path& study,
                                            const std::string& path);
/// The files that are deleted and copied with it: itself and its sidecar.
std::vector<std::string> files_of_stimulus(const std::filesystem::path& study,
                                           const std::string& path);

/// Gives the stimulus another stem, in all protocols and renderings of the study as well, and returns its path. The old
/// files are removed last.
///
/// Errors: PhrasedError for a name that is not valid or that another file has, for a stimulus of a stored session, for a
/// protocol that names it and is not JSON, and for a text that is edited meanwhile; ResultsError for a file that cannot be
/// read, written or removed. Everything is as before then, except if an old file cannot be removed.
std::string rename_stimulus(const Study& study, const std::string& path, const std::string& stem);

/// Errors: PhrasedError for a stimulus that something refers to; ResultsError as for Study, and for a file that cannot be
/// removed.
void delete_stimulus(const Study& study, const std::string& path);

/// A stimulus of another study, for the choice of those to copy.
struct ForeignStimulus {
  enum class State {
    can_be_copied,
    is_there,      ///< with the same content
    name_is_taken  ///< by another file
  };
  std::string path{};
  State state = State::can_be_copied;
};
/// By path. Errors: PhrasedError for a folder without a study.
std::vector<ForeignStimulus> foreign_stimuli(const std::filesystem::path& study,
                                             const std::filesystem::path& other);

/// Writes the files of these stimuli into the study, and returns their number; no file is replaced. When a stop is requested,
/// the remaining stimuli are left out. Errors: ResultsError naming the first file that exists with another content or
/// cannot be written; stimuli before it have been copied.
int copy_stimuli(const std::filesystem::path& study, const std::filesystem::path& other,
                 const std::vector<std::string>& paths, const std::stop_token& stop = {});

}  // namespace asperity
