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
#include "stimuli/stimulus_description.h"

namespace asperity {

/// One surface of a trial.
struct PlannedPresentation {
  int position = 0;    ///< 1-based, the order in which the surfaces come
  std::string role{};  ///< "alternative", "target", "anchor"
  std::string item{};  ///< what it is an instance of: the model (selection) or texture it shows
  std::string code{};  ///< what blinded people see of it: "A" for the first position, then "B", …
  std::string stimulus_template{};  ///< that the stimulus fills in, as the protocol calls it
  StimulusDescription stimulus{};
  std::optional<EqualForce> equal_force{};
};

/// One option of a trial's question, in the order in which it is shown.
struct Option {
  std::string value{};  ///< stored as the answer: an item, a texture, "cannot_tell"
  std::string
      label{};  ///< shown, never a name: a presentation's code, or a picture's place from "1"
  std::optional<std::string> picture{};  ///< study-relative
};

/// The question of a trial. A choice has one answer; an assignment one per presentation, each
/// option used once; a number is above 0 and has no options.
struct TrialQuestion {
  enum class Form { choice, assignment, number };
  std::string name{};
  std::string prompt{};
  std::string experimenter_prompt{};  ///< e.g. which coded sample to place; empty: nothing to do
  /// Study-relative picture of the texture that realism is measured against, where it is shown.
  std::optional<std::string> standard_picture{};
  Form form = Form::choice;
  std::vector<Option> options{};
  bool allow_revisit = true;
  bool pictures_after_feeling = false;  ///< options stay hidden until every surface was felt
  /// The right answers: one for a choice, one per presentation (by position) for an assignment;
  /// empty where no answer is right or wrong.
  std::vector<std::string> correct{};
};

struct Trial {
  int ordinal = 0;  ///< 1-based within the session
  std::string block{};
  int block_ordinal = 0;  ///< 1-based within the session: every run of a block counts
  Phase phase = Phase::main;
  int repetition = 1;  ///< 0 of an anchor
  std::map<std::string, Level, std::less<>> factors{};
  std::vector<PlannedPresentation> presentations{};
  TrialQuestion question{};
};

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
