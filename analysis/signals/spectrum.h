// Spectra of records and of height samples.

#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// X_k = Σ x_n·exp(−2πi·k·n/N) for k = 0 … N/2, of any length N ≥ 1. Takes N·log N steps for every
/// N, primes included.
std::vector<std::complex<double>> real_spectrum(std::span<const double> signal);

/// The window 1/2 − cos(2πi/N)/2, i = 0 … N − 1, whose period is N.
std::vector<double> hann_window(std::size_t count);

/// A one-sided power spectral density, in the square of the signal's unit per hertz; line k stands
/// at k·spacing_Hz and the sum of all lines times the spacing is the mean square.
struct PowerSpectrum {
  double spacing_Hz = 0.0;
  std::vector<double> density{};
};

/// Both borders belong to the band.
struct FrequencyBand {
  double low_Hz = 0.0;
  double high_Hz = 0.0;
};

/// How Welch's method cuts a record: Hann windows, half overlapping, each less its own mean.
struct WelchWindows {
  double rate_Hz = 1000.0;
  std::size_t length = 256;  ///< samples in a window
};

/// Welch's average of windowed periodograms. A rest shorter than half a window is left out. Throws
/// std::invalid_argument when the signal is shorter than one window.
PowerSpectrum welch_spectrum(std::span<const double> signal, const WelchWindows& windows);

/// The mean square of the lines within the band: the sum of their density times the spacing.
double band_power(const PowerSpectrum& spectrum, const FrequencyBand& band) noexcept;

/// RMS of the part of a record that lies in low_Hz ≤ f ≤ high_Hz, by Parseval's theorem:
///
///   RMS² = Σ c_k·|X_k|² / N², over the lines f_k = k·rate/N in the band,
///
/// X the transform of the whole record less its mean, without a window; c_k = 2, but 1 at half the
/// rate. Line 0, which the mean leaves empty, never counts. The default band is the one in which
/// texture forces are made equal: at 1 kHz it reaches to half the rate and includes it.
///
/// This is a definition, not an estimate: exact for what is periodic in the record. Throws
/// std::invalid_argument for an empty signal, a rate that is not positive and a band that is not
/// 0 ≤ low_Hz ≤ high_Hz.
double band_rms(std::span<const double> signal, double rate_Hz, double low_Hz = 5.0,
                double high_Hz = 500.0);

/// Heights on a regular grid, row after row.
struct HeightSamples {
  std::span<const float> heights_m{};
  std::size_t rows = 0;
  std::size_t columns = 0;
  double pitch_m = 0.0;  ///< between neighbours, in both directions
};

/// The wavelength with the greatest power per logarithmic band, whatever its direction; nothing for
/// a plane.
///
/// The central part of up to 1024 × 1024 samples (the greatest lengths without a prime factor above
/// 5) less its least-squares plane, under a Hann window in both directions, is transformed in two
/// dimensions. The power of every line of the spectrum goes by its |f| to a third-octave band, the
/// first of which begins at a third of the shorter side (fewer waves are a shape, not a texture)
/// and the last of which ends at two samples. The answer is 1/f for the mean |f|, weighted with
/// power, of the band with the greatest power. White noise answers a wavelength near two samples:
/// a ring of the plane holds the more lines the wider it is.
///
/// Throws std::invalid_argument for fewer than 16 rows or columns, a size that is not rows ×
/// columns, a pitch that is not positive, and heights that are not finite.
std::optional<double> dominant_wavelength_m(const HeightSamples& samples);

}  // namespace asperity
