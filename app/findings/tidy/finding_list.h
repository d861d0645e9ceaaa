// Collects findings in order.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/numbers/proportion.h"
#include "analysis/tests/pooled_share.h"
#include "analysis/tests/t_test.h"
#include "analysis/tests/two_samples.h"

namespace asperity {

/// A number that is not defined for these data.
inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// The status of a missing number, where no further reason is known.
inline constexpr const char* kNotDefined =
    "this number is not defined for these data, usually because they are too few or do not vary: "
    "add participants or trials";

/// The basis of a number.
struct Basis {
  std::size_t n = 0;                             ///< independent units
  std::string method{};                          ///< what was computed, and the chance level
  std::string unit = "1";                        ///< SI symbol
  std::optional<ConfidenceInterval> interval{};  ///< of the number
  std::optional<double> confidence{};            ///< of that interval
  std::string undefined{};  ///< the status if the number is not defined; empty: the default one
};

/// Collects findings, with a word in place of a value that is not a number.
class FindingList final {
 public:
  /// A number; `NA` with the status "not defined" where it is NaN, `Inf` and `-Inf`.
  void number(std::string quantity, FindingKey key, double value, Basis basis = {});
  void count(std::string quantity, FindingKey key, std::uint64_t value, Basis basis = {});
  void truth(std::string quantity, FindingKey key, bool value, Basis basis = {});
  /// A word instead of a number. `status`: the sentence that states why, and what to do; "ok" where
  /// the word is the result.
  void word(std::string quantity, FindingKey key, std::string word, std::string status,
            Basis basis = {});

  /// A finding of another list.
  void copy(const Finding& finding) { findings_.push_back(finding); }

  std::vector<Finding> take() { return std::move(findings_); }

 private:
  Finding& add(std::string quantity, FindingKey key, Basis&& basis);
  std::vector<Finding> findings_{};
};

/// Withdraws the interval of every finding for which `reason_against` returns a reason: removes its limits and its confidence,
/// appends "; " and the reason to its method, and erases the findings with the same key that state the limits, QUANTITY.lower and
/// QUANTITY.upper (of a d′ with the log-linear correction: dprime.lower.loglinear for dprime.loglinear).
void drop_intervals(
    std::vector<Finding>& findings,
    const std::function<std::optional<std::string>(const Finding&)>& reason_against);

/// The spread of the participants' proportions: `subj.minimum`, `subj.median`, `subj.maximum`. Adds
/// nothing without participants.
void add_spread(const FindingKey& key, std::span<const double> shares, FindingList& findings);

/// "exact", or "random (9999 draws, seed 1)", for a method; `drawn` of 0 is exact.
std::string way_of_counting(std::size_t drawn);

/// The mean of participants' proportions, usually `subj.mean`, with its interval
/// (`mean_share_interval`) where there are two participants. `method`: the quantity that is
/// averaged. All displays of the interval of a mean proportion take it from here.
void add_mean_share(const std::string& quantity, const FindingKey& key,
                    std::span<const HitCount> participants, const std::string& method,
                    const MeanShareQuestion& question, FindingList& findings);

/// The geometric mean of single participants' numbers, at least one, with its interval,
/// `QUANTITY.lower` and `QUANTITY.upper`. Returns whether there is an interval.
struct GeometricScale {
  double confidence = 0.95;
  std::string unit = "1";
  std::string method{};    ///< the quantity that is averaged
  std::string coverage{};  ///< of the interval, as `simulated_coverage`
};
bool add_geometric_mean(const std::string& quantity, const FindingKey& key,
                        std::span<const double> of_participants, const GeometricScale& scale,
                        FindingList& findings);
/// `QUANTITY.status`: why a mean over this many participants has no interval (too_few_participants,
/// undefined_zero_variance).
void add_no_interval(const std::string& quantity, const FindingKey& key, std::size_t n,
                     FindingList& findings);

/// Cohen's h of a proportion against chance, with Wilson's limits on the same scale, on which their
/// coverage is unchanged.
struct ChanceOfHit {
  double chance = 0.5;
  double confidence = 0.95;
};
void add_cohen_h(std::string quantity, FindingKey key, const HitCount& count, const ChanceOfHit& of,
                 FindingList& findings);

/// The numbers of single participants, with their bounds where there are any.
struct GroupScale {
  double confidence = 0.95;
  std::optional<ConfidenceInterval> possible{};
  std::string of = "mean of the group's participants";  ///< description of a mean, for its method
  std::string
      coverage_of_difference{};  ///< of the interval of a difference, as `simulated_coverage`
};
/// The mean of a group's participants with Student's interval, where there is one.
void add_mean_of_group(const std::string& quantity, const FindingKey& key,
                       std::span<const double> of_participants, const GroupScale& scale,
                       FindingList& findings);
/// The means of two groups, first minus second, with Welch's interval, where there is one.
void add_difference_of_means(const std::string& quantity, const FindingKey& key,
                             const TwoSamples& samples, const GroupScale& scale,
                             FindingList& findings);

/// The report of the permutation test of two groups: the number of random permutations
/// (`NAME.draws`; 0 where all were enumerated).
void add_splits(const std::string& name, const FindingKey& key, const SplitTest& test,
                std::size_t n, FindingList& findings);

}  // namespace asperity
