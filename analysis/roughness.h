// How rough a record of force or acceleration is, and a record of heights.

#pragma once

#include <optional>
#include <span>

namespace asperity {

/// Measures of one record; `unit` stands for the record's unit.
///
/// The two bands quote the fast-adapting channels of touch, FA1 (5–50 Hz) and FA2 (50–500 Hz):
/// which of them says more depends on the surface, so both are given. A line at 50 Hz counts as
/// FA2. Powers are mean squares of the record less its mean, as in `band_rms`.
///
/// The Pacinian power weighs each line of the spectrum by the threshold of detection, here of the
/// analytic shape T(f) = T₀·(250 Hz/f)² below 250 Hz and T₀·(f/250 Hz)² above, T₀ = 0.1 µm of
/// displacement. A displacement A at f has the acceleration (2πf)²·A, so up to 250 Hz the threshold
/// is one acceleration, a₀ = (2π·250 Hz)²·0.1 µm = 0.2467 m/s², and above it grows as f⁴:
///
///   P_w = Σ 2·(a_f,rms / a_T(f))²,  a_T = a₀ for f ≤ 250 Hz, a₀·(f/250 Hz)⁴ above,
///
/// with amplitude A = √2·rms as thresholds are quoted for amplitudes. P_w = 1 is one sinusoid at
/// threshold. Lines below 40 Hz, where other channels take over, are not counted.
///
/// The maximum depends on outliers and on the time step; it is never reported alone.
struct RecordRoughness {
  double rms = 0.0;        ///< unit; of the record less its mean
  double fa1_power = 0.0;  ///< unit²; 5 Hz ≤ f < 50 Hz
  double fa2_power = 0.0;  ///< unit²; 50 Hz ≤ f ≤ 500 Hz
  double maximum = 0.0;    ///< unit; the greatest absolute value of the record less its mean
};

/// Throws std::invalid_argument for an empty record and a rate that is not positive.
RecordRoughness record_roughness(std::span<const double> record, double rate_Hz);

/// 20·log₁₀(RMS(LP₃₀₀(a)) / 0.2467 m/s²), in decibels over threshold: LP₃₀₀ the forward
/// fourth-order Butterworth low-pass at 300 Hz of the acceleration less its mean, the first 10 ms
/// of its output (where it wakes) left out. Nothing for a record without power. Throws
/// std::invalid_argument for a rate of 600 Hz or less and a record of 10 ms or less.
std::optional<double> acceleration_roughness_dB(std::span<const double> acceleration_m_per_s2,
                                                double rate_Hz);

/// P_w, as above. Throws std::invalid_argument for an empty record and a rate that is not positive.
double pacinian_power(std::span<const double> acceleration_m_per_s2, double rate_Hz);

/// Amplitude parameters of heights about their mean (ISO 25178-2, without a filter of its own).
struct HeightRoughness {
  double Sa_m = 0.0;  ///< mean absolute height
  double Sq_m = 0.0;  ///< root mean square height
  double Ssk = 0.0;   ///< Σz³/(n·Sq³): negative for a plateau with pits
  double Sku = 0.0;   ///< Σz⁴/(n·Sq⁴): 3 for normally distributed heights, 1.5 for a sinusoid
};

/// Ssk and Sku of a plane are undefined; a plane answers nothing. Throws std::invalid_argument for
/// no heights.
std::optional<HeightRoughness> height_roughness(std::span<const float> heights_m);

}  // namespace asperity
