// The ROC of confidence ratings: areas, and the normal model with equal and with free variances.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/choices/rating_roc.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// The ratings of one condition, ascending.
struct RatedCondition {
  std::string name{};
  std::vector<double> ratings{};
  std::vector<RatingCount> counts{};
  std::vector<std::vector<RatingCount>> of_participants{};  ///< empty without a column `subject`
};

bool has_both_kinds(const std::vector<RatingCount>& counts) {
  RatingCount all{};
  for (const RatingCount& count : counts) {
    all.noise += count.noise;
    all.signal += count.signal;
  }
  return all.noise > 0 && all.signal > 0;
}

std::vector<RatedCondition> rated_conditions(const TidyTable& table) {
  const LabelColumn names = table.all_labels("condition");
  const std::vector<double> ratings = table.all_numbers("rating");
  const std::vector<std::uint64_t> noise = table.counts("noise");
  const std::vector<std::uint64_t> signal = table.counts("signal");
  const bool has_participants = table.has("subject");
  const LabelColumn participants = has_participants ? table.all_labels("subject") : LabelColumn{};
  std::vector<RatedCondition> conditions{};
  for (std::size_t c = 0; c < names.names.size(); ++c) {
    RatedCondition condition{.name = names.names[c]};
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (names.codes[row] == c) condition.ratings.push_back(ratings[row]);
    }
    std::sort(condition.ratings.begin(), condition.ratings.end());
    condition.ratings.erase(std::unique(condition.ratings.begin(), condition.ratings.end()),
                            condition.ratings.end());
    const std::size_t size = condition.ratings.size();
    condition.counts.resize(size);
    std::vector<std::vector<RatingCount>> all(participants.names.size(),
                                              std::vector<RatingCount>(size));
    std::vector<std::vector<bool>> seen(std::max<std::size_t>(1, all.size()),
                                        std::vector<bool>(size));
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (names.codes[row] != c) continue;
      const auto place = static_cast<std::size_t>(
          std::lower_bound(condition.ratings.begin(), condition.ratings.end(), ratings[row]) -
          condition.ratings.begin());
      const std::size_t participant = has_participants ? participants.codes[row] : 0;
      if (seen[participant][place]) {
        table.refuse(
            row, "rating",
            "the rating " + number_text(ratings[row]) + " occurs a second time in the condition " +
                condition.name + "; there must be one row per condition" +
                (has_participants ? ", participant" : "") + " and rating. Remove one of the rows");
      }
      seen[participant][place] = true;
      const RatingCount count{.noise = noise[row], .signal = signal[row]};
      condition.counts[place].noise += count.noise;
      condition.counts[place].signal += count.signal;
      if (has_participants) all[participant][place] = count;
    }
    for (std::vector<RatingCount>& own : all) {
      const bool took_part = std::any_of(own.begin(), own.end(), [](const RatingCount& count) {
        return count.noise + count.signal > 0;
      });
      if (took_part) condition.of_participants.push_back(std::move(own));
    }
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

class RocList final {
 public:
  RocList(const RatedCondition& condition, double confidence, FindingList& list)
      : condition_(condition), confidence_(confidence), list_(list) {
    for (const RatingCount& count : condition.counts) {
      totals_.noise += count.noise;
      totals_.signal += count.signal;
    }
  }

  void add() {
    list_.count("n.noise", condition_.name, totals_.noise, basis("trials without a signal"));
    list_.count("n.signal", condition_.name, totals_.signal, basis("trials with a signal"));
    if (!has_both_kinds(condition_.counts)) {
      list_.word("auc", condition_.name, "no_data",
                 "an ROC needs trials with and trials without a signal: add the missing kind",
                 basis("area under the ROC"));
      return;
    }
    add_points();
    add_area();
    const std::optional<NormalRoc> equal = fit_roc(condition_.counts, RocVariance::equal);
    const std::optional<NormalRoc> free = fit_roc(condition_.counts, RocVariance::free);
    add_model("ev", equal);
    add_model("uv", free);
    if (free) add_unequal(*free);
    if (equal && free) add_test(*equal, *free);
  }

 private:
  Basis basis(std::string method) const {
    return {.n = static_cast<std::size_t>(totals_.noise + totals_.signal),
            .method = std::move(method)};
  }
  FindingKey key_of(std::size_t rating) const {
    return {condition_.name, number_text(condition_.ratings[rating])};
  }

