// Compares the rules for breaks with the longest runs of a plan, and the length of matchings.

#include "protocols/warnings/plan_warnings.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

namespace {

/// A matching of roughness precedes the comparison that it makes fair; a longer one would tire the hand.
constexpr double kLongestMatching_s = 600.0;

struct RunSize {
  int trials = 0;
  double contact_s = 0.0;
  double total_s = 0.0;  ///< with the breaks between its trials
};

/// The largest run of every block.
std::map<std::string, RunSize, std::less<>> largest_runs(const Protocol& protocol,
                                                         const Plan& example) {
  std::map<int, RunSize> runs{};  // by ordinal
  std::map<int, std::string> blocks{};
  double pause_s = 0.0;
  int last = 0;
  for (const PlanStep& step : example.steps) {
    if (const auto* const pause = std::get_if<Protocol::Break>(&step)) pause_s += pause->minimum_s;
    const auto* const of_trial = std::get_if<TrialStep>(&step);
    if (of_trial == nullptr) continue;
    const Trial& trial = example.trials[of_trial->trial];
    RunSize& run = runs[trial.block_ordinal];
    if (trial.block_ordinal == last) run.total_s += pause_s;
    pause_s = 0.0;
    last = trial.block_ordinal;
    ++run.trials;
    const PlanCost cost = cost_of(protocol, example, step);
    run.contact_s += cost.contact_s;
    run.total_s += cost.total_s;
    blocks[trial.block_ordinal] = trial.block;
  }
  std::map<std::string, RunSize, std::less<>> largest{};
  for (const auto& [ordinal, run] : runs) {
    RunSize& known = largest[blocks[ordinal]];
    known.trials = std::max(known.trials, run.trials);
    known.contact_s = std::max(known.contact_s, run.contact_s);
    known.total_s = std::max(known.total_s, run.total_s);
  }
  return largest;
}

}  // namespace

std::vector<Diagnostic> warnings_about_plan(const Protocol& protocol, const std::string& file_name,
                                            const Plan& example) {
  const JsonDocument document(protocol.source, file_name);
  const auto largest = largest_runs(protocol, example);
  std::vector<Diagnostic> warnings{};
  for (std::size_t i = 0; i < protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Protocol::Run>(&protocol.flow[i]);
    if (run == nullptr || !largest.contains(run->block)) continue;
    // A break may come in some sessions.
    if (!has_tracks_of_fixed_length(protocol.blocks.at(run->block))) continue;
    const RunSize& size = largest.at(run->block);
    const std::string place = pointer_to("/flow", i);
    if (run->break_every_trials >= size.trials) {
      warnings.push_back(document.at(
          place + "/break_every_trials",
          (size.trials == 1
               ? phrase("Protocols",
                        "a run of the block %1 has %2 trial, so that there is no break after %3; "
                        "state a smaller number, or remove the key")
               : phrase("Protocols",
                        "a run of the block %1 has %2 trials, so that there is no break after %3; "
                        "state a smaller number, or remove the key"))
              .with(in_quotes(run->block), std::to_string(size.trials),
                    std::to_string(run->break_every_trials))));
    }
    if (run->break_every_contact_s >= size.contact_s && run->break_every_contact_s > 0.0) {
      warnings.push_back(
          document.at(place + "/break_every_contact_minutes",
                      phrase("Protocols",
                             "a run of the block %1 takes about %2 min of contact, so that there "
                             "is no break after %3 min; state a smaller number, or remove the key")
                          .with(in_quotes(run->block), fixed(size.contact_s / 60.0, 1),
                                number_text(run->break_every_contact_s / 60.0))));
    }
  }
  for (const auto& [name, size] : largest) {
    const Protocol::Block& block = protocol.blocks.at(name);
    if (!matches_roughness(protocol, block)) continue;
    if (size.total_s <= kLongestMatching_s) continue;
    warnings.push_back(document.at(
        pointer_to("/blocks", name) + (block.procedure ? "/procedure" : ""),
        phrase("Protocols",
               "matching roughness takes about %1 min of each participant, more than %2 min, after "
               "which the comparison itself has still to be made; reduce the trials of a track, "
               "the stimuli or the exploration")
            .with(fixed(size.total_s / 60.0, 0), fixed(kLongestMatching_s / 60.0, 0))));
  }
  int practised = 0;
  for (const auto& [name, size] : largest) {
    if (protocol.blocks.at(name).phase == Phase::practice) {
      practised = std::max(practised, size.trials);
    }
  }
  if (practised > 0 && protocol.resume.practice_trials > practised) {
    warnings.push_back(document.at(
        "/resume/practice_trials",
        (practised == 1 ? phrase("Protocols",
                                 "a practice block has at most %1 trial, so that no more can be "
                                 "repeated when a session is resumed; state %1 or fewer")
                        : phrase("Protocols",
                                 "a practice block has at most %1 trials, so that no more can be "
                                 "repeated when a session is resumed; state %1 or fewer"))
            .with(std::to_string(practised))));
  }
  return warnings;
}

}  // namespace asperity
