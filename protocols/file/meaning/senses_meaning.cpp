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
        phrase("Protocols",
               "a blindfolded participant sees no scene; remove it, or choose another %1")
            .with(key_name("vision")));
  }
  if (checked.protocol.realism_standard == RealismStandard::photograph) {
    checked.report(
        "/realism_standard",
        phrase("Protocols",
               "a blindfolded participant sees no photograph while feeling; measure "
               "against %1 or %2, or choose another %3")
            .with(word_name("physical_sample"), word_name("memory"), key_name("vision")));
  }
  for (const auto& [name, block] : checked.protocol.blocks) {
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      if (block.questions[i].pictures.empty() || block.pictures_after_feeling) continue;
      checked.report(
          place_of_question(block, i) + "/pictures",
          phrase("Protocols",
                 "a blindfolded participant sees no pictures while feeling; set %1 to true (the "
                 "eye mask is removed for the question), or choose another %2")
              .with(key_name("pictures_after_feeling"), key_name("vision")));
    }
  }
}

}  // namespace

void check_senses(CheckedDocument& checked) {
  const Protocol::Noise& noise = checked.protocol.masking_noise;
  if (noise.kind != Protocol::Noise::Kind::none && !noise.level_dBA) {
    checked.report("/environment/masking_noise",
                   phrase("Protocols", "masking noise needs a level; add the key %1")
                       .with(key_name("level_dBA")));
  }
  const std::vector<std::string> cues = speech_cues();
  for (const auto& [cue, path] : checked.protocol.speech) {
    const std::string pointer = pointer_to("/environment/speech", cue);
    check_path(checked, path, pointer);
    if (std::find(cues.begin(), cues.end(), cue) == cues.end()) {
      checked.report_key(
          pointer,
          phrase("Protocols", "%1; use %2 to %3, %4 to %5, %6")
              .with(
                  with_guess(phrase("Protocols", "there is no cue %1").with(in_quotes(cue)), cue,
                             cues),
                  in_quotes("surface_1"), in_quotes("surface_26"), in_quotes("option_1"),
                  in_quotes("option_26"),
                  joined_by_or(quoted({"next", "question", "accepted", "refused", "right", "wrong",
                                       "rest", "paused", "mask_on", "mask_off", "finished"}))));
    }
  }
  if (checked.protocol.vision == Vision::blindfold) check_blindfold(checked);
}

}  // namespace asperity
