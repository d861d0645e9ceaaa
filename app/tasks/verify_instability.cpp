#include "app/tasks/verify_instability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "analysis/number_text.h"
#include "app/session/attempt_instability.h"
#include "renderers/force/adjacent_patches.h"

namespace asperity {
namespace {

constexpr double kClose = 0.01;              // of the greater of both values
constexpr double kUnit_of_closeness = 1e-9;  // values that are 0 apart from rounding

struct ComparedValue {
  const char* name = nullptr;
  std::optional<double> InstabilityRow::*value{};
};
constexpr std::array kCompared{
    ComparedValue{"buzz", &InstabilityRow::buzz},
    ComparedValue{"buzz_force_N", &InstabilityRow::buzz_force_N},
    ComparedValue{"resting_s", &InstabilityRow::resting_s},
    ComparedValue{"alive_force_N", &InstabilityRow::alive_force_N},
    ComparedValue{"alive_plate_force_N", &InstabilityRow::alive_plate_force_N},
    ComparedValue{"alive_motion_m", &InstabilityRow::alive_motion_m},
    ComparedValue{"alive_work_J", &InstabilityRow::alive_work_J},
    ComparedValue{"crest_share", &InstabilityRow::crest_share},
    ComparedValue{"slow_s", &InstabilityRow::slow_s}};

bool agree(const std::optional<double>& a, const std::optional<double>& b, Agreement agreement) {
  if (agreement == Agreement::exact || !a || !b) return a == b;
  return std::abs(*a - *b) <= kClose * std::max(std::abs(*a), std::abs(*b)) + kUnit_of_closeness;
}

std::string stated(const std::optional<double>& value) {
  return value ? number_text(*value) : "none";
}

}  // namespace

std::optional<std::string> differing_instability(const RecordedAttempt& attempt,
                                                 const RecordedSurface& surface,
                                                 Agreement agreement) {
  if (!surface.row.instability) return {};
  const bool is_side_by_side =
      attempt.trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side;
  const RendererInputs inputs =
      is_side_by_side ? without_border(surface.stimulus.inputs) : surface.stimulus.inputs;
  const InstabilityRow again = instability_row(perceived_instability(
      *surface.stimulus.model, inputs,
      {attempt.records, static_cast<std::uint64_t>(surface.row.position), attempt.rate_Hz}));
  for (const ComparedValue& each : kCompared) {
    const std::optional<double>& stored = *surface.row.instability.*each.value;
    const std::optional<double>& computed = again.*each.value;
    if (agree(stored, computed, agreement)) continue;
    return std::string("the stored value of ") + each.name + " is " + stated(stored) +
           ", that of the recording is " + stated(computed);
  }
  return {};
}

}  // namespace asperity
