// Adds outcomes by test, effect and size in any order, and fits a monotone curve to the counts.

#include "app/power/curve/power_tally.h"

#include <algorithm>

#include "app/findings/outcome/study_test.h"

namespace asperity {

bool is_significant(const SimulatedOutcome& outcome) noexcept {
  const std::optional<double>& p = outcome.corrected_p ? outcome.corrected_p : outcome.p;
  return p && *p < StudyTest::kLevel;
}

PowerTally::PowerTally(PowerOrder order)
    : order_(std::move(order)),
      studies_(static_cast<std::size_t>(studies_per_run(order_)), std::uint64_t{0}) {}

std::size_t PowerTally::test_of(const SimulatedOutcome& outcome) {
  const auto [place, is_new] = places_.try_emplace({outcome.family, outcome.test}, tests_.size());
  if (is_new) {
    tests_.push_back(place->first);
    counts_.emplace_back(studies_.size());
    methods_.emplace_back();
  }
  return place->second;
}

void PowerTally::add(const StudyPlace& place, std::span<const SimulatedOutcome> outcomes) {
  const std::size_t cell = place.effect * order_.participants.size() + place.size;
  ++studies_[cell];
  for (const SimulatedOutcome& outcome : outcomes) {
    const std::size_t test = test_of(outcome);
    if (!outcome.method.empty()) methods_[test].insert(outcome.method);
    Counts& counts = counts_[test][cell];
    if (outcome.p || outcome.corrected_p) {
      ++counts.with_p;
    } else if (!outcome.status.empty()) {
      statuses_[{test, place.effect}].insert(outcome.status);
    }
    if (is_significant(outcome)) ++counts.significant;
    if (!outcome.lower || !outcome.upper) continue;
    // Not of NaN, nor of two equal infinite limits.
    const double width = *outcome.upper - *outcome.lower;
    if (width >= 0.0) counts.widths.add(width);
  }
}

bool PowerTally::is_without_subjects(std::size_t test) const {
  const auto& [family, name] = tests_[test];
  if (name.empty() || std::any_of(counts_[test].begin(), counts_[test].end(),
                                  [](const Counts& counts) { return counts.with_p > 0; })) {
    return false;
  }
  return std::any_of(tests_.begin(), tests_.end(), [&](const Test& other) {
    return other.first == family && other.second.starts_with(name + ' ');
  });
}

std::vector<PowerCurve> PowerTally::curves() const {
  std::vector<PowerCurve> curves{};
  const std::size_t sizes = order_.participants.size();
  for (std::size_t effect = 0; effect < order_.effects.size(); ++effect) {
    for (std::size_t test = 0; test < tests_.size(); ++test) {
      if (is_without_subjects(test)) continue;
      PowerCurve curve{.effect = order_.effects[effect],
                       .family = tests_[test].first,
                       .test = tests_[test].second,
                       .methods = {methods_[test].begin(), methods_[test].end()}};
      if (const auto known = statuses_.find({test, effect}); known != statuses_.end()) {
        curve.statuses.assign(known->second.begin(), known->second.end());
      }
      std::vector<StudiesOfSize> of_sizes{};
      for (std::size_t size = 0; size < sizes; ++size) {
        const std::size_t cell = effect * sizes + size;
        const Counts& counts = counts_[test][cell];
        const std::uint64_t studies = studies_[cell];
        if (studies == 0) continue;
        of_sizes.push_back({.participants = order_.participants[size],
                            .significant = {.hits = counts.significant, .trials = studies}});
        curve.sizes.push_back({.studies = studies,
                               .significant = counts.significant,
                               .without_p = studies - counts.with_p,
                               .median_width = counts.widths.quantile(0.5),
                               .p90_width = counts.widths.quantile(0.9)});
      }
      if (of_sizes.empty()) continue;
      const std::vector<PowerOfSize> fitted = monotone_power(of_sizes);
      for (std::size_t i = 0; i < fitted.size(); ++i) curve.sizes[i].power = fitted[i];
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace asperity
