// The checks of a comparison with a standard of realism.

#include "protocols/kinds/realism.h"

#include <string>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"

namespace asperity {

void check_prompt_for_sample(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.protocol.realism_standard == RealismStandard::physical_sample &&
      checked.block.experimenter_prompt.find("{code}") == std::string::npos) {
    problems.report(
        checked.at_question,
        phrase("Protocols",
               "with the standard %1 the experimenter needs to know which sample to place: add %2 "
               "with {code} in it, such as \"Place sample {code} next to the device.\"")
            .with(word_name("physical_sample"), key_name("experimenter_prompt")));
  }
}

void check_surfaces_with_standard(const BlockOfKind& checked, const Trial& trial,
                                  ProblemSink& problems) {
  const Protocol& protocol = checked.protocol;
  const std::string presented = checked.pointer + "/presented";
  const std::string& texture = trial.presentations.front().stimulus.texture;
  const std::string at_texture = texture.empty() ? presented : pointer_to("/textures", texture);
  for (const PlannedPresentation& planned : trial.presentations) {
    if (planned.stimulus.texture == texture) continue;
    problems.report(
        presented, phrase("Protocols",
                          "the surfaces of a trial show different textures (%1 and %2); realism is "
                          "compared between renderings of one texture; give them the same texture")
                       .with(in_quotes(texture), in_quotes(planned.stimulus.texture)));
  }
  if (protocol.realism_standard == RealismStandard::photograph && !trial.standard_picture) {
    problems.report(
        at_texture,
        phrase("Protocols", "realism is measured against a photograph here: give the texture a %1")
            .with(key_name("picture")));
  }
  if (protocol.realism_standard == RealismStandard::physical_sample &&
      (texture.empty() || protocol.textures.at(texture).code.empty())) {
    problems.report(at_texture, phrase("Protocols",
                                       "realism is measured against a physical sample here: give "
                                       "the texture the %1 on its label")
                                    .with(key_name("code")));
  }
}

}  // namespace asperity
