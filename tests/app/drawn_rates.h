// Rates of docs/data/coverage.tsv over chosen settings, in the words and with the rounding of the texts that state them, and the
// page that describes them.

#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "tests/app/coverage_counts.h"

namespace asperity {

using Counts = std::vector<DrawnCount>;
using Choice = std::function<bool(const DrawnCount&)>;

/// Without the settings in which fewer than one table in twenty has the number.
inline Counts drawn(const std::string& part, const std::string& quantity,
                    const Choice& is_meant = {}) {
  Counts counts = coverage_counts(part, quantity);
  std::erase_if(counts, [&is_meant](const DrawnCount& count) {
    return count.given < 0.05 * count.tables || (is_meant && !is_meant(count));
  });
  EXPECT_FALSE(counts.empty()) << part << ' ' << quantity;
  return counts;
}

inline Choice with_key(const std::string& key) {
  return [key](const DrawnCount& count) { return count.key == key; };
}
inline Choice with_effect(double effect) {
  return [effect](const DrawnCount& count) { return count.effect == effect; };
}
inline Choice with_spread(double spread) {
  return [spread](const DrawnCount& count) { return count.spread == spread; };
}
inline Choice where_participants_differ(bool differ) {
  return [differ](const DrawnCount& count) { return (count.spread > 0.0) == differ; };
}
inline Choice with_participants(double from, double to) {
  return [from, to](const DrawnCount& count) {
    return count.participants >= from && count.participants <= to;
  };
}

inline Counts both_of(Counts counts, const Counts& more) {
  counts.insert(counts.end(), more.begin(), more.end());
  return counts;
}

inline double percent_failed(const DrawnCount& count) { return 100.0 * count.failed / count.given; }

inline double least_coverage(const Counts& counts) {
  double least = 100.0;
  for (const DrawnCount& count : counts) least = std::min(least, 100.0 - percent_failed(count));
  return least;
}
inline double greatest_coverage(const Counts& counts) {
  double greatest = 0.0;
  for (const DrawnCount& count : counts)
    greatest = std::max(greatest, 100.0 - percent_failed(count));
  return greatest;
}

inline std::string whole(double number) { return std::to_string(std::lround(number)); }

/// "at least 92 %": rounded down.
inline std::string at_least(const Counts& counts) {
  return "at least " + whole(std::floor(least_coverage(counts))) + " %";
}
/// "88 to 95 %": rounded outwards.
inline std::string span_of(const Counts& counts) { return span_of_coverage(counts); }

/// The greatest Type I error rate, "7", and the lowest.
inline std::string greatest_size(const Counts& counts) {
  double greatest = 0.0;
  for (const DrawnCount& count : counts) greatest = std::max(greatest, percent_failed(count));
  return whole(greatest);
}
inline std::string least_size(const Counts& counts) {
  double least = 100.0;
  for (const DrawnCount& count : counts) least = std::min(least, percent_failed(count));
  return whole(least);
}
inline std::string up_to(const Counts& counts) { return "up to " + greatest_size(counts) + " %"; }

/// "{88, 95}", as simulated_coverage.h has it.
inline std::string limits(const Counts& counts) {
  return '{' + whole(std::floor(least_coverage(counts))) + ", " +
         whole(std::ceil(greatest_coverage(counts))) + '}';
}
inline std::string coverage_of(const Counts& counts) {
  return "simulated_coverage(" + limits(counts);
}
/// Of participants who are alike, and of those who differ.
inline std::string coverage_of_pooled(const std::string& part, const std::string& quantity) {
  return coverage_of(drawn(part, quantity, where_participants_differ(false))) + ", " +
         limits(drawn(part, quantity, where_participants_differ(true)));
}

/// docs/analysis.md with single spaces in place of the ends of lines.
inline std::string page_in_one_line() {
  std::istringstream words(
      read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/analysis.md"));
  std::string page{};
  for (std::string word; words >> word;) page += (page.empty() ? "" : " ") + word;
  return page;
}

}  // namespace asperity
