// Declares the plan of a session: its trials and the steps between them.

#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity {

/// The exploration of a trial, from its block or from the level of the block's exploration factor.
const Exploration& exploration_of(const Protocol& protocol, const Trial& trial);

/// Whether the first surfaces of two trials are the same stimulus under the same condition, so that their estimates are
/// repeated measurements.
bool are_of_one_stimulus(const Trial& one, const Trial& other);

/// The steps of a session in order. `TrialStep` indexes Plan::trials.
struct TrialStep {
  std::size_t trial = 0;
};
using PlanStep =
    std::variant<Protocol::Screen, Protocol::Check, Protocol::Break, Protocol::Ask, TrialStep>;

struct Plan {
  std::deque<Trial> trials{};  ///< references remain valid when trials are added (Course)
  std::vector<PlanStep> steps{};
  int blocks =
      0;  ///< runs of blocks in the complete session, also those whose trials are not yet known
};

/// The allocation of a plan. All random choices derive from `seed`; the row determines the order of a counterbalanced
/// factor.
struct Allocation {
  std::uint64_t seed = 0;
  int counterbalance_row = 0;
  std::string group{};  ///< of the participant (groups.h); empty: the first one, if there are any
};

/// Makes the plan of one session: the same for the same protocol, seed, row and group, on every platform. Groups differ
/// only in the level of their factor and in the screens that they read. With procedures the plan up to the first trial whose answer determines the next
/// one (Course).
///
/// Errors: std::runtime_error if a constraint on the order cannot be met. This does not occur for a protocol from
/// `read_protocol`, which has tried it. Also for a group that the protocol does not have.
Plan make_plan(const Protocol& protocol, const Allocation& allocation);

/// All trials that can occur in a session for any seed and any answers: each combination once, in an arbitrary order.
std::vector<Trial> possible_trials(const Protocol& protocol);

/// The stimuli by which virtual participants know textures that are felt on bodies only: for each such texture the
/// first stimulus that shows it. `body_models` are the ids of the models that need bodies.
std::map<std::string, StimulusDescription, std::less<>> stimuli_on_bodies(
    const std::vector<Trial>& possible, const std::set<std::string, std::less<>>& body_models);

/// Number of rows after which the counterbalancing repeats; 1 without counterbalancing.
int counterbalance_rows(const Protocol& protocol);

/// The JSON of one planned trial, which is stored before the session starts and compared when it is resumed.
std::string json_of(const Trial& trial);
/// The JSON of the trial's factors alone, identical to that part of the trial's JSON.
std::string factors_json_of(const Trial& trial);
/// The place of an anchor in the run of its block, as the JSON of its trial states it: one that states none is at the start.
AnchorPlace anchor_place_in(const nlohmann::json& trial);

/// The duration and size of a plan, for `check` and for the experimenter.
struct PlanCost {
  int trials = 0;
  int contacts = 0;  ///< surfaces felt
  double contact_s = 0.0;
  double total_s = 0.0;
  double longest_without_break_s = 0.0;
  double breaks_after_contact_s =
      0.0;  ///< part of the total: breaks that the plan does not contain
};
PlanCost cost_of(const Protocol& protocol, const Plan& plan);
/// The same of one step of the plan.
PlanCost cost_of(const Protocol& protocol, const Plan& plan, const PlanStep& step);
/// The same of the steps from `first` on.
PlanCost cost_from(const Protocol& protocol, const Plan& plan, std::size_t first);

/// The state of a practice block with a criterion, given the outcomes so far.
enum class BlockState { go_on, criterion_met, criterion_failed };
BlockState state_of(const Protocol::Criterion& criterion, const std::vector<bool>& correct);

}  // namespace asperity
