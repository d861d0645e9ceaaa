// Implements Burg's method and the Levinson recursion in both directions.

#include "analysis/signals/autoregression.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

void require_enough(std::span<const std::vector<double>> segments, std::size_t order) {
  if (order == 0) throw std::invalid_argument("order is 0; it must be at least 1");
  if (segments.empty())
    throw std::invalid_argument("segments is empty; an autoregression needs at least one segment");
  for (const std::vector<double>& segment : segments) {
    if (segment.size() > 2 * order) continue;
    throw std::invalid_argument(
        "segments: an autoregression of order " + std::to_string(order) + " needs more than " +
        std::to_string(2 * order) + " samples in each segment, and the number in one of them is " +
        std::to_string(segment.size()) + "; choose a lower order or longer segments");
  }
}

double mean_square(std::span<const std::vector<double>> segments) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::vector<double>& segment : segments) {
    for (const double value : segment) sum += value * value;
    count += segment.size();
  }
  return sum / static_cast<double>(count);
}

// The predictor of the next order from its last coefficient.
void step_up(Autoregression& model, double reflection) {
  std::vector<double>& a = model.coefficients;
  const std::vector<double> before = a;
  for (std::size_t j = 0; j < a.size(); ++j) {
    a[j] = before[j] - reflection * before[before.size() - 1 - j];
  }
  a.push_back(reflection);
  model.innovation_variance *= 1.0 - reflection * reflection;
}

}  // namespace

std::optional<Predictors> stationary_predictors(std::span<const double> coefficients) {
  const std::size_t order = coefficients.size();
  Predictors predictors{};
  predictors.coefficients.resize(order + 1);
  predictors.error_variance.assign(order + 1, 1.0);
  predictors.coefficients[order].assign(coefficients.begin(), coefficients.end());
  for (std::size_t k = order; k > 0; --k) {
    const std::vector<double>& a = predictors.coefficients[k];
    const double reflection = a.back();
    if (!(std::abs(reflection) < 1.0)) return {};
    const double less = 1.0 - reflection * reflection;
    std::vector<double>& shorter = predictors.coefficients[k - 1];
    shorter.resize(k - 1);
    for (std::size_t j = 0; j + 1 < k; ++j) {
      shorter[j] = (a[j] + reflection * a[k - 2 - j]) / less;
    }
    predictors.error_variance[k] = less;
  }
  for (std::size_t k = 1; k <= order; ++k) {
    predictors.error_variance[k] *= predictors.error_variance[k - 1];
  }
  return predictors;
}

Autoregression burg_autoregression(std::span<const std::vector<double>> segments,
                                   std::size_t order) {
  require_enough(segments, order);
  Autoregression model{.innovation_variance = mean_square(segments)};
  std::vector<std::vector<double>> forward(segments.begin(), segments.end());
  std::vector<std::vector<double>> backward(segments.begin(), segments.end());
  for (std::size_t k = 1; k <= order; ++k) {
    double product = 0.0;
    double power = 0.0;
    for (std::size_t s = 0; s < forward.size(); ++s) {
      const std::vector<double>& f = forward[s];
      const std::vector<double>& b = backward[s];
      for (std::size_t i = k; i < f.size(); ++i) {
        product += f[i] * b[i - 1];
        power += f[i] * f[i] + b[i - 1] * b[i - 1];
      }
    }
    const double reflection = power > 0.0 ? 2.0 * product / power : 0.0;
    for (std::size_t s = 0; s < forward.size(); ++s) {
      std::vector<double>& f = forward[s];
      std::vector<double>& b = backward[s];
      for (std::size_t i = f.size(); i-- > k;) {  // b[i − 1] is still that of the order before
        const double error = f[i];
        f[i] = error - reflection * b[i - 1];
        b[i] = b[i - 1] - reflection * error;
      }
    }
    step_up(model, reflection);
  }
  return model;
}

Autoregression autoregression_of_covariance(std::span<const double> covariance) {
  if (covariance.size() < 2) {
    throw std::invalid_argument("covariance has " + counted(covariance.size(), "entry", "entries") +
                                "; an autoregression needs at least 2");
  }
  Autoregression model{.innovation_variance = covariance[0]};
  for (std::size_t k = 1; k < covariance.size(); ++k) {
    double error = covariance[k];
    for (std::size_t j = 0; j + 1 < k; ++j) {
      error -= model.coefficients[j] * covariance[k - 1 - j];
    }
    step_up(model, model.innovation_variance > 0.0 ? error / model.innovation_variance : 0.0);
  }
  return model;
}

Autoregression yule_walker_autoregression(std::span<const std::vector<double>> segments,
                                          std::size_t order) {
  require_enough(segments, order);
  std::vector<double> covariance(order + 1, 0.0);
  std::size_t count = 0;
  for (const std::vector<double>& segment : segments) {
    count += segment.size();
    for (std::size_t k = 0; k <= order; ++k) {
      for (std::size_t i = k; i < segment.size(); ++i) {
        covariance[k] += segment[i] * segment[i - k];
      }
    }
  }
  for (double& c : covariance) c /= static_cast<double>(count);
  return autoregression_of_covariance(covariance);
}

void shrink_poles(Autoregression& model, double rho) {
  double power = 1.0;
  for (double& a : model.coefficients) a *= power *= rho;
}

}  // namespace asperity
