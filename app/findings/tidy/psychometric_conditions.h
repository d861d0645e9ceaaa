// The table of the family `psyfit`: counts of hits by condition and level.

#pragma once

#include <string>
#include <vector>

#include "analysis/psychometric/psychometric_model.h"
#include "app/findings/tidy/unforced_estimates.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// Whether a response is "cannot tell".
bool has_unsure(const UnforcedData& data);

struct PsychometricCondition {
  std::string name{};
  std::vector<PsychometricBlock> blocks{};  ///< with responses "cannot tell" split
  UnforcedData unforced{};                  ///< the same blocks
};

/// The rows `condition,x,n,k` and, where there are responses "cannot tell", `unsure` and `m`. Refuses more hits than trials
/// and hits that are impossible under the model.
std::vector<PsychometricCondition> psychometric_conditions(const TidyTable& table,
                                                           const PsychometricModel& model);

}  // namespace asperity
