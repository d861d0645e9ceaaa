// Declares the claims of the tests, the task by its scales, and the sentences on multidimensional scaling.

#include "app/findings/methods/similarity/similarity_analysis.h"

#include <array>
#include <string>

#include "app/findings/outcome/analysis_list.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/task_words.h"
#include "protocols/kinds/similarity.h"

namespace asperity {

namespace {

constexpr std::array kSimilarityClaims{
    TestClaim{"configuration", "",
              "The stress of the configuration was significantly lower than that of permuted "
              "ratings",
              "",
              "The stress of the configuration was not significantly different from that of "
              "permuted ratings"},
    TestClaim{"identical", "",
              "Different surfaces were rated as significantly more dissimilar than identical ones",
              "Different surfaces were rated as significantly less dissimilar than identical ones",
              "The ratings of different and identical surfaces were not significantly different"},
    TestClaim{"properties", "", "The property “%1” was significantly related to the configuration",
              "", "The property “%1” was not significantly related to the configuration"},
    TestClaim{kGroupProfilesTest, "",
              "The ratings of the pairs were significantly different in the groups %1 and %2", "",
              "The ratings of the pairs were not significantly different in the groups %1 and "
              "%2"}};

/// Whether the main blocks ask for the similarity instead of the dissimilarity.
bool asks_for_similarity(const Protocol& protocol) {
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "similarity") continue;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      if (rated_quantity(question) == RatedQuantity::similarity) return true;
    }
  }
  return false;
}

std::string rated_quantity_text(const Protocol& protocol) {
  return asks_for_similarity(protocol) ? "similarity" : "dissimilarity";
}

std::string task_of_similarity(const Protocol& protocol) {
  return "Task: in each trial, two surfaces are presented, and their " +
         rated_quantity_text(protocol) + " is rated on " +
         scales_of_blocks(protocol, "similarity") + '.';
}

std::string paper_task_of_similarity(const Protocol& protocol) {
  return ", and their " + rated_quantity_text(protocol) + " was rated on " +
         scales_of_blocks(protocol, "similarity") + '.';
}

std::string fit_of_similarity(const Protocol& protocol, const AnalysisOutcome&) {
  return std::string(asks_for_similarity(protocol)
                         ? "Ratings of similarity were subtracted from the maximum of the scale. "
                         : "") +
         "Each participant’s ratings of a pair were averaged, in either order, and their means "
         "over "
         "the participants were analysed by non-metric multidimensional scaling (SMACOF) "
         "[Kruskal 1964]. The number of dimensions is the smallest one whose error in "
         "leave-one-participant-out cross-validation was within one standard error of the smallest "
         "error, and at least two. 95 % ellipses of the positions are from a bootstrap over the "
         "participants with Procrustes rotation [Gower 1975]. Weights of the dimensions for each "
         "participant are from INDSCAL [Carroll 1970]. The dendrogram is based on average linkage.";
}

}  // namespace

const StudyAnalysis& similarity_analysis() {
  static const StudyAnalysis kAnalysis{.kind = "similarity",
                                       .name = phrase("Analysis", "similarity"),
                                       .claims = kSimilarityClaims,
                                       .task = task_of_similarity,
                                       .task_for_paper = paper_task_of_similarity,
                                       .fit_for_paper = fit_of_similarity,
                                       .analyze = analyze_similarity,
                                       .test_family = test_similarity,
                                       .estimates = configuration_sentence};
  return kAnalysis;
}

}  // namespace asperity
