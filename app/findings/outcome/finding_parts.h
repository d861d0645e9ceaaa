// Extracts the parts of a finding's key and interval.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// From low to high, where the finding has both.
std::optional<FigureSpan> interval_of(const Finding& finding);

/// Whether any of these points has an interval along either axis: captions explain only what is drawn.
bool draws_intervals(std::span<const FigureSeries> series);

/// "95" for a confidence of 0.95, and for findings without one.
std::string percent_of(const std::vector<const Finding*>& findings);

}  // namespace asperity
