// Estimates the pace from the duration of completed trials and the costs of the planned ones.

#include "app/session/session_progress.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/session/trial_outcome.h"
#include "app/words/coded_phrases.h"

namespace asperity {

namespace {

double duration_s(const AttemptRow& attempt) {
  return static_cast<double>(attempt.offset_ns - attempt.onset_ns) * 1e-9;
}

/// Whether there are breaks that the plan does not contain.
bool rests_after_contact(const Protocol& protocol) {
  return std::any_of(protocol.flow.begin(), protocol.flow.end(), [](const Protocol::Step& step) {
    const auto* const run = std::get_if<Protocol::Run>(&step);
    return run != nullptr && run->break_every_contact_s > 0.0;
  });
}

}  // namespace

SessionProgress::SessionProgress(SessionCourse& course, const Course& trials,
                                 const TrialTally& tally, std::int64_t began_ns)
    : course_(course), trials_(trials), plan_(trials.plan()), tally_(tally) {
  if (!course_.has_monitor()) return;
  course_.update([&](SessionSnapshot& snapshot) {
    snapshot.began_ns = began_ns;
    snapshot.trouble.reset();
  });
  extend();
  for (const AttemptRow& attempt : tally_.attempts()) course_.add_attempt(summary_of(attempt));
  show(0, tally_.coming(0, 0, 0, TrialTally::Again::at_once));
}

void SessionProgress::extend() {
  if (!course_.has_monitor()) return;
  trial_s_.resize(plan_.trials.size());
  for (std::size_t i = planned_s_.size(); i < plan_.steps.size(); ++i) {
    planned_s_.push_back(cost_of(course_.protocol(), plan_, plan_.steps[i]).total_s);
    if (const auto* of_trial = std::get_if<TrialStep>(&plan_.steps[i])) {
      trial_s_.at(of_trial->trial) = planned_s_.back();
    }
  }
  const std::optional<int> last = course_.last_trial();
  const int blocks = course_.last_shown_block(plan_);
  course_.update([&](SessionSnapshot& snapshot) {
    snapshot.blocks = blocks;
    snapshot.trials = static_cast<int>(plan_.trials.size()) + unknown_trials();
    snapshot.trials_are_estimated = !trials_.is_complete();
    if (last && *last <= snapshot.trials) {
      snapshot.trials = *last;
      snapshot.trials_are_estimated = false;
    }
  });
}

int SessionProgress::unknown_trials() const {
  if (trials_.is_complete()) return 0;
  return std::max(
      0, course_.row().expected_trials.value_or(0) - static_cast<int>(plan_.trials.size()));
}

void SessionProgress::add(const AttemptRow& attempt, std::size_t step, int coming) {
  if (course_.has_monitor()) publish(step, coming, summary_of(attempt));
}

void SessionProgress::show(std::size_t step, int coming) {
  if (course_.has_monitor()) publish(step, coming, {});
}

void SessionProgress::set_aside(const AttemptRow& attempt) {
  course_.update([&](SessionSnapshot& snapshot) {
    auto attempts = std::make_shared<std::vector<AttemptSummary>>(*snapshot.attempts);
    for (AttemptSummary& summary : *attempts) {
      if (summary.trial != attempt.trial || summary.attempt != attempt.attempt) continue;
      summary.valid = false;
      summary.reason = phrase_of(attempt.invalid_reason);
    }
    snapshot.attempts = std::move(attempts);
  });
}

/// Updates everything at once: no snapshot shows an attempt as done whose trial is still current.
void SessionProgress::publish(std::size_t step, int coming, std::optional<AttemptSummary> added) {
  int done = 0;
  int not_needed = 0;
  double trials_left_s = 0.0;
  // Breaks and screens, whose duration does not depend on the pace.
  double others_left_s = 0.0;
  if (rests_after_contact(course_.protocol())) {
    others_left_s = cost_from(course_.protocol(), plan_, step).breaks_after_contact_s;
  }
  for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
    if (const auto* of_trial = std::get_if<TrialStep>(&plan_.steps[i])) {
      const Trial& trial = plan_.trials[of_trial->trial];
      if (tally_.is_done(trial) || tally_.is_over(trial)) {
        ++done;
        if (!tally_.is_done(trial)) ++not_needed;
      } else {
        trials_left_s += planned_s_[i];
      }
    } else if (i > step) {
      others_left_s += planned_s_[i];
    }
  }
  if (const int unknown = unknown_trials(); unknown > 0 && !trial_s_.empty()) {
    trials_left_s += unknown * trial_s_.back();
  }
  std::optional<double> left_s = others_left_s;
  if (trials_left_s > 0.0) {
    left_s = pace();
    if (left_s) *left_s = *left_s * trials_left_s + others_left_s;
  }
  if (const auto end = course_.last_trial(); end && coming > *end) coming = 0;
  const AttemptRow* last = tally_.last_done();
  const bool is_refresher = added && added->purpose == AttemptPurpose::refresher;
  course_.update([&](SessionSnapshot& snapshot) {
    if (added) {
      auto attempts = std::make_shared<std::vector<AttemptSummary>>(*snapshot.attempts);
      attempts->push_back(std::move(*added));
      snapshot.attempts = std::move(attempts);
      // The next phase is unknown here; it is stored when it begins.
      snapshot.phase = SessionPhase::iti;
      snapshot.phase_began_ns = snapshot.now_ns;
    }
    if (!is_refresher) {
      snapshot.trial = coming;
      snapshot.attempt = coming == 0 ? 0 : tally_.attempts_at(coming) + 1;
      snapshot.purpose = AttemptPurpose::trial;
    }
    snapshot.last_done = last == nullptr ? 0 : last->trial;
    snapshot.trials_done = done;
    snapshot.trials_not_needed = not_needed;
    snapshot.expected_left_s = left_s;
    snapshot.rows_stored = static_cast<std::int64_t>(tally_.attempts().size());
  });
}

