// How rough a record of force or acceleration is, and a record of heights.

#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// Measures of one record; `unit` stands for the record's unit.
///
/// The two bands quote the fast-adapting channels of touch, FA1 (5–50 Hz) and FA2 (50–500 Hz):
/// which of them says more depends on the surface, so both are given. A line at 50 Hz counts as
/// FA2. Powers are mean squares of the record less its mean, as in `band_rms`.
///
/// The Pacinian power weighs each line of the spectrum by the threshold of detection
/// (VibrationThreshold) [Bensmaia 2003]: with a_T(f) the threshold as an acceleration,
///
///   P_w = Σ 2·(a_f,rms / a_T(f))²,  a_T = a₀ for f ≤ f₀, a₀·(f/f₀)⁴ above,
///
/// with amplitude A = √2·rms as thresholds are quoted for amplitudes. P_w = 1 is one sinusoid at
/// threshold. Lines below 40 Hz, where other channels take over, are not counted.
///
/// The maximum depends on outliers and on the time step; it is never reported alone.
///
/// [Bensmaia 2003] Bensmaïa, Hollins: The vibrations of texture.
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

/// From where on a vibration is felt: the displacement T(f) = T₀·(f₀/f)² below f₀ and T₀·(f/f₀)²
/// above, f₀ = `best_Hz`, T₀ = `displacement_m` (amplitude). A displacement A at f has the acceleration
/// (2πf)²·A, so up to f₀ the threshold is one acceleration, a₀ = (2πf₀)²·T₀. An analytic stand-in for
/// measured curves, which fall by some 12 dB an octave towards their minimum.
struct VibrationThreshold {
  double best_Hz = 250.0;
  double displacement_m = 0.1e-6;

  /// a₀, an amplitude.
  constexpr double acceleration_m_per_s2() const noexcept {
    const double omega_rad_per_s = 2.0 * std::numbers::pi * best_Hz;
    return omega_rad_per_s * omega_rad_per_s * displacement_m;
  }
};
/// Under a large contactor: a₀ = 0.2467 m/s².
inline constexpr VibrationThreshold kLargeContactor{};
/// Of a tool that the whole hand holds: best at 150 to 200 Hz [Brisben 1999], a₀ = 0.0363 m/s². The
/// frequency is the published one; the level, 0.03 µm, is a choice of ours within a range that the
/// publication gives as "below 0.01 µm in some" of its subjects. Another level adds one constant to
/// every power in decibels and changes no order and no difference.
///
/// [Brisben 1999] Brisben, Hsiao, Johnson: Detection of vibration transmitted through an object
/// grasped in the hand.
inline constexpr VibrationThreshold kHeldTool{.best_Hz = 175.0, .displacement_m = 0.03e-6};

/// P_w, as above. Throws std::invalid_argument for an empty record and a rate that is not positive.
double pacinian_power(std::span<const double> acceleration_m_per_s2, double rate_Hz,
                      const VibrationThreshold& threshold = kLargeContactor);

/// How rough the acceleration of a held tool is, over all directions in which it can move.
struct HeldToolRoughness {
  double max_accel_m_per_s2 = 0.0;  ///< the longest vector of the record less its mean
  double rms_accel_m_per_s2 = 0.0;
  double fa1_m2_per_s4 = 0.0;  ///< band powers, as in RecordRoughness
  double fa2_m2_per_s4 = 0.0;
  /// 10·log₁₀ P_w with the threshold of a held tool; nothing without power from 40 Hz on.
  std::optional<double> pacinian_dB{};
};

/// An acceleration that comes sample by sample, from a simulation or from a hand that is felt now, and
/// how rough it was. Powers of the directions are added, because the direction of a vibration is
/// hardly felt. Lines of the spectrum are exact for what is periodic in the record.
///
/// Errors: std::invalid_argument for a rate that is not positive.
class HeldToolRecord final {
 public:
  explicit HeldToolRecord(double rate_Hz);

  void reserve(std::size_t samples);
  /// Along the stroke and across the surface; where it can also move beside the stroke, there too.
  void add(double along_m_per_s2, double across_m_per_s2, double beside_m_per_s2 = 0.0);
  void clear() noexcept;
  std::size_t size() const noexcept { return accelerations_m_per_s2_[0].size(); }
  /// Of all samples since the last `clear`; throws std::invalid_argument without any.
  HeldToolRoughness roughness() const;
  /// Only that of `roughness`, without the spectra.
  double rms_accel_m_per_s2() const;

 private:
  template <class Visit>
  std::vector<double> squares_about_mean(Visit moves) const;

  double rate_Hz_ = 0.0;
  std::array<std::vector<double>, 3> accelerations_m_per_s2_{};
};

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
