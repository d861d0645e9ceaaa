// The tests, checks and judgement of a selection.

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "protocols/design/wording.h"
#include "protocols/kinds/choice_responses.h"
#include "protocols/kinds/expected_textures.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/realism.h"

namespace asperity {

namespace {

constexpr std::array kSelectionTests{
    KindTest{"pairs",
             "whether one item is chosen more often than the other, for every pair of items"},
    KindTest{"target_pairs",
             "whether the target or the other item is chosen more often, for every pair that "
             "contains the target",
             true},
    KindTest{"preference", "whether all items are chosen equally often"},
    KindTest{"position", "whether all positions are chosen equally often"},
    KindTest{"textures", "whether the target is chosen equally often with every texture", true},
    KindTest{kGroupsTest, "whether the target is chosen equally often, for every pair of groups",
             true},
    KindTest{kGroupProfilesTest,
             "whether the proportions of choices of the items differ between two groups, for every "
             "pair of groups"}};

std::string item_of_selection(const PlannedPresentation& surface) { return surface.stimulus.model; }

void check_block_of_selection(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.block.presented.size() < 2) {
    problems.report(
        checked.pointer + "/presented",
        phrase("Protocols",
               "a selection needs at least two surfaces to choose from; list them here"));
  }
  check_prompt_for_sample(checked, problems);
}

void check_trial_of_selection(const BlockOfKind& checked, const Trial& trial,
                              ProblemSink& problems) {
  check_surfaces_with_standard(checked, trial, problems);
  const bool shows_a_texture = std::any_of(
      trial.presentations.begin(), trial.presentations.end(),
      [](const PlannedPresentation& planned) { return !planned.stimulus.texture.empty(); });
  if (checked.protocol.observer.expectation != ObserverDeclaration::Expectation::none &&
      !shows_a_texture) {
    problems.report(checked.pointer + "/presented",
                    phrase("Protocols",
                           "the observer's %1 requires surfaces with a texture: give them a "
                           "texture, or set %1 to %2")
                        .with(key_name("expectation"), word_name("none")));
  }
}

std::size_t option_with(const Question& question, const std::string& value) {
  for (std::size_t option = 0; option < question.options.size(); ++option) {
    if (question.options[option].value == value) return option;
  }
  throw std::logic_error("the question " + question.name + " has no option \"" + value +
                         "\"; use the value of one of its options");
}

VirtualResponse judge_selection(const Judgement& judgement) {
  std::vector<std::size_t> surfaces{};
  for (const PlannedPresentation& planned : judgement.trial.presentations) {
    surfaces.push_back(option_with(judgement.question, planned.item));
  }
  const std::vector<ForceFeatures> expected =
      expected_of(judgement.expectations, {judgement.trial.presentations.front().stimulus.texture});
  if (expected.empty()) {
    return {ChosenOption{surfaces[judgement.observer.guess(surfaces.size())]}, true};
  }
  return {ChosenOption{surfaces[judgement.observer.select(judgement.felt, expected.front())]},
          false};
}

}  // namespace

const ExperimentKind& selection_kind() {
  static const std::array kKeys{RequiredKey{
      "realism_standard",
      phrase("Protocols",
             "a selection must state the standard of realism: add the key %1 with %2, %3 or %4")
          .with(key_name("realism_standard"), word_name("photograph"), word_name("physical_sample"),
                word_name("memory"))}};
  static const ExperimentKind kKind{.id = "selection",
                                    .name = phrase("Protocols", "selection"),
                                    .roles = kAlternativeRole,
                                    .form = ChoiceForm{},
                                    .has_expectations = true,
                                    .tests = kSelectionTests,
                                    .required = kKeys,
                                    .item_of = item_of_selection,
                                    .check_block = check_block_of_selection,
                                    .check_trial = check_trial_of_selection,
                                    .judge = judge_selection,
                                    .responses = &selection_responses()};
  return kKind;
}

}  // namespace asperity
