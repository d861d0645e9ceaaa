// Butterworth filters from their poles: prototype, band, bilinear transform, sections.

#include "analysis/signals/filters.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

using Complex = std::complex<double>;

void refuse(int order, std::span<const double> cutoffs_Hz, double rate_Hz) {
  if (order < 1 || order > 8) {
    throw std::invalid_argument("order is " + std::to_string(order) +
                                "; it must be a whole number from 1 to 8");
  }
  double below_Hz = 0.0;
  for (const double cutoff_Hz : cutoffs_Hz) {
    if (!(cutoff_Hz > below_Hz && cutoff_Hz < 0.5 * rate_Hz)) {
      throw std::invalid_argument("cut-off is " + number_text(cutoff_Hz) +
                                  " Hz with a sampling rate of " + number_text(rate_Hz) +
                                  " Hz; it must lie between " + number_text(below_Hz) +
                                  " Hz and half the sampling rate");
    }
    below_Hz = cutoff_Hz;
  }
}

// The frequency of the analogue filter that the bilinear transform s = (z − 1)/(z + 1) puts there.
double warped(double frequency_Hz, double rate_Hz) {
  return std::tan(std::numbers::pi * frequency_Hz / rate_Hz);
}

Complex digital(Complex s) { return (1.0 + s) / (1.0 - s); }

// Poles of the prototype of cut-off 1 in the upper half plane; for odd orders, −1 is the last.
std::vector<Complex> prototype_poles(int order) {
  std::vector<Complex> poles;
  for (int k = 0; k < order / 2; ++k) {
    poles.push_back(std::polar(1.0, std::numbers::pi * (2.0 * k + order + 1.0) / (2.0 * order)));
  }
  if (order % 2 == 1) {
    poles.emplace_back(-1.0, 0.0);
  }
  return poles;
}

}  // namespace

// Two poles (or one) and two zeros (or one) in the z plane, and where the gain of the section is 1.
struct ButterworthFilter::Prototype {
  struct Pair {
    Complex first{};
    Complex second{};
    bool single = false;
  };
  std::vector<Pair> poles{};
  std::array<double, 2> zeros{};
  Complex unit_gain_at{};
};

void ButterworthFilter::build(const Prototype& prototype) {
  const Complex z = prototype.unit_gain_at;
  for (const Prototype::Pair& pair : prototype.poles) {
    Section section;
    if (pair.single) {
      section.b = {1.0, -prototype.zeros[0], 0.0};
      section.a = {-pair.first.real(), 0.0};
    } else {
      section.b = {1.0, -(prototype.zeros[0] + prototype.zeros[1]),
                   prototype.zeros[0] * prototype.zeros[1]};
      section.a = {-(pair.first + pair.second).real(), (pair.first * pair.second).real()};
    }
    const Complex above = section.b[0] + section.b[1] / z + section.b[2] / (z * z);
    const Complex below = 1.0 + section.a[0] / z + section.a[1] / (z * z);
    const double scale = std::abs(below) / std::abs(above);
    for (double& b : section.b) {
      b *= scale;
    }
    sections_.push_back(section);
  }
}

ButterworthFilter::ButterworthFilter(const LowPass& band, double rate_Hz) : rate_Hz_(rate_Hz) {
  refuse(band.order, std::array{band.cutoff_Hz}, rate_Hz);
  const double cutoff = warped(band.cutoff_Hz, rate_Hz);
  Prototype moved{.poles = {}, .zeros = {-1.0, -1.0}, .unit_gain_at = 1.0};
  for (const Complex pole : prototype_poles(band.order)) {
    const Complex z = digital(cutoff * pole);
    moved.poles.push_back({z, std::conj(z), pole.imag() == 0.0});
  }
  build(moved);
}

