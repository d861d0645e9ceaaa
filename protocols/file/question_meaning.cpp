// Implements the checks that the question of a block can be asked and answered.

#include <algorithm>

#include "protocols/file/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;

void Meaning::check_question(const Block& block, const std::string& pointer) {
  const Protocol::TrialQuestionTemplate& question = block.questions.front();
  const std::string place = pointer + "/question";
  for (std::size_t i = 0; i < question.pictures.size(); ++i) {
    const std::string& name = question.pictures[i];
    const std::string at = pointer_to(place + "/pictures", i);
    const auto texture = protocol_.textures.find(name);
    const auto here = question.pictures.begin() + static_cast<std::ptrdiff_t>(i);
    if (texture == protocol_.textures.end()) {
      report(at, unknown_name("texture", name, protocol_.textures));
    } else if (!texture->second.picture) {
      report(at, "the texture " + in_quotes(name) + " has no \"picture\" to show; give it one");
    }
    if (std::find(question.pictures.begin(), here, name) != here) {
      report(at, "the picture of " + in_quotes(name) + " is listed twice; list it once");
    }
  }
  if (question.pictures.empty()) {
    for (const char* const key : {"reshuffle_pictures", "pictures_after_feeling"}) {
      if (question.reshuffle_pictures || block.pictures_after_feeling) {
        if (document_.root().at("blocks").at(block.name).at("question").contains(key)) {
          report_key(place + "/" + key,
                     "this question shows no pictures to choose from; remove this key");
        }
      }
    }
  } else if (block.pictures_after_feeling && block.allow_revisit) {
    report(place + "/pictures_after_feeling",
           "a participant who may return to a surface feels it with the pictures in view; set "
           "allow_revisit to false");
  }
  if (kind_.check_block != nullptr)
    kind_.check_block({protocol_, block, question, pointer, place}, *this);
  if (block.feedback != Block::Feedback::none && !kind_.has_correct_responses) {
    report(pointer + "/feedback", "feedback needs a correct response, and no response of a " +
                                      std::string(kind_.id) +
                                      " is correct or incorrect; remove this key");
  }
  check_criterion(block, pointer);
}

}  // namespace asperity
