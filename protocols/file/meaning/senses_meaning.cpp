// Implements the checks that participants can see and hear what the protocol presents.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

namespace {

/// Reports what would have to be seen while the mask is worn.
void check_blindfold(CheckedDocument& checked) {
  if (checked.protocol.scene) {
    checked.report_key(
        "/environment/scene",
        "a blindfolded participant sees no scene; remove it, or choose another \"vision\"");
  }
  if (checked.protocol.realism_standard == RealismStandard::photograph) {
    checked.report("/realism_standard",
                   "a blindfolded participant sees no photograph while feeling; measure against "
                   "\"physical_sample\" or \"memory\", or choose another \"vision\"");
  }
  for (const auto& [name, block] : checked.protocol.blocks) {
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      if (block.questions[i].pictures.empty() || block.pictures_after_feeling) continue;
      checked.report(
          place_of_question(block, i) + "/pictures",
          "a blindfolded participant sees no pictures while feeling; set pictures_after_feeling "
          "to true (the eye mask is removed for the question), or choose another \"vision\"");
    }
  }
}

}  // namespace

void check_senses(CheckedDocument& checked) {
  const Protocol::Noise& noise = checked.protocol.masking_noise;
  if (noise.kind != Protocol::Noise::Kind::none && !noise.level_dBA) {
    checked.report("/environment/masking_noise",
                   "masking noise needs a level; add the key \"level_dBA\"");
  }
  const std::vector<std::string> cues = speech_cues();
  for (const auto& [cue, path] : checked.protocol.speech) {
    const std::string pointer = pointer_to("/environment/speech", cue);
    check_path(checked, path, pointer);
    if (std::find(cues.begin(), cues.end(), cue) == cues.end()) {
      checked.report_key(
          pointer, "there is no cue " + in_quotes(cue) + did_you_mean(cue, cues) +
                       "; use \"surface_1\" to \"surface_26\", \"option_1\" to \"option_26\", "
                       "\"next\", \"question\", \"accepted\", \"refused\", \"right\", "
                       "\"wrong\", \"rest\", \"paused\", \"mask_on\", \"mask_off\" or "
                       "\"finished\"");
    }
  }
  if (checked.protocol.vision == Vision::blindfold) check_blindfold(checked);
}

}  // namespace asperity
