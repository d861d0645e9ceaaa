// Two groups of participants and their hits.

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/models/mixed_logit.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/effect_size.h"
#include "analysis/tests/t_test.h"
#include "analysis/tests/two_by_two.h"
#include "analysis/tests/two_samples.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/two_groups.h"

namespace asperity {
namespace {

struct Groups {
  std::vector<std::string> names{};
  std::vector<GroupedHits> participants{};
  std::vector<std::string> participant_names{};  ///< empty where the row has none
  TwoByTwo pooled{};
  std::vector<double> first{};  // proportion of each participant
  std::vector<double> second{};
  std::vector<std::size_t> blocks{};  // of each of `first`, then of `second`; empty without blocks
};

Groups read_groups(const TidyInput& input) {
  const LabelColumn group = two_groups(input);
  Groups groups{.names = group.names};
  const TidyTable& table = input.table();
  refuse_repeated(table, "subject", "one row per participant, with one group");
  const LabelColumn subjects = table.labels("subject");
  const std::vector<std::uint64_t> hits = table.counts("correct");
  const std::vector<std::uint64_t> trials = table.counts("trials");
  const std::vector<std::size_t> blocks = blocks_in(table);
  std::vector<std::size_t> of_second{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (trials[row] == 0 || hits[row] > trials[row]) {
      table.refuse(row, "correct",
                   "correct is " + std::to_string(hits[row]) + " and trials is " +
                       std::to_string(trials[row]) +
                       "; trials must be at least 1, and correct at most trials: correct the "
                       "counts, or leave out participants without trials");
    }
    const HitCount count{.hits = hits[row], .trials = trials[row]};
    const bool is_second = group.codes[row] == 1;
    groups.participants.push_back({.count = count, .second_group = is_second});
    const bool is_named = subjects.codes[row] != LabelColumn::kMissing;
    groups.participant_names.push_back(is_named ? subjects.names[subjects.codes[row]] : "");
    HitCount& pooled = is_second ? groups.pooled.second : groups.pooled.first;
    pooled.hits += count.hits;
    pooled.trials += count.trials;
    (is_second ? groups.second : groups.first).push_back(proportion(count));
    if (!blocks.empty()) (is_second ? of_second : groups.blocks).push_back(blocks[row]);
  }
  groups.blocks = joined(std::move(groups.blocks), of_second);
  return groups;
}

struct StatusText {
  const char* word = nullptr;
  const char* sentence = nullptr;
};

/// Nothing where another finding states the reason: `mixed.boundary`, `glm.status`.
StatusText status_text(NoMixedLogit reason) {
  switch (reason) {
    case NoMixedLogit::separated:
    case NoMixedLogit::no_spread:
      break;
    case NoMixedLogit::unbounded_spread:
      return {"no_maximum",
              "no participant has both correct and incorrect responses: the likelihood increases "
              "without bound with the SD of the random intercepts, so that there is no estimate "
              "and no p; compare the participants' proportions (welch.t, perm.p.two)"};
    case NoMixedLogit::flat:
      return {"flat",
              "the SD of the random intercepts cannot be estimated from these data, so that there "
              "is no p: present several trials to each participant, or compare the "
              "participants' proportions (welch.t, perm.p.two)"};
  }
  return {};
}

class GroupComparison final {
 public:
  GroupComparison(const Groups& groups, double confidence)
      : groups_(groups), confidence_(confidence) {}

  std::vector<Finding> findings() {
    pooled();
    participants();
    regression();
    return list_.take();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = groups_.participants.size(), .method = std::move(method)};
  }
  void number(const char* quantity, const FindingKey& key, double value, std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }
  void number(const char* quantity, double value, std::string method) {
    number(quantity, "", value, std::move(method));
  }
  /// An effect size and, where there is one, its interval.
  void effect(const std::string& quantity, double value,
              const std::optional<ConfidenceInterval>& interval, std::string method) {
    Basis shown = basis(std::move(method));
    if (interval) {
      shown.interval = interval;
      shown.confidence = confidence_;
    }
    list_.number(quantity, "", value, shown);
    if (!interval) return;
    list_.number(quantity + ".ci.lower", "", interval->low, basis("limit of " + quantity));
    list_.number(quantity + ".ci.upper", "", interval->high, basis("limit of " + quantity));
  }
  void coefficients(const char* quantity, const LogitCoefficients& values,
                    const std::string& method) {
    number(quantity, "intercept", values.intercept, method);
    number(quantity, groups_.names[1], values.second_group, method);
  }

