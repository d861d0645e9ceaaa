// Models how contact times and response times depend on conditions, and on the places of trials in the session.

#pragma once

#include "analysis/words/phrase.h"
#include "app/findings/gathering/explored_rows.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/result_table.h"

namespace asperity {

/// The findings of each model, and the table of both.
inline constexpr const char* kContactTimeModel = "contact_time_model";
inline constexpr const char* kResponseTimeModel = "response_time_model";
inline constexpr const char* kExplorationModel = "exploration_model";

/// The test of an effect, "F(2, 35.37) = 2.45"; missing in the row of a level.
inline const ResultColumn kExplorationStatistic{.id = "statistic",
                                                .heading = phrase("AnalysisWords", "statistic"),
                                                .stored_as = {"F", "df1", "df2"}};

/// Adds the table `exploration_model`: linear mixed models of the logarithms of contact times (a row per surface) and
/// response times (a row per trial), with random intercepts of participants, by conditions, the place of the trial in
/// its block, and the places of the block and the session where there are several. Effects are ratios; all tests are
/// exploratory. A model without a fit has its reason. No table where there is no time.
void add_exploration_models(const GatheredAnswers& gathered, const ExploredRows& surfaces,
                            const ExploredRows& trials, AnalysisOutcome& outcome);

}  // namespace asperity
