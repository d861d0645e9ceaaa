#include "app/findings/study/unforced_functions.h"

#include <algorithm>
#include <optional>

#include "analysis/psychometric_fit.h"
#include "analysis/psychometric_maximum.h"
#include "analysis/unforced_bootstrap.h"

namespace asperity {

namespace {

constexpr double kConfidenceOfResamples = 0.95;

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
                           std::span<const double> performances, std::span<FindingList> lists) {
  const PsychometricModel model = psychometric_model(task);
  const std::vector<PsychometricBlock> blocks = psychometric_blocks(task, data.hits);
  const Basis basis{.n = static_cast<std::size_t>(sum_of_choices(data.hits).trials),
                    .method =
                        "maximum likelihood; each response \"cannot tell\" as the mean of a "
                        "guess"};
  bool has_function = true;
  for (FindingList& list : lists) {
    has_function = add_fit_status(blocks, model, data.key, basis, list) && has_function;
  }
  if (!has_function) return;
  const PsychometricMaximum maximum = maximise_psychometric(blocks, model);
  for (FindingList& list : lists) {
    if (maximum.increases) {
      list.word("status", data.key, "ok", "ok", basis);
    } else {
      list.word("status", data.key, "not_increasing",
                "the proportion of hits does not rise with the level: check the responses", basis);
    }
  }
  if (!maximum.increases) return;
  const PsychometricFunction& f = maximum.function;
  UnforcedBootstrap resampled{};
  resampled.thresholds.resize(performances.size());
  if (data.needs_intervals) {
    resampled = bootstrap_unforced(unforced_blocks(task, data.hits), task.design->alternatives(),
                                   {.model = model,
                                    .performances = {performances.begin(), performances.end()},
                                    .confidence = kConfidenceOfResamples},
                                   kUnforcedResamples);
  }
  const Basis fixed{.n = basis.n, .method = "fixed"};
  for (std::size_t i = 0; i < performances.size(); ++i) {
    FindingList& list = lists[i];
    list.number("fit.alpha", data.key, f.alpha, basis);
    list.number("fit.beta", data.key, f.beta, with_percentiles(basis, resampled.beta));
    list.number("fit.gamma", data.key, f.gamma, fixed);
    list.number("fit.lambda", data.key, f.lambda, model.lambda ? fixed : basis);
    list.truth("bound.beta", data.key, maximum.beta_at_bound,
               {.n = basis.n, .method = "whether the slope is at its bound"});
    list.number("loglik", data.key, maximum.log_likelihood,
                {.n = basis.n, .method = "of split counts, binomial coefficients included"});
    const double threshold = f.inverse(performances[i]);
    list.number("threshold", data.key, threshold, with_percentiles(basis, resampled.thresholds[i]));
    list.number("slope.at.threshold", data.key, f.slope(threshold),
                {.n = basis.n, .method = "dψ/dx"});
  }
}

}  // namespace asperity
