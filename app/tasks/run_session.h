// Running sessions: one person's, one virtual participant's, or many virtual ones.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/conductor/conductor.h"
#include "device/simulated_device.h"
#include "renderers/force_model.h"

namespace asperity {

using DoneSink = std::function<void(const AttemptDone&)>;

enum class Recordings { all, first, none };

struct SimulationInputs {
  std::vector<std::filesystem::path> protocols{};
  std::filesystem::path study{};
  int participants = 1;
  std::uint64_t seed = 1;
  int jobs = 1;
  Recordings recordings = Recordings::first;
  /// Go on with an interrupted simulation of the same arguments instead of adding participants.
  bool resume = false;
};

struct SimulationResult {
  int sessions = 0;
  int attempts = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;
};

/// Adds virtual participants to a study (created if it does not exist), each doing every protocol
/// in the given order, once per session that the protocol declares.
///
/// Deterministic in the seed, whatever `jobs`: labels, seeds, counterbalance rows and clocks are
/// dealt out before the first session begins. When it is stopped, sessions under way end after
/// their trial and can be resumed.
///
/// Errors: ProtocolError, ResultsError, std::runtime_error (a session that was stopped by a fault).
SimulationResult simulate(const SimulationInputs& inputs, const ModelRegistry& models,
                          const std::stop_token& stop, const std::function<void(double)>& progress,
                          const DoneSink& done);

enum class RunPacing { stepped, real_time };

struct RunInputs {
  std::filesystem::path protocol{};
  std::filesystem::path study{};
  std::string participant{};
  std::uint64_t seed = 0;
  SessionMode mode = SessionMode::run;
  bool resume = false;
  bool is_virtual = false;
  RunPacing pacing = RunPacing::real_time;
  std::vector<ScriptedFault> faults{};  ///< of the simulated device
};

/// One session. `respondent` is null for a virtual participant.
///
/// The participant is added when new; a person's questions are asked first. `stop` asks the session
/// to end after the trial under way.
///
/// Errors: as `simulate`.
SessionEnd run_session(const RunInputs& inputs, const ModelRegistry& models, Respondent* respondent,
                       const std::stop_token& stop, const DoneSink& done);

}  // namespace asperity
