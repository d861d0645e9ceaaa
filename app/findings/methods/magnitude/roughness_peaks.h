// Reports the spacings of maximum roughness of a magnitude estimation: its tables and its questions.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

/// The table of the maxima of the curves, their spacings, and the p of their being maxima.
inline constexpr const char* kPeaks = "peaks";
inline const ResultColumn kPeakSpacing{.id = "peak_m",
                                       .heading = phrase("AnalysisWords", "peak"),
                                       .unit = "m",
                                       .digits = Digits::length};
inline const ResultColumn kInteriorP{.id = "p_interior",
                                     .heading = phrase("AnalysisWords", "p, interior maximum"),
                                     .digits = Digits::p};

/// Whether the test for an interior maximum of the curve of a condition is significant.
bool has_interior_maximum(const FoundNumbers& found, const std::string& condition);

/// The status of a ratio of peaks of which one is not an interior maximum.
inline constexpr const char* kNotBothPeaks = "at least one condition has no interior maximum";

/// Adds the peak of each condition, and the ratios of the peaks of two conditions.
void add_peaks(const std::vector<std::string>& conditions, const std::vector<std::string>& spacings,
               const FoundNumbers& found, AnalysisOutcome& outcome);

/// Which spacing is judged roughest.
void ask_peaks(const std::vector<std::string>& conditions, const std::vector<std::string>& spacings,
               const FoundNumbers& found, AnalysisOutcome& outcome);

/// Whether any two conditions have their peaks at different spacings.
void ask_peak_ratios(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome);

/// Which shapes the participants' own curves have.
void ask_types(const std::vector<std::string>& conditions, const FoundNumbers& found,
               AnalysisOutcome& outcome);

}  // namespace asperity
