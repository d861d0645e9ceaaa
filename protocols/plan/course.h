// Declares the course of a session: its plan, which grows with the answers where a procedure chooses levels.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/plan/level_tracks.h"
#include "protocols/plan/plan.h"
#include "protocols/plan/trial_maker.h"

namespace asperity {

/// The input of a procedure from one trial.
struct TrialOutcome {
  /// The value of the varied parameter that was delivered, and whether the answer leads to a lower level (`correct`):
  /// the varied surface was chosen, or not chosen where the question asks for less. Nothing where there is no answer that counts for
  /// the track.
  struct Answer {
    double value = 0.0;
    LevelOutcome outcome = LevelOutcome::incorrect;
  };
  std::optional<Answer> answer{};
};

/// What a response to the judged question of a block means for the levels of its procedure. `varied_item`: the item of the surface
/// whose parameter is varied.
LevelOutcome level_outcome_of(const Protocol::Block& block,
                              const Protocol::TrialQuestionTemplate& judged,
                              const std::string& varied_item, const AnsweredItem& response);

/// The trial sequence of one session.
///
/// A session without procedures has its complete plan from the beginning. Otherwise the plan ends with the first trial
/// of a procedure: the outcome of this trial determines the next one, and so on to the end of the block, which is
/// followed by the trials of further blocks up to the next procedure.
///
/// Where a program states the levels (`External`), each of its statements has to be supplied before the plan continues;
/// until then there is no awaited trial.
///
/// A course is a function of protocol, allocation, outcomes and supplied steps. Resuming, verifying and replaying a
/// session make it again from the stored ones and compare it with the stored trials.
class Course final {
 public:
  /// The protocol must outlive the course, and `rules`, those of the protocol where many courses share them. Errors: as `make_plan`.
  Course(const Protocol& protocol, const Allocation& allocation,
         const RulesByBlock* rules = nullptr);

  /// The trials and steps that are determined so far. A reference to a trial remains valid when the plan grows.
  const Plan& plan() const noexcept { return plan_; }
  bool is_complete() const noexcept { return !tracks_; }
  /// The trial whose outcome determines what follows: the last one of the plan. Null when the plan is complete, and while
  /// a level is requested.
  const Trial* awaited() const noexcept;
  /// What a program has to state before the plan continues; nothing where nothing is missing.
  const std::optional<LevelRequest>& requested() const noexcept { return requested_; }
  /// The number of trials before the last outcome or supplied step; all of them where there was none.
  std::size_t trials_before_last_outcome() const noexcept;
  /// The step of the flow that runs this block of the session. Errors: std::out_of_range where there is none.
  const Protocol::Run& run_of(int block_ordinal) const;
  /// The matches of the blocks that match roughness and are finished, by the name of the block.
  const std::map<std::string, std::vector<RoughnessMatch>, std::less<>>& matches() const noexcept {
    return matches_;
  }
  /// The trials that can follow the awaited one, each once: that after an answer that leads to a lower level (the likeliest
  /// where there are correct answers), after one that does not, and after none. Empty where the plan is complete.
  std::vector<Trial> possible_next() const;
  /// Continues the plan after the outcome of the awaited trial.
  ///
  /// Errors: std::logic_error when the plan is complete.
  void advance(const TrialOutcome& outcome);
  /// Continues the plan with the requested step. Errors: as `LevelTracks::supply`.
  void supply(const NextStep& step);

 private:
  /// A step of the flow, or one run of a block of it.
  using Unit = std::variant<PlanStep, BlockRun>;

  void expand_flow(const Allocation& allocation);
  void expand(const Protocol::Run& run, const FactorLevels& group, const Allocation& allocation);
  void proceed();
  /// With the matches of the block that `equal_roughness` of this one names.
  BlockRun with_matches(BlockRun run) const;
  void add_block(const BlockRun& run);
  bool add_next_of_tracks();
  void add_pause(const Protocol::Run& run, std::size_t trials);
  void add_anchor_before(const BlockRun& run, std::size_t trials, std::size_t middle);
  void add_anchor(const BlockRun& run, AnchorPlace place);
  void add(Trial trial);

  const Protocol* protocol_;
  const RulesByBlock* rules_;
  Random random_;
  TrialMaker maker_;
  std::vector<Unit> units_{};
  std::size_t next_unit_ = 0;
  std::optional<LevelTracks> tracks_{};  ///< of the block that is being run
  std::optional<LevelRequest> requested_{};
  std::optional<std::size_t> trials_before_{};
  std::map<std::string, std::vector<RoughnessMatch>, std::less<>> matches_{};
  Plan plan_{};
};

/// The expected number of trials of a session, for the same observer as `example_plan`; exact where no track ends by
/// its reversals or at a bound, and the planned number of a practice to a criterion.
int expected_trials(const Protocol& protocol);
/// Whether this number is an estimate: of tracks without a fixed length, and of catch trials where the last group of
/// trials is incomplete.
bool has_estimated_trials(const Protocol& protocol);

/// The course of a session whose answers come from an observer with a threshold in the middle of the levels: for
/// estimates of durations, and to show an example of a session before it begins; the levels of an external program are
/// examples as well. Equal to `make_plan` for a protocol
/// without procedures.
Plan example_plan(const Protocol& protocol, const Allocation& allocation);

}  // namespace asperity
