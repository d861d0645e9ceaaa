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

/// The two-sided p of the exact binomial test: the probability, by chance, of all counts that are
/// not more probable than the observed one. "Not more" allows one part in 10⁷, so that counts
/// which are equally probable but for rounding are both in; R's binom.test does the same.
double binomial_test(const HitCount& count, double chance);

}  // namespace asperity
