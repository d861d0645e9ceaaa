// Makes the stimuli of recorded attempts with the builds of plug-ins that rendered them.

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "app/plugins/plugin_builds.h"
#include "app/session/stimulus_builder.h"
#include "results_schema/rows.h"

namespace asperity {

/// Builders of stimuli, each made once for the builds of plug-ins that rendered attempts; with the compute device of this
/// machine for attempts that were computed on one.
///
/// Threads: any.
class BuildersOfAttempts final {
 public:
  /// `builds` must outlive this object.
  BuildersOfAttempts(const ModelBuilds& builds, std::filesystem::path study_folder);

  /// Null if a build is not there. Lives as long as this object.
  StimulusBuilder* builder_for(const AttemptRow& attempt, bool on_device);

 private:
  struct Own {
    Own(ModelRegistry registry, const std::filesystem::path& study_folder)
        : models(std::move(registry)), builder(models, study_folder) {}
    ModelRegistry models;
    StimulusBuilder builder;
  };
  const ModelBuilds& builds_;
  std::filesystem::path study_folder_{};
  std::mutex mutex_{};
  std::map<std::pair<std::map<std::string, std::string>, bool>, std::unique_ptr<Own>> own_{};
};

}  // namespace asperity
