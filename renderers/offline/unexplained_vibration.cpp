// Implements the comparison of a delivered force with its replay, line by line.

#include "renderers/offline/unexplained_vibration.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/spectrum.h"

namespace asperity {
namespace {

constexpr double kNeighbourhood_Hz = 40.0;
constexpr double kAllowance = 4.0;  // in medians of the neighbourhood

/// Powers of the lines of one window, all axes together, in N².
struct LinePowers {
  std::vector<double> delivered{};
  std::vector<double> explained{};
  std::vector<double> residual{};
};

/// Tapers windows and transforms them. The powers of all lines add up to the mean square of a steady signal.
class WindowSpectra final {
 public:
  WindowSpectra(const ExplainedForce& force, std::size_t length)
      : force_(force), taper_(length), scratch_(length) {
    double squares = 0.0;
    for (std::size_t i = 0; i < length; ++i) {
      const double phase =
          2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(length);
      taper_[i] = 0.5 - 0.5 * std::cos(phase);
      squares += taper_[i] * taper_[i];
    }
    per_line_ = 2.0 / (squares * static_cast<double>(length));
  }

  LinePowers at(std::size_t first) {
    const std::size_t lines = taper_.size() / 2 + 1;
    LinePowers powers{std::vector<double>(lines), std::vector<double>(lines),
                      std::vector<double>(lines)};
    for (int axis = 0; axis < 3; ++axis) {
      const auto delivered = transformed(force_.delivered_N, first, axis);
      const auto explained = transformed(force_.explained_N, first, axis);
      for (std::size_t k = 0; k < lines; ++k) {
        const bool has_no_mirror = k == 0 || 2 * k == taper_.size();
        const double scale = has_no_mirror ? 0.5 * per_line_ : per_line_;
        powers.delivered[k] += scale * std::norm(delivered[k]);
        powers.explained[k] += scale * std::norm(explained[k]);
        powers.residual[k] += scale * std::norm(delivered[k] - explained[k]);
      }
    }
    return powers;
  }

 private:
  std::vector<std::complex<double>> transformed(std::span<const glm::dvec3> force_N,
                                                std::size_t first, int axis) {
    const std::span<const glm::dvec3> window_N = force_N.subspan(first, taper_.size());
    double mean_N = 0.0;
    for (const glm::dvec3& each_N : window_N) mean_N += each_N[axis];
    mean_N /= static_cast<double>(taper_.size());
    for (std::size_t i = 0; i < taper_.size(); ++i) {
      scratch_[i] = taper_[i] * (window_N[i][axis] - mean_N);
    }
    return real_spectrum(scratch_);
  }

  const ExplainedForce& force_;
  std::vector<double> taper_{};
  std::vector<double> scratch_{};
  double per_line_ = 0.0;
};

double median_around(const std::vector<double>& powers, std::size_t line, std::size_t reach,
                     std::vector<double>& scratch) {
  const std::size_t first = line > reach ? line - reach : 0;
  const std::size_t end = std::min(powers.size(), line + reach + 1);
  scratch.assign(powers.begin() + static_cast<std::ptrdiff_t>(first),
                 powers.begin() + static_cast<std::ptrdiff_t>(end));
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return *middle;
}

/// The power of a window; of one with at most `greatest_N2`, possibly another number up to `greatest_N2`. Most windows have less
/// than an earlier one also without the allowance, and its medians take longer than all else.
double unexplained_power_N2(const LinePowers& powers, double spacing_Hz, double greatest_N2) {
  const auto reach = static_cast<std::size_t>(std::lround(kNeighbourhood_Hz / spacing_Hz));
  const auto lowest = static_cast<std::size_t>(std::ceil(kBuzzFrom_Hz / spacing_Hz - 1e-9));
  const auto excess_N2 = [&powers](std::size_t k) {
    const std::size_t after = std::min(k + 1, powers.explained.size() - 1);
    const double around =
        std::max({powers.explained[k - 1], powers.explained[k], powers.explained[after]});
    return powers.delivered[k] - around;
  };
  double most_N2 = 0.0;
  for (std::size_t k = lowest; k < powers.delivered.size(); ++k) {
    most_N2 += std::min(powers.residual[k], std::max(0.0, excess_N2(k)));
  }
  if (most_N2 <= greatest_N2) return most_N2;
  std::vector<double> scratch{};
  double sum_N2 = 0.0;
  for (std::size_t k = lowest; k < powers.delivered.size(); ++k) {
    const double excess = excess_N2(k);
    if (excess <= 0.0) continue;  // spares the median
    const double allowed = kAllowance * median_around(powers.explained, k, reach, scratch);
    sum_N2 += std::min(powers.residual[k], std::max(0.0, excess - allowed));
  }
  return sum_N2;
}

}  // namespace

std::optional<UnexplainedVibration> unexplained_vibration(const ExplainedForce& force) {
  if (!(force.rate_Hz > 2.0 * kBuzzFrom_Hz)) {
    throw std::invalid_argument("ExplainedForce::rate_Hz is " + number_text(force.rate_Hz) +
                                "; it must be above 300 Hz");
  }
  if (force.delivered_N.size() != force.explained_N.size()) {
    throw std::invalid_argument(
        "ExplainedForce: the numbers of samples of delivered_N and explained_N are " +
        std::to_string(force.delivered_N.size()) + " and " +
        std::to_string(force.explained_N.size()) + "; they must be equal");
  }
  const auto length = static_cast<std::size_t>(std::lround(kBuzzWindow_s * force.rate_Hz));
  const auto step = static_cast<std::size_t>(std::lround(kBuzzStep_s * force.rate_Hz));
  if (force.delivered_N.size() < length) return {};
  WindowSpectra spectra(force, length);
  const double spacing_Hz = force.rate_Hz / static_cast<double>(length);
  double greatest_N2 = -1.0;
  UnexplainedVibration greatest{};
  for (std::size_t first = 0; first + length <= force.delivered_N.size(); first += step) {
    const double power_N2 = unexplained_power_N2(spectra.at(first), spacing_Hz, greatest_N2);
    if (power_N2 <= greatest_N2) continue;
    greatest_N2 = power_N2;
    greatest = {.rms_N = std::sqrt(power_N2), .middle = first + length / 2};
  }
  return greatest;
}

}  // namespace asperity
