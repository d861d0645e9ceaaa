// Draws tables in each setting, analyses them, and counts covering intervals and significant tests.

#include "tests/coverage/coverage.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/proportion.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

namespace {

constexpr double kLevel = 0.05;

void add_to(CoverageCount& sum, const CoverageCount& more) {
  sum.tables += more.tables;
  sum.given += more.given;
  sum.below += more.below;
  sum.above += more.above;
  sum.rejected += more.rejected;
  sum.smallest_p = std::min(sum.smallest_p, more.smallest_p);
}

std::vector<CoverageCount> counts_of_nothing(const CoveragePart& part,
                                             const CoverageSetting& setting) {
  std::vector<CoverageCount> counts{};
  for (const CheckedInterval& checked : part.intervals(setting)) {
    counts.push_back({.part = std::string(part.name),
                      .setting = setting,
                      .what = "interval",
                      .quantity = checked.quantity,
                      .key = checked.key,
                      .truth = checked.truth});
  }
  for (const CheckedTest& checked : part.tests(setting)) {
    counts.push_back({.part = std::string(part.name),
                      .setting = setting,
                      .what = "test",
                      .quantity = checked.quantity,
                      .key = checked.key});
  }
  return counts;
}

/// In the order of counts_of_nothing.
void count_table(const std::vector<Finding>& findings,
                 const std::vector<CheckedInterval>& intervals,
                 const std::vector<CheckedTest>& tests, std::vector<CoverageCount>& counts) {
  const FoundNumbers found(findings);
  std::size_t place = 0;
  for (const CheckedInterval& checked : intervals) {
    CoverageCount& count = counts[place++];
    ++count.tables;
    const auto interval = interval_in(found, checked);
    if (!interval) continue;
    ++count.given;
    // An end that is the truth but for its last digits covers it.
    const double slack = 1e-12 * std::max(1.0, std::abs(checked.truth));
    if (interval->high < checked.truth - slack) ++count.below;
    if (interval->low > checked.truth + slack) ++count.above;
  }
  for (const CheckedTest& checked : tests) {
    CoverageCount& count = counts[place++];
    ++count.tables;
    const auto p = found.value(composed_quantity(checked.quantity), checked.key);
    if (!p) continue;
    ++count.given;
    if (*p <= kLevel) ++count.rejected;
    count.smallest_p = std::min(count.smallest_p, *p);
  }
}

}  // namespace

std::optional<ConfidenceInterval> interval_in(const FoundNumbers& found,
                                              const CheckedInterval& checked) {
  if (checked.lower.empty()) {
    const Finding* const finding = found.find(composed_quantity(checked.quantity), checked.key);
    if (finding == nullptr || !finding->low || !finding->high) return {};
    return ConfidenceInterval{.low = *finding->low, .high = *finding->high};
  }
  const auto low = found.value(composed_quantity(checked.lower), checked.key);
  const auto high = found.value(composed_quantity(checked.upper), checked.key);
  if (!low || !high) return {};
  return ConfidenceInterval{.low = *low, .high = *high};
}

std::vector<CoverageCount> counts_in(const CoveragePart& part, const CoverageSetting& setting,
                                     const CoverageRun& run) {
  const std::vector<CheckedInterval> intervals = part.intervals(setting);
  const std::vector<CheckedTest> tests = part.tests(setting);
  std::vector<CoverageCount> sum = counts_of_nothing(part, setting);
  const Random of_setting = Random(run.seed).split(name_of(part, setting));
  const std::size_t tables = run.tables.value_or(part.tables);
  std::atomic<std::size_t> next{0};
  std::mutex summing;
  const auto work = [&] {
    std::vector<CoverageCount> counts = counts_of_nothing(part, setting);
    for (std::size_t table = next++; table < tables; table = next++) {
      Random random = of_setting.split(static_cast<std::uint64_t>(table));
      count_table(part.findings(part.draw(setting, random)), intervals, tests, counts);
    }
    const std::lock_guard lock(summing);
    for (std::size_t i = 0; i < sum.size(); ++i) add_to(sum[i], counts[i]);
  };
  {
    std::vector<std::jthread> others{};
    for (std::size_t i = 1; i < run.jobs; ++i) others.emplace_back(work);
    work();
  }
  return sum;
}

std::string coverage_header() {
  return "part\tparticipants\ttrials\teffect\tspread\twhat\tquantity\tkey\ttruth\ttables\tgiven\t"
         "below\tabove\trejected\tsmallest_p";
}

std::string name_of(const CoveragePart& part, const CoverageSetting& setting) {
  return std::string(part.name) + '\t' + std::to_string(setting.participants) + '\t' +
         std::to_string(setting.trials) + '\t' + number_text(setting.effect) + '\t' +
         number_text(setting.spread) + '\t';
}

std::string row_of(const CoverageCount& count) {
  const bool is_test = count.what == "test";
  std::string row = name_of({.name = count.part}, count.setting) + count.what + '\t' +
                    count.quantity + '\t' + count.key + '\t' +
                    (is_test ? "n/a" : number_text(count.truth)) + '\t' +
                    std::to_string(count.tables) + '\t' + std::to_string(count.given) + '\t';
  row += is_test
             ? "n/a\tn/a\t" + std::to_string(count.rejected) + '\t' + number_text(count.smallest_p)
             : std::to_string(count.below) + '\t' + std::to_string(count.above) + "\tn/a\tn/a";
  return row;
}

void append_counts(const std::string& file, const std::vector<CoveragePart>& parts,
                   const CoverageRun& run, const std::function<void(const std::string&)>& told) {
  std::set<std::string> there{};
  if (std::filesystem::exists(file)) {
    std::ifstream before(file);
    std::string line;
    std::getline(before, line);
    if (line != coverage_header()) {
      throw std::runtime_error(file + ":1: is no file of counts: name another file");
    }
    while (std::getline(before, line)) {
      std::size_t end = 0;
      constexpr int kColumnsOfSetting = 5;
      for (int column = 0; column < kColumnsOfSetting && end != std::string::npos; ++column) {
        end = line.find('\t', end == 0 ? 0 : end) == std::string::npos ? std::string::npos
                                                                       : line.find('\t', end) + 1;
      }
      if (end != std::string::npos) there.insert(line.substr(0, end));
    }
  }
  std::ofstream out(file, std::ios::app);
  if (there.empty() && std::filesystem::file_size(file) == 0) out << coverage_header() << '\n';
  for (const CoveragePart& part : parts) {
    for (const CoverageSetting& setting : part.settings) {
      if (there.contains(name_of(part, setting))) continue;
      std::string rows{};
      for (const CoverageCount& count : counts_in(part, setting, run)) rows += row_of(count) + '\n';
      out << rows
          << std::flush;  // the rows of a setting at once: what is there of one is all of it
      if (!out) throw std::runtime_error(file + ": cannot be written; is the disk full?");
      told(rows);
    }
  }
}

}  // namespace asperity