ButterworthFilter::ButterworthFilter(const HighPass& band, double rate_Hz) : rate_Hz_(rate_Hz) {
  refuse(band.order, std::array{band.cutoff_Hz}, rate_Hz);
  const double cutoff = warped(band.cutoff_Hz, rate_Hz);
  Prototype moved{.poles = {}, .zeros = {1.0, 1.0}, .unit_gain_at = -1.0};
  for (const Complex pole : prototype_poles(band.order)) {
    const Complex z = digital(cutoff / pole);
    moved.poles.push_back({z, std::conj(z), pole.imag() == 0.0});
  }
  build(moved);
}

ButterworthFilter::ButterworthFilter(const BandPass& band, double rate_Hz) : rate_Hz_(rate_Hz) {
  refuse(band.order, std::array{band.low_Hz, band.high_Hz}, rate_Hz);
  const double low = warped(band.low_Hz, rate_Hz);
  const double high = warped(band.high_Hz, rate_Hz);
  // Each pole p becomes the two roots of s² − p·(high − low)·s + low·high.
  Prototype moved{.poles = {},
                  .zeros = {1.0, -1.0},
                  .unit_gain_at = digital(Complex(0.0, std::sqrt(low * high)))};
  for (const Complex pole : prototype_poles(band.order)) {
    const Complex half = 0.5 * (high - low) * pole;
    const Complex root = std::sqrt(half * half - low * high);
    const Complex first = digital(half + root);
    const Complex second = digital(half - root);
    if (pole.imag() == 0.0) {
      moved.poles.push_back({first, second});
    } else {
      moved.poles.push_back({first, std::conj(first)});
      moved.poles.push_back({second, std::conj(second)});
    }
  }
  build(moved);
}

double ButterworthFilter::next(double sample) noexcept {
  for (Section& section : sections_) {
    const double out = section.b[0] * sample + section.state[0];
    section.state[0] = section.b[1] * sample - section.a[0] * out + section.state[1];
    section.state[1] = section.b[2] * sample - section.a[1] * out;
    sample = out;
  }
  return sample;
}

void ButterworthFilter::reset() noexcept {
  for (Section& section : sections_) {
    section.state = {};
  }
}

double ButterworthFilter::gain(double frequency_Hz) const noexcept {
  const Complex delay = std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz / rate_Hz_);
  double gain = 1.0;
  for (const Section& section : sections_) {
    const Complex above = section.b[0] + delay * (section.b[1] + delay * section.b[2]);
    const Complex below = 1.0 + delay * (section.a[0] + delay * section.a[1]);
    gain *= std::abs(above) / std::abs(below);
  }
  return gain;
}

std::vector<double> filtered(ButterworthFilter filter, std::span<const double> signal) {
  filter.reset();
  std::vector<double> out;
  out.reserve(signal.size());
  for (const double sample : signal) {
    out.push_back(filter.next(sample));
  }
  return out;
}

std::vector<double> filtered_without_delay(const LowPass& band, double rate_Hz,
                                           std::span<const double> signal) {
  ButterworthFilter filter(band, rate_Hz);
  if (signal.empty()) return {};
  const std::size_t last = signal.size() - 1;
  const std::size_t margin =
      std::min(last, static_cast<std::size_t>(std::ceil(rate_Hz / band.cutoff_Hz)));
  std::vector<double> extended;
  extended.reserve(signal.size() + 2 * margin);
  for (std::size_t i = margin; i > 0; --i) extended.push_back(2.0 * signal[0] - signal[i]);
  extended.insert(extended.end(), signal.begin(), signal.end());
  for (std::size_t i = 1; i <= margin; ++i) {
    extended.push_back(2.0 * signal[last] - signal[last - i]);
  }
  // A filter that starts at rest starts at 0: each pass is about the value with which it begins.
  for (int pass = 0; pass < 2; ++pass) {
    filter.reset();
    const double rest = extended.front();
    for (double& value : extended) value = rest + filter.next(value - rest);
    std::reverse(extended.begin(), extended.end());
  }
  const auto first = extended.begin() + static_cast<std::ptrdiff_t>(margin);
  return {first, first + static_cast<std::ptrdiff_t>(signal.size())};
}

}  // namespace asperity
