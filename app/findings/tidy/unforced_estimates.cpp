// One bootstrap serves the slope and the thresholds of all performances, each of which has a list of findings.

#include "app/findings/tidy/unforced_estimates.h"

#include <optional>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kMethodOfSplitCounts =
    "maximum likelihood; each response \"cannot tell\" as the mean of a guess";

Basis with_percentiles(Basis basis, const std::optional<ConfidenceInterval>& interval,
                       double confidence) {
  basis.interval = interval;
  if (interval) basis.confidence = confidence;
  return basis;
}

}  // namespace

void add_unforced_estimates(const UnforcedData& data, const PsychometricMaximum& maximum,
                            const UnforcedQuestion& question, std::size_t draws,
                            std::span<FindingList> lists) {
  std::size_t n = 0;
  for (const UnforcedBlock& block : data.blocks) {
    n += static_cast<std::size_t>(block.hits + block.misses + block.unsure);
  }
  const Basis basis{.n = n, .method = kMethodOfSplitCounts};
  const Basis fixed{.n = n, .method = "fixed"};
  UnforcedBootstrap resampled{};
  resampled.thresholds.resize(question.performances.size());
  if (draws > 0) {
    resampled = bootstrap_unforced(data.blocks, data.alternatives, question, draws);
  }
  const auto with_interval = [&](const std::optional<ConfidenceInterval>& interval) {
    return with_percentiles(basis, interval, question.confidence);
  };
  const PsychometricFunction& f = maximum.function;
  for (std::size_t i = 0; i < question.performances.size(); ++i) {
    FindingList& list = lists[i];
    list.number("fit.alpha", data.key, f.alpha, basis);
    list.number("fit.beta", data.key, f.beta, with_interval(resampled.beta));
    list.number("fit.gamma", data.key, f.gamma, question.model.gamma ? fixed : basis);
    list.number("fit.lambda", data.key, f.lambda, question.model.lambda ? fixed : basis);
    list.truth("bound.beta", data.key, maximum.beta_at_bound,
               {.n = n, .method = "whether the slope is at its bound"});
    list.number("loglik", data.key, maximum.log_likelihood,
                {.n = n, .method = "of split counts, binomial coefficients included"});
    const double threshold = f.inverse(question.performances[i]);
    list.number("threshold", data.key, threshold, with_interval(resampled.thresholds[i]));
    list.number("slope.at.threshold", data.key, f.slope(threshold), {.n = n, .method = "dψ/dx"});
  }
}

}  // namespace asperity
