// Learning: how response times, or proportions correct, change over the trials of a participant.

#include "analysis/tests/learning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/t_test.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/time_column.h"

namespace asperity {
namespace {

constexpr double kMostBlocks = 12.0;

/// The rows of each participant that have a result, in the order of their trials.
struct OrderedTrials {
  std::vector<std::string> participants{};
  std::vector<std::uint64_t> trials{};  ///< by row, from 1
  std::vector<std::vector<std::size_t>> rows{};
  std::uint64_t last = 0;  ///< with or without a result
};

OrderedTrials ordered_trials(const TidyTable& table, const std::vector<bool>& has_result) {
  LabelColumn participants = table.all_labels("subject");
  OrderedTrials ordered{.participants = std::move(participants.names),
                        .trials = table.counts("trial")};
  ordered.rows.resize(ordered.participants.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (ordered.trials[row] == 0)
      table.refuse(row, "trial", "trial is 0; number the trials from 1");
    ordered.last = std::max(ordered.last, ordered.trials[row]);
    if (has_result[row]) ordered.rows[participants.codes[row]].push_back(row);
  }
  for (std::size_t person = 0; person < ordered.rows.size(); ++person) {
    std::vector<std::size_t>& own = ordered.rows[person];
    const auto trial = [&ordered](std::size_t row) { return ordered.trials[row]; };
    std::stable_sort(own.begin(), own.end(),
                     [&](std::size_t a, std::size_t b) { return trial(a) < trial(b); });
    const auto same = std::adjacent_find(
        own.begin(), own.end(), [&](std::size_t a, std::size_t b) { return trial(a) == trial(b); });
    if (same == own.end()) continue;
    table.refuse(*(same + 1), "trial",
                 ordered.participants[person] + " already has a trial " +
                     std::to_string(trial(*same)) +
                     "; number the trials of a participant consecutively");
  }
  return ordered;
}

/// Omits the middle trial of an odd number; nothing for a participant with one trial.
struct Halves {
  std::span<const std::size_t> first{};
  std::span<const std::size_t> second{};
};
std::optional<Halves> halves_of(const std::vector<std::size_t>& rows) {
  const std::size_t half = rows.size() / 2;
  if (half == 0) return std::nullopt;
  return Halves{std::span(rows).first(half), std::span(rows).last(half)};
}

/// Blocks of equally many trials; the last may have fewer.
class TrialBlocks final {
 public:
  TrialBlocks(std::uint64_t last, const FamilyOptions& options) : last_(last) {
    const double most = options.number_or("blocks", kMostBlocks);
    if (!(most >= 1.0) || most != std::round(most)) {
      throw std::runtime_error("the option \"blocks\" is " + number_text(most) +
                               "; it must be a whole number above 0");
    }
    width_ = static_cast<std::uint64_t>(std::ceil(static_cast<double>(last) / most));
    width_ = std::max<std::uint64_t>(width_, 1);
  }
  std::size_t count() const { return static_cast<std::size_t>((last_ + width_ - 1) / width_); }
  std::size_t of(std::uint64_t trial) const {
    return static_cast<std::size_t>((trial - 1) / width_);
  }
  /// "3" for one trial, "1-4" for several.
  std::string name(std::size_t block) const {
    const std::uint64_t first = block * width_ + 1;
    const std::uint64_t last = std::min(first + width_ - 1, last_);
    return first == last ? std::to_string(first)
                         : std::to_string(first) + '-' + std::to_string(last);
  }

