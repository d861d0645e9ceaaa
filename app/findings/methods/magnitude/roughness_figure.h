// Makes the figure of estimates by spacing.

#pragma once

#include <string>

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Whether curves are named as those of probes, or by the names of the study's conditions.
enum class CurveNames { of_probes, alone };

/// Estimates by spacing on logarithmic axes, a curve per probe or condition, with the fitted
/// parabola and its peak. `unit`: of the spacings, where metres are displayed as millimetres; empty
/// where it is unknown.
Figure roughness_figure(const FoundNumbers& found, const std::string& unit, CurveNames names);

}  // namespace asperity
