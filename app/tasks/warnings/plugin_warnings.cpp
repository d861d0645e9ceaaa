// Compares the checksum of each loaded plug-in with those stored with the attempts.

#include "app/tasks/warnings/plugin_warnings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace asperity {
namespace {

/// The first stimulus of each force model that is a loaded plug-in.
std::map<std::string, std::string> stimuli_of_plugins(const CheckedProtocol& checked,
                                                      const ModelRegistry& models) {
  std::map<std::string, std::string> stimuli{};
  const bool has_plugins =
      std::any_of(models.models().begin(), models.models().end(),
                  [](const ForceModel& model) { return model.plugin.has_value(); });
  if (!has_plugins) return stimuli;
  for (const auto& [trial, planned] : checked.presentations()) {
    const ForceModel* const model = models.find(planned.stimulus.model);
    if (model == nullptr || !model->plugin) continue;
    stimuli.try_emplace(planned.stimulus.model, planned.stimulus_template);
  }
  return stimuli;
}

std::vector<SessionRow> sessions_analysed_together(const Protocol& protocol, const Study& study,
                                                   std::optional<SessionMode> mode) {
  std::set<std::int64_t> protocols{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == protocol.name && row.version == protocol.version) protocols.insert(row.id);
  }
  std::vector<SessionRow> sessions = study.sessions();
  std::erase_if(sessions, [&](const SessionRow& session) {
    return session.withdrawn || session.excluded || !protocols.contains(session.protocol_id) ||
           (mode && session.mode != *mode);
  });
  return sessions;
}

bool is_rendered_by(const OtherBuild& build, const AttemptRow& attempt) {
  return std::any_of(attempt.presentations.begin(), attempt.presentations.end(),
                     [&build](const PresentationRow& surface) {
                       return surface.model == build.model &&
                              surface.model_version == build.version &&
                              asset_sha256(surface.assets, kPluginRole) == build.sha256;
                     });
}

}  // namespace

Phrase OtherBuild::text() const {
  return phrase("PluginBuilds",
                "the study has attempts of this protocol with another build of the plug-in of the "
                "force model %1, version %2 (attempts: %3, SHA-256: %4; the loaded plug-in has the "
                "SHA-256 %5); they would be analysed together with new ones")
      .with(model, version, std::to_string(attempts), sha256, loaded_sha256);
}

Phrase remedy_for_builds() {
  return phrase("PluginBuilds",
                "raise the version of the plug-in if its forces have changed, or load the build "
                "that rendered the attempts");
}

std::vector<OtherBuild> other_builds(const CheckedProtocol& checked, const Study& study,
                                     const ModelRegistry& models, std::optional<SessionMode> mode) {
  std::vector<OtherBuild> builds{};
  const std::map<std::string, std::string> stimuli = stimuli_of_plugins(checked, models);
  if (stimuli.empty()) return builds;
  for (const PluginUse& use : study.plugin_uses()) {
    const auto stimulus = stimuli.find(use.model);
    if (stimulus == stimuli.end()) continue;
    const ForceModel& loaded = *models.find(use.model);
    if (loaded.declaration.version != use.model_version || loaded.plugin->sha256 == use.sha256) {
      continue;
    }
    builds.push_back({.stimulus_template = stimulus->second,
                      .model = use.model,
                      .version = use.model_version,
                      .sha256 = use.sha256,
                      .loaded_sha256 = loaded.plugin->sha256});
  }
  if (builds.empty()) return builds;
  for (const SessionRow& session : sessions_analysed_together(checked.protocol, study, mode)) {
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      for (OtherBuild& build : builds) build.attempts += is_rendered_by(build, attempt) ? 1 : 0;
    }
  }
  std::erase_if(builds, [](const OtherBuild& build) { return build.attempts == 0; });
  return builds;
}

std::vector<Diagnostic> warnings_about_plugins(const CheckedProtocol& checked, const Study& study,
                                               const ModelRegistry& models,
                                               std::optional<SessionMode> mode) {
  std::vector<Diagnostic> warnings{};
  for (const OtherBuild& build : other_builds(checked, study, models, mode)) {
    warnings.push_back(checked.at_stimulus(
        build.stimulus_template, Phrase("%1; %2").with(build.text(), remedy_for_builds())));
  }
  return warnings;
}

}  // namespace asperity
