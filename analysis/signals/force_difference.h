// How much two forces on the same motion differ: in all, at most, and in bands of frequency.

#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace asperity {

/// Nine bands of vibration. In [Balasubramanian 2026] the energy in nine critical bands predicted best how alike a rendered
/// and a real texture feel. The borders are a choice of ours: preferred frequencies at ratios of 10^(1/5), two thirds of an
/// octave, up to half the rate of a servo loop of 1 kHz. The border at 50 Hz is that between the channels FA1 and FA2
/// (RecordRoughness); four bands are below it and five above.
///
/// [Balasubramanian 2026] Balasubramanian, Vardar: Perceptually lossless tactile texture synthesis with compact spectral
/// envelope models.
inline constexpr std::size_t kCriticalBands = 9;

/// kCriticalBands + 1 of them, lowest first: 8, 12.5, 20, 31.5, 50, 80, 125, 200, 315 and 500 Hz. A border belongs to the
/// band above it, and 500 Hz to the last one.
std::span<const double> critical_band_borders_Hz() noexcept;

/// The components of a force, sample by sample; all spans have the same length.
struct ForceSamples {
  std::span<const double> x_N{};
  std::span<const double> y_N{};
  std::span<const double> z_N{};
};

/// Integrals over time of the square of a force vector.
struct ForceEnergy {
  double total_N2_s = 0.0;  ///< at all frequencies, the mean included
  std::array<double, kCriticalBands> bands_N2_s{};
};

/// Two forces, `recorded` and `compared`, and their difference. Sums: those of several stretches are added.
struct ForceDifference {
  std::size_t samples = 0;
  double duration_s = 0.0;  ///< samples / rate
  ForceEnergy recorded{};
  ForceEnergy compared{};
  ForceEnergy difference{};
  double largest_N = 0.0;  ///< the longest vector of the difference

  /// √(E / duration), a force vector's length in the quadratic mean; 0 without samples.
  double rms_N(const ForceEnergy& energy) const noexcept;
  void add(const ForceDifference& other) noexcept;
};

/// Compares two forces that were sampled at the same moments, without a gap.
///
///   E = Σ_n |F_n|²·Δt,   E_band = Σ_k c_k·|X_k|²·Δt / N   over the lines f_k = k·rate/N in the band,
///
/// X the transform of the whole record without a window, the three components added; c_k = 2, but 1 at half the rate. By
/// Parseval's theorem the bands are disjoint parts of E; what is missing is the mean and what lies outside 8 to 500 Hz.
/// Exact for what is periodic in the record. Equal forces have a difference of exactly 0.
///
/// Errors: std::invalid_argument for spans of different lengths and a rate that is not positive.
ForceDifference force_difference(const ForceSamples& recorded, const ForceSamples& compared,
                                 double rate_Hz);

}  // namespace asperity
