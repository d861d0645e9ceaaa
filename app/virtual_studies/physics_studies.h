// Simulates the studies of a power analysis on the full physics: a virtual observer feels every surface of every trial.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/power/simulated_run.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/work_folder.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

struct PhysicsInputs {
  /// The study that has the files that the protocol names. It is read once and not changed; empty where the protocol names none.
  std::filesystem::path study{};
  std::vector<int> participants{};  ///< ascending: the numbers for which studies are analysed
  int jobs = 1;                     ///< sessions that are simulated at the same time
  /// Called for each warning of the first simulation (SimulationInputs::warned); may be empty.
  std::function<void(const Diagnostic&)> warned{};
};

/// The simulated studies of a protocol.
///
/// Study number `run` is that of `asperity simulate` with the largest number of participants, the seed `simulation_seed(seed, run)` and
/// without recordings. It is made once, in a folder for temporary files, and removed when its responses are analysed: for each smaller number,
/// those of the first participants, who are the same in a study of that size. What is kept are the results of one run.
///
/// Not safe to call from several threads: a call uses `jobs` threads itself. The protocol and the registry must outlive the studies.
class PhysicsStudies final {
 public:
  /// Errors: std::runtime_error for levels that an external program states, and for files of the protocol without a study; those of
  /// WorkFolder, and of `hash_files` for files that are not in the study.
  PhysicsStudies(const Protocol& protocol, PhysicsInputs inputs, const ModelRegistry& models);

  /// Everything on which the responses depend, except the program, the seed and the runs.
  std::string declaration() const;

  /// The outcomes of one run with one of the numbers of participants. Deterministic: a function of these arguments. None where it was
  /// stopped on request. Errors: those of `simulate`.
  std::vector<SimulatedOutcome> outcomes(int participants, std::uint64_t seed, std::int64_t run,
                                         const std::stop_token& stop);

 private:
  struct Run {
    std::uint64_t seed = 0;
    std::int64_t number = 0;
    std::map<int, std::vector<SimulatedOutcome>> by_participants{};
  };

  std::filesystem::path protocol_file() const { return work_.path() / "protocol.json"; }
  std::filesystem::path origin() const { return work_.path() / "origin"; }
  SimulationInputs simulation_of(const std::filesystem::path& study, std::uint64_t seed) const;
  /// Nothing where it was stopped on request.
  std::optional<Run> simulated(std::uint64_t seed, std::int64_t run, const std::stop_token& stop);

  const Protocol& protocol_;
  PhysicsInputs inputs_;
  const ModelRegistry& models_;
  WorkFolder work_{"power"};
  std::optional<Run> last_{};
};

/// The seed of the simulation of one run.
std::uint64_t simulation_seed(std::uint64_t seed, std::int64_t run);

}  // namespace asperity
