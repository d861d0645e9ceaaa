// Whether a hand did what it was asked to: quantities against a band, strokes, speed.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/summary.h"

namespace asperity {

/// What was asked of one quantity; an absent end is open, a present one belongs to the band.
struct AskedBand {
  std::optional<double> minimum{};
  std::optional<double> maximum{};
};

/// Whether a value belongs to the band.
bool is_inside(const AskedBand& band, double value) noexcept;

/// What one quantity was, and how often it was inside its band.
///
/// The live display and the later analysis call this with the same samples in the same order, as
/// they stand in the recording; then every number is the same to the bit (see Summary).
struct Compliance {
  Summary summary{};
  /// Samples inside divided by all samples; absent when the band is open at both ends.
  std::optional<double> fraction_inside{};
};

/// Nothing for no samples. Throws std::invalid_argument for a sample that is not finite and for a
/// band whose minimum is above its maximum or not a number.
std::optional<Compliance> compliance_of(std::span<const double> samples, const AskedBand& band);

/// How hard a hand presses on a surface whose texture makes the force ripple.
///
///   p_n = Σ w_i F_i / Σ w_i over the samples i = 1 … n of one contact,
///   w_i = dt_i · Π τ / (τ + dt_j) over j = i + 1 … n,
///
/// F_i the normal force in N, dt_i the time since the sample before in s, τ = 0.2 s: the mean of the
/// contact so far, of which the latest counts most. A steady force is known with its first sample;
/// a ripple of f Hz is left with 1 / (2π f τ) of its amplitude in a contact much longer than τ.
class PressingForce final {
 public:
  static constexpr double kMemory_s = 0.2;

  /// The force in N, this sample included. `duration_s` is positive.
  double take(double force_N, double duration_s) noexcept;
  /// The contact is over: the next sample begins another.
  void lift() noexcept { *this = {}; }

 private:
  double weighted_N_s_ = 0.0;
  double weight_s_ = 0.0;
};

/// One passage in one direction: samples `begin` to `end`, both included, of the position.
struct StrokePassage {
  std::size_t begin = 0;
  std::size_t end = 0;
  double length_m = 0.0;  ///< from turning point to turning point, positive forth and negative back
};

/// Cuts the position along the direction of stroking at its turning points.
///
/// A turning point is an extreme from which the hand has since come back by `least_length_m` or
/// more, so tremor and noise below that turn nothing. The first stroke begins at the extreme before
/// it, the last one ends at the extreme it reached. What is shorter than the least length is no
/// stroke. Of equal extremes the first counts. One contact per call: a lift is not a stroke.
///
/// Throws std::invalid_argument when least_length_m is not positive or a position not finite.
std::vector<StrokePassage> strokes_along(std::span<const double> position_m,
                                         double least_length_m = 5e-3);

/// How fast the probe moves along a surface: |v − (v·n)·n|, n the surface's outward unit normal.
double tangential_speed_m_per_s(const std::array<double, 3>& velocity_m_per_s,
                                const std::array<double, 3>& normal) noexcept;

}  // namespace asperity
