// What will be asked, trial by trial, before the first one starts.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity {

/// How a trial is explored: what its block says, or the level of the factor that says it.
const Exploration& exploration_of(const Protocol& protocol, const Trial& trial);

/// Whether the first surfaces of two trials are one stimulus under one condition, so that numbers given
/// to them are estimates of the same.
bool are_of_one_stimulus(const Trial& one, const Trial& other);

/// Steps of a session in order. `TrialStep` indexes Plan::trials.
struct TrialStep {
  std::size_t trial = 0;
};
using PlanStep =
    std::variant<Protocol::Screen, Protocol::Check, Protocol::Break, Protocol::Ask, TrialStep>;

struct Plan {
  std::vector<Trial> trials{};
  std::vector<PlanStep> steps{};
};

/// Who a plan is for. Everything random comes from `seed`; the row picks the order of a
/// counterbalanced factor.
struct Allocation {
  std::uint64_t seed = 0;
  int counterbalance_row = 0;
};

/// The plan of one session: the same for the same protocol, seed and row, on every platform.
///
/// Errors: std::runtime_error when a constraint on the order cannot be met (a protocol that passed
/// `read_protocol` has been tried and does not throw).
Plan make_plan(const Protocol& protocol, const Allocation& allocation);

/// Every trial that a session can have, whatever is drawn: each combination once, in no order that
/// anybody is asked in.
std::vector<Trial> possible_trials(const Protocol& protocol);

/// What virtual participants take a texture for that is felt on bodies only: for each such texture
/// the first of the stimuli that show it. `body_models` are the ids of the models that need bodies.
std::map<std::string, StimulusDescription, std::less<>> stimuli_on_bodies(
    const std::vector<Trial>& possible, const std::set<std::string, std::less<>>& body_models);

/// Number of rows after which the counterbalancing repeats; 1 without counterbalancing.
int counterbalance_rows(const Protocol& protocol);

/// JSON of one planned trial, stored before the session starts and compared when it is resumed.
std::string json_of(const Trial& trial);
/// JSON of its factors alone, as it stands in that of the trial.
std::string factors_json_of(const Trial& trial);

/// What a plan amounts to, for `check` and for the person who has to sit through it.
struct PlanCost {
  int trials = 0;
  int contacts = 0;  ///< surfaces felt
  double contact_s = 0.0;
  double total_s = 0.0;
  double longest_without_break_s = 0.0;
};
PlanCost cost_of(const Protocol& protocol, const Plan& plan);

/// What to do with a block that is practised to a criterion, given the outcomes so far.
enum class BlockState { go_on, criterion_met, criterion_failed };
BlockState state_of(const Protocol::Criterion& criterion, const std::vector<bool>& correct);

}  // namespace asperity
