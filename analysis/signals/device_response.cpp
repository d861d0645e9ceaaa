// Least squares: mass over a grid of delays, resistance from sweeps up and down, sinusoids with offset and drift.

#include "analysis/signals/device_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include <Eigen/Dense>

namespace asperity {
namespace {

void require_equal(std::size_t one, std::size_t other) {
  if (one != other) {
    throw std::invalid_argument("time_s: the number of times is " + std::to_string(one) +
                                "; it must be the number of values, " + std::to_string(other));
  }
}

void require_equal(const ForcedMotion& leg) {
  require_equal(leg.time_s.size(), leg.position_m.size());
  require_equal(leg.time_s.size(), leg.force_N.size());
}

// One push with everything that does not depend on the delay: the integrals of the measured motion and of the
// force up to each tick. Positions are integrated by trapezoids; the force is constant from tick to tick.
struct IntegratedPush {
  const Push* push = nullptr;
  double steady_N = 0.0;  // the constant part of the resistance: K·x₀ + c ± F_c
  std::vector<double> moved_m_s{};
  std::vector<double> moved_m_s2{};
  std::vector<double> impulse_N_s{};
  std::vector<double> impulse_N_s2{};

  // The double integral of the force up to `s_s`, between ticks too.
  double force_integral_N_s2(double s_s) const noexcept {
    const std::vector<double>& t = push->time_s;
    const auto after = std::upper_bound(t.begin(), t.end(), s_s);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - t.begin(), 1)) - 1;
    const double rest_s = s_s - t[i];
    return impulse_N_s2[i] + impulse_N_s[i] * rest_s + 0.5 * push->force_N[i] * rest_s * rest_s;
  }
};

IntegratedPush integrated(const Push& push, const Resistance& resistance) {
  require_equal(push.time_s.size(), push.position_m.size());
  require_equal(push.time_s.size(), push.force_N.size());
  const std::size_t count = push.time_s.size();
  IntegratedPush one{.push = &push,
                     .steady_N = resistance.stiffness_N_per_m * push.rested_at_m +
                                 resistance.offset_N + push.direction * resistance.friction_N,
                     .moved_m_s = std::vector<double>(count),
                     .moved_m_s2 = std::vector<double>(count),
                     .impulse_N_s = std::vector<double>(count),
                     .impulse_N_s2 = std::vector<double>(count)};
  for (std::size_t i = 1; i < count; ++i) {
    const double dt_s = push.time_s[i] - push.time_s[i - 1];
    const double before_m = push.position_m[i - 1] - push.rested_at_m;
    const double now_m = push.position_m[i] - push.rested_at_m;
    one.moved_m_s[i] = one.moved_m_s[i - 1] + 0.5 * dt_s * (before_m + now_m);
    one.moved_m_s2[i] =
        one.moved_m_s2[i - 1] + 0.5 * dt_s * (one.moved_m_s[i - 1] + one.moved_m_s[i]);
    one.impulse_N_s[i] = one.impulse_N_s[i - 1] + dt_s * push.force_N[i - 1];
    one.impulse_N_s2[i] = one.impulse_N_s2[i - 1] + dt_s * one.impulse_N_s[i - 1] +
                          0.5 * dt_s * dt_s * push.force_N[i - 1];
  }
  return one;
}

struct MassFit {
  double mass_kg = 0.0;
  double left_m2 = 0.0;
};
// m·x = r by least squares over 1/m: 1/m = Σrx/Σr², with the residual Σx² − (Σrx)²/Σr². Before L nothing has
// moved: r is 0, and x is residual.
std::optional<MassFit> fit_mass(const std::vector<IntegratedPush>& pushes,
                                const Resistance& resistance, double delay_s) {
  double rr = 0.0;
  double rx = 0.0;
  double xx = 0.0;
  for (const IntegratedPush& one : pushes) {
    for (std::size_t i = 0; i < one.push->time_s.size(); ++i) {
      const double s_s = one.push->time_s[i] - delay_s;
      const double x_m = one.push->position_m[i] - one.push->rested_at_m;
      xx += x_m * x_m;
      if (s_s <= 0.0) continue;
      const double r = one.force_integral_N_s2(s_s) - 0.5 * one.steady_N * s_s * s_s -
                       resistance.damping_N_s_per_m(delay_s) * one.moved_m_s[i] -
                       resistance.stiffness_N_per_m * one.moved_m_s2[i];
      rr += r * r;
      rx += r * x_m;
    }
  }
  if (!(rx > 0.0)) return {};
  return MassFit{rr / rx, xx - rx * rx / rr};
}

// Slope of the line of least squares.
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

std::optional<PushResponse> push_response(const std::vector<Push>& pushes,
                                          const Resistance& resistance) {
  constexpr double kStep_s = 0.05e-3;
  constexpr std::size_t kFewest = 10;
  std::vector<IntegratedPush> all{};
  std::size_t readings = 0;
  double longest_s = 0.0;
  for (const Push& push : pushes) {
    if (push.time_s.empty()) continue;
    all.push_back(integrated(push, resistance));
    readings += push.time_s.size();
    longest_s = std::max(longest_s, push.time_s.back());
  }
  if (readings < kFewest) return {};
  std::optional<PushResponse> best{};
  double least_m2 = std::numeric_limits<double>::infinity();
  for (int step = 0; step * kStep_s <= 0.5 * longest_s; ++step) {
    const double delay_s = step * kStep_s;
    const auto fit = fit_mass(all, resistance, delay_s);
    if (!fit || !(fit->left_m2 < least_m2)) continue;
    least_m2 = fit->left_m2;
    best = PushResponse{delay_s, fit->mass_kg};
  }
  return best;
}

