// The chance that a planned test finds what is there: exact and by noncentral distributions.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity {

/// Every function throws std::invalid_argument for numbers that are no plan: no trials, a
/// probability outside [0, 1], an error outside (0, 1).

/// How a test behaves whose statistic is a count: from which count on it rejects (absent where it
/// rejects none), how often it does so by chance, and how often for what is truly there.
struct ExactPower {
  std::optional<std::size_t> critical{};  ///< for the one-sided tests
  double actual_error = 0.0;
  double power = 0.0;
};

/// Exact binomial tests of n trials against `chance` while hits have the probability `truth`.
struct BinomialPlan {
  std::size_t trials = 1;
  double chance = 0.5;
  double truth = 0.5;
  double error = 0.05;
};
ExactPower binomial_power(const BinomialPlan& plan);            ///< more hits than by chance
ExactPower binomial_two_sided_power(const BinomialPlan& plan);  ///< as `binomial_test`

/// Pearson's X² of n choices against equal probabilities, with the χ² of K − 1 degrees of freedom
/// as its null: enumerated over all counts (refused where there are more than 2·10⁷), and by the noncentral χ² with n·K·Σ(p − 1/K)².
struct UniformPlan {
  std::size_t choices = 1;
  std::vector<double> truth{};  ///< probability of each alternative; their sum is 1
  double error = 0.05;
};
struct UniformPower {
  double actual_error = 0.0;
  double power = 0.0;
  double noncentral_power = 0.0;
};
UniformPower uniform_power(const UniformPlan& plan);

/// The exact test of `MatchingNull` for n assignments of m items, against the permutations π with
/// P(π) ∝ e^{θ·fixed points} (Mallows' model), or against somebody who knows `known` items and
/// permutes the rest at random.
struct MatchingPlan {
  std::size_t assignments = 1;
  std::size_t items = 4;
  double error = 0.05;
};
struct MatchingPower {
  ExactPower exact{};
  double mean_right = 0.0;  ///< items of one assignment, under the alternative
};
MatchingPower mallows_power(const MatchingPlan& plan, double theta);
MatchingPower known_items_power(const MatchingPlan& plan, std::size_t known);

/// Two-sided t test of n differences whose mean is d standard deviations.
struct PairedPlan {
  std::size_t pairs = 2;
  double d = 0.0;
  double error = 0.05;
};
double paired_t_power(const PairedPlan& plan);

/// One factor of K levels within n participants, F with (K−1)·ε and (K−1)(n−1)·ε degrees of freedom
/// and the noncentrality λ = f²·n·K·ε/(1 − ρ): f Cohen's effect size, ρ the correlation of the
/// levels, ε their sphericity.
struct WithinPlan {
  std::size_t participants = 2;
  std::size_t levels = 2;
  double f = 0.0;
  double correlation = 0.0;
  double epsilon = 1.0;
  double error = 0.05;
};
struct WithinPower {
  double noncentrality = 0.0;
  double power = 0.0;
};
WithinPower within_power(const WithinPlan& plan);

/// Fisher's two-sided exact test of two groups. The error is that with both groups at the first
/// probability. Tables that are less probable than 10⁻⁶⁰ of the most probable one are left out.
struct TwoGroupPlan {
  std::size_t first_trials = 1;
  std::size_t second_trials = 1;
  double first_truth = 0.5;
  double second_truth = 0.5;
  double error = 0.05;
};
ExactPower fisher_power(const TwoGroupPlan& plan);

/// How often the pooled one-sided binomial test rejects when each participant has a probability of
/// their own, beta-distributed around `truth`, so that two trials of one participant correlate by
/// `correlation`: with truth = chance its true error. Refused where counting takes more than some seconds.
struct PooledPlan {
  std::size_t participants = 1;
  std::size_t trials_each = 1;
  double chance = 0.5;
  double truth = 0.5;
  double correlation = 0.1;  ///< in (0, 1)
  double error = 0.05;
};
struct PooledRejection {
  double rate = 0.0;
  double design_effect = 1.0;  ///< 1 + (m − 1)·ρ
};
PooledRejection pooled_rejection(const PooledPlan& plan);

}  // namespace asperity
