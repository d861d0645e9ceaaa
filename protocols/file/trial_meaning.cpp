// Implements the checks that every possible trial has a response.

#include <algorithm>

#include "protocols/file/meaning_checks.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

using Block = Protocol::Block;

void Meaning::check_expectation(const Trial& trial,
                                const std::set<std::string, std::less<>>& on_bodies) {
  using Expectation = ObserverDeclaration::Expectation;
  if (protocol_.observer.expectation == Expectation::none) return;
  if (!kind_named(trial.kind).has_expectations) return;
  std::set<std::string> expected{};
  for (const PlannedPresentation& planned : trial.presentations) {
    expected.insert(planned.stimulus.texture);
  }
  for (const auto& question : protocol_.blocks.at(trial.block).questions) {
    if (question.is_additional) continue;  // it is answered at random
    expected.insert(question.pictures.begin(), question.pictures.end());
  }
  expected.erase("");
  for (const std::string& name : expected) {
    const Texture& texture = protocol_.textures.at(name);
    if (protocol_.observer.expectation == Expectation::true_surface && !texture.true_height_field &&
        !on_bodies.contains(name)) {
      report(pointer_to("/textures", name),
             "the observer expects the true surface of this texture: give it a "
             "\"true_height_field\", or a stimulus that shows it on bodies");
    }
    if (protocol_.observer.expectation == Expectation::prior && !texture.prior) {
      report(pointer_to("/textures", name),
             "the observer expects the stated prior of this texture: give it a \"prior\"");
    }
  }
}

void Meaning::check_draws() {
  for (const auto& [name, block] : protocol_.blocks) {
    std::size_t combinations = row_count(protocol_, block);
    if (block.procedure) {
      combinations = std::min(combinations * block.vary->levels().size(), kMaximumRows);
    }
    for (const std::string& factor : block.drawn) {
      combinations =
          std::min(combinations * protocol_.factors.at(factor).levels.size(), kMaximumRows);
    }
    if (combinations > kMaximumSessionTrials) {
      report(pointer_to("/blocks", name) + "/drawn",
             "more than " + std::to_string(kMaximumSessionTrials) +
                 " different trials could be drawn; draw fewer factors or levels");
    }
  }
}

void Meaning::check_trials() {
  check_draws();
  if (!found_.empty()) return;
  const std::vector<Trial> possible = possible_trials(protocol_);
  check_matches(possible);
  check_tests_in_trials(possible);
  std::set<std::string, std::less<>> body_models{};
  for (const auto& [id, model] : models_) {
    if (model->needs_bodies) body_models.insert(id);
  }
  std::set<std::string, std::less<>> on_bodies{};
  for (const auto& [texture, stimulus] : stimuli_on_bodies(possible, body_models)) {
    on_bodies.insert(texture);
  }
  for (const Trial& trial : possible) {
    const std::string pointer = pointer_to("/blocks", trial.block);
    const std::string presented = pointer + "/presented";
    const auto& pairs = protocol_.blocks.at(trial.block).all_pairs;
    const bool may_be_identical = pairs && pairs->with_identical;
    std::set<std::string> items{};
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.item.empty()) {
        report(presented,
               "a surface without a texture needs an \"item\" as its name in the responses");
      } else if (!items.insert(planned.item).second && !may_be_identical) {
        report(presented, "two surfaces of a trial count as " + in_quotes(planned.item) +
                              " in the responses; give each its own \"item\"");
      }
      if (const auto model = models_.find(planned.stimulus.model); model != models_.end()) {
        check_together(*model->second, planned.stimulus.parameters,
                       pointer_to("/stimuli", planned.stimulus_template));
      }
    }
    const Block& block = protocol_.blocks.at(trial.block);
    const ExperimentKind& kind = kind_of(block);
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      // In the order of the file, whatever the order in which they are asked.
      const Question& question = *find_question(trial, block.questions[i].name);
      std::set<std::string> missing(question.correct.begin(), question.correct.end());
      for (const Option& option : question.options) missing.erase(option.value);
      if (missing.empty()) continue;
      const std::string at_question = place_of_question(block, i);
      if (block.questions[i].options.empty()) {
        report(at_question + "/pictures", "the correct response " + in_quotes(*missing.begin()) +
                                              " is not among the pictures; add its picture");
      } else {
        report(at_question + "/options", "the correct response " + in_quotes(*missing.begin()) +
                                             " is not among the options; add it");
      }
    }
    for (std::size_t i = 0; kind.check_trial != nullptr && i < block.questions.size(); ++i) {
      if (kind_of_question(kind, block.questions[i]) != &kind) continue;
      kind.check_trial({protocol_, block, block.questions[i], pointer, place_of_question(block, i)},
                       trial, *this);
    }
    check_expectation(trial, on_bodies);
  }
}

}  // namespace asperity
