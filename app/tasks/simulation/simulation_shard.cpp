// Copies the study, simulates into the copy, and renames it when it is complete.

#include "app/tasks/simulation/simulation_shard.h"

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/shards/study_shard.h"
#include "app/study_files/program.h"
#include "app/tasks/simulation/simulation_declaration.h"
#include "app/tasks/work_folder.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

/// The study from which all shards are made. One that has participants would give them to each of the shards.
void require_no_participants(const Study& study) {
  if (study.participants().empty() && study.withdrawals().empty()) return;
  throw std::runtime_error(
      "the study " + study.folder().string() +
      " has participants already, and a simulation is divided only for a study "
      "without any; name a new study with the same stimuli, and merge the studies "
      "afterwards");
}

/// What every shard begins with.
void make_study(const std::filesystem::path& folder, const std::filesystem::path& whole) {
  if (Study::exists(whole)) {
    const Study study = Study::open(whole, Access::read_only);
    require_no_participants(study);
    study.copy_to(folder);
  } else {
    const std::filesystem::path path = std::filesystem::absolute(whole).lexically_normal();
    Study::create(folder, (path.has_filename() ? path : path.parent_path()).filename().string());
  }
}

/// Copies the study, complete or not at all. Where another process was first with the same shard, its study is kept.
///
/// The copy is made in a folder that no other process has, and renamed: what a killed process left on a network file system, where
/// it cannot be determined whether a process still writes it, does not keep the shard from being stored.
void publish(const std::filesystem::path& from, const std::filesystem::path& to,
             const ShardIdentity& identity) {
  const std::filesystem::path parent = std::filesystem::absolute(to).parent_path();
  make_folders(parent);
  const WorkFolder next_to(parent, to.filename().string() + ".part-", "change its permissions");
  const std::filesystem::path copy = next_to.path() / "content";
  Study::open(from, Access::read_only).copy_to(copy);
  std::error_code error{};
  std::filesystem::rename(copy, to, error);  // not onto a folder that has files
  if (!error || is_stored_study(to, identity)) return;
  throw ResultsError("the study " + to.string() + " cannot be made (" + error.message() +
                         "); change the permissions of " + parent.string() +
                         ", then simulate this shard again",
                     to, error.value());
}

}  // namespace

SimulatedShard simulate_shard(const SimulationInputs& inputs, const ModelRegistry& models,
                              const std::stop_token& stop,
                              const std::function<void(double)>& progress,
                              const std::function<void(const AttemptDone&)>& done) {
  const Shard& shard = inputs.shard.value();
  require_items(shard, static_cast<std::size_t>(inputs.participants), "participants");
  SimulatedShard simulated{.study = shard_path(inputs.study, shard)};
  const ShardIdentity identity{.whole = {.command = "simulate",
                                         .declaration = declaration_of(inputs, models),
                                         .results = static_cast<std::size_t>(inputs.participants),
                                         .program = numerical_identity()},
                               .shard = shard};
  if (is_stored_study(simulated.study, identity)) return simulated;
  const WorkFolder work("shard");
  SimulationInputs own = inputs;
  own.resume = false;
  own.study = work.path() / "study";
  make_study(own.study, inputs.study);
  simulated.result = simulate(own, models, stop, progress, done);
  write_study_shard(own.study, identity);
  publish(own.study, simulated.study, identity);
  return simulated;
}

}  // namespace asperity
