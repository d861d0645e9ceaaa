// Fits split counts by maximum likelihood; bootstrap intervals only for functions whose data need them.

#include "app/findings/methods/discrimination/thresholds/unforced_functions.h"

#include <algorithm>

#include "analysis/psychometric/psychometric_fit.h"
#include "analysis/psychometric/psychometric_maximum.h"
#include "app/findings/tidy/unforced_estimates.h"

namespace asperity {

namespace {

constexpr double kConfidenceOfResamples = 0.95;

}  // namespace

bool has_unsure(const DiscriminationData& data) {
  return std::any_of(data.hits.begin(), data.hits.end(),
                     [](const auto& each) { return each.second.unsure > 0; });
}

bool add_fit_status(const std::vector<PsychometricBlock>& blocks, const PsychometricModel& model,
                    const FindingKey& key, const Basis& basis, FindingList& list) {
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
    case PsychometricStatus::too_few_levels:
      return none("too_few_levels",
                  "the function has more parameters than there are levels with trials, so that "
                  "many functions fit equally well: present more levels");
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
  add_unforced_estimates({.key = data.key,
                          .blocks = unforced_blocks(task, data.hits),
                          .alternatives = task.design->alternatives()},
                         maximum,
                         {.model = model,
                          .performances = {performances.begin(), performances.end()},
                          .confidence = kConfidenceOfResamples},
                         data.needs_intervals ? kUnforcedResamples : 0, lists);
}

}  // namespace asperity
