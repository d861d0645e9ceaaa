// Implements the checks of blocks that match roughness, and of those that present matched surfaces.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

namespace {

/// The stimulus to which matches are assigned.
std::string key_of(const PlannedPresentation& planned) {
  return planned.stimulus_template + '\n' + planned.stimulus.model + '\n' +
         planned.stimulus.texture;
}

Phrase name_of(const PlannedPresentation& planned) {
  return (planned.stimulus.texture.empty()
              ? phrase("Protocols", "the stimulus %1 with the model %2")
              : phrase("Protocols", "the stimulus %1 with the model %2 and the texture %3"))
      .with(in_quotes(planned.stimulus_template), in_quotes(planned.stimulus.model),
            in_quotes(planned.stimulus.texture));
}

const PlannedPresentation* surface_of_role(const Trial& trial, const std::string& role) {
  const auto found = std::find_if(trial.presentations.begin(), trial.presentations.end(),
                                  [&role](const auto& each) { return each.role == role; });
  return found == trial.presentations.end() ? nullptr : &*found;
}

}  // namespace

void check_relative_amplitude(CheckedDocument& checked, const Block& block,
                              const StimulusTemplate& stimulus, const std::string& pointer) {
  const Dimension& dimension = *block.vary;
  for (const auto& [id, place] :
       texts_of(checked, stimulus.model, pointer_to("/stimuli", stimulus.name) + "/model")) {
    const auto model = checked.models.find(id);
    if (model == checked.models.end() || model->second->amplitude_parameter) continue;
    checked.report(pointer + "/vary/parameter",
                   phrase("Protocols",
                          "the model %1 of the stimulus %2 has no amplitude; exclude it from the "
                          "block, or use a model that has one")
                       .with(in_quotes(id), in_quotes(stimulus.name)));
  }
  if (!dimension.values().empty() && !(dimension.values().front() > 0.0)) {
    checked.report(pointer + "/vary/" + std::string(asperity::key_of(dimension.measure)),
                   phrase("Protocols",
                          "a relative amplitude is above 0, but the lowest level is %1; raise it, "
                          "or state %2")
                       .with(digits(dimension.levels().front()), key_name("levels_decibels")));
  }
  if (block.equal_roughness) {
    checked.report_key(
        pointer + "/equal_roughness",
        phrase("Protocols",
               "this block varies the relative amplitude, which equal roughness would determine; "
               "remove one of the two keys"));
  }
}

/// Whether the block that is named can match roughness, and is run before.
void check_equal_roughness(CheckedDocument& checked, const Block& block,
                           const std::string& pointer) {
  if (!block.equal_roughness) return;
  const std::string place = pointer + "/equal_roughness/matched_in";
  const std::string& name = block.equal_roughness->matched_in;
  const auto found = checked.protocol.blocks.find(name);
  if (found == checked.protocol.blocks.end()) {
    checked.report(place, unknown_name("block", name, checked.protocol.blocks));
    return;
  }
  const Block& matching = found->second;
  const std::string at_matching = pointer_to("/blocks", name);
  if (!matching.vary || !matching.vary->is_relative_amplitude()) {
    checked.report(place,
                   phrase("Protocols",
                          "the block %1 does not match roughness: state the parameter %3 under %2 "
                          "of it, or name another block")
                       .with(in_quotes(name), key_name("vary"), in_quotes(kRelativeAmplitude)));
    return;
  }
  const Protocol::TrialQuestionTemplate* const judged = judged_question(matching);
  if (judged != nullptr && judged->judgement() != DiscriminationJudgement::comparison) {
    checked.report(
        place_of_question(matching, static_cast<std::size_t>(judged - matching.questions.data())) +
            "/judgement",
        phrase("Protocols",
               "roughness is matched where both surfaces are judged rougher equally often, which "
               "the judgement %1 does not estimate; use %2")
            .with(word_name("performance"), word_name("comparison")));
  }
  if (!matching.procedure ||
      !std::all_of(
          matching.procedure->tracks.begin(), matching.procedure->tracks.end(),
          [](const ProcedureSettings& settings) { return equality_track(settings).has_value(); })) {
    checked.report(
        at_matching + (matching.procedure ? "/procedure" : ""),
        phrase("Protocols",
               "the block %1 needs the amplitudes of equal roughness from this block: state a "
               "procedure %2 with %3: 1, %4: 1 and equal steps")
            .with(in_quotes(block.name), word_name("transformed_up_down"), key_name("down"),
                  key_name("up")));
  }
  for (const std::string& factor : matching.drawn) {
    checked.report(at_matching + "/drawn",
                   phrase("Protocols",
                          "a track matches one stimulus, but the factor %1 is drawn for every "
                          "trial; cross it instead")
                       .with(in_quotes(factor)));
  }
  std::size_t runs_before = 0;
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&checked.protocol.flow[i]);
    if (run == nullptr) continue;
    const std::string at_run = pointer_to("/flow", i);
    if (run->block == name) {
      if (++runs_before > 1) {
        checked.report(
            at_run + "/run",
            phrase("Protocols", "the block %1 would match the same stimuli twice; run it once")
                .with(in_quotes(name)));
      }
      if (!run->for_each.empty()) {
        checked.report(at_run + "/for_each",
                       phrase("Protocols",
                              "the block %1 matches all stimuli in one run; cross the factor %2 in "
                              "the block instead")
                           .with(in_quotes(name), in_quotes(run->for_each)));
      }
    }
    if (run->block == block.name && runs_before == 0) {
      checked.report(at_run + "/run",
                     phrase("Protocols",
                            "the block %1 presents surfaces of equal roughness, but the block %2, "
                            "which matches them, has not been run; run it before")
                         .with(in_quotes(block.name), in_quotes(name)));
    }
  }
}

