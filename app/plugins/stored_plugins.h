// The plug-ins of a study's sessions, as stored: what each session loaded, and what its surfaces were rendered with.

#pragma once

#include <string>
#include <vector>

#include "app/plugins/plugin_builds.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// EventRow::kind: a plug-in that the segment of the session loaded. Text: the model and its version. Data: `model`, `version`,
/// `sha256`, `file` (its name without a folder), and `declaration` with the parameters of the model.
inline constexpr const char* kPluginEvent = "plugin";

/// One event for each plug-in among the models.
std::vector<EventRow> plugin_events(const ModelRegistry& models, std::int64_t time_ns);

/// The models, and for each plug-in that sessions of the study stored and that is not loaded its last stored declaration,
/// so that protocols with it can be read. Its `make` and `band` throw std::invalid_argument, which names the plug-in.
ModelRegistry with_stored_plugins(ModelRegistry models, const Study& study);

/// The same with every stored build.
ModelBuilds with_stored_builds(ModelBuilds builds, const Study& study);

/// A sentence for each stored declaration that is damaged, and for each plug-in with which attempts of the study were rendered and that is now missing or differs.
std::vector<std::string> plugin_problems(const ModelBuilds& builds, const Study& study);

}  // namespace asperity
