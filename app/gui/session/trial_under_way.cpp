// Determines the trial from the phase and number in the snapshot, the plan and the pending requests.

#include "app/gui/session/trial_under_way.h"

#include <cstddef>

namespace asperity {

bool is_in_trial(const SessionSnapshot& snapshot) noexcept {
  return snapshot.phase == SessionPhase::fore || snapshot.phase == SessionPhase::contact ||
         snapshot.phase == SessionPhase::response;
}

const Trial* trial_now(const SessionSnapshot& snapshot, const SessionFacts* facts) {
  if (facts == nullptr || facts->plan == nullptr || snapshot.trial < 1) return nullptr;
  const auto& trials = facts->plan->trials;
  const auto number = static_cast<std::size_t>(snapshot.trial);
  return number <= trials.size() ? &trials[number - 1] : nullptr;
}

int trial_to_come(const SessionSnapshot& snapshot, const SessionFacts* facts,
                  const SessionRequests::Pending& pending) {
  if (snapshot.phase == SessionPhase::ended) return 0;
  if (is_in_trial(snapshot)) return snapshot.trial;
  if (pending.stop == StopAfter::trial) return 0;
  if (pending.repeat_last && snapshot.last_done != 0) return snapshot.last_done;
  const Trial* next = trial_now(snapshot, facts);
  if (pending.stop == StopAfter::block && next != nullptr && !snapshot.attempts->empty() &&
      next->block_ordinal != snapshot.block) {
    return 0;
  }
  return snapshot.trial;
}

}  // namespace asperity
