// Declares the claims of the tests, and describes the task by its questions and whether ties are allowed.

#include "app/findings/methods/paired_comparison/paired_comparison_analysis.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/task_words.h"
#include "app/findings/shared/selection_questions.h"
#include "app/words/text_parts.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/kind_list.h"

namespace asperity {

namespace {

constexpr std::array kPairedClaims{
    TestClaim{"pairs", "", "The item %1 was chosen significantly more often than %2",
              "The item %1 was chosen significantly less often than %2",
              "The numbers of choices of %1 and %2 were not significantly different"},
    TestClaim{"preference", "", "The numbers of choices of the items were significantly different",
              "", "The numbers of choices of the items were not significantly different"},
    TestClaim{"position", "",
              "The numbers of choices of the first and the second surface of a trial were "
              "significantly different",
              "",
              "The numbers of choices of the first and the second surface of a trial were not "
              "significantly different"},
    kClaimOfChosenItems};

/// The questions of the main blocks of this kind in quotation marks, each once; and whether one of them has ties.
struct PairedQuestions {
  std::vector<std::string> prompts{};
  bool have_ties = false;
};

PairedQuestions paired_questions(const Protocol& protocol) {
  PairedQuestions asked{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != paired_comparison_kind().id) continue;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      if (kind_of_question(kind_of(block), question) != &kind_of(block)) continue;
      asked.have_ties = asked.have_ties || question.own_as<PairQuestion>() != nullptr;
      const std::string prompt = quoted(question.prompt);
      if (std::find(asked.prompts.begin(), asked.prompts.end(), prompt) == asked.prompts.end()) {
        asked.prompts.push_back(prompt);
      }
    }
  }
  return asked;
}

std::string task_of_pairs(const Protocol& protocol) {
  const PairedQuestions asked = paired_questions(protocol);
  std::string text = "Task: in each trial, two surfaces are presented, and one of them";
  if (asked.have_ties) text += ", or a tie,";
  text += " is to be chosen";
  if (asked.prompts.empty()) return text + '.';
  const std::string prompts = listed(asked.prompts);
  return text + ": " + prompts + (prompts.ends_with("?”") ? "" : ".");
}

std::string paper_task_of_pairs(const Protocol& protocol) {
  const PairedQuestions asked = paired_questions(protocol);
  std::string text = ", and one of them";
  if (asked.have_ties) text += ", or a tie,";
  return text + " was to be chosen.";
}

}  // namespace

const StudyAnalysis& paired_comparison_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "paired_comparison",
                                       .name = phrase("Analysis", "paired comparison"),
                                       .claims = kPairedClaims,
                                       .task = task_of_pairs,
                                       .task_for_paper = paper_task_of_pairs,
                                       .analyze = analyze_paired_comparison,
                                       .test_family = test_paired_comparison,
                                       .estimates = pairs_sentence};
  return kAnalysis;
}

}  // namespace asperity
