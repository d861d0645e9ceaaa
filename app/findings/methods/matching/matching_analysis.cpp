// Declares the claims of the tests, the task, and that the items of a trial are scored one by one.

#include "app/findings/methods/matching/matching_analysis.h"

#include <array>

#include "app/findings/outcome/analysis_list.h"

namespace asperity {

namespace {

constexpr std::array kMatchingClaims{
    TestClaim{
        "items", "",
        "The proportion of correctly matched items was significantly above the chance level%3", "",
        "The proportion of correctly matched items was not significantly above the chance level%3"},
    TestClaim{
        "whole", "",
        "The proportion of trials with all items correct was significantly above the chance "
        "level%3",
        "",
        "The proportion of trials with all items correct was not significantly above the chance "
        "level%3"},
    TestClaim{
        "textures", "",
        "The proportion of correct matches of %1 was significantly above the chance level%3", "",
        "The proportion of correct matches of %1 was not significantly above the chance level%3"},
    TestClaim{"sexes", "", "Women matched significantly more items correctly than men",
              "Women matched significantly fewer items correctly than men",
              "The numbers of correctly matched items of women and men were not significantly "
              "different"},
    TestClaim{kGroupsTest, "",
              "The group %1 matched a significantly higher proportion of items correctly than the "
              "group %2",
              "The group %1 matched a significantly lower proportion of items correctly than the "
              "group %2",
              "The proportions of correctly matched items of the groups %1 and %2 were not "
              "significantly different"}};

std::string task_of_matching(const Protocol&) {
  return "Task: in each trial, several textures are presented, and each is to be assigned to one "
         "of an equal number of pictures.";
}

std::string paper_task_of_matching(const Protocol&) {
  return ", and each was to be assigned to one of an equal number of pictures.";
}

}  // namespace

const StudyAnalysis& matching_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "matching",
                                       .name = phrase("Analysis", "picture matching"),
                                       .scores_items = true,
                                       .claims = kMatchingClaims,
                                       .task = task_of_matching,
                                       .task_for_paper = paper_task_of_matching,
                                       .analyze = analyze_matching,
                                       .test_family = test_matching};
  return kAnalysis;
}

}  // namespace asperity
