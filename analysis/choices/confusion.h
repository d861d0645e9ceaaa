// Which stimulus was taken for which: the confusion matrix, and how well it agrees.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// Counts of the answers to m stimuli: row = stimulus, column = answer. Every function on such
/// counts throws std::invalid_argument unless they are square, of at least two labels, and no count
/// is negative or not finite.
using ConfusionCounts = Eigen::MatrixXd;

struct LabelPair {
  std::size_t stimulus = 0;
  std::size_t answer = 0;
};

/// Throws std::invalid_argument for a label that is not below `labels`.
ConfusionCounts confusion_counts(std::span<const LabelPair> trials, std::size_t labels);

void refuse_impossible_counts(const ConfusionCounts& counts);

/// The diagonal against all.
HitCount right_answers(const ConfusionCounts& counts);
/// Of the trials with this stimulus, those that were answered with it; no trials are nothing.
std::optional<HitCount> recall(const ConfusionCounts& counts, std::size_t label);
/// Of the trials with this answer, those in which it was right; no such answer is nothing.
std::optional<HitCount> precision(const ConfusionCounts& counts, std::size_t label);

/// Cohen's κ = (p − e)/(1 − e), e the agreement of independent rows and columns. Nothing without
/// trials, and where e = 1 (one stimulus only, always answered alike).
std::optional<double> kappa(const ConfusionCounts& counts);

/// What similarities of stimuli rest on.
struct PairConfusions {
  std::uint64_t confusions = 0;    ///< incorrect answers
  std::size_t pairs = 0;           ///< of different stimuli
  std::size_t never_confused = 0;  ///< pairs that were not confused in either direction
  /// Whether half of the pairs or more were never confused: their dissimilarities and the fit of any model to them are
  /// those of what is added to empty cells.
  bool are_too_few() const noexcept { return 2 * never_confused >= pairs; }
};
PairConfusions pair_confusions(const ConfusionCounts& counts);

/// Mean recall of the stimuli that were presented.
std::optional<double> balanced_share(const ConfusionCounts& counts);

}  // namespace asperity
