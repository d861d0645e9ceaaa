// The tests, checks and judgement of a matching.

#include <array>
#include <cstddef>
#include <numeric>

#include "protocols/kinds/expected_textures.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/picture_responses.h"

namespace asperity {

namespace {

constexpr std::array kMatchingTests{
    KindTest{"items", "whether more items are matched correctly than expected by chance"},
    KindTest{"whole", "whether more trials are completely correct than expected by chance"},
    KindTest{"textures",
             "whether a texture is matched correctly more often than expected by chance, for every "
             "texture"},
    KindTest{"sexes", "whether women and men differ"},
    KindTest{kGroupsTest, "whether two groups differ, for every pair of groups"}};

std::string item_of_matching(const PlannedPresentation& surface) {
  return surface.stimulus.texture;
}

std::vector<std::string> correct_of_matching(const Protocol::TrialQuestionTemplate&,
                                             const Trial& trial) {
  std::vector<std::string> correct{};
  for (const PlannedPresentation& planned : trial.presentations) correct.push_back(planned.item);
  return correct;
}

void check_block_of_matching(const BlockOfKind& checked, ProblemSink& problems) {
  const Protocol::TrialQuestionTemplate& question = checked.question;
  const std::string& place = checked.at_question;
  if (checked.block.presented.size() < 2) {
    problems.report(
        checked.pointer + "/presented",
        phrase("Protocols", "a matching needs at least two surfaces to assign; list them here"));
  }
  if (question.pictures.size() != checked.block.presented.size()) {
    problems.report(place + (question.pictures.empty() ? "" : "/pictures"),
                    phrase("Protocols",
                           "a matching needs as many pictures as surfaces; pictures given: %1, "
                           "surfaces given: %2; add or remove pictures")
                        .with(std::to_string(question.pictures.size()),
                              std::to_string(checked.block.presented.size())));
  }
}

VirtualResponse judge_matching(const Judgement& judgement) {
  const Question& question = judgement.question;
  const std::vector<std::size_t> open = options_with_textures(judgement.protocol, question);
  const std::vector<ForceFeatures> expected =
      expected_of(judgement.expectations, textures_of(question, open));
  const bool is_guess = expected.size() != open.size();
  std::vector<std::size_t> places{};
  if (is_guess) {
    places.resize(judgement.felt.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    Random guessing = judgement.of_attempt.split("assignment");
    guessing.shuffle(std::span<std::size_t>(places));
  } else {
    places = judgement.observer.match(judgement.felt, expected);
  }
  AssignedOptions assigned{};
  for (const std::size_t place : places) assigned.options.push_back(open.at(place));
  return {std::move(assigned), is_guess};
}

}  // namespace

const ExperimentKind& matching_kind() {
  static const ExperimentKind kKind{.id = "matching",
                                    .name = phrase("Protocols", "matching"),
                                    .roles = kTargetRole,
                                    .form = AssignmentForm{},
                                    .has_expectations = true,
                                    .tests = kMatchingTests,
                                    .item_of = item_of_matching,
                                    .correct_of = correct_of_matching,
                                    .check_block = check_block_of_matching,
                                    .judge = judge_matching,
                                    .responses = &matching_responses()};
  return kKind;
}

}  // namespace asperity
