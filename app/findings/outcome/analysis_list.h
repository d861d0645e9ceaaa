// Declares and lists the analyses of the kinds of experiment; a new kind adds its declaration and its line.

#pragma once

#include <array>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

const StudyAnalysis& selection_analysis();
const StudyAnalysis& matching_analysis();
const StudyAnalysis& recognition_analysis();
const StudyAnalysis& magnitude_analysis();
const StudyAnalysis& rating_analysis();
const StudyAnalysis& paired_comparison_analysis();
const StudyAnalysis& discrimination_analysis();
const StudyAnalysis& similarity_analysis();

/// All of them, in the order of the kinds (protocols/kinds/kind_list.h).
inline constexpr std::array kAnalysisFunctions{
    &selection_analysis,      &matching_analysis,  &recognition_analysis,
    &magnitude_analysis,      &rating_analysis,    &paired_comparison_analysis,
    &discrimination_analysis, &similarity_analysis};

}  // namespace asperity
