// Declares band-limited interpolation between samples.

#pragma once

#include <span>
#include <vector>

namespace asperity {

/// Computes values between equally spaced samples without images and, at a lower rate, without aliases.
///
///   y(t) = r·Σ_j x_j·K(r·(t − j)),   K(u) = sinc(u)·I_0(β·√(1 − (u/12)²))/I_0(β)   for |u| < 12, otherwise 0
///
/// t in samples of x; 0 < r ≤ 1 the rate of the result relative to that of x, above whose half it keeps nothing; β = 5, a
/// Kaiser window. At r = 1 the value at a sample is the sample. Within 0.05 dB up to 0.43 of the lower rate, −6 dB at half
/// of it, −50 dB from 0.57 on. A value needs the samples within 12/r of its place, the next ones included; beyond both ends
/// of the span there is silence.
///
/// K is tabulated at 128 places between its zeros and linear between them (an error below 3·10⁻⁵ of a sample).
///
/// Real-time: `value` does not allocate, lock or throw.
class BandLimitedInterpolation final {
 public:
  static constexpr int kReach = 12;  ///< zeros of K on each side

  BandLimitedInterpolation();

  double value(std::span<const double> samples, double place, double rate = 1.0) const noexcept;

 private:
  static constexpr int kPlaces = 128;
  std::vector<double> kernel_{};
};

}  // namespace asperity
