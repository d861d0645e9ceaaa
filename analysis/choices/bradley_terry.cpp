// Fits models as conditional logits with a stratum per pair; Firth's correction by Newton's method on adjusted scores.

#include "analysis/choices/bradley_terry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/choices/comparison_graph.h"
#include "analysis/numbers/dense.h"

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

/// The outcomes of an ordered pair; of an unordered one, `first` is the lower number.
struct PairCell {
  double first_wins = 0.0;
  double second_wins = 0.0;
  double ties = 0.0;

  double all() const { return first_wins + second_wins + ties; }
};
using PairCells = std::map<std::pair<std::size_t, std::size_t>, PairCell>;

PairCells cells_of(std::span<const Comparison> comparisons, const PairTerms& terms) {
  PairCells cells{};
  for (const Comparison& one : comparisons) {
    if (one.times == 0 || (!terms.ties && !one.winner)) continue;
    const bool swapped = !terms.order && one.second < one.first;
    PairCell& cell =
        cells[swapped ? std::pair(one.second, one.first) : std::pair(one.first, one.second)];
    const auto times = static_cast<double>(one.times);
    if (!one.winner) {
      cell.ties += times;
    } else {
      ((*one.winner == one.first) != swapped ? cell.first_wins : cell.second_wins) += times;
    }
  }
  return cells;
}

/// The places of the parameters: abilities (of all items but the first) where they are free, α, ln ν.
struct PairParameters {
  std::size_t abilities = 0;
  std::optional<std::size_t> order{};
  std::optional<std::size_t> tie{};

  std::size_t count() const { return abilities + (order ? 1 : 0) + (tie ? 1 : 0); }
};

PairParameters parameters_of(std::size_t free_abilities, const PairTerms& terms) {
  PairParameters made{.abilities = free_abilities};
  if (terms.order) made.order = made.count();
  if (terms.ties) made.tie = made.count();
  return made;
}

ChoiceData choices_of(const PairCells& cells, const PairParameters& parameters) {
  ChoiceData data{};
  for (const auto& [pair, cell] : cells) {
    const auto terms = [&](double sign) {
      std::vector<Term> made{};
      if (parameters.abilities > 0) {
        made = terms_of({{pair.first, 0.5 * sign}, {pair.second, -0.5 * sign}});
      }
      if (parameters.order) made.push_back({*parameters.order, 0.5 * sign});
      return made;
    };
    data.begin_stratum();
    data.add(cell.first_wins, terms(1.0));
    data.add(cell.second_wins, terms(-1.0));
    if (parameters.tie) data.add(cell.ties, {Term{*parameters.tie, 1.0}});
  }
  return data;
}

PairFit pair_fit(const PairCells& cells, const PairModel& model, std::size_t parameters) {
  PairFit fit{.smallest_expected = std::numeric_limits<double>::infinity()};
  std::size_t counts = 0;
  std::size_t below_five = 0;
  const auto add = [&](double observed, double expected) {
    fit.pearson += (observed - expected) * (observed - expected) / expected;
    if (observed > 0.0) fit.deviance += 2.0 * observed * std::log(observed / expected);
    fit.smallest_expected = std::min(fit.smallest_expected, expected);
    ++counts;
    below_five += expected < 5.0 ? 1 : 0;
  };
  for (const auto& [pair, cell] : cells) {
    const double apart = model.abilities.value(static_cast<Eigen::Index>(pair.first)) -
                         model.abilities.value(static_cast<Eigen::Index>(pair.second)) +
                         (model.order ? model.order->value : 0.0);
    const double first = std::exp(0.5 * apart);
    const double second = std::exp(-0.5 * apart);
    const double tie = model.tie ? std::exp(model.tie->value) : 0.0;
    const double scale = cell.all() / (first + second + tie);
    add(cell.first_wins, scale * first);
    add(cell.second_wins, scale * second);
    if (model.tie) add(cell.ties, scale * tie);
  }
  if (counts > 0) fit.below_five = static_cast<double>(below_five) / static_cast<double>(counts);
  fit.deviance = std::max(0.0, fit.deviance);  // of a perfect fit, rounding may leave less
  fit.df = cells.size() * (model.tie ? 2 : 1) - parameters;
  return fit;
}

