#include "analysis/device_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <Eigen/Dense>

namespace asperity {
namespace {

void require_equal(std::size_t one, std::size_t other) {
  if (one != other) {
    throw std::invalid_argument("times and values have to be equally many, and there are " +
                                std::to_string(one) + " and " + std::to_string(other));
  }
}

void require_equal(const SweepLeg& leg) {
  require_equal(leg.time_s.size(), leg.position_m.size());
  require_equal(leg.time_s.size(), leg.force_N.size());
}

constexpr int kPowers = 5;  // τ² to τ⁶

/// The fit of one delay: how much it leaves, and its a₂ in units of the longest time.
struct DelayFit {
  double left = 0.0;
  double square = 0.0;
};
DelayFit fit_with_delay(double delay_s, double longest_s, std::span<const double> time_s,
                        std::span<const double> moved_m) {
  using Normal = Eigen::Matrix<double, kPowers, kPowers>;
  using Powers = Eigen::Matrix<double, kPowers, 1>;
  Normal normal = Normal::Zero();
  Powers right = Powers::Zero();
  double squares = 0.0;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (time_s[i] < 0.0) continue;
    squares += moved_m[i] * moved_m[i];
    const double tau = (time_s[i] - delay_s) / longest_s;
    if (tau <= 0.0) continue;
    Powers powers;
    powers(0) = tau * tau;
    for (int power = 1; power < kPowers; ++power) powers(power) = powers(power - 1) * tau;
    normal += powers * powers.transpose();
    right += powers * moved_m[i];
  }
  const Powers found = normal.ldlt().solve(right);
  return {squares - right.dot(found), found(0)};
}

/// Slope of the straight line that fits best.
double slope(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double above = 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    above += (x[i] - x_mean) * (y[i] - y_mean);
    below += (x[i] - x_mean) * (x[i] - x_mean);
  }
  return below > 0.0 ? above / below : 0.0;
}

}  // namespace

std::optional<PushResponse> push_response(std::span<const double> since_push_s,
                                          std::span<const double> moved_m) {
  require_equal(since_push_s.size(), moved_m.size());
  constexpr double kStep_s = 0.05e-3;
  constexpr std::size_t kFewest = 10;
  if (since_push_s.size() < kFewest) return {};
  const double longest_s = *std::max_element(since_push_s.begin(), since_push_s.end());
  if (!(longest_s > 0.0)) return {};
  PushResponse best{};
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step * kStep_s <= 0.5 * longest_s; ++step) {
    const double delay_s = step * kStep_s;
    const DelayFit fit = fit_with_delay(delay_s, longest_s, since_push_s, moved_m);
    if (!(fit.left < least)) continue;
    least = fit.left;
    best = {delay_s, 2.0 * fit.square / (longest_s * longest_s)};
  }
  if (!(best.acceleration_m_per_s2 > 0.0)) return {};
  return best;
}

std::optional<SweepResponse> sweep_response(const std::vector<SweepLeg>& legs) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double speeds = 0.0;
  int up = 0;
  int down = 0;
  for (const SweepLeg& leg : legs) {
    require_equal(leg);
    if (leg.time_s.size() < 2) continue;
    const double velocity_m_per_s = slope(leg.time_s, leg.position_m);
    if (velocity_m_per_s == 0.0) return {};
    (velocity_m_per_s > 0.0 ? up : down) += 1;
    speeds += std::abs(velocity_m_per_s);
    for (std::size_t i = 0; i < leg.time_s.size(); ++i) {
      const Eigen::Vector3d row(leg.position_m[i], 1.0, velocity_m_per_s > 0.0 ? 1.0 : -1.0);
      normal += row * row.transpose();
      right += row * leg.force_N[i];
    }
  }
  if (up == 0 || down == 0) return {};
  const Eigen::Vector3d found = normal.ldlt().solve(right);
  return SweepResponse{.speed_m_per_s = speeds / (up + down),
                       .resistance_N = found(2),
                       .stiffness_N_per_m = found(0)};
}

