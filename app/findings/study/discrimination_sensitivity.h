// Sensitivity by level: hits and false alarms, d′ and the criterion of every participant.

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/found_numbers.h"
#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/discrimination_results.h"

namespace asperity {

/// The tables, and the analysis of the findings of the first.
inline constexpr const char* kSensitivity = "sensitivity";
inline constexpr const char* kResponsesByPair = "responses_by_pair";

/// The participants with trials at a level, and those at the ceiling of d′: without a correction it would be infinite (each
/// response to a signal is a hit, or none without a signal is a false alarm), so that it depends on the number of trials.
struct ParticipantsAtCeiling {
  std::size_t participants = 0;
  std::size_t at_ceiling = 0;
};
/// By condition of DiscriminationResults and value of the parameter.
using CeilingOfLevels = std::map<std::pair<std::size_t, double>, ParticipantsAtCeiling>;
/// Removes the interval of every mean d′ (`dprime.mean`) that includes a participant at the ceiling: the mean is a lower bound,
/// as its method then states.
void mark_lower_bounds(const DiscriminationResults& results, const CeilingOfLevels& levels,
                       std::vector<Finding>& findings);

/// The name in the family `dprime` of a design that is not a choice of three.
std::string_view name_in_family(const DiscriminationDesign& design);

/// The id of a level in the family `dprime`: "wood|7.5e-05".
std::string id_of_level(const DiscriminationResults& results,
                        const std::pair<std::size_t, double>& place);

struct MeanSensitivity {
  const char* table = "";  ///< with d′ of the participants
  Phrase method{};
};
/// Adds the question about the mean d′ at each level, from the findings `dprime.mean`. Nothing without such a mean.
void ask_mean_sensitivity(const DiscriminationResults& results, const CeilingOfLevels& levels,
                          const FoundNumbers& found, const MeanSensitivity& mean,
                          AnalysisOutcome& outcome);

/// Adds, for the tasks with correct responses whose levels did not depend on the responses:
///
///   sensitivity        the findings of the family `dprime` (id: condition and level), a row for every participant,
///                      condition and level; where options are words, a question about the mean d′. Where a surface is
///                      chosen, hits and false alarms are the responses "the first" with the comparison first and second;
///                      otherwise "yes" or "different" with and without a signal, the latter of all levels of the
///                      condition together.
///   responses_by_pair  same–different: the responses to every ordered pair of surfaces
///
/// A proportion over levels that a procedure chose depends on the procedure and is not stated.
void add_sensitivity(const GatheredAnswers& gathered, const std::vector<DiscriminationResults>& all,
                     AnalysisOutcome& outcome);

}  // namespace asperity