PairProblem problem_of(ScaleBlocker blocker) {
  switch (blocker) {
    case ScaleBlocker::never_compared:
      return PairProblem::never_compared;
    case ScaleBlocker::never_lose:
      return PairProblem::never_lose;
    case ScaleBlocker::never_win:
      return PairProblem::never_win;
  }
  throw std::invalid_argument(
      "blocker is not a ScaleBlocker; it must be never_compared, never_lose or never_win");
}

LogParameter parameter_at(const ConditionalLogit& fit, std::size_t place) {
  const auto index = static_cast<Eigen::Index>(place);
  return {.value = fit.coefficients(index),
          .standard_error = std::sqrt(fit.covariance(index, index))};
}

}  // namespace

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
        SymmetricFactors(information.bottomRightCorner(items - 1, items - 1)).inverse();
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

PairAnswer paired_model(std::span<const Comparison> comparisons, std::size_t items,
                        const PairTerms& terms) {
  if (items < 2) {
    throw std::invalid_argument("items is " + std::to_string(items) + "; it must be at least 2");
  }
  const Comparisons counts = count_comparisons(comparisons, items);
  // A tie is a draw: neither of both always wins.
  const BlockedItems blocked =
      blocked_items(terms.ties ? Eigen::MatrixXd(counts.wins + counts.ties) : counts.wins);
  if (!blocked.items.empty()) {
    return {.problem = problem_of(blocked.blocker), .items = blocked.items};
  }
  if (terms.ties && counts.ties.sum() == 0.0) return {.problem = PairProblem::no_ties};
  const PairCells cells = cells_of(comparisons, terms);
  const PairParameters places = parameters_of(items - 1, terms);
  const ChoiceData data = choices_of(cells, places);
  // Where all parameters are 0 every outcome is possible: only aliased terms have no information.
  const auto size = static_cast<Eigen::Index>(places.count());
  const Eigen::MatrixXd at_zero = data.slopes(Eigen::VectorXd::Zero(size)).information;
  if (rank(at_zero) < size) {
    return {.problem = PairProblem::not_identified};
  }
  const std::optional<ConditionalLogit> fit = conditional_logit(data);
  const PairParameters without_abilities = parameters_of(0, terms);
  const ChoiceData equal = choices_of(cells, without_abilities);
  const std::optional<ConditionalLogit> equal_fit = conditional_logit(equal);
  if (!fit || (without_abilities.count() > 0 && !equal_fit)) return {};
  PairModel model{.abilities = abilities_of(fit->coefficients, fit->covariance,
                                            static_cast<Eigen::Index>(items))
                                   .about_mean(),
                  .log_likelihood = fit->log_likelihood};
  if (places.order) model.order = parameter_at(*fit, *places.order);
  if (places.tie) model.tie = parameter_at(*fit, *places.tie);
  model.fit = pair_fit(cells, model, places.count());
  const double equal_log_likelihood =
      equal_fit ? equal_fit->log_likelihood : equal.log_likelihood(Eigen::VectorXd());
  model.equal_abilities = std::max(0.0, 2.0 * (fit->log_likelihood - equal_log_likelihood));
  return {.model = std::move(model)};
}

LogParameter difference_of(const Abilities& abilities, const AbilityPair& pair) {
  const auto i = static_cast<Eigen::Index>(pair.first);
  const auto j = static_cast<Eigen::Index>(pair.second);
  if (i >= abilities.value.size() || j >= abilities.value.size()) {
    throw std::invalid_argument("pair: the items are " + std::to_string(pair.first) + " and " +
                                std::to_string(pair.second) + "; each must be below " +
                                std::to_string(abilities.value.size()));
  }
  const Eigen::MatrixXd& v = abilities.covariance;
  return {.value = abilities.value(i) - abilities.value(j),
          .standard_error = std::sqrt(std::max(0.0, v(i, i) + v(j, j) - 2.0 * v(i, j)))};
}

}  // namespace asperity
