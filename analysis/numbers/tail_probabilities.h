// Tails and limits of the distributions by which tests are judged, and what these are made of.

#pragma once

#include <optional>

namespace asperity {

/// A statistic with its degrees of freedom, which need not be whole numbers (a correction for
/// sphericity makes fractions of them).
struct ChiSquaredStatistic {
  double value = 0.0;
  double df = 1.0;
};
struct FStatistic {
  double value = 0.0;
  double df1 = 1.0;
  double df2 = 1.0;
};
struct TStatistic {
  double value = 0.0;
  double df = 1.0;
};

/// P(X ≥ value), computed as itself and not as 1 − P(X < value), so that small tails keep their
/// digits. A statistic that grew beyond all bounds (an effect without any error) has the tail that
/// its limit has. Nothing where there is no answer: for a statistic that is no number and for
/// degrees of freedom that are not positive: with none of them nothing is tested.
std::optional<double> upper_tail(const ChiSquaredStatistic& statistic);
std::optional<double> upper_tail(const FStatistic& statistic);
std::optional<double> upper_tail(const TStatistic& statistic);

/// P(|X| ≥ |value|).
std::optional<double> two_sided_tail(const TStatistic& statistic);

/// What |X| exceeds with probability 1 − confidence, 0 < confidence < 1: the half width of an
/// interval in standard errors. Nothing for degrees of freedom that are not positive.
double normal_limit(double confidence);
struct TLimit {
  double confidence = 0.95;
  double df = 1.0;
};
std::optional<double> t_limit(const TLimit& limit);

/// What X exceeds with the probability `tail`, 0 < tail < 1; the degrees of freedom are positive.
struct ChiSquaredTail {
  double tail = 0.05;
  double df = 1.0;
};
struct FTail {
  double tail = 0.05;
  double df1 = 1.0;
  double df2 = 1.0;
};
double exceeded_by(const ChiSquaredTail& of);
double exceeded_by(const FTail& of);

/// Of the standard normal distribution: its density at z, P(Z ≤ z), and the z with P(Z ≤ z) = p, 0 < p < 1.
double normal_density(double z);
double normal_below(double z);
double normal_quantile(double p);

/// ln of n!/(k!·(n − k)!), for 0 ≤ k ≤ n.
double log_choose(double n, double k);

}  // namespace asperity
