// The tests, checks and judgement of a paired comparison.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "protocols/design/json_pointer.h"
#include "protocols/design/question_place.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/choice_responses.h"
#include "protocols/kinds/expected_textures.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/positions.h"
#include "protocols/kinds/realism.h"

namespace asperity {

namespace {

constexpr std::array kPairedTests{
    KindTest{"pairs",
             "whether one item is chosen more often than the other, for every pair of items"},
    KindTest{"preference", "whether all items are chosen equally often"},
    KindTest{"position", "whether both positions are chosen equally often"},
    KindTest{kGroupProfilesTest,
             "whether the proportions of choices of the items differ between two groups, for every "
             "pair of groups"}};

std::string item_of_pair(const PlannedPresentation& surface) {
  return surface.stimulus.texture.empty() ? surface.stimulus.model : surface.stimulus.texture;
}

/// The factor and the stimulus of the pairs of a block; empty without `all_pairs`.
std::string items_of_pairs(const Protocol::Block& block) {
  return block.all_pairs ? block.all_pairs->factor + " of " + block.presented.front().stimulus
                         : std::string();
}

/// The text of the option "tie"; empty without one.
std::string tie_of(const Protocol::TrialQuestionTemplate& question) {
  const auto* const pair = question.own_as<PairQuestion>();
  return pair == nullptr ? std::string() : pair->tie;
}

/// Choices in different blocks are analysed together, so that they have to answer one question about the same items.
void check_pairs_of_protocol(const Protocol& protocol, ProblemSink& problems) {
  const Protocol::Block* first_block = nullptr;
  const Protocol::TrialQuestionTemplate* first = nullptr;
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != paired_comparison_kind().id) continue;
    const std::string pointer = pointer_to("/blocks", name);
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      const Protocol::TrialQuestionTemplate& question = block.questions[i];
      if (question.is_additional || !question.is_answered_by<ChoiceForm>()) continue;
      if (first == nullptr) {
        first = &question;
        first_block = &block;
        continue;
      }
      const std::string at_question = place_of_question(block, i);
      if (question.name != first->name || question.prompt != first->prompt ||
          tie_of(question) != tie_of(*first)) {
        problems.report(at_question,
                        phrase("Protocols",
                               "the main blocks of a paired comparison are analysed together, and "
                               "the block %1 has another question; give both questions the same "
                               "name, prompt and tie, or write a protocol for each of them")
                            .with(in_quotes(first_block->name)));
      }
      if (items_of_pairs(block) != items_of_pairs(*first_block)) {
        problems.report(pointer + "/presented",
                        phrase("Protocols",
                               "the main blocks of a paired comparison are analysed together, and "
                               "the block %1 compares other surfaces; give both blocks the same "
                               "stimulus and %2, or write a protocol for each of them")
                            .with(in_quotes(first_block->name), key_name("all_pairs")));
      }
    }
  }
}

void check_block_of_pairs(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.block.presented.size() != 2) {
    problems.report(checked.pointer + "/presented",
                    phrase("Protocols",
                           "a paired comparison presents exactly two surfaces per trial; for all "
                           "pairs of the levels of a factor, add %1 and list one surface")
                        .with(key_name("all_pairs")));
  }
  if (!checked.block.all_pairs) check_positions(checked, problems);
  check_prompt_for_sample(checked, problems);
}

void check_trial_of_pairs(const BlockOfKind& checked, const Trial& trial, ProblemSink& problems) {
  if (checked.protocol.realism_standard) check_surfaces_with_standard(checked, trial, problems);
  for (const PlannedPresentation& planned : trial.presentations) {
    if (planned.item != kTieOption) continue;
    problems.report(checked.pointer + "/presented",
                    phrase("Protocols",
                           "a surface counts as %1 in the responses, but this is the name of a "
                           "tie; give the surface another name")
                        .with(in_quotes(kTieOption)));
  }
}

/// With a standard: the surface that is closer to the expected texture (VirtualObserver::select). Without one, or
/// without an expectation: the surface with the greater magnitude (VirtualObserver::compare), whatever the question asks
/// for; where there is the option, a difference of less than 10 % is a tie.
VirtualResponse judge_pair(const Judgement& judgement) {
  if (judgement.protocol.realism_standard) {
    const std::vector<ForceFeatures> expected = expected_of(
        judgement.expectations, {judgement.trial.presentations.front().stimulus.texture});
    if (!expected.empty()) {
      return {ChosenOption{judgement.observer.select(judgement.felt, expected.front())}, false};
    }
  }
  constexpr double kLeastDifference = 0.1;
  const std::size_t surfaces = judgement.felt.size();
  const bool can_tie = judgement.question.options.size() > surfaces;
  const std::optional<std::size_t> greater = judgement.observer.compare(
      judgement.felt[0], judgement.felt[1], can_tie ? kLeastDifference : 0.0);
  return {ChosenOption{greater.value_or(surfaces)}, false};
}

}  // namespace

const ExperimentKind& paired_comparison_kind() {
  static const ExperimentKind kKind{.id = "paired_comparison",
                                    .name = phrase("Protocols", "paired comparison"),
                                    .roles = kAlternativeRole,
                                    .form = ChoiceForm{},
                                    .tests = kPairedTests,
                                    .item_of = item_of_pair,
                                    .check = check_pairs_of_protocol,
                                    .check_block = check_block_of_pairs,
                                    .check_trial = check_trial_of_pairs,
                                    .judge = judge_pair,
                                    .responses = &paired_comparison_responses()};
  return kKind;
}

}  // namespace asperity
