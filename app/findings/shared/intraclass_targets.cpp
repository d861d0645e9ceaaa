// Replaces the correlations of fewer than three targets by a word and its reason.

#include "app/findings/shared/intraclass_targets.h"

#include "app/findings/outcome/found_numbers.h"

namespace asperity {

void withhold_few_targets(std::vector<Finding>& findings, const IntraclassTargets& targets) {
  constexpr double kFewestTargets = 3.0;
  const std::vector<const Finding*> counted = FoundNumbers(findings).all("n.targets");
  if (counted.empty()) return;  // the family could not be applied, and states why
  const double n = counted.front()->value.value_or(0.0);
  if (n >= kFewestTargets) return;
  const std::string kind = targets.counted.substr(0, targets.counted.find(' '));
  Finding none{};
  none.analysis = findings.front().analysis;
  none.quantity = "icc";
  none.key = targets.key;
  none.word = "too_few_" + kind;
  none.n = static_cast<std::size_t>(n);
  none.method = "intraclass correlation";
  none.status = "an intraclass correlation requires at least 3 " + targets.counted +
                ", because that of 2 has almost no information: add " + kind;
  std::erase_if(findings, [](const Finding& each) { return !each.quantity.starts_with("n."); });
  findings.push_back(std::move(none));
}

}  // namespace asperity
