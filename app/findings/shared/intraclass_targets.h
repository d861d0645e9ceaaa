// The smallest number of targets of an intraclass correlation in a study.

#pragma once

#include <string>
#include <vector>

#include "analysis/numbers/finding.h"

namespace asperity {

/// The targets of intraclass correlations. `counted`: those that count, with their plural as the first word: "items that all
/// participants rated".
struct IntraclassTargets {
  std::string counted{};
  FindingKey key{};  ///< of the status
};

/// Replaces the correlations among the findings of the family `icc` with the status `too_few_items`, or the
/// other plural (quantity `icc`), if there are fewer than three targets. With two, the F of a correlation has one degree of freedom in its numerator: of two unrelated
/// repetitions, an ICC(3,1) above .7 occurs by chance in about a quarter of the studies.
void withhold_few_targets(std::vector<Finding>& findings, const IntraclassTargets& targets);

}  // namespace asperity
