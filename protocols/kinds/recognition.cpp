// The tests, checks and judgement of a recognition.

#include <array>
#include <cstddef>

#include "protocols/design/block_factors.h"
#include "protocols/design/wording.h"
#include "protocols/kinds/expected_textures.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/picture_responses.h"

namespace asperity {

namespace {

constexpr std::array kRecognitionTests{
    KindTest{"right", "whether the proportion correct is above the chance level"},
    KindTest{
        "textures",
        "whether a texture is recognised more often than expected by chance, for every texture"},
    KindTest{"information", "whether the responses depend on the stimulus"},
    KindTest{"sexes", "whether women and men differ"},
    KindTest{kGroupsTest, "whether two groups differ, for every pair of groups"}};

std::string item_of_recognition(const PlannedPresentation& surface) {
  return surface.stimulus.texture;
}

std::vector<std::string> correct_of_recognition(const Protocol::TrialQuestionTemplate& question,
                                                const Trial& trial) {
  return {text_of(trial.factors.at(question.correct_factor()))};
}

void check_block_of_recognition(const BlockOfKind& checked, ProblemSink& problems) {
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const std::string& place = checked.at_question;
  if (checked.block.presented.size() != 1) {
    problems.report(
        checked.pointer + "/presented",
        phrase("Protocols", "a recognition presents exactly one surface per trial; list one here"));
  }
  if (question.pictures.empty()) {
    problems.report(place,
                    phrase("Protocols", "a recognition needs %1 to choose from; add this key")
                        .with(key_name("pictures")));
  }
  if (question.correct_factor().empty()) {
    problems.report(
        place,
        phrase(
            "Protocols",
            "a recognition needs %1: the factor whose level is the correct picture; add this key")
            .with(key_name("correct_factor")));
    return;
  }
  if (!checked.protocol.factors.contains(question.correct_factor())) {
    problems.report(place + "/correct_factor",
                    unknown_name("factor", question.correct_factor(), checked.protocol.factors));
    return;
  }
  for (const Protocol::Run* const run : runs_of(checked.protocol, checked.block)) {
    if (factors_set_by(checked.block, run).contains(question.correct_factor())) continue;
    problems.report(place + "/correct_factor",
                    phrase("Protocols",
                           "the trials of this block do not set the factor %1: cross, list or draw "
                           "it, or run the block %2 of its levels")
                        .with(in_quotes(question.correct_factor()), key_name("for_each")));
  }
}

void check_trial_of_recognition(const BlockOfKind& checked, const Trial& trial,
                                ProblemSink& problems) {
  const std::string& texture = trial.presentations.front().stimulus.texture;
  const std::string& correct = find_question(trial, checked.question.name)->correct.front();
  if (texture.empty() || correct == texture) return;
  problems.report(checked.at_question + "/correct_factor",
                  phrase("Protocols",
                         "the correct response would be %1, but the texture felt is %2; name the "
                         "factor of the texture")
                      .with(in_quotes(correct), in_quotes(texture)));
}

VirtualResponse judge_recognition(const Judgement& judgement) {
  const Question& question = judgement.question;
  const std::vector<std::size_t> open = options_with_textures(judgement.protocol, question);
  const std::vector<ForceFeatures> expected =
      expected_of(judgement.expectations, textures_of(question, open));
  if (expected.size() != open.size()) {
    return {ChosenOption{open.at(judgement.observer.guess(open.size()))}, true};
  }
  return {ChosenOption{open.at(judgement.observer.recognise(judgement.felt.front(), expected))},
          false};
}

}  // namespace

const ExperimentKind& recognition_kind() {
  static const ExperimentKind kKind{.id = "recognition",
                                    .name = phrase("Protocols", "recognition"),
                                    .roles = kTargetRole,
                                    .form = ChoiceForm{},
                                    .has_expectations = true,
                                    .tests = kRecognitionTests,
                                    .item_of = item_of_recognition,
                                    .correct_of = correct_of_recognition,
                                    .check_block = check_block_of_recognition,
                                    .check_trial = check_trial_of_recognition,
                                    .judge = judge_recognition,
                                    .responses = &recognition_responses()};
  return kKind;
}

}  // namespace asperity
