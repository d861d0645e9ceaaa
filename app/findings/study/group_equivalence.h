// Whether women and men are equivalent, beside whether they differ.

#pragma once

#include <optional>
#include <span>

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/gathered_answers.h"

namespace asperity {

/// The analysis that its findings are of.
inline constexpr const char* kSexesEquivalence = "sexes_equivalence";

/// Two one-sided tests with the margin that the protocol declares; without one no verdict, but the
/// smallest margin that the data would support. A Bayes factor in any case. `proportions`: of each of
/// the people that were gathered, in their order; nothing for those without. Asks nothing where there
/// are not both women and men.
void ask_equivalence_of_sexes(const GatheredAnswers& gathered,
                              std::span<const std::optional<double>> proportions,
                              AnalysisOutcome& outcome);

}  // namespace asperity
