// Reads rows into blocks, refusing impossible counts, and splits responses “cannot tell”.

#include "app/findings/tidy/psychometric_conditions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace asperity {

namespace {

/// The responses "cannot tell" by row, and between how many alternatives was chosen.
struct UnsureColumns {
  std::vector<std::uint64_t> unsure{};
  std::vector<std::optional<double>> alternatives{};
};

UnsureColumns read_unsure(const TidyTable& table) {
  UnsureColumns columns{.unsure = std::vector<std::uint64_t>(table.rows()),
                        .alternatives = std::vector<std::optional<double>>(table.rows())};
  if (table.has("unsure")) columns.unsure = table.counts("unsure");
  if (table.has("m")) columns.alternatives = table.numbers("m");
  return columns;
}

/// Whether the responses "cannot tell" of the row can be split; refuses the row otherwise.
void check_unsure(const TidyTable& table, std::size_t row, const UnsureColumns& columns,
                  const UnforcedBlock& block, const UnforcedData& of) {
  if (block.unsure == 0) return;
  const std::optional<double> m = columns.alternatives[row];
  const bool is_count = m && *m >= 2.0 && *m == std::floor(*m);
  if (!is_count || (has_unsure(of) && static_cast<double>(of.alternatives) != *m)) {
    table.refuse(row, table.has("m") ? "m" : "unsure",
                 "responses \"cannot tell\" count as 1/m of a hit; state m, the number of "
                 "alternatives of the choice, at least 2 and the same in all rows of the "
                 "condition");
  }
}

}  // namespace

bool has_unsure(const UnforcedData& data) {
  return std::any_of(data.blocks.begin(), data.blocks.end(),
                     [](const UnforcedBlock& block) { return block.unsure > 0; });
}

std::vector<PsychometricCondition> psychometric_conditions(const TidyTable& table,
                                                           const PsychometricModel& model) {
  const LabelColumn names = table.all_labels("condition");
  const std::vector<double> levels = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> hits = table.counts("k");
  const UnsureColumns columns = read_unsure(table);
  std::vector<PsychometricCondition> conditions{};
  for (const std::string& name : names.names) {
    conditions.push_back({.name = name, .unforced = {.key = name}});
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (hits[row] > trials[row]) {
      table.refuse(row, "k",
                   "k is " + std::to_string(hits[row]) + " and n is " +
                       std::to_string(trials[row]) + "; k must be at most n");
    }
    if (columns.unsure[row] > trials[row] - hits[row]) {
      table.refuse(row, "unsure",
                   "k and unsure together exceed n; responses \"cannot tell\" are part of n and "
                   "not of k");
    }
    const UnforcedBlock block{.x = levels[row],
                              .hits = hits[row],
                              .misses = trials[row] - hits[row] - columns.unsure[row],
                              .unsure = columns.unsure[row]};
    PsychometricCondition& condition = conditions[names.codes[row]];
    check_unsure(table, row, columns, block, condition.unforced);
    if (block.unsure > 0) {
      condition.unforced.alternatives = static_cast<std::size_t>(*columns.alternatives[row]);
    }
    if (is_impossible(split_block(block, condition.unforced.alternatives), model)) {
      table.refuse(
          row, "k",
          "k is " + std::to_string(block.hits) +
              " at x 0, where a Weibull function with gamma 0 has no hits; set gamma to the rate "
              "of hits without a stimulus, or to free, or correct the row");
    }
    condition.unforced.blocks.push_back(block);
  }
  for (PsychometricCondition& condition : conditions) {
    for (const UnforcedBlock& block : condition.unforced.blocks) {
      condition.blocks.push_back(split_block(block, condition.unforced.alternatives));
    }
  }
  return conditions;
}

}  // namespace asperity
