// Measurements by condition: the participants' own medians or means, and how they are distributed over the participants.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/summary.h"
#include "app/findings/tidy/described_conditions.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

OwnAverage own_average_of(const FamilyOptions& options) {
  const std::string average = options.text_or("average", "mean");
  if (average == "mean") return OwnAverage::mean;
  if (average == "median") return OwnAverage::median;
  throw std::runtime_error("the option \"average\" is \"" + average +
                           "\"; it must be mean or median");
}

/// The measurements of one condition, by participant.
using MeasuredByPerson = std::vector<std::vector<double>>;

std::vector<OwnValue> own_values(OwnAverage average, MeasuredByPerson measured) {
  std::vector<OwnValue> own{};
  for (std::size_t person = 0; person < measured.size(); ++person) {
    std::vector<double>& values = measured[person];
    if (values.empty()) continue;
    own.push_back({.participant = person,
                   .measurements = values.size(),
                   .value = own_average(average, values)});
  }
  return own;
}

void add_described(const DescribedCondition& condition, const Description& description,
                   FindingList& findings) {
  const FindingKey& key = condition.key;
  const bool has_means = description.average == OwnAverage::mean;
  std::size_t measurements = 0;
  std::vector<double> own{};
  for (const OwnValue& one : condition.own) {
    measurements += one.measurements;
    own.push_back(one.value);
  }
  findings.count("measurements", key, measurements, {.n = own.size(), .method = "measurements"});
  if (own.empty()) return;
  for (const OwnValue& one : condition.own) {
    const std::string& name = description.participants[one.participant];
    findings.number("subject.value", {name, key}, one.value,
                    {.n = 1,
                     .method = has_means ? "mean of a participant's measurements"
                                         : "median of a participant's measurements"});
  }
  const Summary summary = *summary_of(own);
  std::sort(own.begin(), own.end());
  const auto add = [&](const char* quantity, double value, const std::string& what) {
    findings.number(quantity, key, value,
                    {.n = own.size(),
                     .method = what + " over participants of the participants' " +
                               (has_means ? "means" : "medians")});
  };
  add("mean", summary.mean, "mean");
  if (own.size() > 1) add("sd", summary.sd, "standard deviation");
  add("median", quantile(own, 0.5), "median");
  add("quartile.lower", quantile(own, 0.25), "lower quartile");
  add("quartile.upper", quantile(own, 0.75), "upper quartile");
}

}  // namespace

double own_average(OwnAverage average, std::vector<double>& measurements) {
  switch (average) {
    case OwnAverage::mean:
      return std::accumulate(measurements.begin(), measurements.end(), 0.0) /
             static_cast<double>(measurements.size());
    case OwnAverage::median:
      std::sort(measurements.begin(), measurements.end());
      return quantile(measurements, 0.5);
  }
  return 0.0;
}

std::vector<Finding> findings_of(const Description& description) {
  FindingList findings{};
  findings.count("n.missing", "", description.missing,
                 {.n = description.described, .method = "rows without a measurement"});
  for (const DescribedCondition& condition : description.conditions) {
    add_described(condition, description, findings);
  }
  return findings.take();
}

std::vector<Finding> description_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const NumberColumn values = table.numbers("value");
  Description description{.average = own_average_of(input.options),
                          .participants = participants.names,
                          .described = participants.names.size()};
  std::vector<std::pair<FindingKey, std::vector<OwnValue>>> conditions{};
  const auto add_condition = [&](FindingKey key, MeasuredByPerson measured) {
    conditions.emplace_back(std::move(key), own_values(description.average, std::move(measured)));
  };
  MeasuredByPerson all(participants.names.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (values[row]) {
      all[participants.codes[row]].push_back(*values[row]);
    } else {
      ++description.missing;
    }
  }
  add_condition("", std::move(all));
  for (const auto& [factor, levels] : input.options.levels("factors")) {
    const LabelColumn codes = table.labels(factor, levels);
    std::vector<MeasuredByPerson> by_level(levels.size(),
                                           MeasuredByPerson(participants.names.size()));
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (!values[row] || codes.codes[row] == LabelColumn::kMissing) continue;
      by_level[codes.codes[row]][participants.codes[row]].push_back(*values[row]);
    }
    for (std::size_t level = 0; level < levels.size(); ++level) {
      add_condition(factor + '=' + levels[level], std::move(by_level[level]));
    }
  }
  for (const auto& [key, own] : conditions) description.conditions.push_back({key, own});
  return findings_of(description);
}

}  // namespace asperity
