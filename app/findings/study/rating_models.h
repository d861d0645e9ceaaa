// Fits the mixed model of the single ratings on each scale.

#pragma once

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/gathered_answers.h"
#include "app/findings/study/rated_scales.h"
#include "app/findings/study/study_tests.h"

namespace asperity {

/// The models of all scales: a cumulative link mixed model where the ratings are ordered categories
/// (RatedScale::has_categories), and otherwise a linear mixed model. Items are fixed effects, and participants random
/// intercepts. Every response counts.
class RatingModels final {
 public:
  RatingModels();
  /// Fits the model of a scale with at least two items; adds its findings and the test `rating_model`.
  void add(const GatheredAnswers& gathered, const RatedScale& scale, StudyTests& tests,
           AnalysisOutcome& outcome);
  /// Appends the tables `ordinal` and `mixed_model`, each if it has a row.
  void report(AnalysisOutcome& outcome) &&;

 private:
  NamedTable ordinal_{};
  NamedTable linear_{};
};

}  // namespace asperity
