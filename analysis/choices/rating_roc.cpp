// The areas from counts; the likelihood by Newton's method with its exact derivatives.

#include "analysis/choices/rating_roc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

struct RatingTotals {
  double noise = 0.0;
  double signal = 0.0;
};

RatingTotals rating_totals_of(std::span<const RatingCount> ratings) {
  RatingTotals totals{};
  for (const RatingCount& rating : ratings) {
    totals.noise += static_cast<double>(rating.noise);
    totals.signal += static_cast<double>(rating.signal);
  }
  if (totals.noise > 0.0 && totals.signal > 0.0) return totals;
  throw std::invalid_argument("an ROC needs at least one trial with and one without a signal");
}

/// μ, ln σ and the criteria of the ratings in use. Where σ is fixed, the derivatives by ln σ are left out.
class RatingLikelihood final {
 public:
  RatingLikelihood(std::vector<RatingCount> used, RocVariance variance)
      : used_(std::move(used)), is_free_(variance == RocVariance::free) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(used_.size()) + 1; }
  bool is_free(Eigen::Index parameter) const { return parameter != 1 || is_free_; }

  /// From the proportions, as if σ were 1.
  Eigen::VectorXd start() const {
    const RatingTotals totals = rating_totals_of(used_);
    Eigen::VectorXd at = Eigen::VectorXd::Zero(size());
    double noise = 0.0;
    double signal = 0.0;
    double difference = 0.0;
    for (std::size_t j = 0; j + 1 < used_.size(); ++j) {
      noise += static_cast<double>(used_[j].noise);
      signal += static_cast<double>(used_[j].signal);
      const double below_noise = (noise + 0.5) / (totals.noise + 1.0);
      const double below_signal = (signal + 0.5) / (totals.signal + 1.0);
      at[static_cast<Eigen::Index>(j) + 2] = normal_quantile(below_noise);
      difference += normal_quantile(below_noise) - normal_quantile(below_signal);
    }
    at[0] = difference / static_cast<double>(used_.size() - 1);
    constexpr double kLeastGap = 0.02;
    for (Eigen::Index j = 3; j < size(); ++j) at[j] = std::max(at[j], at[j - 1] + kLeastGap);
    return at;
  }

  double value(const Eigen::VectorXd& at) const { return evaluate(at, nullptr, nullptr); }
  double value(const Eigen::VectorXd& at, Eigen::VectorXd& gradient,
               Eigen::MatrixXd& hessian) const {
    gradient = Eigen::VectorXd::Zero(size());
    hessian = Eigen::MatrixXd::Zero(size(), size());
    return evaluate(at, &gradient, &hessian);
  }

 private:
  /// Φ(u) of one end of a rating, u = (c − m)/s, with the derivatives by all parameters.
  struct End {
    double below = 0.0;
    Eigen::VectorXd first{};
    Eigen::MatrixXd second{};
  };

  End end_of(const Eigen::VectorXd& at, std::size_t j, bool is_signal, bool derives) const {
    End end{};
    if (derives) {
      end.first = Eigen::VectorXd::Zero(size());
      end.second = Eigen::MatrixXd::Zero(size(), size());
    }
    if (j == 0) return end;
    if (j == used_.size()) {
      end.below = 1.0;
      return end;
    }
    const Eigen::Index c = static_cast<Eigen::Index>(j) + 1;
    const double scale = is_signal ? std::exp(-at[1]) : 1.0;
    const double u = (at[c] - (is_signal ? at[0] : 0.0)) * scale;
    end.below = normal_below(u);
    if (!derives) return end;
    Eigen::VectorXd du = Eigen::VectorXd::Zero(size());
    Eigen::MatrixXd ddu = Eigen::MatrixXd::Zero(size(), size());
    du[c] = scale;
    if (is_signal) {
      du[0] = -scale;
      du[1] = -u;
      ddu(1, 1) = u;
      ddu(1, c) = ddu(c, 1) = -scale;
      ddu(1, 0) = ddu(0, 1) = scale;
    }
    const double density = normal_density(u);
    end.first = density * du;
    end.second = density * (ddu - u * du * du.transpose());
    return end;
  }

  double evaluate(const Eigen::VectorXd& at, Eigen::VectorXd* gradient,
                  Eigen::MatrixXd* hessian) const {
    double sum = 0.0;
    for (const bool is_signal : {false, true}) {
      End low = end_of(at, 0, is_signal, gradient != nullptr);
      for (std::size_t j = 0; j < used_.size(); ++j) {
        End high = end_of(at, j + 1, is_signal, gradient != nullptr);
        const auto count = static_cast<double>(is_signal ? used_[j].signal : used_[j].noise);
        const double p = high.below - low.below;
        if (!(p > 0.0)) {
          if (count > 0.0) return -std::numeric_limits<double>::infinity();
        } else if (count > 0.0) {
          sum += count * std::log(p);
          if (gradient != nullptr) {
            const Eigen::VectorXd slope = (high.first - low.first) / p;
            *gradient += count * slope;
            *hessian += count * ((high.second - low.second) / p - slope * slope.transpose());
          }
        }
        low = std::move(high);
      }
    }
    return sum;
  }

  std::vector<RatingCount> used_{};
  bool is_free_ = true;
};

