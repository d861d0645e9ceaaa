// Sums of rows, columns and the diagonal.

#include "analysis/choices/confusion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/matrix_place.h"

namespace asperity {
namespace {

std::uint64_t whole(double count) { return static_cast<std::uint64_t>(std::llround(count)); }

}  // namespace

ConfusionCounts confusion_counts(std::span<const LabelPair> trials, std::size_t labels) {
  const auto size = static_cast<Eigen::Index>(labels);
  ConfusionCounts counts = ConfusionCounts::Zero(size, size);
  for (const LabelPair& trial : trials) {
    if (trial.stimulus >= labels || trial.answer >= labels) {
      throw std::invalid_argument("trials: a label is " +
                                  std::to_string(std::max(trial.stimulus, trial.answer)) +
                                  "; every label must be below " + std::to_string(labels));
    }
    counts(static_cast<Eigen::Index>(trial.stimulus), static_cast<Eigen::Index>(trial.answer)) +=
        1.0;
  }
  return counts;
}

void refuse_impossible_counts(const ConfusionCounts& counts) {
  if (counts.rows() != counts.cols() || counts.rows() < 2) {
    throw std::invalid_argument("counts has the size " + std::to_string(counts.rows()) + " × " +
                                std::to_string(counts.cols()) +
                                "; a confusion matrix must be square, with at least 2 labels");
  }
  if (!counts.allFinite() || counts.minCoeff() < 0.0) {
    throw std::invalid_argument(
        "counts: the count in " +
        place_of_first(counts,
                       [](double value) { return !(value >= 0.0) || !std::isfinite(value); }) +
        " is negative or not finite; all must be finite and at least 0");
  }
}

HitCount right_answers(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  return {.hits = whole(counts.trace()), .trials = whole(counts.sum())};
}

std::optional<HitCount> recall(const ConfusionCounts& counts, std::size_t label) {
  refuse_impossible_counts(counts);
  const auto i = static_cast<Eigen::Index>(label);
  const double trials = counts.row(i).sum();
  if (trials == 0.0) {
    return std::nullopt;
  }
  return HitCount{.hits = whole(counts(i, i)), .trials = whole(trials)};
}

std::optional<HitCount> precision(const ConfusionCounts& counts, std::size_t label) {
  return recall(counts.transpose(), label);
}

std::optional<double> kappa(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  const double n = counts.sum();
  const Eigen::VectorXd stimuli = counts.rowwise().sum();
  const Eigen::VectorXd answers = counts.colwise().sum();
  const double by_chance = stimuli.dot(answers) / (n * n);
  if (!(n > 0.0) || by_chance == 1.0) {
    return std::nullopt;
  }
  return (counts.trace() / n - by_chance) / (1.0 - by_chance);
}

PairConfusions pair_confusions(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  PairConfusions pairs{.confusions =
                           static_cast<std::uint64_t>(std::llround(counts.sum() - counts.trace()))};
  for (Eigen::Index i = 0; i < counts.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < counts.cols(); ++j) {
      ++pairs.pairs;
      if (counts(i, j) + counts(j, i) == 0.0) ++pairs.never_confused;
    }
  }
  return pairs;
}

std::optional<double> balanced_share(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  double sum = 0.0;
  double presented = 0.0;
  for (Eigen::Index i = 0; i < counts.rows(); ++i) {
    const double trials = counts.row(i).sum();
    if (trials > 0.0) {
      sum += counts(i, i) / trials;
      presented += 1.0;
    }
  }
  return presented > 0.0 ? std::optional<double>(sum / presented) : std::nullopt;
}

}  // namespace asperity
