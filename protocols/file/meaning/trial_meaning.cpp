// Implements the checks that every possible trial has a response.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

void check_expectation(CheckedDocument& checked, const Trial& trial,
                       const std::set<std::string, std::less<>>& on_bodies) {
  using Expectation = ObserverDeclaration::Expectation;
  if (checked.protocol.observer.expectation == Expectation::none) return;
  if (!kind_named(trial.kind).has_expectations) return;
  std::set<std::string> expected{};
  for (const PlannedPresentation& planned : trial.presentations) {
    expected.insert(planned.stimulus.texture);
  }
  for (const auto& question : checked.protocol.blocks.at(trial.block).questions) {
    if (question.is_additional) continue;  // it is answered at random
    expected.insert(question.pictures.begin(), question.pictures.end());
  }
  expected.erase("");
  for (const std::string& name : expected) {
    const Texture& texture = checked.protocol.textures.at(name);
    if (checked.protocol.observer.expectation == Expectation::true_surface &&
        !texture.true_height_field && !on_bodies.contains(name)) {
      checked.report(pointer_to("/textures", name),
                     phrase("Protocols",
                            "the observer expects the true surface of this texture: give it a %1, "
                            "or a stimulus that shows it on bodies")
                         .with(key_name("true_height_field")));
    }
    if (checked.protocol.observer.expectation == Expectation::prior && !texture.prior) {
      checked.report(
          pointer_to("/textures", name),
          phrase("Protocols", "the observer expects the stated prior of this texture: give it a %1")
              .with(key_name("prior")));
    }
  }
}

void check_draws(CheckedDocument& checked) {
  for (const auto& [name, block] : checked.protocol.blocks) {
    std::size_t combinations = row_count(checked.protocol, block);
    if (block.procedure) {
      combinations = std::min(combinations * block.vary->levels().size(), kMaximumRows);
    }
    for (const std::string& factor : block.drawn) {
      combinations =
          std::min(combinations * checked.protocol.factors.at(factor).levels.size(), kMaximumRows);
    }
    if (combinations > kMaximumSessionTrials) {
      checked.report(pointer_to("/blocks", name) + "/drawn",
                     phrase("Protocols",
                            "more than %1 different trials could be drawn; draw fewer factors or "
                            "levels")
                         .with(std::to_string(kMaximumSessionTrials)));
    }
  }
}

}  // namespace

void check_trials(CheckedDocument& checked) {
  check_draws(checked);
  if (!checked.found().empty()) return;
  const std::vector<Trial> possible = possible_trials(checked.protocol);
  check_matches(checked, possible);
  check_tests_in_trials(checked, possible);
  std::set<std::string, std::less<>> body_models{};
  for (const auto& [id, model] : checked.models) {
    if (model->needs_bodies) body_models.insert(id);
  }
  std::set<std::string, std::less<>> on_bodies{};
  for (const auto& [texture, stimulus] : stimuli_on_bodies(possible, body_models)) {
    on_bodies.insert(texture);
  }
  for (const Trial& trial : possible) {
    const std::string pointer = pointer_to("/blocks", trial.block);
    const std::string presented = pointer + "/presented";
    const auto& pairs = checked.protocol.blocks.at(trial.block).all_pairs;
    const bool may_be_identical = pairs && pairs->with_identical;
    std::set<std::string> items{};
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.item.empty()) {
        checked.report(
            presented,
            phrase("Protocols",
                   "a surface without a texture needs an %1 as its name in the responses")
                .with(key_name("item")));
      } else if (!items.insert(planned.item).second && !may_be_identical) {
        checked.report(presented,
                       phrase("Protocols",
                              "two surfaces of a trial count as %1 in the responses; give each its "
                              "own %2")
                           .with(in_quotes(planned.item), key_name("item")));
      }
      if (const auto model = checked.models.find(planned.stimulus.model);
          model != checked.models.end()) {
        check_together(checked, *model->second, planned.stimulus.parameters,
                       pointer_to("/stimuli", planned.stimulus_template));
      }
    }
    const Block& block = checked.protocol.blocks.at(trial.block);
    const ExperimentKind& kind = kind_of(block);
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      // In the order of the file, whatever the order in which they are asked.
      const Question& question = *find_question(trial, block.questions[i].name);
      std::set<std::string> missing(question.correct.begin(), question.correct.end());
      for (const Option& option : question.options) missing.erase(option.value);
      if (missing.empty()) continue;
      const std::string at_question = place_of_question(block, i);
      if (block.questions[i].options.empty()) {
        checked.report(at_question + "/pictures",
                       phrase("Protocols",
                              "the correct response %1 is not among the pictures; add its picture")
                           .with(in_quotes(*missing.begin())));
      } else {
        checked.report(
            at_question + "/options",
            phrase("Protocols", "the correct response %1 is not among the options; add it")
                .with(in_quotes(*missing.begin())));
      }
    }
    for (std::size_t i = 0; kind.check_trial != nullptr && i < block.questions.size(); ++i) {
      if (kind_of_question(kind, block.questions[i]) != &kind) continue;
      kind.check_trial(
          {checked.protocol, block, block.questions[i], pointer, place_of_question(block, i)},
          trial, checked);
    }
    check_expectation(checked, trial, on_bodies);
  }
}

}  // namespace asperity
