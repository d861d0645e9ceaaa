// Holds cumulative link models to R, to integration by brute force, and to what has no maximum.

#include "analysis/models/cumulative_link.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/models/cumulative_likelihood.h"
#include "analysis/numbers/random.h"
#include "tests/analysis/computed_in_r/r_results.h"

namespace asperity {
namespace {

using Effects = std::vector<std::string>;

struct OrdinalData {
  std::vector<OrdinalResponse> responses{};
  CumulativeLinkModel model{};
};

OrdinalData ratings_in(const std::string& file, const Effects& effects) {
  const RTable table(file);
  OrdinalData data{.model = {.design = Eigen::MatrixXd(static_cast<Eigen::Index>(table.rows()),
                                                       static_cast<Eigen::Index>(effects.size()))}};
  const auto index = [&table](std::size_t row, const std::string& column) {
    return static_cast<std::size_t>(table.number(row, column)) - 1;
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    data.responses.push_back({.category = index(row, "category"),
                              .participant = index(row, "participant"),
                              .item = index(row, "item")});
    data.model.categories = std::max(data.model.categories, data.responses.back().category + 1);
    for (std::size_t effect = 0; effect < effects.size(); ++effect) {
      data.model.design(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(effect)) =
          table.number(row, effects[effect]);
    }
  }
  return data;
}

struct OrdinalTolerance {
  double coefficient = 0.0;
  double error = 0.0;  // relative
  double log_likelihood = 0.0;
};

void expect_numbers(const CumulativeLinkFit& fit, const std::string& name,
                    const OrdinalTolerance& tolerance) {
  const RResults expected("cumulative_link_expected.csv");
  const Eigen::VectorXd threshold_errors = fit.threshold_standard_error();
  for (Eigen::Index j = 0; j < fit.thresholds.size(); ++j) {
    const auto number = static_cast<std::size_t>(j) + 1;
    EXPECT_NEAR(fit.thresholds(j), expected.at(name + ".threshold", number), tolerance.coefficient);
    const double error = expected.at(name + ".threshold.se", number);
    EXPECT_NEAR(threshold_errors(j), error, tolerance.error * error);
  }
  const Eigen::VectorXd errors = fit.standard_error();
  for (Eigen::Index k = 0; k < fit.beta.size(); ++k) {
    const auto number = static_cast<std::size_t>(k) + 1;
    EXPECT_NEAR(fit.beta(k), expected.at(name + ".beta", number), tolerance.coefficient);
    const double error = expected.at(name + ".se", number);
    EXPECT_NEAR(errors(k), error, tolerance.error * error);
  }
  if (expected.has(name + ".sigma", "participant")) {
    EXPECT_NEAR(fit.sigma_participants, expected.at(name + ".sigma", "participant"),
                tolerance.coefficient);
  }
  if (expected.has(name + ".sigma", "item")) {
    EXPECT_NEAR(fit.sigma_items, expected.at(name + ".sigma", "item"), tolerance.coefficient);
  }
  EXPECT_NEAR(fit.log_likelihood, expected.at(name + ".loglik"), tolerance.log_likelihood);
}

CumulativeLinkFit fit_of(const OrdinalData& data) {
  const CumulativeLinkAnswer answer = cumulative_link_fit(data.responses, data.model);
  EXPECT_TRUE(answer.fit) << static_cast<int>(answer.problem);
  return answer.fit.value_or(CumulativeLinkFit{});
}

// clm ends with Newton's steps at a gradient of 10⁻¹²: both find the same maximum to rounding.
void expect_clm(const std::string& name, const std::string& file, const Effects& effects) {
  const CumulativeLinkFit fit = fit_of(ratings_in(file, effects));
  expect_numbers(fit, name, {.coefficient = 1e-7, .error = 1e-6, .log_likelihood = 1e-9});
  const RResults expected("cumulative_link_expected.csv");
  for (std::size_t effect = 0; effect < effects.size(); ++effect) {
    const WaldTest test = wald_test(fit, effect);
    EXPECT_NEAR(test.z, expected.at(name + ".z", effects[effect]), 1e-5);
    EXPECT_NEAR(test.p, expected.at(name + ".p", effects[effect]), 1e-6);
  }
}

TEST(CumulativeLink, WithoutRandomInterceptsIsThatOfClm) {
  expect_clm("wine", "wine.csv", {"warm", "contact"});
  expect_clm("ratings", "crossed_ratings.csv", {"second", "third", "roughness"});
}

// The script's own maximum is polished by Newton's steps on numerical derivatives: it agrees to 10⁻⁹.
// clmm stops its optimiser earlier, and its errors come from a coarser numerical Hessian: coefficients
// agree within 2·10⁻⁵, errors within 10⁻⁴ of themselves.
void expect_mixed(const std::string& name, const CumulativeLinkFit& fit) {
  expect_numbers(fit, name, {.coefficient = 1e-8, .error = 1e-7, .log_likelihood = 1e-9});
  expect_numbers(fit, "clmm." + name, {.coefficient = 1e-4, .error = 2e-4, .log_likelihood = 1e-7});
}

TEST(CumulativeLink, WithParticipantsIsThatOfClmm) {
  OrdinalData data = ratings_in("wine.csv", {"warm", "contact"});
  data.model.participants_vary = true;
  const CumulativeLinkFit fit = fit_of(data);
  expect_mixed("wine.judges", fit);
  EXPECT_EQ(fit.parameters, 7U);
  OrdinalData smaller = ratings_in("wine.csv", {"warm"});
  smaller.model.participants_vary = true;
  const ChiSquaredStatistic ratio = likelihood_ratio(fit_of(smaller), fit);
  EXPECT_NEAR(ratio.value, RResults("cumulative_link_expected.csv").at("wine.judges", "lr"), 1e-7);
  EXPECT_EQ(ratio.df, 1.0);
}

TEST(CumulativeLink, WithItemsIsThatOfClmm) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "third"});
  data.model.items_vary = true;
  const CumulativeLinkFit fit = fit_of(data);
  expect_mixed("ratings.items", fit);
  EXPECT_EQ(fit.sigma_participants, 0.0);
}

