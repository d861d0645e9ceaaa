// Entropies of counts.

#include "analysis/information_transfer.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/tail_probabilities.h"

namespace asperity {
namespace {

double entropy_bits(const Eigen::ArrayXd& counts, double total) {
  double bits = 0.0;
  for (const double count : counts) {
    if (count > 0.0) {
      bits -= count / total * std::log2(count / total);
    }
  }
  return bits;
}

struct Entropies {
  double stimulus = 0.0;
  double answer = 0.0;
  double both = 0.0;

  double transfer() const { return stimulus + answer - both; }
};

Entropies entropies_of(const ConfusionCounts& counts) {
  const double total = counts.sum();
  return {.stimulus = entropy_bits(counts.rowwise().sum().array(), total),
          .answer = entropy_bits(counts.colwise().sum().transpose().array(), total),
          .both = entropy_bits(counts.reshaped().array(), total)};
}

}  // namespace

InformationTransfer information_transfer(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  const double n = counts.sum();
  if (n == 0.0) {
    throw std::invalid_argument("counts: no trial was answered; information needs at least one");
  }
  const Entropies entropies = entropies_of(counts);
  const double transfer = entropies.transfer();
  const double rows = static_cast<double>((counts.rowwise().sum().array() > 0.0).count());
  const double columns = static_cast<double>((counts.colwise().sum().array() > 0.0).count());
  const double cells = static_cast<double>((counts.array() > 0.0).count());
  const double per_cell = 1.0 / (2.0 * n * std::numbers::ln2);

  InformationTransfer answer;
  answer.stimulus_bits = entropies.stimulus;
  answer.answer_bits = entropies.answer;
  answer.plug_in_bits = transfer;
  if (entropies.stimulus > 0.0) {
    answer.relative = transfer / entropies.stimulus;
  }
  answer.miller_madow_bits = transfer + ((rows - 1.0) + (columns - 1.0) - (cells - 1.0)) * per_cell;
  answer.miller_bits = transfer - (rows - 1.0) * (columns - 1.0) * per_cell;
  if (n > 1.0) {
    double without_one = 0.0;
    ConfusionCounts fewer = counts;
    for (Eigen::Index i = 0; i < counts.rows(); ++i) {
      for (Eigen::Index j = 0; j < counts.cols(); ++j) {
        if (counts(i, j) > 0.0) {
          fewer(i, j) -= 1.0;
          without_one += counts(i, j) * entropies_of(fewer).transfer();
          fewer(i, j) += 1.0;
        }
      }
    }
    answer.jackknife_bits = n * transfer - (n - 1.0) * without_one / n;
  }
  answer.G = 2.0 * n * std::numbers::ln2 * transfer;
  answer.df = (rows - 1.0) * (columns - 1.0);
  answer.p = upper_tail(ChiSquaredStatistic{.value = answer.G, .df = answer.df});
  answer.enough_trials = n >= 5.0 * static_cast<double>(counts.size());
  return answer;
}

}  // namespace asperity
