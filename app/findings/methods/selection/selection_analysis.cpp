// Declares the claims of the tests, and describes the task by its questions, its standard or its varied parameter.

#include "app/findings/methods/selection/selection_analysis.h"

#include <array>

#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/task_words.h"
#include "app/findings/shared/selection_questions.h"
#include "app/words/text_parts.h"
#include "protocols/file/stored_protocol.h"

namespace asperity {

namespace {

constexpr std::array kSelectionClaims{
    TestClaim{"pairs", "", "The item %1 was chosen significantly more often than %2",
              "The item %1 was chosen significantly less often than %2",
              "The numbers of choices of %1 and %2 were not significantly different"},
    TestClaim{"target_pairs", "", "The item %1 was chosen significantly more often than %2",
              "The item %1 was chosen significantly less often than %2",
              "The numbers of choices of %1 and %2 were not significantly different"},
    TestClaim{"preference", "", "The numbers of choices of the items were significantly different",
              "", "The numbers of choices of the items were not significantly different"},
    TestClaim{
        "position", "",
        "The numbers of choices of the positions in a trial were significantly different", "",
        "The numbers of choices of the positions in a trial were not significantly different"},
    TestClaim{"textures", "",
              "The proportion of choices of the target differed significantly between the textures",
              "",
              "The proportion of choices of the target did not differ significantly between the "
              "textures"},
    TestClaim{kGroupsTest, "",
              "The mean proportion of choices of the target was significantly higher in the group "
              "%1 than in the group %2",
              "The mean proportion of choices of the target was significantly lower in the group "
              "%1 than in the group %2",
              "The mean proportions of choices of the target of the groups %1 and %2 were not "
              "significantly different"},
    kClaimOfChosenItems};

std::string task_of_selection(const Protocol& protocol) {
  if (const auto parameter = stored_protocol(protocol.source).compared_parameter) {
    return "Task: in each trial, surfaces that differ only in " + words_of_parameter(*parameter) +
           " are presented, and one of them is to be chosen.";
  }
  std::string text = "Task: in each trial, several surfaces are presented, and one is to be chosen";
  const std::vector<std::string> questions = main_questions(protocol);
  if (!questions.empty()) text += ": " + listed(questions);
  if (!protocol.realism_standard) return text + '.';
  switch (*protocol.realism_standard) {
    case RealismStandard::photograph:
      return text + "; the standard is the texture’s picture.";
    case RealismStandard::physical_sample:
      return text + "; the standard is a physical sample.";
    case RealismStandard::memory:
      return text + "; the standard is the participant’s own idea of the material.";
  }
  return text + '.';
}

std::string paper_task_of_selection(const Protocol& protocol) {
  const auto parameter = stored_protocol(protocol.source).compared_parameter;
  return (parameter ? "; they differed in " + words_of_parameter(*parameter) + " alone" : "") +
         ", and one was to be chosen.";
}

}  // namespace

const StudyAnalysis& selection_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "selection",
                                       .name = phrase("Analysis", "best-of-n choice"),
                                       .claims = kSelectionClaims,
                                       .task = task_of_selection,
                                       .task_for_paper = paper_task_of_selection,
                                       .analyze = analyze_selection,
                                       .test_family = test_selection,
                                       .estimates = choices_sentence};
  return kAnalysis;
}

}  // namespace asperity