bool has_ordered_criteria(const Eigen::VectorXd& at) {
  for (Eigen::Index j = 3; j < at.size(); ++j) {
    if (!(at[j] > at[j - 1])) return false;
  }
  return true;
}

/// Parameters that are not free have the derivative 0 and the curvature −1.
void fix(const RatingLikelihood& likelihood, Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) {
  for (Eigen::Index i = 0; i < likelihood.size(); ++i) {
    if (likelihood.is_free(i)) continue;
    gradient[i] = 0.0;
    hessian.row(i).setZero();
    hessian.col(i).setZero();
    hessian(i, i) = -1.0;
  }
}

/// The ascent direction of Newton's method; the curvature is increased until it is that of a maximum.
Eigen::VectorXd ascent(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& hessian) {
  const Eigen::MatrixXd curvature = -hessian;
  for (double ridge = 0.0; ridge < 1e12; ridge = ridge == 0.0 ? 1e-3 : 10.0 * ridge) {
    const CholeskyFactors factors(
        curvature + ridge * Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
    if (factors.is_positive_definite()) return factors.solved(gradient);
  }
  return gradient;
}

struct RocMaximum {
  Eigen::VectorXd at{};
  Eigen::MatrixXd covariance{};
  double value = 0.0;
};

std::optional<RocMaximum> maximum_of(const RatingLikelihood& likelihood) {
  constexpr int kMostSteps = 500;
  constexpr double kConverged = 1e-10;
  constexpr double kFarthest = 30.0;  // in standard deviations: the likelihood has no maximum
  Eigen::VectorXd at = likelihood.start();
  Eigen::VectorXd gradient{};
  Eigen::MatrixXd hessian{};
  for (int step = 0; step < kMostSteps; ++step) {
    const double value = likelihood.value(at, gradient, hessian);
    if (!std::isfinite(value)) return std::nullopt;
    fix(likelihood, gradient, hessian);
    const Eigen::VectorXd direction = ascent(gradient, hessian);
    if (direction.cwiseAbs().maxCoeff() < kConverged) {
      const CholeskyFactors factors(-hessian);
      if (!factors.is_positive_definite()) return std::nullopt;
      return RocMaximum{.at = at, .covariance = factors.inverse(), .value = value};
    }
    double length = 1.0;
    const double precision = 1e-12 * std::abs(value);
    while (length > 1e-12) {
      const Eigen::VectorXd next = at + length * direction;
      if (has_ordered_criteria(next) && likelihood.value(next) >= value - precision) break;
      length *= 0.5;
    }
    if (length <= 1e-12) return std::nullopt;
    at += length * direction;
    if (at.cwiseAbs().maxCoeff() > kFarthest) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<RocPoint> roc_points(std::span<const RatingCount> ratings) {
  const RatingTotals totals = rating_totals_of(ratings);
  std::vector<RocPoint> points(ratings.size() - 1);
  double noise = 0.0;
  double signal = 0.0;
  for (std::size_t j = ratings.size() - 1; j > 0; --j) {
    noise += static_cast<double>(ratings[j].noise);
    signal += static_cast<double>(ratings[j].signal);
    points[j - 1] = {.false_alarm = noise / totals.noise, .hit = signal / totals.signal};
  }
  return points;
}

RocArea roc_area(std::span<const RatingCount> ratings) {
  const RatingTotals totals = rating_totals_of(ratings);
  // For each rating: the proportion of trials of the other kind below it (signal) or above it (noise), ties half.
  double noise_below = 0.0;
  double signal_above = totals.signal;
  double area = 0.0;
  double squares_of_signal = 0.0;
  double squares_of_noise = 0.0;
  for (const RatingCount& rating : ratings) {
    const auto noise = static_cast<double>(rating.noise);
    const auto signal = static_cast<double>(rating.signal);
    signal_above -= signal;
    const double of_signal = (noise_below + 0.5 * noise) / totals.noise;
    const double of_noise = (signal_above + 0.5 * signal) / totals.signal;
    noise_below += noise;
    area += signal * of_signal / totals.signal;
    squares_of_signal += signal * of_signal * of_signal;
    squares_of_noise += noise * of_noise * of_noise;
  }
  RocArea found{.area = area};
  const auto variance = [area](double squares, double n) {
    return std::max(0.0, squares - n * area * area) / (n - 1.0);
  };
  if (totals.signal > 1.0 && totals.noise > 1.0) {
    found.standard_error = std::sqrt(variance(squares_of_signal, totals.signal) / totals.signal +
                                     variance(squares_of_noise, totals.noise) / totals.noise);
  }
  const double q1 = area / (2.0 - area);
  const double q2 = 2.0 * area * area / (1.0 + area);
  found.hanley_error = std::sqrt((area * (1.0 - area) + (totals.signal - 1.0) * (q1 - area * area) +
                                  (totals.noise - 1.0) * (q2 - area * area)) /
                                 (totals.noise * totals.signal));
  return found;
}

double NormalRoc::d_a() const { return mean / std::sqrt(0.5 * (1.0 + deviation * deviation)); }

double NormalRoc::area() const { return normal_below(d_a() / std::numbers::sqrt2); }

std::optional<NormalRoc> fit_roc(std::span<const RatingCount> ratings, RocVariance variance) {
  rating_totals_of(ratings);
  std::vector<RatingCount> used{};
  for (const RatingCount& rating : ratings) {
    if (rating.noise + rating.signal > 0) used.push_back(rating);
  }
  if (used.size() < (variance == RocVariance::free ? 3U : 2U)) return std::nullopt;
  const std::optional<RocMaximum> maximum = maximum_of(RatingLikelihood(used, variance));
  if (!maximum) return std::nullopt;
  NormalRoc roc{.mean = maximum->at[0],
                .deviation = std::exp(maximum->at[1]),
                .mean_error = std::sqrt(maximum->covariance(0, 0)),
                .log_likelihood = maximum->value};
  if (variance == RocVariance::free) {
    roc.deviation_error = roc.deviation * std::sqrt(maximum->covariance(1, 1));
  }
  std::size_t place = 0;  // of the last rating in use
  bool has_used = false;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < ratings.size(); ++j) {
    const bool is_used = ratings[j].noise + ratings[j].signal > 0;
    // A criterion separates the ratings in use below it from those above it.
    const std::size_t below = has_used ? place + 1 : 0;
    if (j > 0) {
      roc.criteria.push_back(below == 0 ? -kInfinite
                             : below >= used.size()
                                 ? kInfinite
                                 : maximum->at[static_cast<Eigen::Index>(below) + 1]);
    }
    if (!is_used) continue;
    place = has_used ? place + 1 : 0;
    has_used = true;
  }
  return roc;
}

double saturated_roc(std::span<const RatingCount> ratings) {
  const RatingTotals totals = rating_totals_of(ratings);
  double sum = 0.0;
  const auto add = [&sum](std::uint64_t count, double total) {
    if (count > 0) sum += static_cast<double>(count) * std::log(static_cast<double>(count) / total);
  };
  for (const RatingCount& rating : ratings) {
    add(rating.noise, totals.noise);
    add(rating.signal, totals.signal);
  }
  return sum;
}

}  // namespace asperity
