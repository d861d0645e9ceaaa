// Reads protocol files and checks them against the force models, the study's files and a device.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/rehearsal/rehearsal_memory.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "app/words/phrase.h"
#include "device/device_capability.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"

namespace asperity {

class Study;

/// A name without a file is looked up in the study's `protocols/`; without a file there, the name itself.
std::filesystem::path found_protocol(const std::filesystem::path& file,
                                     const std::optional<std::filesystem::path>& study);

/// Reads and checks the protocol that `found_protocol` finds; for the file of a translation, the protocol in its language
/// (protocol_languages.h).
///
/// Errors: ProtocolError; ResultsError when there is no such file.
Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study);

/// The same for a protocol that is about to run: the files that it names are checked as well, and
/// its stimuli are rehearsed.
///
/// Errors: ProtocolError with every file that does not exist, is not in the study (through a link),
/// or is not a height field, picture or WAV as required, or otherwise with the problems found by
/// `problems_of_plugin_stimuli` or `rehearse`; other errors as for `load_protocol`. Stimuli that `memory` (null: none) has as free
/// of problems are not rehearsed again.
Protocol load_protocol_to_run(const std::filesystem::path& file, const std::filesystem::path& study,
                              StimulusBuilder& builder, RehearsalMemory* memory = nullptr);

/// Finds the problems at which a session would fail in a trial: every stimulus of two bodies is
/// made once as in a session, and the simulated device's hand strokes at its place until it touches
/// it. Takes a second or two. The files have been checked before.
std::vector<Diagnostic> rehearse(const CheckedProtocol& checked, StimulusBuilder& builder);

/// The same, with the stimuli that violate an assumption of their model: for every stimulus that
/// the hand touches, a warning for each assumption that is violated in at least half of the
/// contact, with the texture and, for `fine_detail`, both numbers. The stroke continues for 20 ms
/// after the first contact: violations in other places or under a pressing hand are not
/// reported. When a `stop` is requested, the remaining stimuli are left out.
struct RehearsedStimuli {
  std::vector<Diagnostic> problems{};
  std::vector<Diagnostic> warnings{};
};
RehearsedStimuli rehearse_with_warnings(const CheckedProtocol& checked, StimulusBuilder& builder,
                                        const std::stop_token& stop = {});

/// Every problem of one file, and a summary of its plan when there is none.
struct ProtocolCheck {
  std::string file{};
  std::vector<Diagnostic> diagnostics{};  ///< from all layers, in the order of lines
  std::vector<Diagnostic>
      warnings{};  ///< about content that is formally valid (`warnings_about`), in the order of lines
  std::optional<Protocol> protocol{};
  PlanCost cost{};
  /// The design of each main block that has one in words (`design_of`), by the name of the block.
  std::map<std::string, std::string> designs{};

  bool is_valid() const noexcept { return protocol && diagnostics.empty(); }
};

/// Never throws because of the file's content. A translation that cannot be used is a problem of its own file, and a
/// warning about the protocol's. With a study, the files that the protocol names are
/// looked up and the height fields read; with a simulated device, its capability is compared.
/// Errors: those of `simulated_settings` for the name of the device, which are no problems of the protocol.
ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device);
/// The same for a text that need not be on disk. `file_name` names the file in its problems.
ProtocolCheck check_protocol_text(const std::string& text, const std::string& file_name,
                                  const ModelRegistry& models,
                                  const std::optional<std::filesystem::path>& study,
                                  const std::optional<std::string>& device);

/// The sessions that are counted as uses of a protocol.
enum class SessionsOf { people, everybody };
/// Sessions that were run with this protocol's name and version, but with another text. The same
/// protocol in another language is not another text.
struct VersionUse {
  std::string version{};
  int sessions = 0;
};
/// Nothing where there are none, or where the text contains no name and version. Errors:
/// ResultsError as for Study.
std::optional<VersionUse> other_text_of_version(const Study& study, const std::string& text,
                                                SessionsOf counted = SessionsOf::people);
/// The warning that such sessions, those of virtual participants included, are analysed together with
/// new ones, at the key "version": analyses select sessions by name and version, and only the SHA-256 of the
/// protocol distinguishes them. Errors as for `other_text_of_version`.
std::optional<Diagnostic> warning_about_version(const Protocol& protocol,
                                                const std::string& file_name, const Study& study);

/// The warnings about sessions of the study that are analysed together with new ones: of another text of this version, and
/// with another build of a plug-in. Errors: ResultsError as for Study.
std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked, const Study& study,
                                                const ModelRegistry& models);
/// The same for the study in a folder; none where there is no study. If it cannot be read, a warning at the key "version"
/// states this: the protocol can be checked all the same.
std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked,
                                                const std::filesystem::path& study,
                                                const ModelRegistry& models);

/// The requirements of a protocol that a device does not meet, a sentence each.
std::vector<Phrase> complaints_about_device(const Protocol& protocol,
                                            const DeviceCapability& device);

/// The problem of a label that is to become part of file names; nothing when it is acceptable.
/// Labels that begin with "virtual" are reserved for virtual participants.
std::optional<Phrase> complaint_about_label(const std::string& label, bool is_virtual);

}  // namespace asperity
