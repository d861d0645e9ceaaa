// Keeps one stimulus builder for each combination of builds that rendered attempts.

#include "app/records/builders_of_attempts.h"

#include "app/session/session_compute.h"

namespace asperity {

BuildersOfAttempts::BuildersOfAttempts(const ModelBuilds& builds,
                                       std::filesystem::path study_folder)
    : builds_(builds), study_folder_(std::move(study_folder)) {}

StimulusBuilder* BuildersOfAttempts::builder_for(const AttemptRow& attempt, bool on_device) {
  const std::map<std::string, std::string> wanted = plugin_builds_of(attempt);
  if (!builds_.has(wanted)) return nullptr;
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Own>& own = own_[{wanted, on_device}];
  if (!own) {
    own = std::make_unique<Own>(builds_.with(wanted), study_folder_);
    if (on_device && !ComputeDevice::all().empty()) {
      own->builder.compute_on(compute_on_simulated_clock());
    }
  }
  return &own->builder;
}

}  // namespace asperity
