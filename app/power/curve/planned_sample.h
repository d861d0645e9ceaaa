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
  SmallestSample smallest{};
  /// The smallest number, rounded up to whole rounds of the design; nothing where no number of the curve has the power.
  std::optional<std::size_t> planned{};
  std::optional<Recruitment> recruited{};  ///< for `planned`
};

PlannedSample planned_sample(const PowerCurve& curve, double power, const SampleRules& rules);

/// "ok", "at_first_size", "not_reached": the code of a status in tables.
const char* code_of(PowerReached reached) noexcept;

}  // namespace asperity