/// Whether every surface of a block with equal roughness is matched, once, or is the reference.
void check_matches(CheckedDocument& checked, const std::vector<Trial>& possible) {
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (!block.equal_roughness) continue;
    const std::string& matched_in = block.equal_roughness->matched_in;
    const Block& matching = checked.protocol.blocks.at(matched_in);
    const std::string at_matching = pointer_to("/blocks", matched_in);
    std::map<std::string, const PlannedPresentation*> matched{};
    std::vector<const PlannedPresentation*> references{};
    for (const Trial& trial : possible) {
      if (trial.block != matched_in) continue;
      const PlannedPresentation* const varied = surface_of_role(trial, matching.vary->role);
      const PlannedPresentation* const reference =
          surface_of_role(trial, matching.vary->standard_role);
      if (varied == nullptr || reference == nullptr) continue;
      references.push_back(reference);
      const auto [known, is_new] = matched.emplace(key_of(*varied), varied);
      if (!is_new && !are_of_same_stimulus(*known->second, *varied)) {
        checked.report(
            at_matching + "/presented",
            phrase("Protocols",
                   "%1 would be matched several times, with different parameters; a match belongs "
                   "to a stimulus, a model and a texture: define a stimulus for each of them, with "
                   "a separate block that matches it and a separate block that presents it")
                .with(name_of(*varied)));
      }
      if (are_of_same_stimulus(*varied, *reference)) {
        checked.report(
            at_matching,
            phrase("Protocols",
                   "%1 would be matched with itself: it is the reference; list it under %2")
                .with(name_of(*varied), key_name("exclude")));
      }
    }
    for (const Trial& trial : possible) {
      if (trial.block != name) continue;
      for (const PlannedPresentation& planned : trial.presentations) {
        const auto own = matched.find(key_of(planned));
        if (own != matched.end() && are_of_same_stimulus(*own->second, planned)) continue;
        if (own == matched.end() &&
            std::any_of(references.begin(), references.end(), [&planned](const auto* reference) {
              return are_of_same_stimulus(*reference, planned);
            })) {
          continue;
        }
        checked.report(pointer_to("/blocks", name) + "/equal_roughness",
                       phrase("Protocols",
                              "%1 is neither matched in the block %2 nor its reference; present "
                              "the same stimulus there, with the same parameters, material and %3")
                           .with(name_of(planned), in_quotes(matched_in), key_name("equal_force")));
      }
    }
  }
}

}  // namespace asperity
