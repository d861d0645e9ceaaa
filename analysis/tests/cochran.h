// Whether the same participants say yes equally often in several conditions.

#pragma once

#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/proportion.h"

namespace asperity {

/// `answers` is a matrix of zeros and ones, a row per participant and a column per condition, without
/// gaps. With J conditions, totals C_j of the columns and R_i of the rows [Cochran 1950],
///
///   Q = (J − 1)·(J·Σ C_j² − T²)/(J·T − Σ R_i²),  T = Σ C_j,
///
/// chi-squared with J − 1 degrees of freedom for many participants. Q and both p are NaN where every
/// participant answers all conditions alike, or there is nobody or one condition: then nothing is
/// compared. The exact p permutes the answers within each participant.
///
/// It asks whether the conditions differ. Across the alternatives of one choice, where every row has
/// a single 1, it would only be Pearson's X² again.
///
/// [Cochran 1950] Cochran: The comparison of percentages in matched samples.
struct CochranTest {
  double q = 0.0;
  double df = 0.0;
  double p = 1.0;
  double exact_p = 1.0;
  bool counted = true;    ///< false: the exact p is of random permutations,
  std::size_t drawn = 0;  ///< of so many
};
CochranTest cochran_test(const CountMatrix& answers);

/// Two of the conditions: b participants say yes only in the first, c only in the second; the exact
/// two-sided binomial test of b of b + c against ½, 1 where nobody differs [McNemar 1947].
///
/// [McNemar 1947] McNemar: Note on the sampling error of the difference between correlated
/// proportions or percentages.
struct Discordance {
  std::uint64_t only_first = 0;   ///< b
  std::uint64_t only_second = 0;  ///< c
};
double mcnemar_test(const Discordance& discordance);

/// What that test can give where only the margins are known: `first` and `second` of n participants
/// say yes, and nothing tells which of them do so in both. The smallest and the largest p over all
/// tables with these margins. Throws std::invalid_argument for margins above n.
struct McNemarMargins {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
  std::uint64_t participants = 0;
};
ConfidenceInterval mcnemar_bounds(const McNemarMargins& margins);

}  // namespace asperity
