// Implements the registry of the analyses of kinds.

#include <algorithm>
#include <array>
#include <tuple>

#include "app/findings/outcome/analysis_list.h"

namespace asperity {

std::span<const StudyAnalysis* const> study_analyses() {
  static const std::array kAnalyses = std::apply(
      [](const auto... analysis) { return std::array{&analysis()...}; }, kAnalysisFunctions);
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
