// Autoregressive models: the estimators against R and against known processes, and the test of stationarity.

#include "analysis/signals/autoregression.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

// R's `lh`: luteinizing hormone in 48 blood samples [Diggle 1990].
std::vector<double> luteinizing_hormone() {
  std::vector<double> levels{2.4, 2.4, 2.4, 2.2, 2.1, 1.5, 2.3, 2.3, 2.5, 2.0, 1.9, 1.7,
                             2.2, 1.8, 3.2, 3.2, 2.7, 2.2, 2.2, 1.9, 1.9, 1.8, 2.7, 3.0,
                             2.3, 2.0, 2.0, 2.9, 2.9, 2.7, 2.7, 2.3, 2.6, 2.4, 1.8, 1.7,
                             1.5, 1.4, 2.1, 3.3, 3.5, 3.5, 3.1, 2.6, 2.1, 3.4, 3.0, 2.9};
  double mean = 0.0;
  for (const double level : levels) mean += level / static_cast<double>(levels.size());
  for (double& level : levels) level -= mean;
  return levels;
}

std::vector<double> simulated_process(const std::vector<double>& a, std::size_t count,
                                      std::uint64_t seed) {
  Random random(seed);
  std::vector<double> m(count + 2000, 0.0);
  for (std::size_t i = a.size(); i < m.size(); ++i) {
    m[i] = random.normal();
    for (std::size_t j = 0; j < a.size(); ++j) m[i] += a[j] * m[i - 1 - j];
  }
  return {m.begin() + 2000, m.end()};
}

// ar(lh, order.max = 3, aic = FALSE) and ar(lh, method = "burg"), as R prints them.
TEST(Autoregression, AgreesWithR) {
  const std::vector<std::vector<double>> segments{luteinizing_hormone()};
  EXPECT_THAT(
      yule_walker_autoregression(segments, 3).coefficients,
      ElementsAre(DoubleNear(0.6534, 5e-5), DoubleNear(-0.0636, 5e-5), DoubleNear(-0.2269, 5e-5)));
  EXPECT_THAT(
      burg_autoregression(segments, 3).coefficients,
      ElementsAre(DoubleNear(0.6588, 5e-5), DoubleNear(-0.0608, 5e-5), DoubleNear(-0.2234, 5e-5)));
}

// The equations c_1 = a_1·c_0 + a_2·c_1 and c_2 = a_1·c_1 + a_2·c_0 in closed form.
TEST(Autoregression, SolvesTheYuleWalkerEquations) {
  const std::vector<double> signal = simulated_process({1.2, -0.5}, 300, 7);
  double c[3]{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = k; i < signal.size(); ++i) c[k] += signal[i] * signal[i - k];
    c[k] /= static_cast<double>(signal.size());
  }
  const double determinant = c[0] * c[0] - c[1] * c[1];
  const double a1 = c[1] * (c[0] - c[2]) / determinant;
  const double a2 = (c[0] * c[2] - c[1] * c[1]) / determinant;
  const Autoregression found =
      yule_walker_autoregression(std::vector<std::vector<double>>{signal}, 2);
  EXPECT_THAT(found.coefficients, ElementsAre(DoubleNear(a1, 1e-12), DoubleNear(a2, 1e-12)));
  EXPECT_NEAR(found.innovation_variance, c[0] - a1 * c[1] - a2 * c[2], 1e-12);
}

TEST(Autoregression, RecoversTheCoefficientsOfAProcess) {
  constexpr std::size_t kCount = 40'000;
  const double tolerance = 3.0 / std::sqrt(static_cast<double>(kCount));
  const std::vector<double> a{1.4562, -0.81};
  const std::vector<std::vector<double>> segments{simulated_process(a, kCount / 2, 1),
                                                  simulated_process(a, kCount / 2, 2)};
  for (const Autoregression& found :
       {burg_autoregression(segments, 2), yule_walker_autoregression(segments, 2)}) {
    EXPECT_THAT(found.coefficients,
                ElementsAre(DoubleNear(a[0], tolerance), DoubleNear(a[1], tolerance)));
    EXPECT_NEAR(found.innovation_variance, 1.0, 4.0 * std::sqrt(2.0 / kCount));
  }
}

