// Excludes participants by their errors in catch trials, as the protocol declares it before data collection.

#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The table of the errors by participant, with the decision; absent without a declared rule.
inline constexpr const char* kExclusions = "exclusions";
/// The end of the names of tables, and of the analyses of findings, that contain the excluded participants.
inline constexpr const char* kWithExcluded = "_with_excluded";

/// The errors of a participant in the catch trials of all types and blocks. A missed deadline is an error.
struct CatchErrors {
  std::string participant{};
  std::size_t errors = 0;
  std::size_t trials = 0;
};
/// By participant with a catch trial, in the order of GatheredAnswers::catch_responses.
std::vector<CatchErrors> catch_errors(const GatheredAnswers& gathered);

bool is_excluded(const CatchExclusion& rule, const CatchErrors& errors);

/// The responses without those of these participants. Responses in catch trials remain: they are the reason.
GatheredAnswers without_participants(GatheredAnswers gathered,
                                     const std::set<std::string>& participants);

/// The participants whom the declared rule excludes; all of them where it excludes every one.
std::set<std::string> excluded_by_rule(const GatheredAnswers& gathered);

/// The responses on which the results of `analyze_with_exclusions` are based.
GatheredAnswers without_excluded(const GatheredAnswers& gathered);

/// Runs `analyze` on the responses without the participants whom the declared rule excludes, and a second time on all
/// responses: the tables of thresholds, their means and the tests of the second run are added with names that end in
/// `kWithExcluded`, and their findings with such an analysis. Adds the table `kExclusions`. Without a rule, or if it excludes no
/// participant or all of them, `analyze` runs once on all responses.
void analyze_with_exclusions(const GatheredAnswers& gathered, AnalysisOutcome& outcome,
                             void (*analyze)(const GatheredAnswers&, AnalysisOutcome&));

/// The participants whom the declared rule excluded from the results, from the table `kExclusions`; none where the results are
/// those of all participants.
std::set<std::string> excluded_participants(const AnalysisOutcome& outcome);

/// " The rule that the protocol declares (more than 2 errors in catch trials) excluded 2 of 12 participants, …", from the table
/// `kExclusions`; empty without it and without an excluded participant.
std::string exclusions_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
