// Vibration models with known resonances, and third octaves of them, for the tests of vibration models.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/signals/line_spectrum.h"
#include "analysis/signals/spectrum.h"
#include "renderers/vibrations/vibration_models.h"

namespace asperity {

/// Two pairs of poles: at `peak_Hz` with `radius`, and at 220 Hz with a radius of 0.6.
struct Resonance {
  double speed_m_per_s = 0.06;
  double normal_N = 1.0;
  double peak_Hz = 80.0;
  double radius = 0.93;
  double variance_m2_per_s4 = 0.04;
};

inline VibrationModel resonant_model(const Resonance& resonance) {
  const auto angle = [](double frequency_Hz) {
    return 2.0 * std::numbers::pi * frequency_Hz / kVibrationRate_Hz;
  };
  const double p = 2.0 * resonance.radius * std::cos(angle(resonance.peak_Hz));
  const double q = -resonance.radius * resonance.radius;
  const double r = 1.2 * std::cos(angle(220.0));
  const double s = -0.36;
  // (1 − p·z⁻¹ − q·z⁻²)·(1 − r·z⁻¹ − s·z⁻²)
  const std::vector<double> coefficients{p + r, q + s - p * r, -(p * s + q * r), -q * s};
  return {.speed_m_per_s = resonance.speed_m_per_s,
          .normal_N = resonance.normal_N,
          .variance_m2_per_s4 = resonance.variance_m2_per_s4,
          .lines_rad = line_spectral_frequencies(coefficients)};
}

/// Speeds of 30 to 150 mm/s and forces of 0.5 to 2 N, the peaks at 1 Hz per mm/s: nine models, eight triangles.
inline VibrationModels resonant_models() {
  VibrationModels set{};
  for (const double speed_m_per_s : {0.03, 0.06, 0.15}) {
    for (const double normal_N : {0.5, 1.0, 2.0}) {
      set.models.push_back(resonant_model({.speed_m_per_s = speed_m_per_s,
                                           .normal_N = normal_N,
                                           .peak_Hz = 1000.0 * speed_m_per_s,
                                           .variance_m2_per_s4 = 0.4 * speed_m_per_s * normal_N}));
    }
  }
  return set;
}

inline constexpr double kThirdOctaves_Hz[] = {20.0,  25.0,  31.5,  40.0,  50.0,  63.0,  80.0,
                                              100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0};

inline FrequencyBand third_octave(double centre_Hz) {
  return {centre_Hz * std::pow(2.0, -1.0 / 6.0), centre_Hz * std::pow(2.0, 1.0 / 6.0)};
}

/// The mean square of a model in a third of an octave.
inline double third_of_model(const VibrationModel& model, double centre_Hz) {
  const FrequencyBand band = third_octave(centre_Hz);
  constexpr int kLines = 200;
  const double spacing_Hz = (band.high_Hz - band.low_Hz) / kLines;
  double sum = 0.0;
  for (int i = 0; i < kLines; ++i) {
    sum += spacing_Hz * acceleration_density(model, band.low_Hz + (i + 0.5) * spacing_Hz);
  }
  return sum;
}

/// The greatest difference of two models in third octaves from 20 to 400 Hz.
inline double largest_difference_dB(const VibrationModel& a, const VibrationModel& b) {
  double largest_dB = 0.0;
  for (const double centre_Hz : kThirdOctaves_Hz) {
    largest_dB = std::max(largest_dB, std::abs(10.0 * std::log10(third_of_model(a, centre_Hz) /
                                                                 third_of_model(b, centre_Hz))));
  }
  return largest_dB;
}

}  // namespace asperity