// The seam between two segments belongs to neither: a signal is predicted from its own past.
TEST(Autoregression, DoesNotPredictAcrossSegments) {
  const std::vector<double> signal = simulated_process({0.9}, 200, 3);
  std::vector<double> opposite = signal;
  for (double& value : opposite) value = -value;
  const std::vector<std::vector<double>> one{signal};
  const std::vector<std::vector<double>> two{signal, opposite};
  EXPECT_NEAR(burg_autoregression(two, 3).coefficients[0],
              burg_autoregression(one, 3).coefficients[0], 1e-12);
  EXPECT_NEAR(yule_walker_autoregression(two, 3).coefficients[0],
              yule_walker_autoregression(one, 3).coefficients[0], 1e-12);
}

TEST(Autoregression, RefusesSegmentsThatAreTooShort) {
  EXPECT_THROW(burg_autoregression(std::vector<std::vector<double>>{{1, 2, 3, 4}}, 2),
               std::invalid_argument);
  EXPECT_THROW(burg_autoregression({}, 2), std::invalid_argument);
  EXPECT_THROW(yule_walker_autoregression(std::vector<std::vector<double>>{{1, 2}}, 0),
               std::invalid_argument);
}

TEST(StationaryPredictors, HaveTheVarianceOfOrderTwoInClosedForm) {
  const double a1 = 1.4562;
  const double a2 = -0.81;
  const auto predictors = stationary_predictors(std::vector<double>{a1, a2});
  ASSERT_TRUE(predictors);
  EXPECT_NEAR(predictors->error_variance[2],
              (1.0 + a2) * ((1.0 - a2) * (1.0 - a2) - a1 * a1) / (1.0 - a2), 1e-12);
  EXPECT_NEAR(predictors->coefficients[1][0], a1 / (1.0 - a2), 1e-12);
  EXPECT_EQ(predictors->error_variance[0], 1.0);
}

// The process with the innovation variance of its predictor has the variance 1: to 2 % over 10⁶ samples.
TEST(StationaryPredictors, HaveTheVarianceOfASimulatedProcess) {
  for (const std::vector<double>& a :
       {std::vector<double>{1.4562, -0.81}, std::vector<double>{0.5, -0.3, 0.2, -0.4}}) {
    const auto predictors = stationary_predictors(a);
    ASSERT_TRUE(predictors);
    double sum_of_squares = 0.0;
    const std::vector<double> values = simulated_process(a, 1'000'000, 9);
    for (const double value : values) sum_of_squares += value * value;
    EXPECT_NEAR(sum_of_squares / 1e6 * predictors->error_variance.back(), 1.0, 0.02);
  }
}

// Coefficients from given roots: with one outside the unit circle, or on it, the process is not stationary.
TEST(StationaryPredictors, ExistExactlyForRootsInsideTheUnitCircle) {
  const auto with_roots = [](const std::vector<std::complex<double>>& roots) {
    std::vector<std::complex<double>> polynomial{1.0};
    for (const std::complex<double>& root : roots) {
      polynomial.push_back(0.0);
      for (std::size_t i = polynomial.size() - 1; i > 0; --i) {
        polynomial[i] -= root * polynomial[i - 1];
      }
    }
    std::vector<double> a{};
    for (std::size_t i = 1; i < polynomial.size(); ++i) a.push_back(-polynomial[i].real());
    return a;
  };
  for (const double radius : {0.2, 0.9, 0.999, 1.001, 1.5}) {
    for (const double angle : {0.1, 1.0, 3.0}) {
      const auto pair = std::polar(radius, angle);
      EXPECT_EQ(stationary_predictors(with_roots({pair, std::conj(pair), 0.5, -0.7})).has_value(),
                radius < 1.0)
          << radius << ' ' << angle;
    }
  }
  EXPECT_FALSE(stationary_predictors(std::vector<double>{1.0}));
  EXPECT_FALSE(stationary_predictors(std::vector<double>{0.0, -1.0}));
}

TEST(ShrinkPoles, MovesEveryRootByTheFactor) {
  Autoregression model{.coefficients = {2.0 * std::cos(0.4), -1.0}};
  shrink_poles(model, 0.9);
  EXPECT_THAT(model.coefficients,
              ElementsAre(DoubleNear(1.8 * std::cos(0.4), 1e-15), DoubleNear(-0.81, 1e-15)));
}

}  // namespace
}  // namespace asperity
