// Measurements by condition: the participants' own medians or means, and how they are distributed over the participants.

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/summary.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

enum class OwnValue { median, mean };

OwnValue own_value_of(const FamilyOptions& options) {
  const std::string average = options.text_or("average", "mean");
  if (average == "mean") return OwnValue::mean;
  if (average == "median") return OwnValue::median;
  throw std::runtime_error("the option \"average\" is \"" + average +
                           "\"; it must be mean or median");
}

/// The measurements of one condition, by participant.
using MeasuredByPerson = std::vector<std::vector<double>>;

struct DescribedCondition {
  const std::vector<std::string>& participants;
  OwnValue own_value = OwnValue::mean;
};

void add_described(const std::string& key, MeasuredByPerson measured,
                   const DescribedCondition& condition, FindingList& findings) {
  const std::string average = condition.own_value == OwnValue::mean ? "means" : "medians";
  std::vector<double> own{};
  std::size_t measurements = 0;
  std::vector<std::string> names{};
  for (std::size_t person = 0; person < measured.size(); ++person) {
    std::vector<double>& values = measured[person];
    if (values.empty()) continue;
    measurements += values.size();
    if (condition.own_value == OwnValue::mean) {
      own.push_back(summary_of(values)->mean);
    } else {
      std::sort(values.begin(), values.end());
      own.push_back(quantile(values, 0.5));
    }
    names.push_back(condition.participants[person]);
  }
  findings.count("measurements", key, measurements, {.n = own.size(), .method = "measurements"});
  if (own.empty()) return;
  for (std::size_t i = 0; i < own.size(); ++i) {
    findings.number("subject.value", key.empty() ? names[i] : both(names[i], key), own[i],
                    {.n = 1,
                     .method = condition.own_value == OwnValue::mean
                                   ? "mean of a participant's measurements"
                                   : "median of a participant's measurements"});
  }
  const Summary summary = *summary_of(own);
  std::sort(own.begin(), own.end());
  const auto add = [&](const char* quantity, double value, const std::string& what) {
    findings.number(
        quantity, key, value,
        {.n = own.size(), .method = what + " over participants of the participants' " + average});
  };
  add("mean", summary.mean, "mean");
  if (own.size() > 1) add("sd", summary.sd, "standard deviation");
  add("median", quantile(own, 0.5), "median");
  add("quartile.lower", quantile(own, 0.25), "lower quartile");
  add("quartile.upper", quantile(own, 0.75), "upper quartile");
}

}  // namespace

std::vector<Finding> description_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const NumberColumn values = table.numbers("value");
  const DescribedCondition condition{.participants = participants.names,
                                     .own_value = own_value_of(input.options)};
  MeasuredByPerson all(participants.names.size());
  std::size_t missing = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (values[row]) {
      all[participants.codes[row]].push_back(*values[row]);
    } else {
      ++missing;
    }
  }
  FindingList findings{};
  findings.count("n.missing", "", missing,
                 {.n = participants.names.size(), .method = "rows without a measurement"});
  add_described("", std::move(all), condition, findings);
  for (const auto& [factor, levels] : input.options.levels("factors")) {
    const LabelColumn codes = table.labels(factor, levels);
    std::vector<MeasuredByPerson> by_level(levels.size(),
                                           MeasuredByPerson(participants.names.size()));
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (!values[row] || codes.codes[row] == LabelColumn::kMissing) continue;
      by_level[codes.codes[row]][participants.codes[row]].push_back(*values[row]);
    }
    for (std::size_t level = 0; level < levels.size(); ++level) {
      add_described(factor + '=' + levels[level], std::move(by_level[level]), condition, findings);
    }
  }
  return findings.take();
}

}  // namespace asperity
