// Whether every trial that can come about has an answer.

#include <algorithm>

#include "protocols/file/meaning_checks.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

using Block = Protocol::Block;

void Meaning::check_expectation(const Trial& trial,
                                const std::set<std::string, std::less<>>& on_bodies,
                                const std::string& pointer) {
  using Expectation = ObserverDeclaration::Expectation;
  if (protocol_.observer.expectation == Expectation::none) return;
  if (protocol_.kind == ProtocolKind::magnitude) {
    report("/observer/expectation",
           "an observer derives a magnitude from what it feels and has no expectation: set this to "
           "\"none\"");
    return;
  }
  std::set<std::string> expected{};
  for (const PlannedPresentation& planned : trial.presentations) {
    expected.insert(planned.stimulus.texture);
  }
  const auto& pictures = protocol_.blocks.at(trial.block).question.pictures;
  expected.insert(pictures.begin(), pictures.end());
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
  if (protocol_.kind == ProtocolKind::selection && expected.empty()) {
    report(pointer + "/presented", "nothing can be expected of surfaces without a texture");
  }
}

void Meaning::check_draws() {
  for (const auto& [name, block] : protocol_.blocks) {
    std::size_t combinations = row_count(protocol_, block);
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
    std::set<std::string> items{};
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.item.empty()) {
        report(presented,
               "a surface without a texture needs an \"item\" as its name in the answers");
      } else if (!items.insert(planned.item).second) {
        report(presented, "two surfaces of a trial count as " + in_quotes(planned.item) +
                              " in the answers; give each its own \"item\"");
      }
      if (const auto model = models_.find(planned.stimulus.model); model != models_.end()) {
        check_together(*model->second, planned.stimulus.parameters,
                       pointer_to("/stimuli", planned.stimulus_template));
      }
    }
    const std::string& texture = trial.presentations.front().stimulus.texture;
    std::set<std::string> pictures(trial.question.correct.begin(), trial.question.correct.end());
    for (const Option& option : trial.question.options) pictures.erase(option.value);
    if (!pictures.empty()) {
      report(pointer + "/question/pictures",
             "the correct response " + in_quotes(*pictures.begin()) + " is not among the pictures");
    }
    switch (protocol_.kind) {
      case ProtocolKind::selection:
        for (const PlannedPresentation& planned : trial.presentations) {
          if (planned.stimulus.texture != texture) {
            report(presented, "the surfaces of a trial show different textures (" +
                                  in_quotes(texture) + " and " +
                                  in_quotes(planned.stimulus.texture) +
                                  "); a selection compares renderings of one texture");
          }
        }
        if (protocol_.realism_standard == RealismStandard::photograph &&
            !trial.question.standard_picture) {
          report(texture.empty() ? presented : pointer_to("/textures", texture),
                 "realism is measured against a photograph here: give the texture a \"picture\"");
        }
        if (protocol_.realism_standard == RealismStandard::physical_sample &&
            (texture.empty() || protocol_.textures.at(texture).code.empty())) {
          report(texture.empty() ? presented : pointer_to("/textures", texture),
                 "realism is measured against a physical sample here: give the texture the "
                 "\"code\" on its label");
        }
        break;
      case ProtocolKind::matching:
      case ProtocolKind::magnitude:
        break;
      case ProtocolKind::recognition:
        if (!texture.empty() && trial.question.correct.front() != texture) {
          report(pointer + "/question/correct_factor",
                 "the correct response would be " + in_quotes(trial.question.correct.front()) +
                     ", but what is felt is " + in_quotes(texture));
        }
        break;
    }
    check_expectation(trial, on_bodies, pointer);
  }
}

}  // namespace asperity
