// Warns of attempts with another build of a loaded plug-in that has the same version.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// A build of a plug-in that rendered attempts of a protocol and is not the loaded one, although both have the same version.
struct OtherBuild {
  std::string stimulus_template{};  ///< the first one with the force model
  std::string model{};
  std::string version{};
  std::string sha256{};
  std::string loaded_sha256{};
  std::int64_t attempts = 0;

  /// A sentence without its full stop and without the remedy.
  Phrase text() const;
};
/// A sentence without its full stop.
Phrase remedy_for_builds();

/// The builds whose attempts would be analysed together with new ones: those of sessions of this name and version of the
/// protocol, of one mode or, without it, of any. Excluded sessions and participants who have withdrawn are left out.
/// Attempts are read only in a study with such builds. Errors: ResultsError.
std::vector<OtherBuild> other_builds(const CheckedProtocol& checked, const Study& study,
                                     const ModelRegistry& models, std::optional<SessionMode> mode);

/// The same as warnings, at the first stimulus with the force model.
std::vector<Diagnostic> warnings_about_plugins(const CheckedProtocol& checked, const Study& study,
                                               const ModelRegistry& models,
                                               std::optional<SessionMode> mode);

}  // namespace asperity
