// The parts of a session in their order, with their estimated durations: runs of blocks, breaks, and what is read between.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "protocols/plan/plan.h"

namespace asperity {

/// Successive steps of a plan that belong together.
struct PlanPart {
  enum class What {
    trials,   ///< of one run of a block, between two breaks
    pause,    ///< a break
    reading,  ///< texts, checks of the device and questions of the questionnaire
  };
  What what = What::reading;
  const Protocol::Block* block = nullptr;  ///< of trials; in the protocol
  int block_ordinal = 0;                   ///< of trials
  std::size_t first_step = 0;
  int trials = 0;
  double duration_s = 0.0;  ///< as PlanCost::total_s
};
/// The protocol must outlive the parts.
std::vector<PlanPart> parts_of(const Protocol& protocol, const Plan& plan);

/// One run of a block in a plan.
struct PlannedRun {
  const Protocol::Block* block = nullptr;  ///< in the protocol
  int trials = 0;
  double duration_s = 0.0;  ///< of its trials
  /// The trials of the longest run with other responses; nothing where the responses do not matter.
  std::optional<int> most_trials{};
};
/// Those that the parts of a plan consist of, in their order. The protocol must outlive them.
std::vector<PlannedRun> runs_in(const Protocol& protocol, const std::vector<PlanPart>& parts);

/// The first step of a plan that is a trial; the number of steps where there is none.
std::size_t first_trial_step(const Plan& plan);

/// Whether the responses determine how many trials a run of the block has.
bool has_variable_length(const Protocol::Block& block);

}  // namespace asperity