std::optional<SweepResponse> sweep_response(const std::vector<ForcedMotion>& legs) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double speeds = 0.0;
  int up = 0;
  int down = 0;
  for (const ForcedMotion& leg : legs) {
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
                       .stiffness_N_per_m = found(0),
                       .offset_N = found(1)};
}

std::optional<double> unevenness_m(const std::vector<ForcedMotion>& legs) {
  double squares_m2 = 0.0;
  std::size_t samples = 0;
  for (const ForcedMotion& leg : legs) {
    require_equal(leg);
    if (leg.time_s.size() < 3) continue;
    const auto n = static_cast<double>(leg.time_s.size());
    const double time_s = std::accumulate(leg.time_s.begin(), leg.time_s.end(), 0.0) / n;
    const double position_m =
        std::accumulate(leg.position_m.begin(), leg.position_m.end(), 0.0) / n;
    const double velocity_m_per_s = slope(leg.time_s, leg.position_m);
    for (std::size_t i = 0; i < leg.time_s.size(); ++i) {
      const double off_m =
          leg.position_m[i] - position_m - velocity_m_per_s * (leg.time_s[i] - time_s);
      squares_m2 += off_m * off_m;
    }
    samples += leg.time_s.size();
  }
  if (samples == 0) return {};
  return std::sqrt(squares_m2 / static_cast<double>(samples));
}

std::optional<Resistance> resistance_of(const SweepResponse& slow, const SweepResponse& fast) {
  const double between_m_per_s = fast.speed_m_per_s - slow.speed_m_per_s;
  if (!(std::abs(between_m_per_s) > 0.0)) return {};
  const double growth = (fast.resistance_N - slow.resistance_N) / between_m_per_s;
  return Resistance{.friction_N = std::max(0.0, slow.resistance_N - growth * slow.speed_m_per_s),
                    .growth_N_s_per_m = growth,
                    .stiffness_N_per_m = 0.5 * (slow.stiffness_N_per_m + fast.stiffness_N_per_m),
                    .offset_N = 0.5 * (slow.offset_N + fast.offset_N)};
}

std::optional<double> position_error_m(const std::vector<ForcedMotion>& legs) {
  constexpr int kCubic = 4;
  double squares = 0.0;
  std::size_t freedom = 0;
  for (const ForcedMotion& leg : legs) {
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

std::optional<FrequencyResponse> frequency_response(double frequency_Hz, const ForcedMotion& motion,
                                                    double least_force_N) {
  const auto moved = component_at(frequency_Hz, motion.time_s, motion.position_m);
  const auto pushed = component_at(frequency_Hz, motion.time_s, motion.force_N);
  if (!moved || !pushed || std::abs(*pushed) < least_force_N) return {};
  return FrequencyResponse{frequency_Hz, std::abs(*moved) / std::abs(*pushed)};
}

std::optional<double> resonance_Hz(const std::vector<FrequencyResponse>& responses) {
  if (responses.size() < 3) return {};
  std::vector<double> per_force(responses.size());  // ω²|X/F|
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

double rounding_error_m(double step_m) { return step_m / std::sqrt(12.0); }

double step_of_rounding_m(double error_m) { return std::sqrt(12.0) * error_m; }

bool is_swinging(std::span<const double> position_m, double step_m) {
  constexpr double kStill_m = 0.1e-3;
  if (position_m.empty()) return false;
  const auto [low, high] = std::minmax_element(position_m.begin(), position_m.end());
  return *high - *low > std::max(kStill_m, 4.0 * step_m);
}

double motion_without_friction_m(const HeldPush& push) {
  return push.force_N * std::min(0.5 * push.duration_s * push.duration_s / push.mass_kg,
                                 1.0 / push.stiffness_N_per_m);
}

std::optional<double> mean_motion_m(const PushTrain& train, const ForcedMotion& motion,
                                    double judged_s) {
  require_equal(motion.time_s.size(), motion.position_m.size());
  const auto mean_before_m = [&](double end_s) -> std::optional<double> {
    double sum_m = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < motion.time_s.size(); ++i) {
      if (motion.time_s[i] <= end_s - judged_s || motion.time_s[i] > end_s) continue;
      sum_m += motion.position_m[i];
      ++count;
    }
    if (count == 0) return {};
    return sum_m / static_cast<double>(count);
  };
  double sum_m = 0.0;
  int counted = 0;
  for (int number = 0; number < train.pushes; ++number) {
    const double begins_s = train.first_s + 2.0 * number * train.length_s;
    const auto before_m = mean_before_m(begins_s);
    const auto after_m = mean_before_m(begins_s + train.length_s);
    if (!before_m || !after_m) continue;
    sum_m += (number % 2 == 0 ? 1.0 : -1.0) * (*after_m - *before_m);
    ++counted;
  }
  if (counted == 0) return {};
  return sum_m / counted;
}

double four_standard_errors_m(double step_m, const MotionReadings& readings) {
  return rounding_error_m(step_m) * 4.0 / std::sqrt(0.5 * readings.each * readings.pushes);
}

}  // namespace asperity
