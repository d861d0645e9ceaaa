// Whether the question of a block can be asked and answered.

#include <algorithm>

#include "protocols/file/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

void Meaning::check_question(const Block& block, const std::string& pointer) {
  const Protocol::TrialQuestionTemplate& question = block.question;
  const std::string place = pointer + "/question";
  for (std::size_t i = 0; i < question.pictures.size(); ++i) {
    const std::string& name = question.pictures[i];
    const std::string at = pointer_to(place + "/pictures", i);
    const auto texture = protocol_.textures.find(name);
    const auto here = question.pictures.begin() + static_cast<std::ptrdiff_t>(i);
    if (texture == protocol_.textures.end()) {
      report(at, unknown("texture", name, protocol_.textures));
    } else if (!texture->second.picture) {
      report(at, "the texture " + in_quotes(name) + " has no \"picture\" to show");
    }
    if (std::find(question.pictures.begin(), here, name) != here) {
      report(at, "the picture of " + in_quotes(name) + " is listed twice; list it once");
    }
  }
  if (question.pictures.empty()) {
    for (const char* const key : {"reshuffle_pictures", "pictures_after_feeling"}) {
      if (question.reshuffle_pictures || question.pictures_after_feeling) {
        if (document_.root().at("blocks").at(block.name).at("question").contains(key)) {
          report_key(place + "/" + key,
                     "this question shows no pictures to choose from; remove this key");
        }
      }
    }
  } else if (question.pictures_after_feeling && question.allow_revisit) {
    report(place + "/pictures_after_feeling",
           "a participant who may return to a surface feels it with the pictures in view; set "
           "allow_revisit to false");
  }
  switch (protocol_.kind) {
    case ProtocolKind::selection:
      if (block.presented.size() < 2) {
        report(pointer + "/presented", "a selection needs at least two surfaces to choose from");
      }
      if (!question.pictures.empty()) {
        report(place + "/pictures",
               "in a selection the options are the surfaces felt; the picture of the texture is "
               "shown when realism_standard is \"photograph\"");
      }
      if (!question.correct_factor.empty()) {
        report(place + "/correct_factor", "no response of a selection is correct or incorrect");
      }
      if (protocol_.realism_standard == RealismStandard::physical_sample &&
          question.experimenter_prompt.find("{code}") == std::string::npos) {
        report(place,
               "with the standard \"physical_sample\" the experimenter needs to know which sample "
               "to place: add \"experimenter_prompt\" with {code} in it, such as \"Place sample "
               "{code} next to the device.\"");
      }
      break;
    case ProtocolKind::matching:
      if (block.presented.size() < 2) {
        report(pointer + "/presented", "a matching needs at least two surfaces to assign");
      }
      if (question.pictures.size() != block.presented.size()) {
        report(place + (question.pictures.empty() ? "" : "/pictures"),
               "a matching needs as many pictures as surfaces, but there are " +
                   std::to_string(question.pictures.size()) + " and " +
                   std::to_string(block.presented.size()));
      }
      if (question.allow_cannot_tell) {
        report(place + "/allow_cannot_tell",
               "in a matching every surface gets a picture, and there is no \"cannot tell\"; set "
               "this to false");
      }
      if (!question.correct_factor.empty()) {
        report(place + "/correct_factor",
               "in a matching the correct responses are the textures felt; remove this key");
      }
      break;
    case ProtocolKind::recognition:
      if (block.presented.size() != 1) {
        report(pointer + "/presented", "a recognition presents exactly one surface per trial");
      }
      if (question.pictures.empty()) {
        report(place, "a recognition needs \"pictures\" to choose from");
      }
      if (question.correct_factor.empty()) {
        report(place,
               "a recognition needs \"correct_factor\": the factor whose level is the correct "
               "picture");
        break;
      }
      if (!protocol_.factors.contains(question.correct_factor)) {
        report(place + "/correct_factor",
               unknown("factor", question.correct_factor, protocol_.factors));
        break;
      }
      for (const Run* const run : runs_of(block)) {
        if (!factors_set_by(block, run).contains(question.correct_factor)) {
          report(place + "/correct_factor", "nothing sets the factor " +
                                                in_quotes(question.correct_factor) +
                                                " in the trials of this block: cross, list or draw "
                                                "it, or run the block for_each of its levels");
        }
      }
      break;
    case ProtocolKind::magnitude:
      if (block.presented.size() != 1) {
        report(pointer + "/presented", "a magnitude presents exactly one surface per trial");
      }
      if (!question.pictures.empty()) {
        report(place + "/pictures",
               "a magnitude is answered by a number, not by a picture; remove this key");
      }
      if (question.allow_cannot_tell) {
        report(place + "/allow_cannot_tell",
               "in a magnitude every surface gets a number, and there is no \"cannot tell\"; set "
               "this to false");
      }
      if (!question.correct_factor.empty()) {
        report(place + "/correct_factor",
               "a magnitude estimate is neither correct nor incorrect; remove this key");
      }
      break;
  }
  if (block.feedback != Block::Feedback::none && !has_right_answers(protocol_.kind)) {
    report(pointer + "/feedback", "feedback needs a correct response, and no response of a " +
                                      std::string(text_of(protocol_.kind)) +
                                      " is correct or incorrect");
  }
  check_criterion(block, pointer);
}

}  // namespace asperity
