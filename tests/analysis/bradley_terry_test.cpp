// Holds the models of paired comparisons to R and names what has no finite scale.

#include "analysis/choices/bradley_terry.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "analysis/choices/comparison_graph.h"
#include "tests/analysis/computed_in_r/r_results.h"

namespace asperity {
namespace {

std::vector<Comparison> comparisons_in(const std::string& file) {
  const RTable table(file);
  std::vector<Comparison> all{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto first = static_cast<std::size_t>(table.number(row, "first")) - 1;
    const auto second = static_cast<std::size_t>(table.number(row, "second")) - 1;
    const auto add = [&](const std::string& column, std::optional<std::size_t> winner) {
      all.push_back({.first = first,
                     .second = second,
                     .winner = winner,
                     .times = static_cast<std::size_t>(table.number(row, column))});
    };
    add("first_wins", first);
    add("second_wins", second);
    add("ties", std::nullopt);
  }
  return all;
}

struct PairedCase {
  std::string name{};
  std::string file{};
  std::size_t items = 0;
  PairTerms terms{};
};

// R's glm stops when the deviance changes by less than 10⁻⁸ of itself; with Newton's last step the
// coefficients then are good to some 10⁻⁷.
void expect_model_of_r(const PairedCase& one) {
  constexpr double kTolerance = 1e-6;
  const RResults expected("paired_comparisons_expected.csv");
  const PairAnswer answer = paired_model(comparisons_in(one.file), one.items, one.terms);
  ASSERT_TRUE(answer.model);
  const PairModel& model = *answer.model;
  const Eigen::VectorXd errors = model.abilities.standard_error();
  for (std::size_t item = 0; item < one.items; ++item) {
    const auto index = static_cast<Eigen::Index>(item);
    EXPECT_NEAR(model.abilities.value(index), expected.at(one.name + ".ability", item + 1),
                kTolerance);
    EXPECT_NEAR(errors(index), expected.at(one.name + ".se", item + 1), kTolerance);
  }
  EXPECT_NEAR(model.abilities.value.sum(), 0.0, 1e-12);
  const LogParameter apart = difference_of(model.abilities, {.first = 2, .second = 1});
  EXPECT_NEAR(apart.value, model.abilities.value(2) - model.abilities.value(1), 1e-15);
  EXPECT_NEAR(apart.standard_error, expected.at(one.name + ".difference.se", "3|2"), kTolerance);
  EXPECT_NEAR(model.log_likelihood, expected.at(one.name + ".loglik"), 1e-6);
  EXPECT_NEAR(model.equal_abilities, expected.at(one.name + ".equal"), 1e-6);
  EXPECT_NEAR(model.fit.pearson, expected.at(one.name + ".pearson"), 1e-5);
  EXPECT_NEAR(model.fit.deviance, expected.at(one.name + ".deviance"), 1e-6);
  EXPECT_EQ(static_cast<double>(model.fit.df), expected.at(one.name + ".df"));
  EXPECT_EQ(model.order.has_value(), one.terms.order);
  EXPECT_EQ(model.tie.has_value(), one.terms.ties);
  if (model.order) {
    EXPECT_NEAR(model.order->value, expected.at(one.name + ".order", "value"), kTolerance);
    EXPECT_NEAR(model.order->standard_error, expected.at(one.name + ".order", "se"), kTolerance);
  }
  if (model.tie) {
    EXPECT_NEAR(model.tie->value, expected.at(one.name + ".tie", "value"), kTolerance);
    EXPECT_NEAR(model.tie->standard_error, expected.at(one.name + ".tie", "se"), kTolerance);
  }
}

TEST(PairedModel, OfCitationsIsThatOfR) {
  expect_model_of_r({.name = "citations", .file = "citations.csv", .items = 4});
}

TEST(PairedModel, OfBaseballWithAnAdvantageAtHomeIsThatOfR) {
  expect_model_of_r(
      {.name = "baseball", .file = "baseball.csv", .items = 7, .terms = {.order = true}});
}

TEST(PairedModel, WithTiesIsThatOfR) {
  expect_model_of_r(
      {.name = "ties", .file = "ties_and_order.csv", .items = 5, .terms = {.ties = true}});
}

TEST(PairedModel, WithTiesAndOrderIsThatOfR) {
  expect_model_of_r({.name = "ties_and_order",
                     .file = "ties_and_order.csv",
                     .items = 5,
                     .terms = {.order = true, .ties = true}});
}

// The same models, fitted from other strata.
TEST(PairedModel, IsThatOfTheFunctionsWithoutGoodnessOfFit) {
  const std::vector<Comparison> all = comparisons_in("ties_and_order.csv");
  const auto plain = paired_model(all, 5).model;
  const auto bradley = bradley_terry(all, 5);
  ASSERT_TRUE(plain && bradley);
  EXPECT_LT((plain->abilities.value - bradley->abilities.about_mean().value).cwiseAbs().maxCoeff(),
            1e-10);
  EXPECT_NEAR(plain->fit.deviance, bradley->deviance, 1e-9);
  EXPECT_NEAR(plain->equal_abilities, bradley->likelihood_ratio, 1e-9);
  const auto order = paired_model(all, 5, {.order = true}).model;
  ASSERT_TRUE(order && bradley->order);
  EXPECT_NEAR(order->order->value, bradley->order->advantage, 1e-10);
  const auto tied = paired_model(all, 5, {.ties = true}).model;
  const auto of_davidson = davidson(count_comparisons(all, 5));
  ASSERT_TRUE(tied && of_davidson);
  EXPECT_NEAR(tied->tie->value, of_davidson->log_tie, 1e-10);
  EXPECT_NEAR(tied->fit.deviance, of_davidson->deviance, 1e-9);
  EXPECT_EQ(tied->fit.df, of_davidson->df);
}

// Two items: λ₁ − λ₂ = ln(9/3), and both expected counts are the observed ones.
TEST(PairedModel, OfTwoItemsIsSaturated) {
  const std::vector<Comparison> all{{.first = 0, .second = 1, .winner = 0, .times = 9},
                                    {.first = 1, .second = 0, .winner = 1, .times = 3}};
  const auto model = paired_model(all, 2).model;
  ASSERT_TRUE(model);
  EXPECT_NEAR(model->abilities.value(0), 0.5 * std::log(3.0), 1e-12);
  EXPECT_NEAR(difference_of(model->abilities, {}).standard_error, std::sqrt(1.0 / 9.0 + 1.0 / 3.0),
              1e-12);
  EXPECT_NEAR(model->fit.pearson, 0.0, 1e-12);
  EXPECT_EQ(model->fit.df, 0U);
  EXPECT_NEAR(model->fit.smallest_expected, 3.0, 1e-10);
  EXPECT_DOUBLE_EQ(model->fit.below_five, 0.5);
  EXPECT_FALSE(model->fit.is_approximately_chi_squared());
}

Comparison won(std::size_t winner, std::size_t loser) {
  return {.first = winner, .second = loser, .winner = winner};
}

void expect_blocked(const PairAnswer& answer, PairProblem problem,
                    const std::vector<std::size_t>& items) {
  EXPECT_FALSE(answer.model);
  EXPECT_EQ(answer.problem, problem);
  EXPECT_EQ(answer.items, items);
}

TEST(PairedModel, NamesTheItemsWithoutAFiniteScale) {
  const std::vector<Comparison> circle{won(1, 2), won(2, 3), won(3, 1)};
  std::vector<Comparison> all = circle;
  expect_blocked(paired_model(all, 4), PairProblem::never_compared, {0});
  all.push_back(won(0, 2));
  expect_blocked(paired_model(all, 4), PairProblem::never_lose, {0});
  all.back() = won(2, 0);
  expect_blocked(paired_model(all, 4), PairProblem::never_win, {0});
  // Two circles: the lower one never wins against the higher one.
  all = {won(0, 4), won(4, 0), won(1, 2), won(2, 3), won(3, 1), won(1, 4), won(2, 0)};
  expect_blocked(paired_model(all, 5), PairProblem::never_win, {0, 4});
  all.push_back({.first = 0, .second = 3, .winner = {}});
  expect_blocked(paired_model(all, 5), PairProblem::never_win, {0, 4});
}

TEST(PairedModel, TakesATieForADrawWhereTiesAreATerm) {
  std::vector<Comparison> all{won(0, 1), won(1, 0), won(0, 2), won(1, 2)};
  expect_blocked(paired_model(all, 3, {.ties = true}), PairProblem::never_win, {2});
  all.push_back({.first = 1, .second = 2, .winner = {}});
  all.push_back({.first = 0, .second = 1, .winner = {}});
  const auto model = paired_model(all, 3, {.ties = true}).model;
  ASSERT_TRUE(model);
  EXPECT_LT(model->abilities.value(2), model->abilities.value(1));
  expect_blocked(paired_model(all, 3), PairProblem::never_win, {2});
}

TEST(PairedModel, ReportsTermsThatTheDataCannotEstimate) {
  // Both items were presented in one order only: the order effect is the difference.
  const std::vector<Comparison> one_order{{.first = 0, .second = 1, .winner = 0, .times = 5},
                                          {.first = 0, .second = 1, .winner = 1, .times = 2}};
  expect_blocked(paired_model(one_order, 2, {.order = true}), PairProblem::not_identified, {});
  expect_blocked(paired_model(one_order, 2, {.ties = true}), PairProblem::no_ties, {});
  // The first item always wins.
  const std::vector<Comparison> first_wins{won(0, 1), won(1, 0)};
  expect_blocked(paired_model(first_wins, 2, {.order = true}), PairProblem::no_maximum, {});
  // All are ties.
  const std::vector<Comparison> tied{{.first = 0, .second = 1, .winner = {}, .times = 7}};
  expect_blocked(paired_model(tied, 2, {.ties = true}), PairProblem::no_maximum, {});
}

TEST(PairedModel, RefusesImpossibleComparisons) {
  EXPECT_THROW(paired_model({}, 1), std::invalid_argument);
  const std::vector<Comparison> itself{won(0, 0)};
  EXPECT_THROW(paired_model(itself, 2), std::invalid_argument);
  const std::vector<Comparison> both{won(0, 1), won(1, 0)};
  EXPECT_THROW(difference_of(paired_model(both, 2).model->abilities, {.first = 0, .second = 2}),
               std::invalid_argument);
}

TEST(BlockedItems, AreNoneOfAConnectedGraph) {
  Eigen::MatrixXd wins = Eigen::MatrixXd::Zero(3, 3);
  wins(0, 1) = wins(1, 2) = wins(2, 0) = 1.0;
  EXPECT_TRUE(blocked_items(wins).items.empty());
  wins(2, 0) = 0.0;  // a chain: its ends are equally small sets
  EXPECT_EQ(blocked_items(wins).blocker, ScaleBlocker::never_lose);
  EXPECT_EQ(blocked_items(wins).items, (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace asperity
