// Sums the power of two bands of force features per octave, and averages logarithms over presentations.

#include "app/records/felt_octaves.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "app/session/rig/recording_columns.h"
#include "renderers/offline/recorded_force.h"
#include "results_schema/recording.h"

namespace asperity {

namespace {

constexpr double kFloor = kFeltRatio * kFeltRatio;

/// r² of a band whose feature is ln √(r² + floor).
double power_in(double feature) noexcept { return std::exp(2.0 * feature) - kFloor; }

}  // namespace

double FeltOctaves::mean_ratio(std::size_t octave) const noexcept {
  return std::exp(sums[octave] / static_cast<double>(presentations));
}

void add_octaves(const ForceFeatures& features, FeltOctaves& of_item) noexcept {
  if (features.size <= std::log(kFeltRatio)) return;
  ++of_item.presentations;
  for (std::size_t octave = 0; octave < kFeltOctaves; ++octave) {
    const double power =
        power_in(features.spectrum[2 * octave]) + power_in(features.spectrum[2 * octave + 1]);
    of_item.sums[octave] += 0.5 * std::log(power + kFloor);
  }
}

void add_felt_octaves(const Study& study, const AttemptRow& attempt,
                      std::map<std::string, FeltOctaves>& by_item) {
  if (!attempt.recording) return;
  const std::filesystem::path file = study.folder() / attempt.recording->path;
  const Recording recording = read_recording(file);
  const std::vector<TickRecord> records = records_of(recording, file);
  for (const PresentationRow& surface : attempt.presentations) {
    add_octaves(recorded_force_features({records, static_cast<std::uint64_t>(surface.position),
                                         recording.header.rate_Hz}),
                by_item[surface.item]);
  }
}

}  // namespace asperity
