// What a force record feels like, in a few numbers.

#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace asperity {

/// The samples in contact of one or more stretches of contact; all spans have the same length.
/// What was sampled in the air is left out: where time jumps by more than kLift_s, the hand had
/// left the surface. `time_s` and `travel_m` never decrease; to and fro both add to the travel.
struct FeltForce {
  std::span<const double> time_s{};
  std::span<const double> travel_m{};  ///< distance travelled along the surface since the start
  std::span<const double> normal_N{};
  std::span<const double> lateral_N{};  ///< along the motion, positive against it
};

inline constexpr std::size_t kFeatureBands = 10;
/// What is felt of a force r times the mean normal force is √(r² + kFeltRatio²): 2 mN on 1 N. That
/// is what 4 µm of relief do on 500 N/m; a fingertip hardly notices less, while the logarithm of
/// such a force would make much of a camera's noise and of the device's steps.
inline constexpr double kFeltRatio = 2e-3;
/// A pause in the samples longer than this is a lift; a shorter one is a lost sample.
inline constexpr double kLift_s = 0.020;

/// Spectrum, size and roughness of a force record: what an observer, a report and a sweep look at.
///
/// The spectrum is over travelled distance, so that it belongs to the surface and not to the speed
/// of the hand: the RMS of the normal force (its mean and slow drift removed) in logarithmic bands
/// of wavelength, as a fraction of the mean normal force, in natural logarithm with a soft floor
/// (kFeltRatio). Roughness is the same of the lateral force, in all bands together: the hand's own
/// drift, which friction passes on to it, lies in longer waves and is no part of it.
///
/// How it is made: of every unbroken contact the first and last 0.1 s are dropped (landing and
/// lifting are the hand's, not the surface's). Force as a function of travel, straight between
/// samples, is averaged over cells of 0.1 mm, which makes nothing of a hand that stands still. From
/// windows of 256 cells (25.6 mm), half overlapping, the straight line of least squares is removed,
/// each is weighted by a Hann window, and their power spectra are averaged. A spectral line counts
/// for the bands in proportion to where its width of 1/25.6 mm lies. The average over a cell and
/// the line between samples weaken the shortest band, by about 1 dB in slow strokes; a hand faster
/// than half a wavelength per sample shows nothing of it.
///
/// Contacts shorter than a window are left out; with fewer than three windows in all, which is 51.2
/// mm of one contact, there is nothing to judge and every feature is at its floor, ln kFeltRatio.
struct ForceFeatures {
  std::array<double, kFeatureBands> spectrum{};  ///< ln(band RMS / mean normal force)
  double size = 0.0;                             ///< likewise, in all bands together
  double roughness = 0.0;  ///< ln(RMS of the lateral force in all bands / mean normal force)
  /// RMS acceleration of a held tool that the force shakes. Of a recorded hand
  /// (recorded_force_features) and not of a FeltForce; 0 where there was nothing to judge.
  double shaking_m_per_s2 = 0.0;
  /// Mean depth of the probe in the surface over the mean normal force, of a recorded hand likewise; 0 without contact.
  double compliance_m_per_N = 0.0;
};

/// Wavelengths in metres at the borders of the bands, longest first: kFeatureBands + 1 of them.
///
/// Half octaves from 10 mm to 0.3125 mm. Longer waves are felt as shape, and a stroke of a few
/// centimetres holds too few of them; shorter ones are lost at 1 kHz when the hand is quicker than
/// 150 mm/s. Half an octave is what the window can tell apart at 10 mm.
std::span<const double> feature_band_borders_m() noexcept;

/// Features of the samples in contact. Throws std::invalid_argument when the spans differ in
/// length, when a number is not finite, and when time or travel goes back.
ForceFeatures force_features(const FeltForce& felt);

/// Squared Euclidean distance, each spectral band weighted 1/kFeatureBands, size and roughness 1. The
/// shaking and the compliance have no part in it: the shaking grows with the hand's force and speed.
double squared_distance(const ForceFeatures& a, const ForceFeatures& b) noexcept;

}  // namespace asperity
