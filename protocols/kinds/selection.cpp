// The tests, checks and judgement of a selection.

#include "protocols/kinds/selection.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/expected_textures.h"

namespace asperity {

namespace {

constexpr std::array kSelectionTests{
    KindTest{"pairs", "for every pair of items: is one chosen more often than the other"},
    KindTest{
        "target_pairs",
        "for every pair of the target and another item: is one chosen more often than the other",
        true},
    KindTest{"preference", "are all items chosen equally often"},
    KindTest{"position", "are all positions chosen equally often"},
    KindTest{"textures", "is the target chosen equally often with every texture", true},
    KindTest{"groups", "for every pair of groups: is the target chosen equally often", true}};

constexpr std::array kSelectionKeys{
    KindKey{"realism_standard",
            "a selection has to state the standard of realism: add the key \"realism_standard\" "
            "with \"photograph\", \"physical_sample\" or \"memory\"",
            "only in a selection is realism measured against a standard; remove this key"}};

std::string item_of_selection(const StimulusDescription& stimulus) { return stimulus.model; }

void check_block_of_selection(const BlockOfKind& checked, ProblemSink& problems) {
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const std::string& place = checked.at_question;
  if (checked.block.presented.size() < 2) {
    problems.report(checked.pointer + "/presented",
                    "a selection needs at least two surfaces to choose from");
  }
  if (!question.pictures.empty()) {
    problems.report(place + "/pictures",
                    "in a selection the options are the surfaces felt; the picture of the texture "
                    "is shown when realism_standard is \"photograph\"; remove this key");
  }
  if (!question.correct_factor.empty()) {
    problems.report(place + "/correct_factor",
                    "no response of a selection is correct or incorrect; remove this key");
  }
  if (checked.protocol.realism_standard == RealismStandard::physical_sample &&
      checked.block.experimenter_prompt.find("{code}") == std::string::npos) {
    problems.report(place,
                    "with the standard \"physical_sample\" the experimenter needs to know which "
                    "sample to place: add \"experimenter_prompt\" with {code} in it, such as "
                    "\"Place sample {code} next to the device.\"");
  }
}

void check_trial_of_selection(const BlockOfKind& checked, const Trial& trial,
                              ProblemSink& problems) {
  const Protocol& protocol = checked.protocol;
  const std::string presented = checked.pointer + "/presented";
  const std::string& texture = trial.presentations.front().stimulus.texture;
  const std::string at_texture = texture.empty() ? presented : pointer_to("/textures", texture);
  for (const PlannedPresentation& planned : trial.presentations) {
    if (planned.stimulus.texture == texture) continue;
    problems.report(presented,
                    "the surfaces of a trial show different textures (" + in_quotes(texture) +
                        " and " + in_quotes(planned.stimulus.texture) +
                        "); a selection compares renderings of one texture: give them the same");
  }
  if (protocol.realism_standard == RealismStandard::photograph && !trial.standard_picture) {
    problems.report(
        at_texture,
        "realism is measured against a photograph here: give the texture a \"picture\"");
  }
  if (protocol.realism_standard == RealismStandard::physical_sample &&
      (texture.empty() || protocol.textures.at(texture).code.empty())) {
    problems.report(at_texture,
                    "realism is measured against a physical sample here: give the texture the "
                    "\"code\" on its label");
  }
  const bool shows_a_texture = std::any_of(
      trial.presentations.begin(), trial.presentations.end(),
      [](const PlannedPresentation& planned) { return !planned.stimulus.texture.empty(); });
  if (protocol.observer.expectation != ObserverDeclaration::Expectation::none && !shows_a_texture) {
    problems.report(presented,
                    "the observer's \"expectation\" requires surfaces with a texture: give them a "
                    "texture, or set \"expectation\" to \"none\"");
  }
}

std::size_t option_with(const TrialQuestion& question, const std::string& value) {
  for (std::size_t option = 0; option < question.options.size(); ++option) {
    if (question.options[option].value == value) return option;
  }
  throw std::logic_error("no option has the value " + value);
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
  static const ExperimentKind kKind{.id = "selection",
                                    .role = "alternative",
                                    .form = ChoiceForm{},
                                    .has_target = true,
                                    .has_expectations = true,
                                    .tests = kSelectionTests,
                                    .keys = kSelectionKeys,
                                    .item_of = item_of_selection,
                                    .check_block = check_block_of_selection,
                                    .check_trial = check_trial_of_selection,
                                    .judge = judge_selection};
  return kKind;
}

}  // namespace asperity
