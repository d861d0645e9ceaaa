// Prints and writes the results of a power analysis.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/power/curve/effect_levels.h"
#include "app/power/curve/planned_sample.h"
#include "app/power/curve/power_order.h"
#include "app/power/curve/simulate_power.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// A power analysis with its inputs.
struct PowerReport {
  const Protocol& protocol;
  PlanCost cost{};                    ///< of one session
  std::vector<EffectLevel> levels{};  ///< of PowerOrder::effects
  PowerOrder order{};
  SampleRules rules{};
  SimulatedPower power{};
};

/// On standard output, in lines of at most 100 columns: the session, the assumptions, the power and the numbers of participants of
/// every test, and the statement for 80 % of every level with an effect.
void print_power(const PowerReport& report);

/// `asperity.power/1`
nlohmann::ordered_json json_of(const PowerReport& report);

/// `power.tsv`, `sample_size.tsv` and, of response tables, `assumptions.json` in a folder. They are made of the studies there: files of these names are
/// replaced.
void write_power(const std::filesystem::path& folder, const PowerReport& report);

/// Prints the size of each test whose proportion of significant studies without an effect differs from the level (`true_size_text`), or that
/// no level without an effect was simulated.
void say_true_sizes(const PowerReport& report);

}  // namespace asperity
