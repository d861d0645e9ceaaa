// Protocol files as the program meets them: on disk, against the force models that there are.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/rehearsal/rehearsal.h"
#include "app/session/stimulus_builder.h"
#include "app/words/phrase.h"
#include "device/device_capability.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"

namespace asperity {

class Study;

/// Reads and checks a protocol file. A name without a file is looked for in the study's
/// `protocols/`.
///
/// Errors: ProtocolError; ResultsError when there is no such file.
Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study);

/// The same for a protocol that is about to run: the files that it names are looked at as well, and
/// its stimuli are rehearsed.
///
/// Errors: ProtocolError with every file that is not there, not in the study (a link may lead out
/// of it), no height field, no picture or no WAV, or else with what `rehearse` finds; otherwise as
/// above. What `memory` (null: none) has found without problems is not rehearsed again.
Protocol load_protocol_to_run(const std::filesystem::path& file, const std::filesystem::path& study,
                              StimulusBuilder& builder, RehearsalMemory* memory = nullptr);

/// What a session would fail at in a trial: every stimulus of two bodies is made once as in a
/// session, and the simulated device's hand strokes where it should be until it touches it. A second
/// or two. The files have been looked at.
std::vector<Diagnostic> rehearse(const Protocol& protocol, const std::string& file_name,
                                 StimulusBuilder& builder);

/// The same, and what is rendered otherwise than the model promises: of every stimulus that the hand
/// touches, a doubt for each limit of the model that counts half of the contact or more, with the
/// texture and, of `fine_detail`, both numbers. The hand strokes on for 20 ms: what a stimulus is beyond
/// in other places or under a hand that presses is not reported.
struct RehearsedStimuli {
  std::vector<Diagnostic> problems{};
  std::vector<Diagnostic> doubts{};
};
RehearsedStimuli rehearse_with_doubts(const Protocol& protocol, const std::string& file_name,
                                      StimulusBuilder& builder);

/// Every problem of one file, and a summary of its plan when there is none.
struct ProtocolCheck {
  std::string file{};
  std::vector<Diagnostic> diagnostics{};  ///< of all layers, in the order of lines
  std::vector<Diagnostic>
      warnings{};  ///< of what has the form of a protocol (`doubts_about`), in the order of lines
  std::optional<Protocol> protocol{};
  PlanCost cost{};
};

/// Never throws because of the file's content. With a study, the files that the protocol names are looked
/// for and the height fields read; with a device, its capability is compared.
ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device);
/// The same for a text that need not be on disk. `file_name` names the file in its problems.
ProtocolCheck check_protocol_text(const std::string& text, const std::string& file_name,
                                  const ModelRegistry& models,
                                  const std::optional<std::filesystem::path>& study,
                                  const std::optional<std::string>& device);

/// Sessions of people that were run with this protocol's name and version, but with another text.
struct VersionUse {
  std::string version{};
  int sessions = 0;
};
/// Nothing where there are none, or the text says no name and version. Errors: ResultsError as
/// Study's.
std::optional<VersionUse> other_text_of_version(const Study& study, const std::string& text);

/// What a protocol asks for that a device cannot do, a sentence each.
std::vector<Phrase> complaints_about_device(const Protocol& protocol,
                                            const DeviceCapability& device);

/// What is wrong with a label that is to become part of file names; nothing when it is acceptable.
/// Labels that begin with "virtual" are kept for virtual participants.
std::optional<Phrase> complaint_about_label(const std::string& label, bool is_virtual);

}  // namespace asperity