  void pooled() {
    const TwoByTwo& table = groups_.pooled;
    const std::string independent = ", trials treated as independent";
    for (const auto& [name, count] :
         {std::pair{groups_.names[0], table.first}, std::pair{groups_.names[1], table.second}}) {
      list_.count("pooled.k", name, count.hits, basis("correct responses"));
      list_.count("pooled.n", name, count.trials, basis("trials"));
    }
    const FisherTest fisher = fisher_test(table, confidence_);
    number("fisher.p.two", fisher.p_two_sided, "Fisher's exact test" + independent);
    number("fisher.p.greater", fisher.p_greater, "Fisher's exact test, one-sided" + independent);
    number("fisher.p.less", fisher.p_less, "Fisher's exact test, one-sided" + independent);
    Basis ratio =
        basis("conditional maximum likelihood, exact limits" + independent +
              (fisher.margins_decide
                   ? "; not estimable, because all responses are correct or all are incorrect"
                   : ""));
    ratio.interval = fisher.interval;
    ratio.confidence = confidence_;
    list_.number("fisher.or.cond", "", fisher.odds_ratio, ratio);
    number("fisher.or.lower", fisher.interval.low, "exact limit of the odds ratio");
    number("fisher.or.upper", fisher.interval.high, "exact limit of the odds ratio");
    const HaldaneRatio haldane = haldane_ratio(table);
    const double factor = std::exp(normal_limit(confidence_) * haldane.log_standard_error);
    effect(
        "or.haldane", haldane.odds_ratio,
        ConfidenceInterval{.low = haldane.odds_ratio / factor, .high = haldane.odds_ratio * factor},
        "½ added to every cell; Wald interval of the log odds ratio" + independent);
    number("or.haldane.selog", haldane.log_standard_error, "standard error of the log odds ratio");
    const ShareDifference difference = newcombe_difference(table, confidence_);
    Basis newcombe = basis("first − second; Newcombe interval" + independent);
    newcombe.interval = difference.interval;
    newcombe.confidence = confidence_;
    list_.number("diff", "", difference.difference, newcombe);
    const ArcsineDifference arcsine = cohen_h(table.first, table.second, confidence_);
    effect("cohen.h", arcsine.h, arcsine.interval,
           "Cohen's h, difference of arcsines" + independent);
    number("diff.newcombe.lower", difference.interval.low, "Newcombe interval");
    number("diff.newcombe.upper", difference.interval.high, "Newcombe interval");
  }

  void participants() {
    const TwoSamples samples{.first = groups_.first, .second = groups_.second};
    const GroupScale shares{.confidence = confidence_,
                            .possible = kShares,
                            .coverage_of_difference = simulated_coverage({94, 100})};
    for (const bool second : {false, true}) {
      std::vector<HitCount> own{};
      for (const GroupedHits& one : groups_.participants) {
        if (one.second_group == second) own.push_back(one.count);
      }
      add_mean_share("subj.mean", groups_.names[second ? 1 : 0], own,
                     "mean of the proportions of the group's participants",
                     {.confidence = confidence_}, list_);
    }
    for (std::size_t i = 0; i < groups_.participants.size(); ++i) {
      const GroupedHits& one = groups_.participants[i];
      list_.number("subject.share",
                   {groups_.participant_names[i], groups_.names[one.second_group ? 1 : 0]},
                   proportion(one.count), {.n = 1, .method = "proportion of a participant"});
    }
    const std::optional<WelchT> welch = welch_t(samples, confidence_);
    add_difference_of_means("subj.diff", "", samples, shares, list_);
    if (welch) {
      number("welch.t", welch->t, "Welch's t over participants");
      number("welch.df", welch->df, "Welch's degrees of freedom");
      number("welch.p.two", welch->p, "two-sided Welch's t test over participants");
      const auto limits = standardised_difference_interval(*welch, samples, confidence_);
      effect("cohen.d", welch->d, limits,
             "difference divided by the pooled standard deviation; interval from the noncentral t "
             "distribution");
      effect("hedges.g", welch->g, bias_corrected(*welch, limits),
             "d corrected for bias, exact J; interval from the noncentral t distribution");
    } else {
      list_.word(
          "welch.t", "", "undefined_zero_variance",
          "a group has a single participant, or all participants of each group have the same "
          "proportion, so that t is undefined: add participants, or use perm.p.two",
          basis("Welch's t over participants"));
    }
    const SplitTest splits = permutation_test(samples, groups_.blocks);
    number("perm.p.two", splits.p,
           "permutation test of the group labels, difference of means, " +
               way_of_splits(splits, groups_.blocks));
    add_splits("perm", "", splits, groups_.participants.size(), list_);
    const MannWhitney ranks = mann_whitney(samples);
    number("mannwhitney.U", groups_.names[0], ranks.U,
           "Mann–Whitney U: pairs in which the participant of this group has the higher "
           "proportion, ties counted as half");
    if (ranks.p_exact) {
      number("mannwhitney.exact.p.two", *ranks.p_exact,
             "exact Mann–Whitney U test with midranks, two-sided");
    } else {
      number("mannwhitney.p.two", ranks.p_normal.value_or(kUndefined),
             "Mann–Whitney U test, normal approximation with midranks, two-sided: too many "
             "participants for the exact test");
    }
  }

