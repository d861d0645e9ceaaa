// The results of a power analysis as tables and as JSON.

#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/power/curve/planned_sample.h"
#include "app/power/curve/power_tally.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The statistical tests of a curve with their sides, "paired t test, two-sided"; empty of a family, and where no test was made.
std::string methods_text(const PowerCurve& curve);

/// A row for each effect, test and number of participants: `effect family test method participants studies significant power power_low
/// power_high fitted_power without_p median_width p90_width`. The row of a family has no test.
Table power_table(std::span<const PowerCurve> curves);

/// A row for each effect, test and wanted power: `effect family test power status participants participants_low participants_high
/// planned recruited_on_average recruited_assured`, whole numbers. Limits beyond the numbers of the curve are missing.
Table sample_table(std::span<const PowerCurve> curves, const SampleRules& rules);

/// An object for each row, with the columns as keys and null for what is missing.
nlohmann::ordered_json json_of(const Table& table);

}  // namespace asperity
