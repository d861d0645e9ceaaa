// Makes figures of receiver operating characteristics (ROC).

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// An ROC of a figure. `key`: of the findings of the family `roc`, without the rating.
struct RocCurve {
  FindingKey key{};
  Phrase name{};
};
/// Hits over false alarms of the ratings, the fitted normal model and its area; a series per curve.
Figure roc_figure(const FoundNumbers& found, std::span<const RocCurve> curves);
/// Of a discrimination with ratings of confidence: for every condition the ROCs of the levels, over all participants and
/// of each one.
std::vector<Figure> roc_figures(const ResultTable& table, const AnalysisOutcome& outcome);

}  // namespace asperity
