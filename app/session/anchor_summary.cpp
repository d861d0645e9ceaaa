// Lists the valid responses of each block in their order, and states the change from the first to the last.

#include "app/session/anchor_summary.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"

namespace asperity {

namespace {

/// The response to one question of an anchor.
struct ShownResponse {
  Phrase text{};
  std::optional<double> number{};
};

ShownResponse shown_response(const Question& question, const AttemptRow& attempt) {
  ShownResponse shown{};
  std::optional<bool> correct{};
  for (const ResponseRow& response : attempt.responses) {
    if (response.question != question.name || response.source == kNotAsked) continue;
    const Phrase label = label_of(question, response.answer);
    shown.text = shown.text.empty() ? label : Phrase("%1, %2").with(shown.text, label);
    if (response.answer_number) shown.number = response.answer_number;
    if (response.correct) correct = correct.value_or(true) && *response.correct;
  }
  if (correct) {
    shown.text = *correct ? phrase("SessionEnd", "correct") : phrase("SessionEnd", "incorrect");
  }
  return shown;
}

Phrase series_text(const std::vector<ShownResponse>& responses) {
  Phrase series{};
  for (const ShownResponse& each : responses) {
    series = series.empty() ? each.text : Phrase("%1 → %2").with(series, each.text);
  }
  return series;
}

/// Of numbers; empty otherwise.
Phrase change_text(const std::vector<ShownResponse>& responses, const AnswerForm& form) {
  const std::optional<double>& first = responses.front().number;
  const std::optional<double>& last = responses.back().number;
  if (!first || !last) return {};
  if (std::holds_alternative<ScaleForm>(form)) {
    return phrase("SessionEnd", "last − first: %1").with(rounded_text(*last - *first));
  }
  if (*first <= 0.0) return {};
  return phrase("SessionEnd", "last/first: %1").with(fixed(*last / *first, 2));
}

}  // namespace

std::vector<Phrase> anchor_summary(const Plan& plan, std::span<const AttemptRow> attempts) {
  std::map<int, const AttemptRow*> valid{};
  for (const AttemptRow& attempt : attempts) {
    if (attempt.valid && attempt.purpose == AttemptPurpose::trial) valid[attempt.trial] = &attempt;
  }
  std::map<int, std::vector<const Trial*>> anchors{};  // with a valid attempt, by block
  for (const Trial& trial : plan.trials) {
    if (trial.anchor && valid.contains(trial.ordinal)) {
      anchors[trial.block_ordinal].push_back(&trial);
    }
  }
  std::vector<Phrase> lines{};
  for (const auto& [block, trials] : anchors) {
    for (const Question& question : trials.front()->questions) {
      std::vector<ShownResponse> responses{};
      for (const Trial* const trial : trials) {
        const Question* const asked = find_question(*trial, question.name);
        if (asked == nullptr) continue;
        ShownResponse response = shown_response(*asked, *valid.at(trial->ordinal));
        if (!response.text.empty()) responses.push_back(std::move(response));
      }
      if (responses.size() < 2) continue;
      const Phrase change = change_text(responses, question.form);
      const std::string number = std::to_string(block);
      const Phrase series = series_text(responses);
      const std::string& name = trials.front()->block;
      lines.push_back(change.empty()
                          ? phrase("SessionEnd", "Anchors of block %1 (%2), question %3: %4.")
                                .with(number, name, question.name, series)
                          : phrase("SessionEnd", "Anchors of block %1 (%2), question %3: %4; %5.")
                                .with(number, name, question.name, series, change));
    }
  }
  return lines;
}

}  // namespace asperity
