#include "analysis/psychometric_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/psychometric_maximum.h"
#include "analysis/summary.h"

namespace asperity {

ThresholdBootstrap bootstrap_threshold(std::span<const PsychometricBlock> blocks,
                                       std::span<const std::vector<std::uint64_t>> resamples,
                                       const PsychometricQuestion& question) {
  ThresholdBootstrap answer;
  std::vector<double> found;
  for (const std::vector<std::uint64_t>& hits : resamples) {
    if (hits.size() != blocks.size()) {
      throw std::invalid_argument("resamples: a row has " + std::to_string(hits.size()) +
                                  " counts for " + std::to_string(blocks.size()) + " blocks");
    }
    std::vector<PsychometricBlock> resampled(blocks.begin(), blocks.end());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      resampled[i].hits = hits[i];
    }
    answer.thresholds.emplace_back();
    if (judge(resampled, question.model).status != PsychometricStatus::ok) {
      continue;
    }
    const PsychometricMaximum maximum = maximise_psychometric(resampled, question.model);
    if (!maximum.increases) {
      continue;
    }
    answer.slopes_at_bound += maximum.beta_at_bound ? 1 : 0;
    const double threshold = maximum.function.inverse(question.performance);
    if (std::isfinite(threshold)) {
      answer.thresholds.back() = threshold;
      found.push_back(threshold);
    }
  }
  answer.valid = found.size();
  if (found.size() >= 2) {
    answer.standard_error = summary_of(found)->sd;
  }
  if (!found.empty()) {
    std::sort(found.begin(), found.end());
    const double outside = 0.5 * (1.0 - question.confidence);
    answer.percentile = {.low = quantile(found, outside), .high = quantile(found, 1.0 - outside)};
  }
  return answer;
}

}  // namespace asperity
