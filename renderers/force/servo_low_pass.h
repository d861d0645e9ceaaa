// Declares the low-pass that makes a texture of the path fit the rate of the servo loop.

#pragma once

#include <array>
#include <cstddef>

namespace asperity {

/// Filters the steps of a texture within each tick, so that what is faster than the servo loop does not alias.
///
/// A Butterworth low-pass of fourth order at 0.4 of the servo rate, run at kStepsPerTick steps per tick: two biquads by the
/// bilinear transform, with coefficients that do not depend on the rate. −0.4 dB at 0.3 of the servo rate, −8 dB at half of
/// it; it delays slow changes by about one tick.
///
/// Real-time: no allocation, no exceptions.
class ServoLowPass final {
 public:
  static constexpr int kStepsPerTick = 8;

  /// Sets the state that a constant input has led to.
  void reset(double value) noexcept {
    for (Biquad& biquad : biquads_) biquad.reset(value);
  }

  /// The output after one more step of the input.
  double step(double value) noexcept {
    for (Biquad& biquad : biquads_) value = biquad.step(value);
    return value;
  }

 private:
  // tan(π·0.4/kStepsPerTick), as a number so that it has the same bits everywhere.
  static constexpr double kTangent = 0.15838444032453629;

  struct Biquad {
    double b0 = 0.0;
    double a1 = 0.0;
    double a2 = 0.0;
    double first = 0.0;
    double second = 0.0;

    constexpr explicit Biquad(double quality) noexcept {
      const double norm = 1.0 / (1.0 + kTangent / quality + kTangent * kTangent);
      b0 = kTangent * kTangent * norm;
      a1 = 2.0 * (kTangent * kTangent - 1.0) * norm;
      a2 = (1.0 - kTangent / quality + kTangent * kTangent) * norm;
    }

    void reset(double value) noexcept {
      second = (b0 - a2) * value;
      first = (2.0 * b0 - a1) * value + second;
    }

    double step(double in) noexcept {
      const double out = b0 * in + first;
      first = 2.0 * b0 * in - a1 * out + second;
      second = b0 * in - a2 * out;
      return out;
    }
  };

  // The quality factors of a Butterworth filter of fourth order: 1/(2 cos 22.5°) and 1/(2 cos 67.5°).
  std::array<Biquad, 2> biquads_{Biquad(0.54119610014619698), Biquad(1.3065629648763766)};
};

}  // namespace asperity
