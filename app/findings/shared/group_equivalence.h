// Tests whether two groups of participants are equivalent, in addition to whether they differ.

#pragma once

#include <optional>
#include <span>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/shared/participant_pairs.h"

namespace asperity {

/// The names of the analysis in its findings, of women and men and of the protocol's groups.
inline constexpr const char* kSexesEquivalence = "sexes_equivalence";
inline constexpr const char* kGroupsEquivalence = "groups_equivalence";

/// Two one-sided tests with the margin that the protocol declares; without a margin no verdict, but
/// the smallest margin that the data would support. A Bayes factor in every case. `proportions`:
/// one for each of the gathered people, in their order; nothing for those without. Adds no question
/// where there are no participants of both levels.
void ask_equivalence(const ParticipantPair& pair, const GatheredAnswers& gathered,
                     std::span<const std::optional<double>> proportions, AnalysisOutcome& outcome);

}  // namespace asperity
