// Runs many virtual participants through a study.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/conductor.h"
#include "app/shards/shard.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"

namespace asperity {

enum class Recordings { all, first, none };

/// Participants with the same seed that a study already has when others are added.
struct SameSeed {
  int there = 0;
  std::string first{};  ///< label of the first added participant
  std::string last{};
};

struct SimulationInputs {
  std::vector<std::filesystem::path> protocols{};
  std::filesystem::path study{};
  int participants = 1;
  std::uint64_t seed = 1;
  int jobs = 1;
  Recordings recordings = Recordings::first;
  std::string device = "simulated";  ///< or one of its models, as in RunInputs::device
  /// States the levels of the procedure `external`; of protocols without it, it is not started.
  std::optional<ExternalProgram> level_program{};
  /// As RunInputs::on_gpu, for all protocols.
  std::optional<bool> on_gpu{};
  /// Resume the interrupted simulation of the same seed and number of participants, or begin it in
  /// a study that has no virtual participants yet. Otherwise such a simulation is rejected.
  bool resume = false;
  /// Add and simulate the participants of this shard only; those of the whole simulation are the items. The study has no
  /// participants yet, and is discarded if the simulation fails or is stopped: `simulate_shard`.
  std::optional<Shard> shard{};
  /// Called before participants are added to others with the same seed; may be empty.
  std::function<void(const SameSeed&)> noticed{};
  /// Called before participants are added for each warning about a protocol: sessions with another text of the same
  /// version (`warning_about_version`) or another build of a plug-in (`warnings_about_plugins`), and stimuli
  /// (`warnings_about_stimuli`); may be empty.
  std::function<void(const Diagnostic&)> warned{};
};

/// Of the sessions that were begun or resumed in this run.
struct SimulationResult {
  int sessions = 0;
  int attempts = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;
};

/// A session was stopped by a fault: every completed trial is stored, and the simulation can be resumed.
class SimulationStopped final : public PhrasedError {
 public:
  using PhrasedError::PhrasedError;
};

/// Adds virtual participants to a study (created if it does not exist), each completing every
/// protocol in the given order, once per session that the protocol declares.
///
/// Deterministic in the seed, independent of `jobs`: labels, seeds, counterbalance rows and clocks
/// are assigned before the first session begins. When it is stopped, current sessions end after
/// their trial and can be resumed; each participant's row states the simulation that it belongs to.
///
/// `progress` and `done` may be empty. Both are called from the jobs' threads.
///
/// Errors: ProtocolError, ResultsError, SimulationStopped, std::runtime_error (a device that is not simulated; nothing to
/// resume; an interrupted simulation of the same seed, number of participants and protocols, without `resume`).
SimulationResult simulate(const SimulationInputs& inputs, const ModelRegistry& models,
                          const std::stop_token& stop, const std::function<void(double)>& progress,
                          const std::function<void(const AttemptDone&)>& done);

}  // namespace asperity
