// Declares the vibration of a delivered force that its model does not explain.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

namespace asperity {

/// A force as it was delivered, and as its model computes it for the slow motion of the same hand (slow_hand.h): samples of
/// the same ticks, evenly spaced.
struct ExplainedForce {
  std::span<const glm::dvec3> delivered_N{};
  std::span<const glm::dvec3> explained_N{};
  double rate_Hz = 1000.0;
};

/// The greatest unexplained vibration of a record.
struct UnexplainedVibration {
  double rms_N = 0.0;      ///< over one window, all axes together
  std::size_t middle = 0;  ///< the sample in the middle of that window
};

/// The lowest frequency that counts. Textures under a hand lie mostly below it, device resonances above it.
inline constexpr double kBuzzFrom_Hz = 150.0;
/// A window, and the distance between the beginnings of two windows. An oscillation of 0.3 s covers a window up to 50 ms, of
/// which the taper leaves less than 1 % of the power.
inline constexpr double kBuzzWindow_s = 0.3;
inline constexpr double kBuzzStep_s = 0.1;

/// The RMS between kBuzzFrom_Hz and half the rate of the part of a delivered force that its model does not explain: the
/// greatest over windows; nullopt for a record shorter than one window.
///
/// In each window (Hann) the spectra D of the delivered and R of the explained force are compared line by line; |·|² is the
/// power of a line, summed over the three axes:
///
///   U(f) = min( |D − R|², max(0, |D|² − R²ₘ(f) − a·M(f)) )         RMS² = Σ U(f) over the band
///
///   R²ₘ  the greatest |R|² of the line and its two neighbours
///   M    the median of |R|² over ±40 Hz
///   a    = 4
///
/// The first term is the residual of a force that depends on the place: the replay gives it again sample by sample, and the
/// term is nearly 0, also where the force is strong. It does not suit a force that is drawn from noise along the path. The
/// slow motion passes other places of that noise, so that D and R are independent draws from one spectrum, and the residual
/// has twice its power. The second term suits such a force: the power of a line of noise about its mean m is distributed as
/// m·χ²₂/2 in each axis, P(power > x·m) = e⁻ˣ. R²ₘ + 4·M is about 5·m, which noise exceeds in fewer than 1 % of the lines and
/// then by m in the mean. The greatest of many windows of white noise along one axis is 0.2 to 0.4 of its RMS. An oscillation of
/// half the RMS of this noise has a quarter of its power in three lines of about 150, more than ten times the mean of a line.
/// The second term alone would count as unexplained where a periodic texture is moved to a neighbouring line by a different
/// speed; the median does not include a tone, therefore a tone of the texture does not hide an oscillation next to it.
///
/// Identities: a delivered force that equals the explained one has RMS 0; so has one without a component in the band. An
/// oscillation F·sin(2πft) on a force without other components in the band has RMS F/√2.
///
/// Limits: an oscillation with the frequency of a line of the texture counts as the increase of that line only. The rate must be
/// above 2·kBuzzFrom_Hz.
///
/// Errors: std::invalid_argument for a rate that is too low and for spans of different lengths.
std::optional<UnexplainedVibration> unexplained_vibration(const ExplainedForce& force);

}  // namespace asperity
