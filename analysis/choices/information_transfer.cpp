// Entropies of counts.

#include "analysis/choices/information_transfer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/numbers/tail_probabilities.h"

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
    throw std::invalid_argument(
        "counts: no trial was answered; at least one answered trial is needed");
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

namespace {

/// The trials of all participants one after the other, whose responses are permuted.
struct PooledTrials {
  std::vector<std::size_t> stimuli{};
  std::vector<std::size_t> answers{};
  std::vector<std::size_t> ends{};  ///< of each participant's trials
};

PooledTrials pooled_trials(std::span<const std::vector<LabelPair>> trials_of_participants,
                           std::size_t labels) {
  PooledTrials pool{};
  for (const std::vector<LabelPair>& own : trials_of_participants) {
    for (const LabelPair& trial : own) {
      if (trial.stimulus >= labels || trial.answer >= labels) {
        throw std::invalid_argument("trials: a label is " +
                                    std::to_string(std::max(trial.stimulus, trial.answer)) +
                                    "; every label must be below " + std::to_string(labels));
      }
      pool.stimuli.push_back(trial.stimulus);
      pool.answers.push_back(trial.answer);
    }
    pool.ends.push_back(pool.stimuli.size());
  }
  return pool;
}

/// Otherwise every order of the answers gives the same table.
bool can_be_permuted(const std::vector<LabelPair>& trials) {
  const auto differ = [&trials](std::size_t LabelPair::*label) {
    return std::any_of(trials.begin(), trials.end(), [&](const LabelPair& trial) {
      return trial.*label != trials.front().*label;
    });
  };
  return differ(&LabelPair::stimulus) && differ(&LabelPair::answer);
}

/// Σ n·ln n over the cells of a table. The margins are those of every permutation, and G is twice this
/// sum plus what depends on them alone.
class CellSum final {
 public:
  CellSum(std::size_t labels, std::size_t trials)
      : labels_(labels), cells_(labels * labels), terms_(trials + 1) {
    for (std::size_t n = 2; n <= trials; ++n) {
      terms_[n] = static_cast<double>(n) * std::log(static_cast<double>(n));
    }
  }

  double of(const PooledTrials& pool) {
    std::fill(cells_.begin(), cells_.end(), 0U);
    for (std::size_t trial = 0; trial < pool.stimuli.size(); ++trial) {
      ++cells_[pool.stimuli[trial] * labels_ + pool.answers[trial]];
    }
    double sum = 0.0;
    for (const std::uint32_t n : cells_) sum += terms_[n];
    return sum;
  }

 private:
  std::size_t labels_ = 0;
  std::vector<std::uint32_t> cells_{};
  std::vector<double> terms_{};  ///< n·ln n
};

}  // namespace

std::optional<InformationTest> information_test(
    std::span<const std::vector<LabelPair>> trials_of_participants, std::size_t labels,
    Random random) {
  PooledTrials pool = pooled_trials(trials_of_participants, labels);
  if (std::none_of(trials_of_participants.begin(), trials_of_participants.end(), can_be_permuted)) {
    return std::nullopt;
  }
  constexpr double kSwaps = 3e7;  // some tenths of a second
  const auto trials = static_cast<double>(pool.stimuli.size());
  const auto draws = static_cast<std::size_t>(std::clamp(kSwaps / trials, 199.0, 9999.0));
  CellSum sum(labels, pool.stimuli.size());
  constexpr double kRounding = 1e-12;  // of the same cells summed in another order
  double largest = sum.of(pool);
  const double observed = largest * (1.0 - kRounding);
  std::size_t as_large = 1;
  std::size_t as_largest = 1;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::size_t begin = 0;
    for (const std::size_t end : pool.ends) {
      random.shuffle(std::span(pool.answers).subspan(begin, end - begin));
      begin = end;
    }
    const double drawn = sum.of(pool);
    if (drawn >= observed) ++as_large;
    if (drawn * (1.0 - kRounding) > largest) {
      largest = drawn;
      as_largest = 1;
    } else if (drawn >= largest * (1.0 - kRounding)) {
      ++as_largest;
    }
  }
  const double orders = static_cast<double>(draws) + 1.0;
  return InformationTest{.p = static_cast<double>(as_large) / orders,
                         .smallest = static_cast<double>(as_largest) / orders,
                         .drawn = draws};
}

}  // namespace asperity
