// Keeps the attempts by trial, and derives which trial comes next, criteria and repetitions.

#include "app/session/trial_tally.h"

#include <algorithm>
#include <variant>

#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

bool is_right(const AttemptRow& attempt) {
  const auto is_judged = [](const ResponseRow& response) { return response.correct.has_value(); };
  return std::any_of(attempt.responses.begin(), attempt.responses.end(), is_judged) &&
         std::all_of(attempt.responses.begin(), attempt.responses.end(),
                     [](const ResponseRow& response) { return response.correct.value_or(true); });
}

bool failed_technically(const AttemptRow& attempt) {
  if (attempt.valid) return false;
  return attempt.outcome == AttemptOutcome::answered ||
         attempt.outcome == AttemptOutcome::timed_out ||
         std::any_of(attempt.presentations.begin(), attempt.presentations.end(),
                     [](const PresentationRow& surface) { return surface.contact_s <= 0.0; });
}

bool has_excessive_buzz(const AttemptRow& attempt) {
  return !attempt.valid && attempt.invalid_reason &&
         codes_of(*attempt.invalid_reason).starts_with(phrase_of(Reason::buzz_too_strong).code());
}

bool TrialTally::does_its_trial(const AttemptRow& attempt) const {
  if (is_refresher(attempt)) return false;
  return attempt.valid || (attempt.outcome == AttemptOutcome::skipped &&
                           !set_aside_.contains({attempt.trial, attempt.attempt}));
}

const AttemptRow* TrialTally::last_done() const {
  const auto last =
      std::find_if(attempts_.rbegin(), attempts_.rend(),
                   [this](const AttemptRow& attempt) { return does_its_trial(attempt); });
  return last == attempts_.rend() ? nullptr : &*last;
}

void TrialTally::set_aside(int trial, int attempt, const StoredWords& reason) {
  remember_set_aside(trial, attempt);
  for (AttemptRow& row : attempts_) {
    if (row.trial != trial || row.attempt != attempt) continue;
    row.valid = false;
    row.invalid_reason = joined(row.invalid_reason, set_aside_because(reason));
  }
}

bool TrialTally::is_done(const Trial& trial) const {
  return std::any_of(attempts_.begin(), attempts_.end(), [&trial, this](const AttemptRow& attempt) {
    return attempt.trial == trial.ordinal && does_its_trial(attempt);
  });
}

BlockState TrialTally::criterion_of(const Trial& trial) const {
  const Protocol::Block& block = protocol_.blocks.at(trial.block);
  if (!block.until) return BlockState::go_on;
  std::vector<bool> correct{};
  for (const AttemptRow& attempt : attempts_) {
    if (!attempt.valid || is_refresher(attempt)) continue;
    const Trial& tried = plan_.trials.at(static_cast<std::size_t>(attempt.trial - 1));
    if (tried.block_ordinal != trial.block_ordinal) continue;
    correct.push_back(is_right(attempt));
  }
  return state_of(*block.until, correct);
}

int TrialTally::attempts_at(int trial) const {
  return static_cast<int>(
      std::count_if(attempts_.begin(), attempts_.end(),
                    [trial](const AttemptRow& attempt) { return attempt.trial == trial; }));
}

int TrialTally::coming(std::size_t step, int block, int tried, Again again) const {
  if (tried != 0 && again == Again::at_once &&
      is_open(plan_.trials.at(static_cast<std::size_t>(tried - 1)))) {
    return tried;
  }
  const auto ahead = [&](bool of_block) {
    for (std::size_t i = step; i < plan_.steps.size(); ++i) {
      const TrialStep* at = std::get_if<TrialStep>(&plan_.steps[i]);
      if (at == nullptr) continue;
      const Trial& trial = plan_.trials.at(at->trial);
      const bool is_wanted = !of_block || (trial.block_ordinal == block && trial.ordinal != tried);
      if (is_wanted && is_open(trial)) return trial.ordinal;
    }
    return 0;
  };
  if (block != 0) {
    if (const int next = ahead(true)) return next;
    // Open trials of the block are asked in rounds, in order.
    int first = 0;
    for (const Trial& trial : plan_.trials) {
      if (trial.block_ordinal != block || !is_open(trial)) continue;
      if (trial.ordinal > tried) return trial.ordinal;
      if (first == 0) first = trial.ordinal;
    }
    if (first != 0) return first;
  }
  return ahead(false);
}

std::optional<double> TrialTally::earlier_estimate(const Trial& trial) const {
  const auto asked =
      std::find_if(trial.questions.begin(), trial.questions.end(), [](const Question& question) {
        return question.is_answered_by<NumberForm>() && !question.is_additional;
      });
  if (asked == trial.questions.end()) return {};
  for (auto attempt = attempts_.rbegin(); attempt != attempts_.rend(); ++attempt) {
    if (!attempt->valid) continue;
    const Trial& tried = plan_.trials.at(static_cast<std::size_t>(attempt->trial - 1));
    if (!are_of_one_stimulus(tried, trial)) continue;
    for (const ResponseRow& response : attempt->responses) {
      if (response.question == asked->name && response.answer_number) return response.answer_number;
    }
  }
  return {};
}

int TrialTally::explored_wrongly(int trial) const {
  return static_cast<int>(
      std::count_if(attempts_.begin(), attempts_.end(), [trial](const AttemptRow& attempt) {
        return attempt.trial == trial && !is_refresher(attempt) &&
               attempt.outcome == AttemptOutcome::not_compliant && !failed_technically(attempt);
      }));
}

int TrialTally::repeated_for_buzz(int trial) const {
  return static_cast<int>(
      std::count_if(attempts_.begin(), attempts_.end(), [trial](const AttemptRow& attempt) {
        return attempt.trial == trial && !is_refresher(attempt) && has_excessive_buzz(attempt);
      }));
}

}  // namespace asperity
