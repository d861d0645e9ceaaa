// Clustered variance by the ratio estimator; intervals on the logit scale with an effective number of trials.

#include "analysis/tests/pooled_share.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {

PooledShare pooled_share(std::span<const HitCount> participants) {
  if (participants.empty()) {
    throw std::invalid_argument("participants is empty; at least one is needed");
  }
  HitCount all{};
  for (const HitCount& own : participants) {
    static_cast<void>(proportion(own));  // refuses what is impossible
    all.hits += own.hits;
    all.trials += own.trials;
  }
  PooledShare pooled{.share = proportion(all)};
  const auto trials = static_cast<double>(all.trials);
  const auto n = static_cast<double>(participants.size());
  double squares = 0.0;
  for (const HitCount& own : participants) {
    const double from =
        static_cast<double>(own.hits) - pooled.share * static_cast<double>(own.trials);
    squares += from * from;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const double binomial = pooled.share * (1.0 - pooled.share) / trials;
  const double clustered = n > 1.0 ? n / (n - 1.0) * squares / (trials * trials) : kNone;
  pooled.clustered_standard_error = std::sqrt(clustered);
  pooled.binomial_standard_error = std::sqrt(binomial);
  pooled.design_effect = binomial > 0.0 ? clustered / binomial : kNone;
  return pooled;
}

namespace {

/// logit q ∓ t/√((n' + 1)q(1 − q)) as proportions, for a mean proportion on n' effective trials.
ConfidenceInterval logit_interval(double mean, double trials, double t) {
  const double shrunk = (trials * mean + 0.5) / (trials + 1.0);
  const double logit = std::log(shrunk / (1.0 - shrunk));
  const double half = t / std::sqrt((trials + 1.0) * shrunk * (1.0 - shrunk));
  const auto share = [](double of_logit) { return 1.0 / (1.0 + std::exp(-of_logit)); };
  return {.low = mean == 0.0 ? 0.0 : share(logit - half),
          .high = mean == 1.0 ? 1.0 : share(logit + half)};
}

void require_confidence(double confidence) {
  if (confidence > 0.0 && confidence < 1.0) return;
  throw std::invalid_argument("confidence is " + number_text(confidence) +
                              "; it must lie between 0 and 1");
}

}  // namespace

std::optional<ConfidenceInterval> mean_share_interval(std::span<const HitCount> participants,
                                                      const MeanShareQuestion& question) {
  const double all = pooled_share(participants).share;  // refuses what is impossible
  require_confidence(question.confidence);
  if (!(question.least_design_effect >= 1.0)) {
    throw std::invalid_argument("least_design_effect is " +
                                number_text(question.least_design_effect) +
                                "; it must be at least 1");
  }
  const auto n = static_cast<double>(participants.size());
  const std::optional<double> t = t_limit({.confidence = question.confidence, .df = n - 1.0});
  if (!t) return std::nullopt;
  double mean = 0.0;
  double reciprocal_trials = 0.0;
  for (const HitCount& own : participants) {
    mean += proportion(own) / n;
    reciprocal_trials += 1.0 / static_cast<double>(own.trials);
  }
  double trials = n * n / reciprocal_trials / question.least_design_effect;
  if (all > 0.0 && all < 1.0) {
    double between = 0.0;
    for (const HitCount& own : participants) between += std::pow(proportion(own) - mean, 2);
    between /= n * (n - 1.0);
    const double binomial = mean * (1.0 - mean) / trials;
    trials = mean * (1.0 - mean) / std::max(between, binomial);
  } else {
    mean = all;  // exactly
  }
  return logit_interval(mean, trials, *t);
}

std::optional<ConfidenceInterval> equal_shares_interval(const EqualShares& shares) {
  require_confidence(shares.confidence);
  if (!(shares.share >= 0.0 && shares.share <= 1.0)) {
    throw std::invalid_argument("share is " + number_text(shares.share) +
                                "; it must lie between 0 and 1");
  }
  double reciprocal_trials = 0.0;
  for (const double trials : shares.trials) {
    if (!(trials > 0.0)) {
      throw std::invalid_argument("trials is " + number_text(trials) + "; it must be above 0");
    }
    reciprocal_trials += 1.0 / trials;
  }
  const auto n = static_cast<double>(shares.trials.size());
  const std::optional<double> t = t_limit({.confidence = shares.confidence, .df = n - 1.0});
  if (!t) return std::nullopt;
  return logit_interval(shares.share, n * n / reciprocal_trials, *t);
}

}  // namespace asperity
