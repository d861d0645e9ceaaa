// Represents the responses of a magnitude estimation as estimates by condition and spacing, and as the tables that
// families of analyses read.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/result_table.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Geometric means of estimates: as given, and without the participants' scales.
inline const ResultColumn kRawEstimate{
    .id = "raw", .heading = phrase("AnalysisWords", "raw"), .digits = Digits::estimate};
inline const ResultColumn kNormalisedEstimate{.id = "normalised",
                                              .heading = phrase("AnalysisWords", "normalised"),
                                              .digits = Digits::estimate};

/// One estimate with the names of its factors' levels as in the tables.
struct Estimated {
  std::uint32_t person = 0;
  std::string condition{};  ///< "all" if the protocol has none
  std::string spacing{};    ///< metres; of stimuli without spacings the name of the stimulus
  int repetition = 1;
  double estimate = 0.0;
};

/// The estimates that are analysed, with the levels of their factors in the protocol's order; levels that it does not list come
/// last, numbers ascending and before names. Nothing depends on the order of the sessions.
struct ComparedEstimates {
  const GatheredAnswers& gathered;
  std::vector<Estimated> estimates{};  ///< by condition and stimulus
  std::vector<std::string> conditions{};
  std::vector<std::string> stimuli{};         ///< or spacings
  std::map<std::string, double> predictor{};  ///< of every stimulus; empty: none
};

/// Of the numbers above 0 whose spacing or stimulus is known, without a predictor; remarks on the number of others and of anchors,
/// and on missing estimates of the standard.
ComparedEstimates compared_estimates(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// By participant, condition, and spacing or stimulus: the logarithms of the estimates.
using EstimateCells =
    std::map<std::tuple<std::uint32_t, std::string, std::string>, std::vector<double>>;
EstimateCells cells_of(const std::vector<Estimated>& estimates);
/// The logarithms of the estimates by participant and cell, less the participant's mean in the condition, as profiles in which the
/// groups are compared. The factor of the groups
/// is no condition: a participant is in one group.
GroupProfile profile_of_estimates(const ComparedEstimates& compared);
/// Of at least one logarithm.
double mean_logarithm(const std::vector<double>& logarithms);

/// The reliability of the logarithms over the repetitions.
void ask_reliability_of_estimates(const ComparedEstimates& compared, AnalysisOutcome& outcome);

/// As the protocol states it; none where it is that of a standard of which there is no estimate.
EstimateNormalisation used_normalisation(const EstimationDeclaration& estimation,
                                         const std::vector<Estimated>& estimates);
/// For the family `magnitude`, with `used_normalisation`.
TidyInput curves_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates);
/// The same by stimulus. `predictor`: of every stimulus; empty: none.
TidyInput items_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                      const std::map<std::string, double>& predictor);
/// What was removed from the estimates, as a sentence for the note of a table.
Phrase normalisation_note(const EstimationDeclaration& estimation,
                          const std::vector<Estimated>& estimates);
/// For the family `rmanova`: logarithms with `used_normalisation`. A participant's scale is a constant and part of no F, but with
/// free modulus its variance would be in the denominator of generalised η², which would then measure the choice of numbers.
TidyInput anova_table(const ComparedEstimates& compared, const std::string& factor = "spacing");

}  // namespace asperity
