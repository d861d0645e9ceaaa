#include "app/findings/study/unforced_functions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "analysis/psychometric_fit.h"
#include "analysis/psychometric_maximum.h"
#include "analysis/unforced_bootstrap.h"

namespace asperity {

namespace {

constexpr double kConfidenceOfResamples = 0.95;

/// The same model as in `psychometric_input`.
PsychometricModel model_of(const DiscriminationTask& task) {
  if (!task.is_performance) {
    return {.shape = PsychometricShape::normal,
            .gamma = kSymmetricLapseRate,
            .lambda = kSymmetricLapseRate};
  }
  return {.shape = PsychometricShape::weibull,
          .gamma = 1.0 / static_cast<double>(task.design->alternatives()),
          .lambda = std::nullopt,
          .greatest_lambda = kGreatestLapseRate};
}

/// By x as in `psychometric_blocks`, ascending.
std::vector<UnforcedBlock> unforced_blocks(const DiscriminationTask& task,
                                           const HitsByValue& hits) {
  std::map<double, UnforcedBlock> by_x{};
  for (const auto& [value, count] : hits) {
    const double x = task.is_performance ? std::abs(value - task.standard()) : value;
    UnforcedBlock& block = by_x[x];
    block.x = x;
    block.hits += count.hits;
    block.unsure += count.unsure;
    block.misses += count.trials - count.hits - count.unsure;
  }
  std::vector<UnforcedBlock> blocks{};
  for (const auto& [x, block] : by_x) blocks.push_back(block);
  return blocks;
}

Basis with_percentiles(Basis basis, const std::optional<ConfidenceInterval>& interval) {
  basis.interval = interval;
  if (interval) basis.confidence = kConfidenceOfResamples;
  return basis;
}

}  // namespace

bool has_unsure(const DiscriminationData& data) {
  return std::any_of(data.hits.begin(), data.hits.end(),
                     [](const auto& each) { return each.second.unsure > 0; });
}

bool add_fit_status(const std::vector<PsychometricBlock>& blocks, const PsychometricModel& model,
                    const std::string& key, const Basis& basis, FindingList& list) {
  const auto none = [&](const char* word, const char* sentence) {
    list.word("status", key, word, sentence, basis);
    return false;
  };
  switch (judge(blocks, model).status) {
    case PsychometricStatus::ok:
      return true;
    case PsychometricStatus::all_correct:
      return none("all_correct", "every response is correct: present smaller differences");
    case PsychometricStatus::all_wrong:
      return none("all_wrong",
                  "every response is incorrect: check the question and its correct response");
    default:
      return none("one_level", "all trials are at one level: present several");
  }
}

void add_unforced_function(const DiscriminationTask& task, const DiscriminationData& data,
                           double performance, FindingList& list) {
  const PsychometricModel model = model_of(task);
  const std::size_t alternatives = task.design->alternatives();
  const std::vector<PsychometricBlock> blocks = psychometric_blocks(task, data.hits);
  const Basis basis{.n = static_cast<std::size_t>(sum_of_choices(data.hits).trials),
                    .method =
                        "maximum likelihood; each response \"cannot tell\" as the mean of a "
                        "guess"};
  if (!add_fit_status(blocks, model, data.key, basis, list)) return;
  const PsychometricMaximum maximum = maximise_psychometric(blocks, model);
  if (!maximum.increases) {
    list.word("status", data.key, "not_increasing",
              "the proportion of hits does not rise with the level: check the responses", basis);
    return;
  }
  list.word("status", data.key, "ok", "ok", basis);
  const PsychometricFunction& f = maximum.function;
  UnforcedBootstrap resampled{};
  if (data.needs_intervals) {
    resampled = bootstrap_unforced(
        unforced_blocks(task, data.hits), alternatives,
        {.model = model, .performance = performance, .confidence = kConfidenceOfResamples},
        kUnforcedResamples);
  }
  const Basis fixed{.n = basis.n, .method = "fixed"};
  list.number("fit.alpha", data.key, f.alpha, basis);
  list.number("fit.beta", data.key, f.beta, with_percentiles(basis, resampled.beta));
  list.number("fit.gamma", data.key, f.gamma, fixed);
  list.number("fit.lambda", data.key, f.lambda, model.lambda ? fixed : basis);
  list.truth("bound.beta", data.key, maximum.beta_at_bound,
             {.n = basis.n, .method = "whether the slope is at its bound"});
  list.number("loglik", data.key, maximum.log_likelihood,
              {.n = basis.n, .method = "of split counts, binomial coefficients included"});
  const double threshold = f.inverse(performance);
  list.number("threshold", data.key, threshold, with_percentiles(basis, resampled.threshold));
  list.number("slope.at.threshold", data.key, f.slope(threshold),
              {.n = basis.n, .method = "dψ/dx"});
}

}  // namespace asperity
