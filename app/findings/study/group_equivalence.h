// Tests whether women and men are equivalent, in addition to whether they differ.

#pragma once

#include <optional>
#include <span>

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/gathered_answers.h"

namespace asperity {

/// The name of the analysis in its findings.
inline constexpr const char* kSexesEquivalence = "sexes_equivalence";

/// Two one-sided tests with the margin that the protocol declares; without a margin no verdict, but
/// the smallest margin that the data would support. A Bayes factor in every case. `proportions`:
/// one for each of the gathered people, in their order; nothing for those without. Adds no question
/// where there are not both women and men.
void ask_equivalence_of_sexes(const GatheredAnswers& gathered,
                              std::span<const std::optional<double>> proportions,
                              AnalysisOutcome& outcome);

}  // namespace asperity
