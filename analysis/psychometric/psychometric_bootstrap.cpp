// Refits every resample from one grid of starts; binomial counts are drawn by inversion, one random number each.

#include "analysis/psychometric/psychometric_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/binomial.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"
#include "analysis/numbers/summary.h"
#include "analysis/psychometric/psychometric_maximum.h"

namespace asperity {
namespace {

struct Refit {
  PsychometricMaximum maximum{};
  std::optional<double> threshold{};
};

Refit refitted(std::span<const PsychometricBlock> blocks, const PsychometricQuestion& question,
               PsychometricStarts& starts) {
  Refit refit{.maximum = maximise_psychometric(blocks, question.model, starts)};
  const bool has_threshold =
      refit.maximum.increases && judge(blocks, question.model).status == PsychometricStatus::ok;
  const double threshold = refit.maximum.function.inverse(question.performance);
  if (has_threshold && std::isfinite(threshold)) {
    refit.threshold = threshold;
  }
  return refit;
}

void add(const Refit& refit, ThresholdBootstrap& bootstrap) {
  bootstrap.thresholds.push_back(refit.threshold);
  bootstrap.valid += refit.threshold ? 1 : 0;
  bootstrap.slopes_at_bound += refit.threshold && refit.maximum.beta_at_bound ? 1 : 0;
}

void summarise(double confidence, ThresholdBootstrap& bootstrap) {
  std::vector<double> found;
  for (const std::optional<double>& threshold : bootstrap.thresholds) {
    if (threshold) {
      found.push_back(*threshold);
    }
  }
  if (found.size() >= 2) {
    bootstrap.standard_error = summary_of(found)->sd;
  }
  if (!found.empty()) {
    std::sort(found.begin(), found.end());
    const double outside = 0.5 * (1.0 - confidence);
    bootstrap.percentile = {.low = quantile(found, outside),
                            .high = quantile(found, 1.0 - outside)};
  }
}

// By inversion of the distribution, so that every draw uses one random number.
std::uint64_t binomial_draw(std::uint64_t trials, double probability, Random& random) {
  using Policy = boost::math::policies::policy<
      boost::math::policies::discrete_quantile<boost::math::policies::integer_round_up>>;
  const boost::math::binomial_distribution<double, Policy> binomial(
      static_cast<double>(trials), std::clamp(probability, 0.0, 1.0));
  return static_cast<std::uint64_t>(boost::math::quantile(binomial, random.uniform()));
}

}  // namespace

ThresholdBootstrap bootstrap_threshold(std::span<const PsychometricBlock> blocks,
                                       std::span<const std::vector<std::uint64_t>> resamples,
                                       const PsychometricQuestion& question) {
  ThresholdBootstrap answer;
  PsychometricStarts starts{};
  std::vector<PsychometricBlock> resampled(blocks.begin(), blocks.end());
  for (const std::vector<std::uint64_t>& hits : resamples) {
    if (hits.size() != blocks.size()) {
      throw std::invalid_argument(
          "resamples: a row has " + counted(hits.size(), "count", "counts") +
          "; the number must be that of the blocks, " + std::to_string(blocks.size()));
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
      resampled[i].hits = hits[i];
    }
    add(refitted(resampled, question, starts), answer);
  }
  summarise(question.confidence, answer);
  return answer;
}

ParametricBootstrap parametric_bootstrap(std::span<const PsychometricBlock> blocks,
                                         const PsychometricFit& fit,
                                         const PsychometricQuestion& question, std::size_t draws) {
  constexpr double kRounding = 1e-9;
  ParametricBootstrap answer;
  Random random = Random(kSeedOfTests).split("psychometric bootstrap");
  std::vector<PsychometricBlock> drawn(blocks.begin(), blocks.end());
  PsychometricStarts starts{};
  std::size_t as_large = 1;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    for (PsychometricBlock& block : drawn) {
      block.hits = binomial_draw(block.trials, fit.function.value(block.x), random);
    }
    const Refit refit = refitted(drawn, question, starts);
    as_large += refit.maximum.deviance >= fit.deviance - kRounding ? 1 : 0;
    add(refit, answer.thresholds);
  }
  summarise(question.confidence, answer.thresholds);
  if (fit.deviance_df > 0.0) {
    answer.deviance_p = static_cast<double>(as_large) / static_cast<double>(draws + 1);
  }
  return answer;
}

}  // namespace asperity
