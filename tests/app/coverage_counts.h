// The counts of docs/data/coverage.tsv, with which tests compare what the program states about its intervals and tests.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// A row: of the simulated tables, those with the number, and those whose interval is above or below the true value or whose test
/// rejects.
struct DrawnCount {
  double participants = 0.0;
  double trials = 0.0;  ///< of each participant
  double effect = 0.0;
  double spread = 0.0;  ///< difference between participants
  std::string key{};
  std::optional<double> truth{};  ///< of an interval
  double tables = 0.0;
  double given = 0.0;
  double failed = 0.0;
};

/// The rows of a quantity of a part, in their order.
inline std::vector<DrawnCount> coverage_counts(const std::string& part,
                                               const std::string& quantity) {
  const std::filesystem::path path =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/data/coverage.tsv";
  const TidyTable table(read_file(path), path.string());
  const auto parts = table.texts("part");
  const auto quantities = table.texts("quantity");
  const auto kinds = table.texts("what");
  const auto keys = table.texts("key");
  const auto participants = table.all_numbers("participants");
  const auto trials = table.all_numbers("trials");
  const auto effects = table.all_numbers("effect");
  const auto spreads = table.all_numbers("spread");
  const auto truths = table.numbers("truth");
  const auto tables = table.all_numbers("tables");
  const auto given = table.all_numbers("given");
  const auto below = table.numbers("below");
  const auto above = table.numbers("above");
  const auto rejected = table.numbers("rejected");
  std::vector<DrawnCount> counts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (parts[row] != part || quantities[row] != quantity) continue;
    const bool is_test = kinds[row] == "test";
    counts.push_back(
        {.participants = participants[row],
         .trials = trials[row],
         .effect = effects[row],
         .spread = spreads[row],
         .key = std::string(keys[row]),
         .truth = truths[row],
         .tables = tables[row],
         .given = given[row],
         .failed = is_test ? rejected[row].value() : below[row].value() + above[row].value()});
  }
  return counts;
}

/// "88 to 95 %": the lowest and the highest coverage over these settings, rounded outwards; without those in which fewer than one
/// table in twenty has the interval.
inline std::string span_of_coverage(const std::vector<DrawnCount>& counts) {
  double lowest = 100.0;
  double highest = 0.0;
  for (const DrawnCount& count : counts) {
    if (count.given < 0.05 * count.tables) continue;
    const double covered = 100.0 * (count.given - count.failed) / count.given;
    lowest = std::min(lowest, std::floor(covered));
    highest = std::max(highest, std::ceil(covered));
  }
  return std::to_string(std::lround(lowest)) + " to " + std::to_string(std::lround(highest)) + " %";
}

/// Of the settings in which participants differ or do not.
inline std::string span_of_coverage(const std::string& part, const std::string& quantity,
                                    std::optional<bool> differ = {}) {
  std::vector<DrawnCount> counts = coverage_counts(part, quantity);
  std::erase_if(counts, [differ](const DrawnCount& count) {
    return differ && (count.spread > 0.0) != *differ;
  });
  return span_of_coverage(counts);
}

}  // namespace asperity
