// Simulates one shard of the participants of a simulation, into a study of its own.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>

#include "app/tasks/simulation/simulation.h"

namespace asperity {

struct SimulatedShard {
  std::filesystem::path study{};
  /// Nothing where the study existed: an earlier command simulated this shard.
  std::optional<SimulationResult> result{};
};

/// Simulates the participants of `inputs.shard`, which must be set, into the new study `shard_path(inputs.study, shard)`. Labels,
/// seeds, counterbalance rows, groups and clocks are those of the whole simulation, so that the rows of all shards together are
/// those of the undivided one. The study also contains the files of `inputs.study`, which is not changed; if there is none, the
/// shard is a new study. `inputs.resume` is ignored.
///
/// Works in a folder of the system for temporary files (TMPDIR), and appears under its name when it is complete: sessions
/// cannot be stored on a network file system, and of two processes with the same shard neither disturbs the other.
///
/// Errors: as `simulate`; std::runtime_error for a study that has participants, or withdrawals, already, and as
/// `is_stored_study`; std::invalid_argument for more shards than participants.
SimulatedShard simulate_shard(const SimulationInputs& inputs, const ModelRegistry& models,
                              const std::stop_token& stop,
                              const std::function<void(double)>& progress,
                              const std::function<void(const AttemptDone&)>& done);

}  // namespace asperity
