// A count as a proportion: intervals, and a test against chance.

#pragma once

#include <cstdint>

namespace asperity {

/// `hits` of `trials`. Every function here throws std::invalid_argument for no trials, for more
/// hits than trials, and for a confidence or chance that is no probability.
struct HitCount {
  std::uint64_t hits = 0;
  std::uint64_t trials = 0;
};

struct ConfidenceInterval {
  double low = 0.0;
  double high = 1.0;
};

/// What of an interval can be. A method that knows no bounds (Student's, Welch's) reaches beyond those
/// of a share, and says of values that do not exist that it does not exclude them. What is left holds
/// the true value exactly when the whole does, so it covers as often; a test of a possible value
/// rejects with the one as with the other.
ConfidenceInterval within(const ConfidenceInterval& possible, const ConfidenceInterval& interval);
/// What a share can be.
inline constexpr ConfidenceInterval kShares{.low = 0.0, .high = 1.0};

double proportion(const HitCount& count);

/// The proportions p that a score test with z = Φ⁻¹(½ + confidence/2) does not reject
/// [Wilson 1927]: |hits/n − p| ≤ z·√(p(1−p)/n). Covers the confidence on average over p. 0 of n
/// begins at 0 and n of n ends at 1, exactly.
///
/// [Wilson 1927] Wilson: Probable inference, the law of succession, and statistical inference.
ConfidenceInterval wilson_interval(const HitCount& count, double confidence = 0.95);

/// The proportions that neither one-sided exact test rejects at half the error [Clopper 1934]:
/// quantiles of the beta distribution. Covers at least the confidence for every p, mostly more.
/// 0 of n begins at 0 and n of n ends at 1, exactly.
///
/// [Clopper 1934] Clopper, Pearson: The use of confidence or fiducial limits.
ConfidenceInterval clopper_pearson_interval(const HitCount& count, double confidence = 0.95);

/// Quantiles of the beta distribution with half a hit and half a miss added [Brown 2001]: the
/// posterior of Jeffreys' prior. 0 of n begins at 0 and n of n ends at 1, exactly.
///
/// [Brown 2001] Brown, Cai, DasGupta: Interval estimation for a binomial proportion.
ConfidenceInterval jeffreys_interval(const HitCount& count, double confidence = 0.95);

/// p̃ ∓ z·√(p̃(1 − p̃)/ñ) with ñ = n + z² and p̃ = (hits + z²/2)/ñ [Agresti 1998], cut to [0, 1].
///
/// [Agresti 1998] Agresti, Coull: Approximate is better than “exact” for interval estimation.
ConfidenceInterval agresti_coull_interval(const HitCount& count, double confidence = 0.95);

/// P(at least so many hits) and P(at most so many) by chance: the one-sided exact tests.
double binomial_upper_tail(const HitCount& count, double chance);
double binomial_lower_tail(const HitCount& count, double chance);

/// The same with half of the probability of the observed count itself (mid-p).
double binomial_upper_mid_tail(const HitCount& count, double chance);
/// Twice the smaller of both mid-p, at most 1.
double binomial_mid_test(const HitCount& count, double chance);

/// 2·asin√(proportion) − 2·asin√(chance) [Cohen 1988]: how far a proportion is from another on a
/// scale on which equal distances are about equally easy to detect.
///
/// [Cohen 1988] Cohen: Statistical power analysis for the behavioral sciences.
double cohen_h(const HitCount& count, double chance);

/// The two-sided p of the exact binomial test: the probability, by chance, of all counts that are
/// not more probable than the observed one. "Not more" allows one part in 10⁷, so that counts
/// which are equally probable but for rounding are both in; R's binom.test does the same.
double binomial_test(const HitCount& count, double chance);

}  // namespace asperity
