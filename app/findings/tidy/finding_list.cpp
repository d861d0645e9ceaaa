// Stores numbers that are not finite as words with a reason; means of groups have t intervals.

#include "app/findings/tidy/finding_list.h"

#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/numbers/seed_of_tests.h"
#include "analysis/numbers/summary.h"
#include "analysis/tests/geometric_mean.h"
#include "app/findings/tidy/simulated_coverage.h"

namespace asperity {

Finding& FindingList::add(std::string quantity, FindingKey key, Basis&& basis) {
  Finding& finding = findings_.emplace_back();
  finding.quantity = std::move(quantity);
  finding.key = std::move(key);
  finding.n = basis.n;
  finding.method = std::move(basis.method);
  finding.unit = std::move(basis.unit);
  if (basis.interval) {
    finding.low = basis.interval->low;
    finding.high = basis.interval->high;
    finding.confidence = basis.confidence;
  }
  return finding;
}

void FindingList::number(std::string quantity, FindingKey key, double value, Basis basis) {
  std::string why = basis.undefined.empty() ? kNotDefined : std::move(basis.undefined);
  Finding& finding = add(std::move(quantity), std::move(key), std::move(basis));
  if (std::isnan(value)) {
    finding.word = "NA";
    finding.status = std::move(why);
  } else if (std::isinf(value)) {
    finding.word = value > 0.0 ? "Inf" : "-Inf";
    finding.status = "this number is infinite for these data";
  } else {
    finding.value = value == 0.0 ? 0.0 : value;  // no negative zero
  }
}

void FindingList::count(std::string quantity, FindingKey key, std::uint64_t value, Basis basis) {
  number(std::move(quantity), std::move(key), static_cast<double>(value), std::move(basis));
}

void FindingList::truth(std::string quantity, FindingKey key, bool value, Basis basis) {
  word(std::move(quantity), std::move(key), value ? "TRUE" : "FALSE", "ok", std::move(basis));
}

void FindingList::word(std::string quantity, FindingKey key, std::string word, std::string status,
                       Basis basis) {
  Finding& finding = add(std::move(quantity), std::move(key), std::move(basis));
  finding.word = std::move(word);
  finding.status = std::move(status);
}

void drop_intervals(
    std::vector<Finding>& findings,
    const std::function<std::optional<std::string>(const Finding&)>& reason_against) {
  std::set<std::pair<std::string, FindingKey>> limits{};  // quantities and keys
  for (Finding& finding : findings) {
    const std::optional<std::string> reason = reason_against(finding);
    if (!reason) continue;
    finding.low.reset();
    finding.high.reset();
    finding.confidence.reset();
    finding.method += "; " + *reason;
    constexpr std::string_view kCorrected = ".loglinear";  // after the name of a limit
    const bool is_corrected = finding.quantity.ends_with(kCorrected);
    const std::size_t end = finding.quantity.size() - (is_corrected ? kCorrected.size() : 0);
    for (const char* const limit : {".lower", ".upper"}) {
      std::string quantity = finding.quantity;
      limits.emplace(quantity.insert(end, limit), finding.key);
    }
  }
  std::erase_if(findings, [&limits](const Finding& finding) {
    return limits.contains({finding.quantity, finding.key});
  });
}

void add_spread(const FindingKey& key, std::span<const double> shares, FindingList& findings) {
  const std::optional<Summary> summary = summary_of(shares);
  if (!summary) return;
  const Basis basis{.n = summary->n, .method = "of the participants' proportions"};
  findings.number("subj.minimum", key, summary->minimum, basis);
  findings.number("subj.median", key, summary->p50, basis);
  findings.number("subj.maximum", key, summary->maximum, basis);
}

std::string way_of_counting(std::size_t drawn) {
  if (drawn == 0) return "exact";
  return "random (" + std::to_string(drawn) + " draws, seed " + std::to_string(kSeedOfTests) + ")";
}

void add_mean_share(const std::string& quantity, const FindingKey& key,
                    std::span<const HitCount> participants, const std::string& method,
                    const MeanShareQuestion& question, FindingList& findings) {
  Basis basis{.n = participants.size(),
              .method = method + "; t interval on the logit scale",
              .undefined = "there are no participants: add participants"};
  double mean = kUndefined;
  if (!participants.empty()) {
    std::vector<double> shares{};
    for (const HitCount& own : participants) shares.push_back(proportion(own));
    mean = one_sample_t(shares).mean;
    basis.interval = mean_share_interval(participants, question);
    if (basis.interval) {
      basis.confidence = question.confidence;
      basis.method += simulated_coverage({90, 100}) + " with mean proportions of at most 98 %";
    }
  }
  findings.number(quantity, key, mean, basis);
}

bool add_geometric_mean(const std::string& quantity, const FindingKey& key,
                        std::span<const double> of_participants, const GeometricScale& scale,
                        FindingList& findings) {
  const GeometricMean mean = geometric_mean(of_participants, scale.confidence);
  Basis basis{.n = mean.n,
              .method = scale.method + "; t interval on the log scale" +
                        (mean.interval ? scale.coverage : std::string()),
              .unit = scale.unit,
              .interval = mean.interval};
  if (mean.interval) basis.confidence = scale.confidence;
  findings.number(quantity, key, mean.mean, basis);
  if (!mean.interval) return false;
  const Basis limit{.n = mean.n, .method = "limit of the interval", .unit = scale.unit};
  findings.number(quantity + ".lower", key, mean.interval->low, limit);
  findings.number(quantity + ".upper", key, mean.interval->high, limit);
  return true;
}

void add_no_interval(const std::string& quantity, const FindingKey& key, std::size_t n,
                     FindingList& findings) {
  const bool is_alone = n < 2;
  findings.word(
      quantity + ".status", key, is_alone ? "too_few_participants" : "undefined_zero_variance",
      is_alone ? "an interval over participants needs at least 2 participants: add participants"
               : "all participants have the same value, so there is no interval: add participants",
      {.n = n, .method = "interval of a mean over participants"});
}

void add_cohen_h(std::string quantity, FindingKey key, const HitCount& count, const ChanceOfHit& of,
                 FindingList& findings) {
  const ConfidenceInterval limits = wilson_interval(count, of.confidence);
  const auto h = [&of](double share) {
    return 2.0 * std::asin(std::sqrt(share)) - 2.0 * std::asin(std::sqrt(of.chance));
  };
  findings.number(std::move(quantity), std::move(key), cohen_h(count, of.chance),
                  {.n = count.trials,
                   .method = "Cohen's h against the chance level; interval from the Wilson limits",
                   .interval = ConfidenceInterval{.low = h(limits.low), .high = h(limits.high)},
                   .confidence = of.confidence});
}

void add_splits(const std::string& name, const FindingKey& key, const SplitTest& test,
                std::size_t n, FindingList& findings) {
  findings.count(
      name + ".draws", key, test.exact ? 0 : kRandomSplits,
      {.n = n,
       .method = "permutations of the group labels drawn at random; 0 if all were enumerated"});
}

void add_mean_of_group(const std::string& quantity, const FindingKey& key,
                       std::span<const double> of_participants, const GroupScale& scale,
                       FindingList& findings) {
  const OneSampleT t = one_sample_t(of_participants, {.confidence = scale.confidence});
  Basis basis{.n = t.n, .method = scale.of + "; t interval"};
  if (scale.possible) basis.method += ", truncated to possible values";
  if (t.test) {
    basis.interval = scale.possible ? within(*scale.possible, t.test->interval) : t.test->interval;
    basis.confidence = scale.confidence;
  }
  findings.number(quantity, key, t.mean, basis);
}

void add_difference_of_means(const std::string& quantity, const FindingKey& key,
                             const TwoSamples& samples, const GroupScale& scale,
                             FindingList& findings) {
  Basis basis{.n = samples.first.size() + samples.second.size(),
              .method = "difference of the participants' means, first − second; Welch's interval"};
  if (scale.possible) basis.method += ", truncated to possible differences";
  const std::optional<WelchT> welch = welch_t(samples, scale.confidence);
  if (welch) {
    basis.interval = welch->interval;
    basis.method += scale.coverage_of_difference;
    if (scale.possible) {
      const double most = scale.possible->high - scale.possible->low;
      basis.interval = within({.low = -most, .high = most}, welch->interval);
    }
    basis.confidence = scale.confidence;
  }
  findings.number(quantity, key,
                  one_sample_t(samples.first).mean - one_sample_t(samples.second).mean, basis);
}

}  // namespace asperity
