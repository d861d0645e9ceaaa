// What a force record feels like, in a few numbers.

#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace asperity {

/// A stretch of contact, sample by sample; all spans have the same length.
struct FeltForce {
  std::span<const double> time_s{};
  std::span<const double> travel_m{};  ///< distance travelled along the surface since the start
  std::span<const double> normal_N{};
  std::span<const double> lateral_N{};  ///< along the motion, positive against it
};

inline constexpr std::size_t kFeatureBands = 10;

/// Spectrum, size and roughness of a force record: what an observer, a report and a sweep look at.
///
/// The spectrum is over travelled distance, so that it belongs to the surface and not to the speed
/// of the hand: the RMS of the normal force (its mean and slow drift removed) in logarithmic bands
/// of wavelength, as a fraction of the mean normal force, in natural logarithm.
struct ForceFeatures {
  std::array<double, kFeatureBands>
      spectrum{};     ///< ln(band RMS / mean normal force), floor ln(1e-4)
  double size = 0.0;  ///< ln(RMS of the texture force / mean normal force), same floor
  double roughness =
      0.0;  ///< ln(RMS of the lateral force about its mean / mean normal force), same floor
};

/// Wavelengths in metres at the borders of the bands, longest first: kFeatureBands + 1 of them.
std::span<const double> feature_band_borders_m() noexcept;

/// Features of the samples in contact. With less than a few strokes' worth of contact every feature
/// is at its floor.
ForceFeatures force_features(const FeltForce& felt);

/// Euclidean distance, each spectral band weighted 1/kFeatureBands, size and roughness 1.
double squared_distance(const ForceFeatures& a, const ForceFeatures& b) noexcept;

}  // namespace asperity
