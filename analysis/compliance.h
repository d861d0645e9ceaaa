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
