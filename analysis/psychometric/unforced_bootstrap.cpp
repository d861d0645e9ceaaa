// Draws hits, misses and responses “cannot tell” of each level with replacement, splits the last, and refits.

#include "analysis/psychometric/unforced_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"
#include "analysis/numbers/summary.h"
#include "analysis/psychometric/psychometric_fit.h"
#include "analysis/psychometric/psychometric_maximum.h"

namespace asperity {
namespace {

UnforcedBlock drawn(const UnforcedBlock& block, Random& random) {
  const std::uint64_t trials = block.hits + block.misses + block.unsure;
  UnforcedBlock made{.x = block.x};
  for (std::uint64_t i = 0; i < trials; ++i) {
    const std::uint64_t place = random.below(trials);
    ++(place < block.hits                  ? made.hits
       : place < block.hits + block.unsure ? made.unsure
                                           : made.misses);
  }
  return made;
}

ConfidenceInterval percentiles(std::vector<double>& values, double confidence) {
  std::sort(values.begin(), values.end());
  const double outside = 0.5 * (1.0 - confidence);
  return {.low = quantile(values, outside), .high = quantile(values, 1.0 - outside)};
}

}  // namespace

PsychometricBlock split_block(const UnforcedBlock& block, std::size_t alternatives) {
  if (alternatives == 0) {
    throw std::invalid_argument("alternatives is 0; it must be at least 1");
  }
  return {.x = block.x,
          .trials = block.hits + block.misses + block.unsure,
          .hits = block.hits,
          .guessed_hits = static_cast<double>(block.unsure) / static_cast<double>(alternatives)};
}

UnforcedBootstrap bootstrap_unforced(std::span<const UnforcedBlock> blocks,
                                     std::size_t alternatives, const UnforcedQuestion& question,
                                     std::size_t draws) {
  Random random = Random(kSeedOfTests).split("unforced bootstrap");
  const std::size_t asked = question.performances.size();
  UnforcedBootstrap answer{.draws = draws};
  answer.thresholds.resize(asked);
  std::vector<std::vector<double>> thresholds(asked);
  std::vector<double> betas{};
  std::size_t at_bound = 0;
  PsychometricStarts starts{};
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::vector<PsychometricBlock> resampled{};
    for (const UnforcedBlock& block : blocks) {
      resampled.push_back(split_block(drawn(block, random), alternatives));
    }
    if (judge(resampled, question.model).status != PsychometricStatus::ok) continue;
    const PsychometricMaximum maximum = maximise_psychometric(resampled, question.model, starts);
    std::vector<double> of_draw{};
    for (const double performance : question.performances) {
      of_draw.push_back(maximum.function.inverse(performance));
    }
    const bool has_all = std::all_of(of_draw.begin(), of_draw.end(),
                                     [](double threshold) { return std::isfinite(threshold); });
    if (!maximum.increases || !has_all) continue;
    for (std::size_t i = 0; i < asked; ++i) thresholds[i].push_back(of_draw[i]);
    betas.push_back(maximum.function.beta);
    if (maximum.beta_at_bound) ++at_bound;
  }
  answer.valid = betas.size();
  if (2 * answer.valid < draws || betas.empty()) return answer;
  for (std::size_t i = 0; i < asked; ++i) {
    answer.thresholds[i] = percentiles(thresholds[i], question.confidence);
  }
  const double outside = 0.5 * (1.0 - question.confidence);
  if (static_cast<double>(at_bound) <= outside * static_cast<double>(betas.size())) {
    answer.beta = percentiles(betas, question.confidence);
  }
  return answer;
}

}  // namespace asperity
