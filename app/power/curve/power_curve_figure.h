// Makes the figure of simulated power over the number of participants.

#pragma once

#include <span>

#include "app/findings/outcome/figure.h"
#include "app/power/curve/power_tally.h"

namespace asperity {

/// A mark with its Monte-Carlo interval for every number of participants, and the monotone fit as a line, for each effect and test;
/// of a family with several tests only the power to find at least one of them where all tests would be more curves than are
/// distinguishable.
Figure power_curve_figure(std::span<const PowerCurve> curves);

}  // namespace asperity
