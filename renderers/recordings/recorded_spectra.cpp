// Implements the spectra of a recorded texture.

#include "renderers/recordings/recorded_spectra.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <span>

#include "analysis/signals/spectrum.h"

namespace asperity {
namespace {

constexpr double kHighest = 0.45;  // of the sampling rate: what anti-aliasing filters leave
constexpr double kSameSpeed = 1.1;
constexpr std::size_t kMostLines = 4096;  // more would need tables that no cache holds
constexpr double kSmallest_N = 1e-12;     // of which a logarithm is taken

// Adds the mean square of each band (k ± ½)·spacing, times a weight.
void add_powers(const EvenStroke& stroke, double spacing, double weight, std::span<double> power) {
  const std::vector<std::complex<double>> spectrum = real_spectrum(stroke.force);
  const auto count = static_cast<double>(stroke.force.size());
  const double width = 1.0 / stroke.length();
  for (std::size_t j = 1; j < spectrum.size(); ++j) {
    const double sides = 2 * j == stroke.force.size() ? 1.0 : 2.0;
    const double line = sides * std::norm(spectrum[j]) / (count * count);
    const double low = (static_cast<double>(j) - 0.5) * width / spacing + 0.5;
    const double high = (static_cast<double>(j) + 0.5) * width / spacing + 0.5;
    // Band k is [k, k + 1) on this scale; k = 1 is power[0].
    for (auto k = static_cast<std::size_t>(low); static_cast<double>(k) < high; ++k) {
      if (k < 1 || k > power.size()) continue;
      const double part =
          std::min(high, static_cast<double>(k + 1)) - std::max(low, static_cast<double>(k));
      power[k - 1] += weight * line * part / (high - low);
    }
  }
}

}  // namespace

RecordedSpectra::RecordedSpectra(const TextureRecording& recording, SpectrumAxis axis,
                                 double force_exponent) {
  require_strokes(recording, "the recorded texture");
  std::vector<EvenStroke> strokes{};
  double shortest = std::numeric_limits<double>::infinity();
  double highest = 0.0;
  for (const RecordedStroke& stroke : recording.strokes) {
    strokes.push_back(even_stroke(stroke, axis, force_exponent));
    shortest = std::min(shortest, strokes.back().length());
    highest = std::max(highest, kHighest / strokes.back().step);
  }
  // The resolution that all strokes have: a wave is then in the same line at every speed.
  spacing_ = std::max(1.0 / shortest, highest / static_cast<double>(kMostLines));
  lines_ = static_cast<std::size_t>(highest / spacing_);
  std::sort(strokes.begin(), strokes.end(), [](const EvenStroke& a, const EvenStroke& b) {
    return a.speed_m_per_s < b.speed_m_per_s;
  });
  for (std::size_t from = 0; from < strokes.size();) {
    std::size_t to = from;
    double length = 0.0;
    double speed_m_per_s = 0.0;
    double shortest_of_speed = strokes[from].length();
    double coarsest = strokes[from].step;
    for (; to < strokes.size() &&
           strokes[to].speed_m_per_s < kSameSpeed * strokes[from].speed_m_per_s;
         ++to) {
      length += strokes[to].length();
      speed_m_per_s += strokes[to].length() * strokes[to].speed_m_per_s;
      shortest_of_speed = std::min(shortest_of_speed, strokes[to].length());
      coarsest = std::max(coarsest, strokes[to].step);
    }
    Speed speed{.amplitude = std::vector<double>(lines_, 0.0)};
    for (; from < to; ++from) {
      add_powers(strokes[from], spacing_, strokes[from].length() / length, speed.amplitude);
    }
    for (double& amplitude : speed.amplitude) amplitude = std::sqrt(2.0 * amplitude);
    // Line k = i + 1 covers (i + ½ … i + 3/2)·spacing.
    speed.first = static_cast<std::size_t>(
        std::max(0.0, std::ceil(0.5 / (shortest_of_speed * spacing_) - 0.5 - 1e-9)));
    speed.end = std::min(lines_, static_cast<std::size_t>(kHighest / (coarsest * spacing_) + 1e-9));
    std::fill_n(speed.amplitude.begin(), std::min(speed.first, lines_), 0.0);
    std::fill(speed.amplitude.begin() + static_cast<std::ptrdiff_t>(speed.end),
              speed.amplitude.end(), 0.0);
    speeds_.push_back(std::move(speed));
    speeds_m_per_s_.push_back(speed_m_per_s / length);
  }
}

std::vector<double> RecordedSpectra::amplitudes_at(double speed_m_per_s) const {
  std::vector<double> amplitudes(lines_, 0.0);
  for (std::size_t line = 0; line < lines_; ++line) {
    const Speed* below = nullptr;
    const Speed* above = nullptr;
    double slower_m_per_s = 0.0;
    double faster_m_per_s = 0.0;
    for (std::size_t i = 0; i < speeds_.size() && above == nullptr; ++i) {
      if (line < speeds_[i].first || line >= speeds_[i].end) continue;
      if (speeds_m_per_s_[i] <= speed_m_per_s) {
        below = &speeds_[i];
        slower_m_per_s = speeds_m_per_s_[i];
      } else {
        above = &speeds_[i];
        faster_m_per_s = speeds_m_per_s_[i];
      }
    }
    if (below == nullptr && above == nullptr) continue;
    if (below == nullptr || above == nullptr) {
      amplitudes[line] = (below == nullptr ? above : below)->amplitude[line];
      continue;
    }
    const double part =
        std::log(speed_m_per_s / slower_m_per_s) / std::log(faster_m_per_s / slower_m_per_s);
    amplitudes[line] =
        std::exp((1.0 - part) * std::log(std::max(kSmallest_N, below->amplitude[line])) +
                 part * std::log(std::max(kSmallest_N, above->amplitude[line])));
  }
  return amplitudes;
}

double RecordedSpectra::band() const noexcept {
  constexpr double kPart = 0.99;
  double total = 0.0;
  for (const Speed& speed : speeds_) {
    for (const double amplitude : speed.amplitude) total += amplitude * amplitude;
  }
  double so_far = 0.0;
  for (std::size_t line = 0; line < lines_; ++line) {
    for (const Speed& speed : speeds_) so_far += speed.amplitude[line] * speed.amplitude[line];
    if (so_far >= kPart * total) return spacing_ * static_cast<double>(line + 1);
  }
  return spacing_ * static_cast<double>(lines_);
}

}  // namespace asperity