 private:
  std::uint64_t last_ = 0;
  std::uint64_t width_ = 1;
};

/// The rows of a participant in each block.
std::vector<std::vector<std::size_t>> rows_by_block(const std::vector<std::size_t>& own,
                                                    const OrderedTrials& ordered,
                                                    const TrialBlocks& blocks) {
  std::vector<std::vector<std::size_t>> by_block(blocks.count());
  for (const std::size_t row : own) by_block[blocks.of(ordered.trials[row])].push_back(row);
  return by_block;
}

// --- response times ------------------------------------------------------------------------------

double geometric_mean_of(std::span<const std::size_t> rows,
                         const std::vector<std::optional<double>>& logarithms) {
  double sum = 0.0;
  for (const std::size_t row : rows) sum += *logarithms[row];
  return std::exp(sum / static_cast<double>(rows.size()));
}

std::optional<double> change_per_trials(const std::vector<std::size_t>& rows,
                                        const OrderedTrials& ordered,
                                        const std::vector<std::optional<double>>& logarithms) {
  std::vector<TrialResult> results{};
  for (const std::size_t row : rows) {
    results.push_back(
        {.trial = static_cast<double>(ordered.trials[row]), .result = *logarithms[row]});
  }
  const std::optional<double> slope = slope_over_trials(results);
  return slope ? std::optional(std::exp(static_cast<double>(kTrialsOfSlope) * *slope))
               : std::nullopt;
}

std::vector<Finding> times_over_trials(const TidyTable& table, const FamilyOptions& options) {
  const std::vector<std::optional<double>> logarithms = logarithms_of_times(table);
  std::vector<bool> is_timed(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) is_timed[row] = logarithms[row].has_value();
  const OrderedTrials ordered = ordered_trials(table, is_timed);
  const TrialBlocks blocks(ordered.last, options);
  const double confidence = options.confidence();
  std::vector<double> first{};
  std::vector<double> second{};
  std::vector<double> ratios{};
  std::vector<double> slopes{};
  std::vector<std::vector<double>> of_blocks(blocks.count());
  FindingList single{};
  const auto add_single = [&single](const char* quantity, const FindingKey& key, double value,
                                    const char* method, const char* unit = "1") {
    single.number(quantity, key, value, {.n = 1, .method = method, .unit = unit});
  };
  for (std::size_t person = 0; person < ordered.rows.size(); ++person) {
    const std::string& name = ordered.participants[person];
    const std::vector<std::size_t>& own = ordered.rows[person];
    if (const std::optional<Halves> halves = halves_of(own)) {
      first.push_back(geometric_mean_of(halves->first, logarithms));
      second.push_back(geometric_mean_of(halves->second, logarithms));
      ratios.push_back(second.back() / first.back());
      add_single("subject.half.ratio", name, ratios.back(),
                 "response time of a participant, second half over first half");
    }
    if (const std::optional<double> change = change_per_trials(own, ordered, logarithms)) {
      slopes.push_back(*change);
      add_single("subject.slope.ratio", name, *change,
                 "exp(10·slope of log response time on trial number) of a participant");
    }
    const auto by_block = rows_by_block(own, ordered, blocks);
    for (std::size_t block = 0; block < by_block.size(); ++block) {
      if (by_block[block].empty()) continue;
      of_blocks[block].push_back(geometric_mean_of(by_block[block], logarithms));
      add_single("subject.block", {name, blocks.name(block)}, of_blocks[block].back(),
                 "geometric mean of a participant's response times in a range of trials", "s");
    }
  }
  FindingList findings{};
  findings.count("n.untimed", "",
                 static_cast<std::uint64_t>(std::count(is_timed.begin(), is_timed.end(), false)),
                 {.n = ordered.participants.size(), .method = "responses without a response time"});
  const auto add_time = [&](const char* quantity, const FindingKey& key,
                            const std::vector<double>& of, const char* method) {
    if (of.empty()) return;
    add_geometric_mean(quantity, key, of, {.confidence = confidence, .unit = "s", .method = method},
                       findings);
  };
  const auto add_ratio = [&](const char* quantity, const std::vector<double>& of,
                             const char* method) {
    if (of.empty()) return;
    const GeometricScale scale{.confidence = confidence, .method = method};
    const bool has_interval = add_geometric_mean(quantity, "", of, scale, findings);
    if (!has_interval) add_no_interval(quantity, "", of.size(), findings);
  };
  add_time("half.first", "", first, "geometric mean response time, first half of the trials");
  add_time("half.second", "", second, "geometric mean response time, second half of the trials");
  add_ratio(
      "half.ratio", ratios,
      "geometric mean of the participants' ratios of response times, second half over first half");
  add_ratio("slope.ratio", slopes,
            "geometric mean of the participants' change of response time per 10 trials, by "
            "least-squares regression of log response time on trial number");
  for (std::size_t block = 0; block < of_blocks.size(); ++block) {
    add_time("block", blocks.name(block), of_blocks[block],
             "geometric mean response time in a range of trials");
  }
  std::vector<Finding> all = findings.take();
  for (Finding& one : single.take()) all.push_back(std::move(one));
  return all;
}

// --- proportions correct -------------------------------------------------------------------------

HitCount hits_of(std::span<const std::size_t> rows, const std::vector<HitCount>& results) {
  HitCount sum{};
  for (const std::size_t row : rows) {
    sum.hits += results[row].hits;
    sum.trials += results[row].trials;
  }
  return sum;
}

std::vector<HitCount> results_in(const TidyTable& table) {
  const std::vector<std::uint64_t> correct = table.counts("correct");
  const std::vector<std::uint64_t> items = table.counts("items");
  std::vector<HitCount> results{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (items[row] == 0 || correct[row] > items[row]) {
      table.refuse(
          row, "correct",
          "correct is " + std::to_string(correct[row]) + " and items is " +
              std::to_string(items[row]) +
              "; items must be at least 1, and correct at most items: correct the counts, or leave "
              "out rows without items");
    }
    results.push_back({.hits = correct[row], .trials = items[row]});
  }
  return results;
}

/// The mean of the participants' differences with Student's interval, or why there is none.
void add_difference(const std::vector<double>& differences, double confidence,
                    FindingList& findings) {
  if (differences.empty()) return;
  constexpr ConfidenceInterval kDifferences{.low = -1.0, .high = 1.0};
  const OneSampleT t = one_sample_t(differences, {.confidence = confidence});
  Basis basis{.n = t.n,
              .method =
                  "mean of the participants' differences of proportions correct, second half minus "
                  "first half; t interval, truncated to possible differences"};
  if (t.test) {
    basis.interval = within(kDifferences, t.test->interval);
    basis.confidence = confidence;
  }
  findings.number("half.difference", "", t.mean, basis);
  if (t.test) {
    const Basis limit{.n = t.n, .method = "limit of the interval"};
    findings.number("half.difference.lower", "", basis.interval->low, limit);
    findings.number("half.difference.upper", "", basis.interval->high, limit);
    return;
  }
  add_no_interval("half.difference", "", t.n, findings);
}

std::vector<Finding> proportions_over_trials(const TidyTable& table, const FamilyOptions& options) {
  const std::vector<HitCount> results = results_in(table);
  const OrderedTrials ordered = ordered_trials(table, std::vector<bool>(table.rows(), true));
  const TrialBlocks blocks(ordered.last, options);
  const double confidence = options.confidence();
  std::vector<HitCount> first{};
  std::vector<HitCount> second{};
  std::vector<double> differences{};
  std::vector<std::vector<HitCount>> of_blocks(blocks.count());
  FindingList single{};
  for (std::size_t person = 0; person < ordered.rows.size(); ++person) {
    const std::string& name = ordered.participants[person];
    const std::vector<std::size_t>& own = ordered.rows[person];
    if (const std::optional<Halves> halves = halves_of(own)) {
      first.push_back(hits_of(halves->first, results));
      second.push_back(hits_of(halves->second, results));
      differences.push_back(proportion(second.back()) - proportion(first.back()));
      single.number(
          "subject.half.difference", name, differences.back(),
          {.n = 1, .method = "proportion correct of a participant, second half minus first half"});
    }
    const auto by_block = rows_by_block(own, ordered, blocks);
    for (std::size_t block = 0; block < by_block.size(); ++block) {
      if (by_block[block].empty()) continue;
      of_blocks[block].push_back(hits_of(by_block[block], results));
      single.number("subject.block", {name, blocks.name(block)},
                    proportion(of_blocks[block].back()),
                    {.n = 1, .method = "proportion correct of a participant in a range of trials"});
    }
  }
  FindingList findings{};
  const auto add_mean = [&](const char* quantity, const FindingKey& key,
                            const std::vector<HitCount>& of, const char* method) {
    if (of.empty()) return;
    add_mean_share(quantity, key, of, method, {.confidence = confidence}, findings);
  };
  add_mean("half.first", "", first, "mean proportion correct, first half of the trials");
  add_mean("half.second", "", second, "mean proportion correct, second half of the trials");
  add_difference(differences, confidence, findings);
  for (std::size_t block = 0; block < of_blocks.size(); ++block) {
    add_mean("block", blocks.name(block), of_blocks[block],
             "mean proportion correct in a range of trials");
  }
  std::vector<Finding> all = findings.take();
  for (Finding& one : single.take()) all.push_back(std::move(one));
  return all;
}

}  // namespace

std::vector<Finding> learning_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  return table.has("time_s") ? times_over_trials(table, input.options)
                             : proportions_over_trials(table, input.options);
}

}  // namespace asperity
