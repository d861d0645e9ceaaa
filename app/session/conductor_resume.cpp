// The part of Conductor that prepares an interrupted session before it continues.

#include <iterator>
#include <string>
#include <vector>

#include "app/session/conductor.h"

namespace asperity {

/// Prepares the participant of an interrupted session for trial `first`.
void Conductor::lead_back(std::size_t first) {
  const std::vector<PlanStep>& steps = plan().steps;
  step_ = first;
  // A virtual participant needs no preparation, and answers as if there had been no interruption.
  const bool is_person = session_.row.mode != SessionMode::simulate;
  std::vector<std::string> texts = protocol_.resume.screens.value_or(std::vector<std::string>{});
  if (!protocol_.resume.screens) {
    for (std::size_t i = 0; i < first; ++i) {
      const auto* const screen = std::get_if<Protocol::Screen>(&steps[i]);
      if (screen != nullptr && holds(screen->condition)) texts = {screen->text};
    }
  }
  if (!is_person) texts.clear();
  for (const std::string& text : texts) {
    run_outside_trials([&] { let_read(scene_to_read(as_read(text))); });
  }
  // The device may be a different one now, or the same one after a fault.
  for (std::size_t i = 0; i < first; ++i) {
    if (std::holds_alternative<Protocol::Check>(steps[i])) run_other(steps[i]);
  }
  if (!is_person) return;
  refresh_practice(first);
  if (!stopped_) run_outside_trials([&] { let_read(scene_of_resuming()); });
}

/// Has the first trials of the latest practice made again, unless the session was interrupted within a practice.
void Conductor::refresh_practice(std::size_t first) {
  const auto* const last = std::get_if<TrialStep>(&plan().steps[first]);
  const int block = last == nullptr ? 0 : plan().trials[last->trial].block_ordinal;
  const int next = tally_->coming(first, block, 0, TrialTally::Again::at_once);
  if (protocol_.resume.practice_trials == 0 || next == 0) return;
  const std::deque<Trial>& trials = plan().trials;
  const auto coming = trials.begin() + (next - 1);
  if (coming->phase == Phase::practice) return;
  int practice = 0;
  for (auto trial = trials.begin(); trial != coming; ++trial) {
    if (trial->phase == Phase::practice) practice = trial->block_ordinal;
  }
  std::vector<const Trial*> repeated{};
  for (auto trial = trials.begin(); trial != coming; ++trial) {
    const bool is_practised = trial->block_ordinal == practice && tally_->is_done(*trial);
    if (is_practised && std::ssize(repeated) < protocol_.resume.practice_trials) {
      repeated.push_back(&*trial);
    }
  }
  if (repeated.empty()) return;
  run_outside_trials([&] { let_read(scene_of_refresher()); });
  is_refreshing_ = true;
  for (const Trial* const trial : repeated) {
    if (!stopped_) run_trial(*trial, AttemptPurpose::refresher);
  }
  is_refreshing_ = false;
  show_progress();
}

/// Repeats trials of earlier blocks that were invalidated to be repeated before the session was
/// interrupted.
void Conductor::resume_repeats(std::size_t first) {
  // An external program can end every track before its first trial.
  if (!session_.resumed || first >= plan().steps.size()) return;
  const TrialStep* next = std::get_if<TrialStep>(&plan().steps.at(first));
  if (next == nullptr) return;
  const int block = plan().trials[next->trial].block_ordinal;
  for (const auto& [ordinal, attempt] : tally_->those_set_aside()) {
    const Trial& trial = plan().trials.at(static_cast<std::size_t>(ordinal - 1));
    if (trial.block_ordinal < block && !tally_->is_done(trial) && !stopped_) ask_again(trial);
  }
}

}  // namespace asperity
