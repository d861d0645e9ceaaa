// Draws participants with replacement; percentiles are expanded by the t quantile and n/(n − 1) [Hesterberg 2015].

#include "analysis/tests/participant_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"
#include "analysis/numbers/summary.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

/// The proportion of draws outside each end of the interval.
double expanded_tail(const BootstrapPlan& plan) {
  const auto n = static_cast<double>(plan.participants);
  const double t = t_limit({.confidence = plan.confidence, .df = n - 1.0}).value();
  return normal_below(-std::sqrt(n / (n - 1.0)) * t);
}

}  // namespace

ParticipantBootstrap bootstrap_participants(
    const BootstrapPlan& plan,
    const std::function<std::optional<double>(std::span<const std::size_t>)>& statistic) {
  if (plan.participants < kFewestResampled) return {};
  ParticipantBootstrap bootstrap{.draws = plan.draws};
  const Random seeded = Random(kSeedOfTests).split("participant_bootstrap");
  std::vector<double> found{};
  std::vector<std::size_t> drawn(plan.participants);
  for (std::size_t draw = 0; draw < plan.draws; ++draw) {
    Random random = seeded.split(draw);
    for (std::size_t& place : drawn) {
      place = static_cast<std::size_t>(random.below(plan.participants));
    }
    if (const std::optional<double> value = statistic(drawn)) {
      found.push_back(*value);
    } else {
      ++bootstrap.without;
    }
  }
  if (found.empty()) return bootstrap;
  std::sort(found.begin(), found.end());
  const double outside = expanded_tail(plan);
  bootstrap.interval =
      ConfidenceInterval{.low = quantile(found, outside), .high = quantile(found, 1.0 - outside)};
  return bootstrap;
}

}  // namespace asperity
