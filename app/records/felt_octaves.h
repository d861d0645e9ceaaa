// The wavelengths in the forces that were sent while an item was felt, from the recordings of a study.

#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>

#include "analysis/signals/force_features.h"
#include "results_schema/study.h"

namespace asperity {

/// Octaves of wavelength, longest first: 10 to 5 mm, …, 0.625 to 0.3125 mm; each is two bands of ForceFeatures.
inline constexpr std::size_t kFeltOctaves = kFeatureBands / 2;

/// Their names as properties of an item. The value is FeltOctaves::mean_ratio.
inline constexpr std::array<const char*, kFeltOctaves> kOctaveProperties{
    "waves_5_to_10_mm", "waves_2.5_to_5_mm", "waves_1.25_to_2.5_mm", "waves_0.625_to_1.25_mm",
    "waves_0.3125_to_0.625_mm"};

/// Of one item, over the presentations in which the contact was long enough for a spectrum (force_features.h).
struct FeltOctaves {
  std::size_t presentations = 0;
  /// Sums of ln √(r² + kFeltRatio²), r: RMS of the normal force in the octave over the mean normal force.
  std::array<double, kFeltOctaves> sums{};

  /// The geometric mean of √(r² + kFeltRatio²) over the presentations; there is at least one.
  double mean_ratio(std::size_t octave) const noexcept;
};

/// One presentation. Without a spectrum (features at their floor) nothing is added.
void add_octaves(const ForceFeatures& features, FeltOctaves& of_item) noexcept;

/// Reads the recording of an attempt and adds its surfaces to their items. Without a recording nothing is added.
///
/// Errors: ResultsError for a recording that cannot be read.
void add_felt_octaves(const Study& study, const AttemptRow& attempt,
                      std::map<std::string, FeltOctaves>& by_item);

}  // namespace asperity
