// Makes the figures of a table that a family analyses: its findings as marks on axes, without further computation.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/findings/outcome/figure.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// The figures of a family's findings (tidy_families.h) for `input`. `level_unit`: SI symbol of the
/// unit of the spacings or levels in its table; empty where it is unknown. A figure without sufficient
/// data states that in `instead`. Empty for a family without figures.
std::vector<Figure> figures_of(const std::string& family, const TidyInput& input,
                               std::span<const Finding> findings,
                               const std::string& level_unit = {});

}  // namespace asperity
