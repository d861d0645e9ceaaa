#include "analysis/unforced_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/psychometric_fit.h"
#include "analysis/psychometric_maximum.h"
#include "analysis/random.h"
#include "analysis/seed_of_tests.h"
#include "analysis/summary.h"

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
                                     std::size_t alternatives, const PsychometricQuestion& question,
                                     std::size_t draws) {
  Random random = Random(kSeedOfTests).split("unforced bootstrap");
  UnforcedBootstrap answer{.draws = draws};
  std::vector<double> thresholds{};
  std::vector<double> betas{};
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::vector<PsychometricBlock> resampled{};
    for (const UnforcedBlock& block : blocks) {
      resampled.push_back(split_block(drawn(block, random), alternatives));
    }
    if (judge(resampled, question.model).status != PsychometricStatus::ok) continue;
    const PsychometricMaximum maximum = maximise_psychometric(resampled, question.model);
    const double threshold = maximum.function.inverse(question.performance);
    if (!maximum.increases || !std::isfinite(threshold)) continue;
    thresholds.push_back(threshold);
    betas.push_back(maximum.function.beta);
  }
  answer.valid = thresholds.size();
  if (2 * answer.valid < draws || thresholds.empty()) return answer;
  answer.threshold = percentiles(thresholds, question.confidence);
  answer.beta = percentiles(betas, question.confidence);
  return answer;
}

}  // namespace asperity