TEST(CumulativeLink, WithParticipantsAndItemsIsThatOfClmm) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "third", "roughness"});
  data.model.participants_vary = data.model.items_vary = true;
  const CumulativeLinkFit fit = fit_of(data);
  expect_mixed("ratings.crossed", fit);
  OrdinalData smaller = ratings_in("crossed_ratings.csv", {"roughness"});
  smaller.model.participants_vary = smaller.model.items_vary = true;
  const ChiSquaredStatistic ratio = likelihood_ratio(fit_of(smaller), fit);
  EXPECT_NEAR(ratio.value, RResults("cumulative_link_expected.csv").at("ratings.crossed", "lr"),
              1e-7);
  EXPECT_EQ(ratio.df, 2.0);
}

TEST(CumulativeLink, OfRandomInterceptsAloneIsThatOfClmm) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {});
  data.model.participants_vary = data.model.items_vary = true;
  expect_mixed("ratings.empty", fit_of(data));
}

TEST(CumulativeLink, OfTwoCategoriesIsThatOfClmm) {
  OrdinalData data = ratings_in("crossed_binary.csv", {"second", "third"});
  data.model.participants_vary = data.model.items_vary = true;
  expect_mixed("binary.crossed", fit_of(data));
}

// Without effects the thresholds are the logits of the cumulative proportions, ln(3/7) and ln(8/2).
TEST(CumulativeLink, HasTheThresholdsOfTheProportions) {
  std::vector<OrdinalResponse> responses{};
  for (std::size_t i = 0; i < 10; ++i) {
    responses.push_back({.category = i < 3 ? 0U : (i < 8 ? 1U : 2U)});
  }
  const CumulativeLinkModel model{.categories = 3, .design = Eigen::MatrixXd(10, 0)};
  const CumulativeLinkFit fit = fit_of({.responses = responses, .model = model});
  EXPECT_NEAR(fit.thresholds(0), std::log(3.0 / 7.0), 1e-12);
  EXPECT_NEAR(fit.thresholds(1), std::log(8.0 / 2.0), 1e-12);
  EXPECT_NEAR(fit.log_likelihood, 3.0 * std::log(0.3) + 5.0 * std::log(0.5) + 2.0 * std::log(0.2),
              1e-12);
  // √(1/3 + 1/7): that of a logit.
  EXPECT_NEAR(fit.threshold_standard_error()(0), std::sqrt(1.0 / 3.0 + 1.0 / 7.0), 1e-9);
}

