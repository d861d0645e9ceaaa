// Sensitivity by level: hits and false alarms, d′ and the criterion of every participant.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/methods/discrimination/sensitivity/sensitivity_bounds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

inline const ResultColumn kDPrime{.id = "d_prime", .heading = phrase("AnalysisWords", "d′")};
inline const ResultColumn kDPrimeIndependent{
    .id = "d_prime_independent",
    .heading = phrase("AnalysisWords", "d′, independent observations")};

/// The tables, and the analysis of the findings of the first.
inline constexpr const char* kSensitivity = "sensitivity";
inline constexpr const char* kResponsesByPair = "responses_by_pair";

/// The name in the family `dprime` of a design that is not a choice of three.
std::string_view name_in_family(const DiscriminationDesign& design);

/// d′ by condition and participant, as in the table `sensitivity`, of a task with a single level, for which no function of the level
/// can be fitted; nothing where d′ is a bound, because all hits or no false alarms were responses. Empty for all other tasks.
std::map<std::pair<std::size_t, std::uint32_t>, std::optional<double>> sensitivities_at_only_level(
    const GatheredAnswers& gathered, const DiscriminationResults& results);

struct MeanSensitivity {
  const char* table = "";  ///< with d′ of the participants
  Phrase method{};
};
/// Adds the question about the mean d′ at each level, from the findings `dprime.mean`. Nothing without such a mean.
void ask_mean_sensitivity(const DiscriminationResults& results, const UnboundedAtLevels& levels,
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