  void regression() {
    const std::optional<FixedLogit> fixed = fixed_logit(groups_.participants);
    if (!fixed) {
      list_.word(
          "glm.status", "", "separated",
          "a group has only correct or only incorrect responses, so that its odds have no finite "
          "estimate: use or.haldane",
          basis("logistic regression"));
      return;
    }
    coefficients("glm.beta", fixed->beta, "logistic regression, trials treated as independent");
    coefficients("glm.se", fixed->standard_error, "trials treated as independent");
    const auto clustered = [this](const FindingKey& key, double error) {
      Basis own = basis("participants as clusters (CR0)");
      own.undefined =
          "a group has one participant, and a standard error over participants needs two in each "
          "group: add participants";
      list_.number("glm.se.cluster", key, error, own);
    };
    clustered("intercept", fixed->cluster_standard_error.intercept);
    clustered(groups_.names[1], fixed->cluster_standard_error.second_group);
    random_intercepts(mixed_logit(groups_.participants));
  }

  void random_intercepts(const std::variant<MixedLogit, NoMixedLogit>& result) {
    const std::string method =
        "logistic regression with a random intercept per participant, maximum likelihood";
    const auto* none = std::get_if<NoMixedLogit>(&result);
    list_.truth("mixed.boundary", "", none != nullptr && *none == NoMixedLogit::no_spread,
                basis("whether the SD of the random intercepts is estimated as 0"));
    if (none != nullptr) {
      const StatusText text = status_text(*none);
      if (text.sentence != nullptr) {
        list_.word("mixed.status", "", text.word, text.sentence, basis(method));
      }
      return;
    }
    const MixedLogit& mixed = std::get<MixedLogit>(result);
    coefficients("mixed.beta", mixed.beta, method);
    coefficients("mixed.se", mixed.standard_error, "observed information");
    number("mixed.sigma", mixed.sigma, "SD of the random intercepts");
    number("mixed.loglik", mixed.log_likelihood, "binomial coefficients included");
    number("mixed.lr.group", mixed.likelihood_ratio,
           "likelihood-ratio statistic against equal groups");
    number(
        "mixed.lr.group.p", mixed.p.value_or(kUndefined),
        "χ² test with one degree of freedom, liberal with few participants: in simulations of "
        "equal "
        "groups the Type I error rate at α = .05 was up to 9 % with 3 participants in each group, "
        "and up to 7 % with 6");
    const auto df = static_cast<double>(groups_.first.size() + groups_.second.size()) - 2.0;
    number("mixed.lr.group.F.p",
           upper_tail(FStatistic{.value = mixed.likelihood_ratio, .df1 = 1.0, .df2 = df})
               .value_or(kUndefined),
           "likelihood-ratio statistic, tested as F with 1 and N − 2 degrees of freedom, N "
           "participants");
  }

  const Groups& groups_;
  double confidence_ = 0.95;
  FindingList list_{};
};

}  // namespace

std::vector<Finding> group_findings(const TidyInput& input) {
  const Groups groups = read_groups(input);
  for (std::size_t i = 0; i < 2; ++i) {
    if ((i == 0 ? groups.first : groups.second).empty()) {
      FindingList list{};
      list.word(
          "status", groups.names[i], "no_data",
          "this group has no participants, so that no comparison is possible: add participants");
      return list.take();
    }
  }
  return GroupComparison(groups, input.options.confidence()).findings();
}

}  // namespace asperity