  void add_points() {
    const std::vector<RocPoint> points = roc_points(condition_.counts);
    for (std::size_t i = 0; i < points.size(); ++i) {
      list_.number("roc.fa", key_of(i + 1), points[i].false_alarm,
                   basis("proportion of noise trials with this rating or a higher one"));
      list_.number("roc.hit", key_of(i + 1), points[i].hit,
                   basis("proportion of signal trials with this rating or a higher one"));
    }
  }

  /// The trials of several participants, whose criteria may differ.
  bool is_pooled() const { return condition_.of_participants.size() > 1; }

  /// Of 0 or 1: DeLong's standard error is then 0.
  static bool is_at_end(const RocArea& area) {
    constexpr double kRounding = 1e-9;  // of the sum of the trapezoids
    return area.area <= kRounding || area.area >= 1.0 - kRounding;
  }

  /// DeLong's standard error lacks one of its two parts where all trials of a kind have the same rating.
  bool has_interval(const RocArea& area) const {
    const auto categories = [this](std::uint64_t RatingCount::*of) {
      return std::count_if(condition_.counts.begin(), condition_.counts.end(),
                           [of](const RatingCount& count) { return count.*of > 0; });
    };
    return area.standard_error && !is_at_end(area) && categories(&RatingCount::noise) > 1 &&
           categories(&RatingCount::signal) > 1;
  }

  void add_area() {
    const RocArea area = roc_area(condition_.counts);
    Basis trapezoids = basis("area under the ROC by trapezoids, equal to Mann and Whitney's U/nm");
    if (is_pooled()) {
      trapezoids.method +=
          "; over participants together, without the interval of DeLong, which takes the trials as "
          "independent" +
          simulated_coverage({93, 97}, {14, 80});
    } else if (has_interval(area)) {
      const double reach = normal_limit(confidence_) * *area.standard_error;
      trapezoids.method += "; normal interval with DeLong's standard error, truncated to 0 to 1" +
                           simulated_coverage({88, 95}) + " for one participant";
      trapezoids.interval = ConfidenceInterval{.low = std::max(0.0, area.area - reach),
                                               .high = std::min(1.0, area.area + reach)};
      trapezoids.confidence = confidence_;
    } else {
      trapezoids.method +=
          is_at_end(area)
              ? "; without an interval: DeLong's standard error is 0, and the coverage of the "
                "interval of the area alone is 0 %"
              : "; without an interval: DeLong's standard error lacks the part of trials that "
                "all have the same rating";
    }
    list_.number("auc", condition_.name, area.area, trapezoids);
    list_.number("auc.se.delong", condition_.name, area.standard_error.value_or(kUndefined),
                 basis("standard error of DeLong, DeLong and Clarke-Pearson"));
    if (trapezoids.interval) {
      list_.number("auc.lower", condition_.name, trapezoids.interval->low,
                   basis("normal interval, DeLong, at least 0"));
      list_.number("auc.upper", condition_.name, trapezoids.interval->high,
                   basis("normal interval, DeLong, at most 1"));
    }
    list_.number("auc.se.hanley", condition_.name, area.hanley_error,
                 basis("standard error of Hanley and McNeil"));
    add_mean_area("auc.mean", "mean of the participants' areas by trapezoids", CoverageSpan{91, 97},
                  [](const std::vector<RatingCount>& own) -> std::optional<double> {
                    return roc_area(own).area;
                  });
  }

  void add_model(const std::string& model, const std::optional<NormalRoc>& fit) {
    const std::string method = std::string(model == "ev" ? "equal" : "unequal") +
                               "-variance normal model, maximum likelihood";
    if (!fit) {
      list_.word(model + ".mu", condition_.name, "not_estimable",
                 "the likelihood has no finite maximum: signal and noise trials share too few "
                 "ratings; add trials or use fewer ratings",
                 basis(method));
      return;
    }
    const double reach = normal_limit(confidence_) * fit->mean_error;
    Basis mean = basis(method + ": mean of the signal in standard deviations of the noise");
    if (is_pooled()) {
      mean.method +=
          "; over participants together, without an interval, which would take all trials as "
          "independent";
    } else {
      mean.interval = ConfidenceInterval{.low = fit->mean - reach, .high = fit->mean + reach};
      mean.confidence = confidence_;
    }
    list_.number(model + ".mu", condition_.name, fit->mean, mean);
    list_.number(model + ".mu.se", condition_.name, fit->mean_error, basis("observed information"));
    for (std::size_t i = 0; i < fit->criteria.size(); ++i) {
      list_.number(model + ".criterion", key_of(i + 1), fit->criteria[i],
                   basis(method + ": criterion of this rating"));
    }
    list_.number(model + ".loglik", condition_.name, fit->log_likelihood,
                 basis("log likelihood without multinomial coefficients"));
  }

