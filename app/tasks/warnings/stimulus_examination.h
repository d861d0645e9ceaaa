// Examines the stimuli of a protocol: the problems at which a session would fail, and the warnings about them.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session/explored_stimuli.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// The result of an examination. With problems the warnings are incomplete.
struct StimulusExamination {
  std::vector<Diagnostic> problems{};  ///< at which a session would fail in a trial
  std::vector<Diagnostic> warnings{};
};

/// Renders the stimuli of a protocol, which takes from a moment to minutes. The result consists of
///
///   `warnings_about_compute`
///   `problems_of_plugin_stimuli`
///   `warnings_about_textures`, `rehearse_with_warnings`   in a study, without a problem so far
///   `warnings_about_stimuli`                              without a problem so far
///
/// `study` is the folder of `builder`: empty without a study. The text and the files of the protocol have been checked before
/// (`check_protocol`). It depends on the text, the contents of these files, the models and, for a protocol that computes on
/// a GPU, the computer.
///
/// When a stop is requested, the result is incomplete. `course.progress` receives the progress of `warnings_about_stimuli`.
/// Errors: as StimulusBuilder; none where the files have been checked before.
StimulusExamination examine_stimuli(const CheckedProtocol& checked,
                                    const std::filesystem::path& study, StimulusBuilder& builder,
                                    const StimuliCourse& course = {});

/// Adds the result of an examination to that of a check, in the order of lines.
void add_examination(ProtocolCheck& check, const StimulusExamination& examination);

}  // namespace asperity
