// Declares the claims of the tests, and describes the task by the number of pictures.

#include "app/findings/methods/recognition/recognition_analysis.h"

#include <array>
#include <set>

#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/display_number.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr std::array kRecognitionClaims{
    TestClaim{"right", "binomial",
              "The proportion of correct responses was significantly above the chance level%3", "",
              "The proportion of correct responses was not significantly above the chance level%3"},
    TestClaim{
        "right", "", "The mean proportion correct was significantly above the chance level%3",
        "The mean proportion correct was significantly below the chance level%3",
        "The mean proportion correct was not significantly different from the chance level%3"},
    TestClaim{
        "textures", "",
        "The proportion of correct responses to %1 was significantly above the chance level%3", "",
        "The proportion of correct responses to %1 was not significantly above the chance level%3"},
    TestClaim{"information", "", "The responses were significantly associated with the stimulus",
              "", "The responses were not significantly associated with the stimulus"},
    TestClaim{"sexes", "",
              "The mean proportion correct of women was significantly higher than that of men",
              "The mean proportion correct of women was significantly lower than that of men",
              "The mean proportions correct of women and men were not significantly different"},
    TestClaim{kGroupsTest, "",
              "The mean proportion correct was significantly higher in the group %1 than in the "
              "group %2",
              "The mean proportion correct was significantly lower in the group %1 than in the "
              "group %2",
              "The mean proportions correct of the groups %1 and %2 were not significantly "
              "different"}};

std::string among_pictures(const Protocol& protocol) {
  std::set<std::size_t> numbers{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "recognition") continue;
    for (const auto& question : block.questions) {
      if (kind_of_question(kind_of(block), question) == &kind_of(block)) {
        numbers.insert(question.pictures.size());
      }
    }
  }
  return " among " + (numbers.size() == 1 && *numbers.begin() > 1 ? count_in_words(*numbers.begin())
                                                                  : std::string("several"));
}

std::string task_of_recognition(const Protocol&) {
  return "Task: in each trial, one texture is presented, and its picture is to be chosen from "
         "several.";
}

std::string paper_task_of_recognition(const Protocol& protocol) {
  return ", and its picture was to be chosen" + among_pictures(protocol) + '.';
}

}  // namespace

const StudyAnalysis& recognition_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "recognition",
                                       .name = phrase("Analysis", "absolute identification"),
                                       .claims = kRecognitionClaims,
                                       .task = task_of_recognition,
                                       .task_for_paper = paper_task_of_recognition,
                                       .analyze = analyze_recognition,
                                       .test_family = test_recognition};
  return kAnalysis;
}

}  // namespace asperity