// A participant at a time: ∫ Π P(category | u)·φ(u) du on a grid.
double integrated_ratings(const OrdinalData& data, const CumulativeLinkFit& fit,
                          std::size_t participants) {
  constexpr double kStep = 0.05;
  constexpr int kHalf = 140;
  const Eigen::VectorXd fixed = data.model.design * fit.beta;
  const auto below = [&](std::size_t category, double eta) {
    if (category + 1 == data.model.categories) return 1.0;
    return 1.0 / (1.0 + std::exp(eta - fit.thresholds(static_cast<Eigen::Index>(category))));
  };
  double sum = 0.0;
  for (std::size_t participant = 0; participant < participants; ++participant) {
    double integral = 0.0;
    for (int place = -kHalf; place <= kHalf; ++place) {
      const double u = kStep * place;
      double density = std::exp(-0.5 * u * u) / std::sqrt(2.0 * std::numbers::pi);
      for (std::size_t i = 0; i < data.responses.size(); ++i) {
        const OrdinalResponse& one = data.responses[i];
        if (one.participant != participant) continue;
        const double eta = fixed(static_cast<Eigen::Index>(i)) + fit.sigma_participants * u;
        density *=
            below(one.category, eta) - (one.category == 0 ? 0.0 : below(one.category - 1, eta));
      }
      integral += kStep * density;
    }
    sum += std::log(integral);
  }
  return sum;
}

// Laplace's approximation errs by a few hundredths of the logarithm with eight responses per participant.
TEST(CumulativeLink, IsNearTheIntegralItself) {
  OrdinalData data = ratings_in("wine.csv", {"warm", "contact"});
  data.model.participants_vary = true;
  const CumulativeLinkFit fit = fit_of(data);
  const double exact = integrated_ratings(data, fit, 9);
  EXPECT_NEAR(fit.log_likelihood, exact, 0.1);
  for (const double factor : {0.7, 1.4}) {
    CumulativeLinkFit other = fit;
    other.sigma_participants *= factor;
    EXPECT_LT(integrated_ratings(data, other, 9), exact);
  }
}

// By θ, β, σ_p and σ_i, away from the maximum, against differences of the likelihood.
TEST(OrdinalLikelihood, HasTheGradientOfItsDifferences) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "roughness"});
  data.model.participants_vary = data.model.items_vary = true;
  const OrdinalLikelihood likelihood(data.responses, data.model);
  Eigen::VectorXd place(likelihood.thresholds() + likelihood.effects() + 2);
  place << -2.5, -1.0, 0.0, 1.5, 2.0, 3.0, 0.4, -0.3, 0.7, 1.2;
  const auto at = [&likelihood](const Eigen::VectorXd& all) {
    return OrdinalParameters{.thresholds = OrdinalThresholds(all.head(likelihood.thresholds())),
                             .beta = all.segment(likelihood.thresholds(), likelihood.effects()),
                             .sigma_p = all(all.size() - 2),
                             .sigma_i = all(all.size() - 1)};
  };
  CrossedIntercepts intercepts = likelihood.none();
  const Eigen::VectorXd gradient = likelihood.gradient(at(place), intercepts);
  constexpr double kStep = 1e-4;
  for (Eigen::Index i = 0; i < place.size(); ++i) {
    Eigen::VectorXd above = place;
    Eigen::VectorXd below = place;
    above(i) += kStep;
    below(i) -= kStep;
    const double difference =
        (likelihood.value(at(above), intercepts) - likelihood.value(at(below), intercepts)) /
        (2.0 * kStep);
    EXPECT_NEAR(gradient(i), difference, 1e-6 * (1.0 + std::abs(difference))) << i;
  }
}

