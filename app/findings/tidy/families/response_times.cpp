// Response times by condition, on the logarithmic scale.

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/time_column.h"

namespace asperity {
namespace {

/// The logarithms of response times in one condition.
class LogTimes final {
 public:
  explicit LogTimes(std::size_t participants) : sums_(participants), counts_(participants) {}

  void add(std::size_t participant, double logarithm) {
    sums_[participant] += logarithm;
    ++counts_[participant];
    ++responses_;
  }
  std::size_t responses() const noexcept { return responses_; }
  /// Nothing for a participant without a time.
  std::optional<double> geometric_mean_of(std::size_t participant) const {
    if (counts_[participant] == 0) return std::nullopt;
    return std::exp(sums_[participant] / static_cast<double>(counts_[participant]));
  }

 private:
  std::vector<double> sums_;
  std::vector<std::size_t> counts_;
  std::size_t responses_ = 0;
};

void add_condition(const FindingKey& key, const std::vector<std::string>& participants,
                   const LogTimes& times, double confidence, FindingList& findings) {
  std::vector<double> means{};
  for (std::size_t i = 0; i < participants.size(); ++i) {
    const std::optional<double> own = times.geometric_mean_of(i);
    if (own) means.push_back(*own);
  }
  findings.count("responses", key, times.responses(),
                 {.n = means.size(), .method = "responses with a response time"});
  if (means.empty()) return;
  const bool has_interval = add_geometric_mean(
      "geomean", key, means,
      {.confidence = confidence,
       .unit = "s",
       .method = "geometric mean over participants of their geometric mean response times",
       .coverage = simulated_coverage({92, 96})},
      findings);
  if (!has_interval) add_no_interval("geomean", key, means.size(), findings);
  for (std::size_t i = 0; i < participants.size(); ++i) {
    const std::optional<double> own = times.geometric_mean_of(i);
    if (!own) continue;
    findings.number(
        "subject.geomean", {participants[i], key}, *own,
        {.n = 1, .method = "geometric mean of a participant's response times", .unit = "s"});
  }
}

}  // namespace

std::vector<Finding> response_times_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<std::optional<double>> logarithms = logarithms_of_times(table);
  const double confidence = input.options.confidence();
  LogTimes all(participants.names.size());
  std::size_t untimed = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (logarithms[row]) {
      all.add(participants.codes[row], *logarithms[row]);
    } else {
      ++untimed;
    }
  }
  FindingList findings{};
  findings.count("n.untimed", "", untimed,
                 {.n = participants.names.size(), .method = "responses without a response time"});
  if (all.responses() == 0) {
    findings.word("status", "", "no_data",
                  "no response has a response time: enter the response times",
                  {.method = "response times"});
    return findings.take();
  }
  add_condition("", participants.names, all, confidence, findings);
  for (const auto& [factor, levels] : input.options.levels("factors")) {
    const LabelColumn codes = table.labels(factor, levels);
    std::vector<LogTimes> by_level(levels.size(), LogTimes(participants.names.size()));
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (!logarithms[row] || codes.codes[row] == LabelColumn::kMissing) continue;
      by_level[codes.codes[row]].add(participants.codes[row], *logarithms[row]);
    }
    for (std::size_t level = 0; level < levels.size(); ++level) {
      add_condition(factor + '=' + levels[level], participants.names, by_level[level], confidence,
                    findings);
    }
  }
  return findings.take();
}

}  // namespace asperity
