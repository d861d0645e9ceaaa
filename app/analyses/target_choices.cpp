#include "app/analyses/target_choices.h"

#include <vector>

#include "app/analyses/repetition_reliability.h"

namespace asperity {

void ask_target_choices(const Selection& selection, AnalysisOutcome& outcome) {
  if (!selection.has_target() || !selection.all_offered) {
    if (!has_repetitions(selection.gathered)) return;
    if (!selection.has_target()) {
      add_no_reliability(
          "no_target", "the protocol declares no target whose choices could be compared", outcome);
    } else {
      add_no_reliability("models_differ", "not every trial presents every model", outcome);
    }
    return;
  }
  std::vector<RepeatedScore> scores{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    const std::size_t chosen = selection.chosen(answer);
    if (chosen == kNoChoice) continue;
    const bool is_target = selection.items[chosen] == selection.target();
    scores.push_back({answer.person, answer.column, answer.repetition, is_target ? 1.0 : 0.0});
  }
  ask_reliability(selection.gathered,
                  {scores, phrase("Analysis", "the participants' proportions of choices of %1")
                               .with(selection.target())},
                  outcome);
}

}  // namespace asperity