TEST(CumulativeLink, IsAMaximumOfTheLikelihood) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "third", "roughness"});
  data.model.participants_vary = data.model.items_vary = true;
  const CumulativeLinkFit fit = fit_of(data);
  const auto at = [&data](const CumulativeLinkFit& other) {
    return cumulative_link_log_likelihood(data.responses, data.model, other);
  };
  EXPECT_NEAR(at(fit), fit.log_likelihood, 1e-9);
  for (const double sign : {-1.0, 1.0}) {
    CumulativeLinkFit other = fit;
    other.sigma_items += sign * 0.01;
    EXPECT_LT(at(other), fit.log_likelihood);
    other = fit;
    other.sigma_participants += sign * 0.01;
    EXPECT_LT(at(other), fit.log_likelihood);
    other = fit;
    other.beta(2) += sign * 1e-4;
    EXPECT_LT(at(other), fit.log_likelihood);
    other = fit;
    other.thresholds(3) += sign * 0.01;
    EXPECT_LT(at(other), fit.log_likelihood);
  }
}

// Reversing the categories reverses the scale: β and θ change their signs.
TEST(CumulativeLink, TurnsWithTheCategories) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "third"});
  data.model.participants_vary = data.model.items_vary = true;
  const CumulativeLinkFit before = fit_of(data);
  for (OrdinalResponse& one : data.responses) {
    one.category = data.model.categories - 1 - one.category;
  }
  const CumulativeLinkFit after = fit_of(data);
  EXPECT_LT((before.beta + after.beta).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((before.thresholds + after.thresholds.reverse()).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(before.sigma_items, after.sigma_items, 1e-8);
  EXPECT_NEAR(before.log_likelihood, after.log_likelihood, 1e-9);
}

TEST(CumulativeLink, DoesNotDependOnTheUnitsOfACovariate) {
  OrdinalData data = ratings_in("crossed_ratings.csv", {"second", "roughness"});
  data.model.participants_vary = data.model.items_vary = true;
  const CumulativeLinkFit before = fit_of(data);
  data.model.design.col(1) *= 1e-6;
  const CumulativeLinkFit after = fit_of(data);
  EXPECT_NEAR(1e-6 * after.beta(1), before.beta(1), 1e-9);
  EXPECT_NEAR(1e-6 * after.standard_error()(1), before.standard_error()(1), 1e-9);
  EXPECT_NEAR(after.log_likelihood, before.log_likelihood, 1e-9);
}

OrdinalData categories_of(const std::vector<std::vector<std::size_t>>& by_participant,
                          std::size_t categories) {
  OrdinalData data{};
  for (std::size_t participant = 0; participant < by_participant.size(); ++participant) {
    for (std::size_t item = 0; item < by_participant[participant].size(); ++item) {
      data.responses.push_back({.category = by_participant[participant][item],
                                .participant = participant,
                                .item = item});
    }
  }
  data.model = {.categories = categories,
                .design = Eigen::MatrixXd(static_cast<Eigen::Index>(data.responses.size()), 0)};
  return data;
}

void expect_problem(const OrdinalData& data, CumulativeLinkProblem problem) {
  const CumulativeLinkAnswer answer = cumulative_link_fit(data.responses, data.model);
  EXPECT_FALSE(answer.fit);
  EXPECT_EQ(answer.problem, problem);
}

TEST(CumulativeLink, NamesACategoryWithoutResponses) {
  const OrdinalData data = categories_of({{0, 1, 3}, {1, 3, 0}}, 5);
  expect_problem(data, CumulativeLinkProblem::unused_category);
  EXPECT_EQ(cumulative_link_fit(data.responses, data.model).unused_category, 2U);
}

TEST(CumulativeLink, ReportsSeparation) {
  // A condition whose responses are all in the highest category: β is infinite.
  OrdinalData data = categories_of({{0, 2, 1, 2}, {1, 2, 0, 2}, {2, 2, 1, 2}}, 3);
  data.model.design = Eigen::MatrixXd::Zero(12, 1);
  for (Eigen::Index i = 1; i < 12; i += 2) data.model.design(i, 0) = 1.0;
  expect_problem(data, CumulativeLinkProblem::separated);
  data.model.participants_vary = true;
  expect_problem(data, CumulativeLinkProblem::separated);
  // A covariate that orders all responses.
  data = categories_of({{0, 0, 1, 1, 2, 2}}, 3);
  data.model.design = Eigen::VectorXd::LinSpaced(6, 1.0, 6.0);
  expect_problem(data, CumulativeLinkProblem::separated);
  // The same covariate, with one response out of order, has a maximum.
  data.responses[2].category = 2;
  data.responses[4].category = 1;
  EXPECT_TRUE(cumulative_link_fit(data.responses, data.model).fit);
}

TEST(CumulativeLink, NamesTheVarianceThatIsEstimatedAsNone) {
  OrdinalData same = categories_of({{0, 1, 2, 1}, {0, 1, 2, 1}, {0, 1, 2, 1}}, 3);
  same.model.participants_vary = true;
  expect_problem(same, CumulativeLinkProblem::no_participant_variance);
  OrdinalData alike = categories_of({{0, 0, 1, 0}, {1, 2, 1, 1}, {2, 1, 2, 2}, {1, 0, 0, 1}}, 3);
  alike.model.participants_vary = alike.model.items_vary = true;
  expect_problem(alike, CumulativeLinkProblem::no_item_variance);
  OrdinalData square = categories_of({{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}, 3);
  square.model.participants_vary = square.model.items_vary = true;
  expect_problem(square, CumulativeLinkProblem::no_variance);
}

// Each participant has one category only: the likelihood grows with σ without bound.
TEST(CumulativeLink, ReportsAVarianceWithoutBound) {
  OrdinalData data = categories_of({{0, 0, 0, 0}, {1, 1, 1, 1}, {2, 2, 2, 2}, {1, 1, 1, 1}}, 3);
  data.model.participants_vary = true;
  expect_problem(data, CumulativeLinkProblem::unbounded_variance);
}

/// Ratings on categories between `thresholds` of participants with the intercepts `u` and items with `v`,
/// who rate each item in two conditions; the second one adds `effect`.
struct DrawnRatings {
  std::vector<double> thresholds{};
  double effect = 0.0;
  std::vector<double> u{};
  std::vector<double> v{};
};
OrdinalData drawn_ratings(const DrawnRatings& from, Random& random) {
  const std::size_t rows = 2 * from.u.size() * from.v.size();
  OrdinalData data{.model = {.categories = from.thresholds.size() + 1,
                             .design = Eigen::MatrixXd(static_cast<Eigen::Index>(rows), 1),
                             .participants_vary = true,
                             .items_vary = true}};
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t participant = row / (2 * from.v.size());
    const std::size_t item = row / 2 % from.v.size();
    const double x = row % 2 == 0 ? 0.0 : 1.0;
    data.model.design(static_cast<Eigen::Index>(row), 0) = x;
    const double uniform = random.uniform();
    const double latent =
        from.effect * x + from.u[participant] + from.v[item] + std::log(uniform / (1.0 - uniform));
    std::size_t category = 0;
    while (category < from.thresholds.size() && latent > from.thresholds[category]) ++category;
    data.responses.push_back({.category = category, .participant = participant, .item = item});
  }
  return data;
}

std::vector<double> normal_numbers(std::size_t count, double sd, Random& random) {
  std::vector<double> made(count);
  for (double& one : made) one = sd * random.normal();
  return made;
}

// Recovery: estimates from 150 participants lie within four standard errors of the true values.
TEST(CumulativeLink, RecoversTheModelThatItIsDrawnFrom) {
  Random random(5);
  const DrawnRatings from{.thresholds = {-1.5, 0.0, 1.0, 2.5},
                          .effect = 0.8,
                          .u = normal_numbers(150, 1.2, random),
                          .v = std::vector<double>(6, 0.0)};
  OrdinalData data = drawn_ratings(from, random);
  data.model.items_vary = false;
  const CumulativeLinkFit fit = fit_of(data);
  EXPECT_NEAR(fit.beta(0), 0.8, 4.0 * fit.standard_error()(0));
  EXPECT_NEAR(fit.sigma_participants, 1.2, 0.3);
  for (Eigen::Index j = 0; j < 4; ++j) {
    EXPECT_NEAR(fit.thresholds(j), from.thresholds[static_cast<std::size_t>(j)],
                4.0 * fit.threshold_standard_error()(j));
  }
}

// Small tables, of which many have an estimate of 0 for the variance of their four items: every search ends
// at a maximum, whether inside or on the boundary. In one of the tables a search that accepts a step
// without a gain moves between σ and −σ for ever.
TEST(CumulativeLink, EndsAtAMaximumOfSmallTables) {
  std::size_t fits = 0;
  std::size_t boundaries = 0;
  for (std::uint64_t table = 0; table < 40; ++table) {
    Random random = Random(99).split(table);
    DrawnRatings from{.effect = 0.5};
    for (int j = 0; j < 6; ++j) from.thresholds.push_back(-1.7 + 4.0 * j / 6.0);
    from.u = normal_numbers(10, 1.0, random);
    from.v = normal_numbers(4, 0.5, random);
    const OrdinalData data = drawn_ratings(from, random);
    const CumulativeLinkAnswer answer = cumulative_link_fit(data.responses, data.model);
    if (answer.fit) {
      ++fits;
      continue;
    }
    ++boundaries;
    EXPECT_THAT(answer.problem, testing::AnyOf(CumulativeLinkProblem::no_participant_variance,
                                               CumulativeLinkProblem::no_item_variance,
                                               CumulativeLinkProblem::no_variance))
        << table;
  }
  EXPECT_GT(fits, 20U);
  EXPECT_GT(boundaries, 5U);
}

TEST(CumulativeLink, RefusesWhatIsNotAModel) {
  const OrdinalData data = categories_of({{0, 1}, {1, 0}}, 2);
  const auto refused = [&data](const CumulativeLinkModel& model) {
    EXPECT_THROW(cumulative_link_fit(data.responses, model), std::invalid_argument);
  };
  CumulativeLinkModel model = data.model;
  model.categories = 1;
  refused(model);
  model = data.model;
  model.design = Eigen::MatrixXd(3, 0);
  refused(model);
  model.design = Eigen::MatrixXd::Ones(4, 1);  // the thresholds stand for it
  refused(model);
  model.design = Eigen::MatrixXd::Constant(4, 1, std::nan(""));
  refused(model);
  EXPECT_THROW(cumulative_link_fit({}, data.model), std::invalid_argument);
  const OrdinalData one = categories_of({{0, 1, 1, 0}}, 2);
  model = one.model;
  model.participants_vary = true;
  EXPECT_THROW(cumulative_link_fit(one.responses, model), std::invalid_argument);
  const OrdinalData beyond = categories_of({{0, 2}, {1, 0}}, 2);
  EXPECT_THROW(cumulative_link_fit(beyond.responses, beyond.model), std::invalid_argument);
}

TEST(CumulativeLink, RefusesTestsOfModelsThatAreNotNested) {
  const CumulativeLinkFit one = fit_of(ratings_in("wine.csv", {"warm"}));
  const CumulativeLinkFit other = fit_of(ratings_in("wine.csv", {"contact"}));
  const CumulativeLinkFit elsewhere =
      fit_of(ratings_in("crossed_ratings.csv", {"second", "third"}));
  EXPECT_THROW(likelihood_ratio(one, other), std::invalid_argument);
  EXPECT_THROW(likelihood_ratio(one, elsewhere), std::invalid_argument);
  EXPECT_THROW(wald_test(one, 1), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
