// The checks of a comparison with a standard of realism.

#include "protocols/kinds/realism.h"

#include <string>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"

namespace asperity {

void check_prompt_for_sample(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.protocol.realism_standard == RealismStandard::physical_sample &&
      checked.block.experimenter_prompt.find("{code}") == std::string::npos) {
    problems.report(checked.at_question,
                    "with the standard \"physical_sample\" the experimenter needs to know which "
                    "sample to place: add \"experimenter_prompt\" with {code} in it, such as "
                    "\"Place sample {code} next to the device.\"");
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
    problems.report(presented,
                    "the surfaces of a trial show different textures (" + in_quotes(texture) +
                        " and " + in_quotes(planned.stimulus.texture) +
                        "); realism is compared between renderings of one texture; give them the "
                        "same texture");
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
}

}  // namespace asperity
