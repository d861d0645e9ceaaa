// From power curves to numbers of participants: those to plan, and those to recruit.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/power/recruitment.h"
#include "analysis/power/smallest_sample.h"
#include "app/power/curve/power_tally.h"

namespace asperity {

/// The powers for which numbers of participants are stated.
inline constexpr std::array<double, 2> kWantedPowers{0.8, 0.9};

/// The probability with which the assured number of recruited participants leaves the planned one.
inline constexpr double kAssurance = 0.9;

struct SampleRules {
  std::size_t multiple = 1;  ///< participants in one round of counterbalancing rows and groups
  Attrition attrition{};
};

/// The sample of one test for one power.
struct PlannedSample {
  double power = 0.8;
  PowerReached reached = PowerReached::beyond_sizes;
  /// The smallest whole number of participants with the power, and its Monte-Carlo interval: `smallest_sample`, rounded up.
  /// Nothing where no number of the curve has the power, and for limits beyond its numbers.
  std::optional<std::size_t> participants{};
  std::optional<std::size_t> low{};
  std::optional<std::size_t> high{};
  /// `participants`, rounded up to whole rounds of the design.
  std::optional<std::size_t> planned{};
  std::optional<Recruitment> recruited{};  ///< for `planned`
};

PlannedSample planned_sample(const PowerCurve& curve, double power, const SampleRules& rules);

/// The estimated power with a number of participants that need not have been simulated: linear between the two next simulated
/// numbers of the curve, as in `smallest_sample`.
struct PowerEstimate {
  double power = 0.0;  ///< of the monotone fit
  ConfidenceInterval interval{};
  int below = 0;  ///< the simulated numbers that it lies between, equal where it is one of them
  int above = 0;
};

/// Of a number below the smallest one or above the largest one the estimate is that of the smallest, or of the largest one.
PowerEstimate power_at(const PowerCurve& curve, std::size_t participants);

/// "ok", "at_first_size", "not_reached": the code of a status in tables.
const char* code_of(PowerReached reached) noexcept;

}  // namespace asperity
