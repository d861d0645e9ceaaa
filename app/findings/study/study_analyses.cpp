// The registry of the analyses of kinds; a new kind adds its include and its line.

#include <algorithm>
#include <array>

#include "app/findings/methods/discrimination/discrimination_analysis.h"
#include "app/findings/methods/magnitude/magnitude_analysis.h"
#include "app/findings/methods/matching/matching_analysis.h"
#include "app/findings/methods/paired_comparison/paired_comparison_analysis.h"
#include "app/findings/methods/rating/rating_analysis.h"
#include "app/findings/methods/recognition/recognition_analysis.h"
#include "app/findings/methods/selection/selection_analysis.h"
#include "app/findings/methods/similarity/similarity_analysis.h"
#include "app/findings/outcome/study_analysis.h"

namespace asperity {

std::span<const StudyAnalysis* const> study_analyses() {
  static const std::array kAnalyses{&selection_analysis(),      &matching_analysis(),
                                    &recognition_analysis(),    &magnitude_analysis(),
                                    &rating_analysis(),         &paired_comparison_analysis(),
                                    &discrimination_analysis(), &similarity_analysis()};
  return kAnalyses;
}

const StudyAnalysis* find_analysis(std::string_view kind) noexcept {
  const auto analyses = study_analyses();
  const auto found =
      std::find_if(analyses.begin(), analyses.end(),
                   [kind](const StudyAnalysis* analysis) { return analysis->kind == kind; });
  return found == analyses.end() ? nullptr : *found;
}

std::string name_of_kind(std::string_view kind) {
  const StudyAnalysis* const analysis = find_analysis(kind);
  return analysis == nullptr ? std::string(kind) : analysis->name.english();
}

}  // namespace asperity
