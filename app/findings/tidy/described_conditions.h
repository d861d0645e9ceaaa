// Describes measurements by condition from the participants' own values.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"

namespace asperity {

/// How a participant's measurements become the participant's own value.
enum class OwnAverage { mean, median };

/// The measurements of one participant in one condition.
struct OwnValue {
  std::size_t participant = 0;  ///< index in the names
  std::size_t measurements = 0;
  double value = 0.0;  ///< their mean or median
};

/// The mean in the order of the measurements, or the median; `measurements` is not empty, and is sorted for the median.
double own_average(OwnAverage average, std::vector<double>& measurements);

/// Those with a measurement, in the order of the participants.
struct DescribedCondition {
  FindingKey key{};  ///< of the findings
  std::span<const OwnValue> own{};
};

/// What the family `description` reports, from values that were averaged within participants before.
struct Description {
  OwnAverage average = OwnAverage::mean;
  std::vector<std::string> participants{};  ///< names
  std::size_t described = 0;                ///< participants with a row
  std::size_t missing = 0;                  ///< rows without a measurement
  std::vector<DescribedCondition> conditions{};
};
std::vector<Finding> findings_of(const Description& description);

}  // namespace asperity
