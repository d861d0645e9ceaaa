// Converts choices into hits of the target, for a crossed mixed model and for reliability over repetitions.

#include "app/findings/methods/selection/target_choices.h"

#include <vector>

#include "app/findings/shared/crossed_textures.h"
#include "app/findings/shared/repetition_reliability.h"

namespace asperity {

std::vector<HitCount> target_choices_of_people(const Selection& selection) {
  std::vector<HitCount> own(selection.gathered.people.size());
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    const std::size_t chosen = selection.chosen(answer);
    if (chosen == kNoChoice) continue;
    ++own[answer.person].trials;
    if (selection.items[chosen] == selection.target()) ++own[answer.person].hits;
  }
  return own;
}

void ask_target_choices(const Selection& selection, AnalysisOutcome& outcome) {
  const bool is_repeated = has_repetitions(selection.gathered);
  if (!selection.has_target()) {
    if (!is_repeated) return;
    add_no_reliability("no_target", "the protocol declares no target", outcome);
    return;
  }
  if (!selection.all_offered) {
    constexpr const char* kDiffer = "models_differ";
    constexpr const char* kReason = "not every model is presented in every trial";
    add_no_crossed_model(kDiffer, kReason, outcome);
    if (is_repeated) add_no_reliability(kDiffer, kReason, outcome);
    return;
  }
  std::vector<RepeatedScore> scores{};
  std::vector<TextureResponse> responses{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    const std::size_t chosen = selection.chosen(answer);
    if (chosen == kNoChoice) continue;
    const bool is_target = selection.items[chosen] == selection.target();
    scores.push_back({answer.person, selection.gathered.column_of(answer), answer.repetition,
                      is_target ? 1.0 : 0.0});
    responses.push_back({.person = answer.person,
                         .texture = selection.gathered.surfaces_of(answer)[0].texture,
                         .is_hit = is_target});
  }
  ask_other_textures(
      {.responses = responses,
       .chance = 1.0 / static_cast<double>(selection.items.size()),
       .proportion =
           phrase("Analysis", "the proportion of choices of %1").with(selection.target())},
      outcome);
  ask_reliability(selection.gathered,
                  {scores, phrase("Analysis", "the participants' proportions of choices of %1")
                               .with(selection.target())},
                  outcome);
}

}  // namespace asperity
