// The tests, checks and judgement of a similarity.

#include "protocols/kinds/similarity.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "protocols/design/block_factors.h"
#include "protocols/design/question_place.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/positions.h"
#include "protocols/kinds/similarity_responses.h"

namespace asperity {

namespace {

constexpr std::array kSimilarityTests{
    KindTest{"configuration",
             "whether the stress of the configuration is below that of permuted ratings"},
    KindTest{"identical",
             "whether different surfaces are rated as more dissimilar than identical ones"},
    KindTest{"properties",
             "whether a measured property is related to the configuration, for every property"},
    KindTest{kGroupProfilesTest,
             "whether the dissimilarities of the pairs differ between two groups, for every pair "
             "of groups"}};

std::string item_of_similarity(const PlannedPresentation& surface) {
  return surface.stimulus.texture.empty() ? surface.stimulus.model : surface.stimulus.texture;
}

void check_block_of_similarity(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.block.presented.size() != 2) {
    problems.report(checked.pointer + "/presented",
                    phrase("Protocols",
                           "a similarity presents exactly two surfaces per trial; for all pairs of "
                           "the levels of a factor, add %1 and list one surface")
                        .with(key_name("all_pairs")));
  }
  if (!checked.block.all_pairs) check_positions(checked, problems);
}

/// The ratings of all main blocks are analysed together, so that they have to answer one question.
void check_question_of_similarity(const Protocol& protocol, ProblemSink& problems) {
  const Protocol::Block* first_block = nullptr;
  const Protocol::TrialQuestionTemplate* first = nullptr;
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != similarity_kind().id) continue;
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      const Protocol::TrialQuestionTemplate& question = block.questions[i];
      if (!std::holds_alternative<ScaleForm>(question.form)) continue;
      if (first == nullptr) {
        first = &question;
        first_block = &block;
        continue;
      }
      if (question.name == first->name && question.prompt == first->prompt &&
          rated_quantity(question) == rated_quantity(*first))
        continue;
      problems.report(place_of_question(block, i),
                      phrase("Protocols",
                             "the main blocks of a similarity are analysed together, and the block "
                             "%1 has another question; give both questions the same name, prompt "
                             "and %2, or write a protocol for each of them")
                          .with(in_quotes(first_block->name), key_name("rates")));
    }
  }
}

RatedQuantity rated_in(const Judgement& judgement) {
  const auto* const asked =
      question_named(judgement.protocol.blocks.at(judgement.trial.block), judgement.question.name);
  return asked == nullptr ? RatedQuantity::dissimilarity : rated_quantity(*asked);
}

/// A point on the scale: the dissimilarity 1 − exp(−δ) of the perceived difference δ of both surfaces
/// (VirtualObserver::difference), from 0 for identical surfaces towards 1. In a lapse, and if the observer is deaf, every
/// point is equally probable.
VirtualResponse judge_similarity(const Judgement& judgement) {
  const auto& form = std::get<ScaleForm>(judgement.question.form);
  const std::optional<double> difference =
      judgement.observer.difference(judgement.felt[0], judgement.felt[1]);
  if (!difference) {
    const std::size_t points = static_cast<std::size_t>(form.steps()) + 1;
    return {ScalePoint{static_cast<int>(judgement.observer.guess(points))}, false};
  }
  const double similarity = std::exp(-*difference);
  const double share =
      rated_in(judgement) == RatedQuantity::similarity ? similarity : 1.0 - similarity;
  return {ScalePoint{static_cast<int>(std::lround(share * form.steps()))}, false};
}

}  // namespace

RatedQuantity rated_quantity(const Protocol::TrialQuestionTemplate& question) {
  const auto* const stated = question.own_as<SimilarityQuestion>();
  return stated == nullptr ? RatedQuantity::dissimilarity
                           : stated->rates.value_or(RatedQuantity::dissimilarity);
}

const ExperimentKind& similarity_kind() {
  static const ExperimentKind kKind{.id = "similarity",
                                    .name = phrase("Protocols", "similarity"),
                                    .roles = kAlternativeRole,
                                    .form = ScaleForm{},
                                    .tests = kSimilarityTests,
                                    .item_of = item_of_similarity,
                                    .check = check_question_of_similarity,
                                    .check_block = check_block_of_similarity,
                                    .judge = judge_similarity,
                                    .responses = &similarity_responses()};
  return kKind;
}

}  // namespace asperity