std::optional<Resistance> resistance_of(const SweepResponse& slow, const SweepResponse& fast,
                                        double delay_s) {
  const double between_m_per_s = fast.speed_m_per_s - slow.speed_m_per_s;
  if (!(std::abs(between_m_per_s) > 0.0)) return {};
  const double growth = (fast.resistance_N - slow.resistance_N) / between_m_per_s;
  const double stiffness_N_per_m = 0.5 * (slow.stiffness_N_per_m + fast.stiffness_N_per_m);
  return Resistance{.friction_N = std::max(0.0, slow.resistance_N - growth * slow.speed_m_per_s),
                    .damping_N_s_per_m = growth - std::max(0.0, stiffness_N_per_m) * delay_s};
}

std::optional<double> position_error_m(const std::vector<SweepLeg>& legs) {
  constexpr int kCubic = 4;
  double squares = 0.0;
  std::size_t freedom = 0;
  for (const SweepLeg& leg : legs) {
    require_equal(leg);
    for (std::size_t begin = 0; begin + kSmoothWindow <= leg.time_s.size();
         begin += kSmoothWindow) {
      const double first_s = leg.time_s[begin];
      const double lasts_s = leg.time_s[begin + kSmoothWindow - 1] - first_s;
      if (!(lasts_s > 0.0)) continue;
      Eigen::Matrix<double, kSmoothWindow, kCubic> powers;
      Eigen::Matrix<double, kSmoothWindow, 1> moved;
      for (std::size_t i = 0; i < kSmoothWindow; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double u = 2.0 * (leg.time_s[begin + i] - first_s) / lasts_s - 1.0;
        powers.row(row) << 1.0, u, u * u, u * u * u;
        moved(row) = leg.position_m[begin + i] - leg.position_m[begin];
      }
      const Eigen::Matrix<double, kCubic, 1> found = powers.colPivHouseholderQr().solve(moved);
      squares += (moved - powers * found).squaredNorm();
      freedom += kSmoothWindow - kCubic;
    }
  }
  if (freedom == 0) return {};
  return std::sqrt(squares / static_cast<double>(freedom));
}

std::optional<std::complex<double>> component_at(double frequency_Hz,
                                                 std::span<const double> time_s,
                                                 std::span<const double> values) {
  require_equal(time_s.size(), values.size());
  constexpr std::size_t kFewest = 8;
  if (time_s.size() < kFewest) return {};
  const double omega = 2.0 * std::numbers::pi * frequency_Hz;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const double lasts_s = time_s.back() - time_s.front();
  if (!(lasts_s > 0.0)) return {};
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double t_s = time_s[i] - time_s.front();
    const Eigen::Vector4d row(std::cos(omega * t_s), -std::sin(omega * t_s), 1.0, t_s / lasts_s);
    normal += row * row.transpose();
    right += row * (values[i] - values.front());
  }
  const Eigen::Vector4d found = normal.ldlt().solve(right);
  return std::complex<double>(found(0), found(1));
}

std::optional<double> resonance_Hz(const std::vector<FrequencyResponse>& responses) {
  if (responses.size() < 3) return {};
  std::vector<double> per_force(responses.size());  // ω²|X/F|: 1/m of a mass alone
  std::transform(responses.begin(), responses.end(), per_force.begin(), [](const auto& one) {
    const double omega = 2.0 * std::numbers::pi * one.frequency_Hz;
    return omega * omega * one.response_m_per_N;
  });
  const auto peak = static_cast<std::size_t>(std::max_element(per_force.begin(), per_force.end()) -
                                             per_force.begin());
  std::vector<double> sorted = per_force;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  if (peak == 0 || peak + 1 == responses.size()) return {};
  if (per_force[peak] < 2.0 * sorted[sorted.size() / 2]) return {};
  // The top of the parabola through the three highest, over the logarithm of frequency.
  const auto log_f = [&](std::size_t i) { return std::log(responses[i].frequency_Hz); };
  const double left = log_f(peak - 1) - log_f(peak);
  const double right = log_f(peak + 1) - log_f(peak);
  const double left_rise = (per_force[peak - 1] - per_force[peak]) / left;
  const double right_rise = (per_force[peak + 1] - per_force[peak]) / right;
  const double curvature = (right_rise - left_rise) / (right - left);
  const double at_peak = left_rise - curvature * left;
  const double offset =
      curvature < 0.0 ? std::clamp(-at_peak / (2.0 * curvature), left, right) : 0.0;
  return std::exp(log_f(peak) + offset);
}

}  // namespace asperity