  void add_unequal(const NormalRoc& fit) {
    list_.number("uv.sigma", condition_.name, fit.deviation,
                 basis("standard deviation of the signal in those of the noise"));
    list_.number("uv.sigma.se", condition_.name, fit.deviation_error,
                 basis("observed information"));
    list_.number("uv.da", condition_.name, fit.d_a(), basis("d_a = μ/√(½·(1 + σ²))"));
    Basis area = basis("A_z = Φ(d_a/√2), area under the fitted ROC");
    if (is_pooled()) {
      area.method += "; over participants together, without an interval by a bootstrap over them" +
                     simulated_coverage({93, 96}, {12, 87});
    }
    list_.number("uv.az", condition_.name, fit.area(), area);
    add_mean_area("uv.az.mean", "mean of the participants' A_z", CoverageSpan{92, 97},
                  [](const std::vector<RatingCount>& own) -> std::optional<double> {
                    const std::optional<NormalRoc> fitted = fit_roc(own, RocVariance::free);
                    if (!fitted) return std::nullopt;
                    return fitted->area();
                  });
    const double ratings = static_cast<double>(condition_.ratings.size());
    list_.number("uv.deviance", condition_.name,
                 2.0 * (saturated_roc(condition_.counts) - fit.log_likelihood),
                 basis("against one proportion per rating"));
    list_.number("uv.df", condition_.name, 2.0 * (ratings - 1.0) - (ratings + 1.0),
                 basis("degrees of freedom of the deviance"));
  }

  /// The mean over the participants of an area of their own. Without an interval where a participant has none, because those who
  /// have one are then a selection.
  template <typename Area>
  void add_mean_area(const char* quantity, const char* method, const CoverageSpan& coverage,
                     const Area& area_of) {
    std::vector<double> areas{};
    for (const std::vector<RatingCount>& counts : condition_.of_participants) {
      if (!has_both_kinds(counts)) continue;
      if (const std::optional<double> area = area_of(counts)) areas.push_back(*area);
    }
    if (areas.empty()) return;
    FindingList mean{};
    add_mean_of_group(quantity, condition_.name, areas,
                      {.confidence = confidence_,
                       .possible = ConfidenceInterval{.low = 0.0, .high = 1.0},
                       .of = method},
                      mean);
    std::vector<Finding> findings = mean.take();
    const std::size_t missing = condition_.of_participants.size() - areas.size();
    drop_intervals(findings, [missing](const Finding&) -> std::optional<std::string> {
      if (missing == 0) return std::nullopt;
      return "without an interval, because " + std::to_string(missing) +
             " participants have no estimate";
    });
    for (Finding& finding : findings) {
      if (finding.low && finding.high) finding.method += simulated_coverage(coverage);
      list_.copy(finding);
    }
  }

  void add_test(const NormalRoc& equal, const NormalRoc& free) {
    const double ratio = 2.0 * (free.log_likelihood - equal.log_likelihood);
    list_.number("lr.equal.variance", condition_.name, ratio,
                 basis("likelihood-ratio statistic of equal variances"));
    list_.number("lr.equal.variance.p", condition_.name,
                 upper_tail(ChiSquaredStatistic{.value = std::max(0.0, ratio), .df = 1.0})
                     .value_or(kUndefined),
                 basis("likelihood-ratio test of equal variances, χ² with one degree of freedom"));
  }

  const RatedCondition& condition_;
  double confidence_ = 0.95;
  FindingList& list_;
  RatingCount totals_{};
};

}  // namespace

std::vector<Finding> roc_findings(const TidyInput& input) {
  const double confidence = input.options.confidence();
  FindingList findings{};
  for (const RatedCondition& condition : rated_conditions(input.table())) {
    RocList(condition, confidence, findings).add();
  }
  return findings.take();
}

}  // namespace asperity
