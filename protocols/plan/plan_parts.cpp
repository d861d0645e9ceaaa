// Joins the steps of a plan to parts, and the parts of a run to the run.

#include "protocols/plan/plan_parts.h"

#include <algorithm>
#include <variant>

#include "protocols/plan/level_tracks.h"

namespace asperity {

namespace {

PlanPart part_of(const Protocol& protocol, const Plan& plan, std::size_t step) {
  PlanPart part{.first_step = step,
                .duration_s = cost_of(protocol, plan, plan.steps[step]).total_s};
  if (std::holds_alternative<Protocol::Break>(plan.steps[step])) {
    part.what = PlanPart::What::pause;
  } else if (const auto* const of_trial = std::get_if<TrialStep>(&plan.steps[step])) {
    const Trial& trial = plan.trials[of_trial->trial];
    part.what = PlanPart::What::trials;
    part.block = &protocol.blocks.at(trial.block);
    part.block_ordinal = trial.block_ordinal;
    part.trials = 1;
  }
  return part;
}

std::optional<int> most_trials_of_run(const Protocol& protocol, const PlannedRun& run) {
  if (!has_variable_length(*run.block)) return {};
  // The plan has as many as there are without the criterion.
  if (run.block->until) return run.trials;
  const std::size_t anchors = run.block->has_anchors() ? run.block->anchor_places.size() : 0;
  return std::max(run.trials, static_cast<int>(most_trials_of(protocol, *run.block) + anchors));
}

}  // namespace

std::vector<PlanPart> parts_of(const Protocol& protocol, const Plan& plan) {
  std::vector<PlanPart> parts{};
  for (std::size_t step = 0; step < plan.steps.size(); ++step) {
    const PlanPart next = part_of(protocol, plan, step);
    const bool continues = !parts.empty() && parts.back().what == next.what &&
                           parts.back().block_ordinal == next.block_ordinal;
    if (!continues) {
      parts.push_back(next);
      continue;
    }
    parts.back().trials += next.trials;
    parts.back().duration_s += next.duration_s;
  }
  return parts;
}

std::vector<PlannedRun> runs_in(const Protocol& protocol, const std::vector<PlanPart>& parts) {
  std::vector<PlannedRun> runs{};
  int ordinal = 0;  // of the last run; the first has 1
  for (const PlanPart& part : parts) {
    if (part.what != PlanPart::What::trials) continue;
    if (part.block_ordinal != ordinal) runs.push_back({.block = part.block});
    ordinal = part.block_ordinal;
    runs.back().trials += part.trials;
    runs.back().duration_s += part.duration_s;
  }
  for (PlannedRun& run : runs) run.most_trials = most_trials_of_run(protocol, run);
  return runs;
}

std::size_t first_trial_step(const Plan& plan) {
  const auto first = std::find_if(plan.steps.begin(), plan.steps.end(), [](const PlanStep& step) {
    return std::holds_alternative<TrialStep>(step);
  });
  return static_cast<std::size_t>(first - plan.steps.begin());
}

bool has_variable_length(const Protocol::Block& block) {
  return block.until || !has_tracks_of_fixed_length(block);
}

}  // namespace asperity
