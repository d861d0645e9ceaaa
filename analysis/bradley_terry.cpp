#include "analysis/bradley_terry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include <Eigen/Cholesky>

#include "analysis/comparison_graph.h"

namespace asperity {
namespace {

using Term = ChoiceData::Term;

/// The terms of a sum of abilities and other parameters; the first item has none.
std::vector<Term> terms_of(std::initializer_list<Term> abilities, std::optional<Term> other = {}) {
  std::vector<Term> terms{};
  for (const Term& ability : abilities) {
    if (ability.parameter > 0) terms.push_back({ability.parameter - 1, ability.weight});
  }
  if (other) terms.push_back(*other);
  return terms;
}

Abilities abilities_of(const Eigen::VectorXd& coefficients, const Eigen::MatrixXd& covariance,
                       Eigen::Index items) {
  Abilities abilities{.value = Eigen::VectorXd::Zero(items),
                      .covariance = Eigen::MatrixXd::Zero(items, items)};
  abilities.value.tail(items - 1) = coefficients.head(items - 1);
  abilities.covariance.bottomRightCorner(items - 1, items - 1) =
      covariance.topLeftCorner(items - 1, items - 1);
  return abilities;
}

/// A stratum per pair that was compared, with ties as a third alternative where they count.
struct PairData {
  ChoiceData data{};
  std::size_t pairs = 0;
};
PairData pair_data(const Comparisons& counts, bool with_ties) {
  PairData made{};
  const Eigen::Index items = counts.wins.rows();
  const auto tie = static_cast<std::size_t>(items - 1);
  for (Eigen::Index i = 0; i < items; ++i) {
    for (Eigen::Index j = i + 1; j < items; ++j) {
      const double ties = with_ties ? counts.ties(i, j) : 0.0;
      if (counts.wins(i, j) + counts.wins(j, i) + ties == 0.0) continue;
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      ++made.pairs;
      made.data.begin_stratum();
      made.data.add(counts.wins(i, j), terms_of({{a, 1.0}}));
      made.data.add(counts.wins(j, i), terms_of({{b, 1.0}}));
      if (with_ties) made.data.add(ties, terms_of({{a, 0.5}, {b, 0.5}}, Term{tie, 1.0}));
    }
  }
  return made;
}

/// Comparisons without a tie, a stratum for each participant, first and second item; `order`: with
/// an advantage of the first. Those of a stratum have the same probabilities.
struct ByParticipant {
  ChoiceData data{};
  std::vector<std::size_t> clusters{};
};
ByParticipant by_participant(std::span<const Comparison> comparisons, std::size_t items,
                             bool order) {
  std::map<std::array<std::size_t, 3>, std::array<double, 2>> counts{};
  for (const Comparison& one : comparisons) {
    if (!one.winner) continue;
    counts[{one.participant, one.first, one.second}][*one.winner == one.first ? 0 : 1] +=
        static_cast<double>(one.times);
  }
  ByParticipant made{};
  for (const auto& [of, won] : counts) {
    made.data.begin_stratum();
    made.clusters.push_back(of[0]);
    made.data.add(won[0], terms_of({{of[1], 1.0}},
                                   order ? std::optional(Term{items - 1, 1.0}) : std::nullopt));
    made.data.add(won[1], terms_of({{of[2], 1.0}}));
  }
  return made;
}

}  // namespace

Comparisons count_comparisons(std::span<const Comparison> comparisons, std::size_t items) {
  const auto size = static_cast<Eigen::Index>(items);
  Comparisons counts{.wins = Eigen::MatrixXd::Zero(size, size),
                     .ties = Eigen::MatrixXd::Zero(size, size)};
  for (const Comparison& one : comparisons) {
    const bool judged = !one.winner || *one.winner == one.first || *one.winner == one.second;
    if (one.first >= items || one.second >= items || one.first == one.second || !judged) {
      throw std::invalid_argument("comparisons: each must be of two different items below " +
                                  std::to_string(items) + ", and won by one of them or tied");
    }
    const auto a = static_cast<Eigen::Index>(one.first);
    const auto b = static_cast<Eigen::Index>(one.second);
    const auto times = static_cast<double>(one.times);
    if (!one.winner) {
      counts.ties(a, b) += times;
      counts.ties(b, a) += times;
    } else if (*one.winner == one.first) {
      counts.wins(a, b) += times;
    } else {
      counts.wins(b, a) += times;
    }
  }
  return counts;
}

Eigen::VectorXd Abilities::standard_error() const {
  return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

Eigen::MatrixXd centring(Eigen::Index items) {
  return Eigen::MatrixXd::Identity(items, items) -
         Eigen::MatrixXd::Constant(items, items, 1.0 / static_cast<double>(items));
}

Abilities Abilities::about_mean() const {
  const Eigen::MatrixXd centred = centring(value.size());
  return {.value = centred * value, .covariance = centred * covariance * centred.transpose()};
}

Eigen::VectorXd Abilities::worth() const {
  const Eigen::VectorXd above = (value.array() - value.maxCoeff()).exp();
  return above / above.sum();
}

std::optional<BradleyTerry> bradley_terry(std::span<const Comparison> comparisons,
                                          std::size_t items) {
  const Comparisons counts = count_comparisons(comparisons, items);
  if (items < 2 || !strongly_connected(counts.wins)) return std::nullopt;
  const PairData pairs = pair_data(counts, false);
  const std::optional<ConditionalLogit> fit = conditional_logit(pairs.data);
  if (!fit) return std::nullopt;
  const auto size = static_cast<Eigen::Index>(items);
  BradleyTerry result{.abilities = abilities_of(fit->coefficients, fit->covariance, size)};
  result.deviance = 2.0 * (pairs.data.largest_log_likelihood() - fit->log_likelihood);
  result.df = pairs.pairs - (items - 1);
  const double equal = pairs.data.log_likelihood(Eigen::VectorXd::Zero(size - 1));
  result.likelihood_ratio = 2.0 * (fit->log_likelihood - equal);
  const ByParticipant judgements = by_participant(comparisons, items, false);
  const Eigen::MatrixXd clustered =
      clustered_covariance(*fit, judgements.data, judgements.clusters);
  result.clustered = abilities_of(fit->coefficients, clustered, size);
  result.centred_errors = clustered_errors(*fit, judgements.data, judgements.clusters,
                                           centring(size).rightCols(size - 1));
  if (const auto with_order = conditional_logit(by_participant(comparisons, items, true).data)) {
    result.order = {.advantage = with_order->coefficients(size - 1),
                    .standard_error = std::sqrt(with_order->covariance(size - 1, size - 1)),
                    .likelihood_ratio = 2.0 * (with_order->log_likelihood - fit->log_likelihood)};
  }
  return result;
}

// The score is Σ x·(y − n·μ + h·(½ − μ)) with the leverages h: the data with half a leverage added
// as a win to either side.
std::optional<Abilities> firth_bradley_terry(const Comparisons& counts) {
  const Eigen::Index items = counts.wins.rows();
  if (items < 2 || !connected(counts.wins)) return std::nullopt;
  constexpr int kMostSteps = 2000;
  constexpr double kLongestStep = 2.0;
  Eigen::VectorXd ability = Eigen::VectorXd::Zero(items);
  Eigen::MatrixXd covariance{};
  for (int step = 0; step < kMostSteps; ++step) {
    const auto chance = [&](Eigen::Index i, Eigen::Index j) {
      return 1.0 / (1.0 + std::exp(ability(j) - ability(i)));
    };
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(items, items);
    for (Eigen::Index i = 0; i < items; ++i) {
      for (Eigen::Index j = i + 1; j < items; ++j) {
        const double weight = (counts.wins(i, j) + counts.wins(j, i)) * chance(i, j) * chance(j, i);
        information(i, i) += weight;
        information(j, j) += weight;
        information(i, j) -= weight;
        information(j, i) -= weight;
      }
    }
    covariance = Eigen::MatrixXd::Zero(items, items);
    covariance.bottomRightCorner(items - 1, items - 1) =
        information.bottomRightCorner(items - 1, items - 1)
            .ldlt()
            .solve(Eigen::MatrixXd::Identity(items - 1, items - 1));
    Eigen::VectorXd score = Eigen::VectorXd::Zero(items);
    for (Eigen::Index i = 0; i < items; ++i) {
      for (Eigen::Index j = i + 1; j < items; ++j) {
        const double trials = counts.wins(i, j) + counts.wins(j, i);
        const double spread = covariance(i, i) + covariance(j, j) - 2.0 * covariance(i, j);
        const double leverage = trials * chance(i, j) * chance(j, i) * spread;
        const double more = counts.wins(i, j) + 0.5 * leverage - (trials + leverage) * chance(i, j);
        score(i) += more;
        score(j) -= more;
      }
    }
    Eigen::VectorXd move = covariance * score;
    const double far = move.cwiseAbs().maxCoeff();
    if (!std::isfinite(far)) return std::nullopt;
    if (far > kLongestStep) move *= kLongestStep / far;
    ability += move;
    if (far < 1e-13 * (1.0 + ability.cwiseAbs().maxCoeff())) {
      return Abilities{.value = ability, .covariance = covariance};
    }
  }
  return std::nullopt;
}

std::optional<Davidson> davidson(const Comparisons& counts) {
  const Eigen::Index items = counts.wins.rows();
  if (items < 2 || counts.ties.sum() == 0.0 || !strongly_connected(counts.wins)) {
    return std::nullopt;
  }
  const PairData pairs = pair_data(counts, true);
  const std::optional<ConditionalLogit> fit = conditional_logit(pairs.data);
  if (!fit) return std::nullopt;
  return Davidson{.abilities = abilities_of(fit->coefficients, fit->covariance, items),
                  .log_tie = fit->coefficients(items - 1),
                  .log_tie_standard_error = std::sqrt(fit->covariance(items - 1, items - 1)),
                  .deviance = 2.0 * (pairs.data.largest_log_likelihood() - fit->log_likelihood),
                  .df = 2 * pairs.pairs - static_cast<std::size_t>(items)};
}

Consistency consistency(std::span<const std::size_t> wins) {
  const auto k = static_cast<double>(wins.size());
  if (wins.size() < 3) {
    throw std::invalid_argument("wins: number of items " + std::to_string(wins.size()) +
                                "; circular triads require at least 3");
  }
  double squares = 0.0;
  for (const std::size_t own : wins) squares += static_cast<double>(own * own);
  Consistency result{.circular_triads = k * (k - 1.0) * (2.0 * k - 1.0) / 12.0 - 0.5 * squares};
  const double most = (wins.size() % 2 == 1 ? k * k * k - k : k * k * k - 4.0 * k) / 24.0;
  result.zeta = 1.0 - result.circular_triads / most;
  return result;
}

}  // namespace asperity
