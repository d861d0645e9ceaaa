// How much an answer tells about the stimulus, in bits.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/choices/confusion.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// Transmitted information of a confusion matrix of N trials, with its corrections for bias.
///
///   T = H(stimulus) + H(answer) − H(both),  H = −Σ p·log₂p.
///
/// The plug-in T is too large in small samples: guessing among 6 with 5 trials each seems to
/// transmit 0.7 bits. `miller` takes off (r−1)(c−1)/(2N·ln 2) for r rows and c columns with trials
/// [Miller 1955]; `miller_madow` corrects each entropy by its own number of occupied cells, and
/// fails on sparse, nearly diagonal tables; `jackknife` is N·T − (N−1)·mean of T without one
/// trial. Corrected values may leave 0 … H(stimulus): they are not clamped.
///
/// `G` = 2N·ln2·T is the likelihood ratio against no transfer, `df` = (r−1)(c−1).
///
/// [Miller 1955] Miller: Note on the bias of information estimates.
struct InformationTransfer {
  double stimulus_bits = 0.0;
  double answer_bits = 0.0;
  double plug_in_bits = 0.0;
  std::optional<double> relative{};  ///< T/H(stimulus); absent where only one was presented
  double miller_madow_bits = 0.0;
  double miller_bits = 0.0;
  std::optional<double> jackknife_bits{};  ///< absent for a single trial
  double G = 0.0;
  double df = 0.0;
  std::optional<double> p{};
  bool enough_trials = false;  ///< N ≥ 5m²: below it no correction is to be trusted
};

/// Throws std::invalid_argument as confusion.h does, and for no trials.
InformationTransfer information_transfer(const ConfusionCounts& counts);

/// Permutation test of G: how often G is at least the observed one when each participant's responses
/// are permuted over that participant's trials, the observed order among them [Davison 1997]. Where a
/// participant's trials are exchangeable under the null hypothesis its size is at most the nominal one,
/// whatever a participant prefers to answer; the distribution of χ² rejects too often: of 36 trials
/// among four pictures 12 % at .05.
///
/// 9999 random permutations; fewer, but at least 199, of more than 3000 trials. Nothing where no
/// participant has both two different stimuli and two different answers. Throws std::invalid_argument for a label that
/// is not below `labels`.
///
/// [Davison 1997] Davison, Hinkley: Bootstrap Methods and their Application.
struct InformationTest {
  double p = 1.0;
  /// The p of the largest G among the observed and the drawn orders: an estimate of the smallest p that these responses
  /// can give.
  double smallest = 1.0;
  std::size_t drawn = 0;
};
std::optional<InformationTest> information_test(
    std::span<const std::vector<LabelPair>> trials_of_participants, std::size_t labels,
    Random random = Random(kSeedOfTests));

}  // namespace asperity