/// Skipped trials provide no information, and neither do refreshers, which are not planned.
std::optional<double> SessionProgress::pace() const {
  constexpr int kFewest = 3;  // too few trials give no reliable pace
  int done = 0;
  double planned_s = 0.0;
  double spent_s = 0.0;
  for (const AttemptRow& attempt : tally_.attempts()) {
    if (attempt.outcome == AttemptOutcome::skipped) continue;
    if (attempt.purpose == AttemptPurpose::refresher) continue;
    spent_s += duration_s(attempt);
    if (!attempt.valid) continue;
    planned_s += trial_s_.at(static_cast<std::size_t>(attempt.trial - 1));
    ++done;
  }
  if (done < kFewest || planned_s <= 0.0) return {};
  return spent_s / planned_s;
}

AttemptSummary SessionProgress::summary_of(const AttemptRow& attempt) const {
  const auto index = static_cast<std::size_t>(attempt.trial - 1);
  const Trial& trial = plan_.trials.at(index);
  AttemptSummary summary{};
  summary.trial = attempt.trial;
  summary.attempt = attempt.attempt;
  summary.purpose = attempt.purpose;
  summary.outcome = attempt.outcome;
  summary.valid = attempt.valid;
  summary.flagged = attempt.flagged;
  summary.reason = phrase_of(attempt.valid ? attempt.flag_reason : attempt.invalid_reason);
  for (const ResponseRow& response : attempt.responses) {
    if (response.source == kNotAsked) continue;
    const Question* const question = find_question(trial, response.question);
    summary.answers.push_back(question == nullptr ? response.answer
                                                  : label_of(*question, response.answer));
  }
  const auto is_judged = [](const ResponseRow& response) { return response.correct.has_value(); };
  if (std::ranges::any_of(attempt.responses, is_judged)) summary.correct = is_right(attempt);
  const auto is_of_kind = [&trial](const ResponseRow& response) {
    const Question* const question = find_question(trial, response.question);
    return question == nullptr || !question->is_additional;
  };
  const auto timed = std::ranges::find_if(attempt.responses, is_of_kind);
  if (timed != attempt.responses.end()) {
    summary.from_cue_s = timed->from_cue_s;
    summary.from_contact_s = timed->from_contact_s;
  }
  if (trial.track && attempt.valid && attempt.purpose == AttemptPurpose::trial) {
    summary.answer_of_track = level_answer_of(course_.protocol(), trial, attempt);
  }
  summary.duration_s = duration_s(attempt);
  return summary;
}

}  // namespace asperity
