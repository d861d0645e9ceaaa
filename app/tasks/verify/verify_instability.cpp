// Compares each stored value within its tolerance, including that of replayed forces.

#include "app/tasks/verify/verify_instability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "analysis/numbers/number_text.h"
#include "app/session/attempt_instability.h"
#include "renderers/force/adjacent_patches.h"

namespace asperity {
namespace {

constexpr double kClose = 0.01;              // of the greater of both values
constexpr double kUnit_of_closeness = 1e-9;  // values that are 0 apart from rounding
constexpr double kPath_m = 0.5;              // a long path of a resting hand

struct ComparedValue {
  const char* name = nullptr;
  std::optional<double> InstabilityRow::*value{};
  double per_N = 0.0;  ///< the change of the value with a force that differs by 1 N
};
constexpr std::array kCompared{
    ComparedValue{"buzz", &InstabilityRow::buzz, 1.0 / kLeastTexture_N},
    ComparedValue{"buzz_force_N", &InstabilityRow::buzz_force_N, 1.0},
    ComparedValue{"resting_s", &InstabilityRow::resting_s},
    ComparedValue{"alive_force_N", &InstabilityRow::alive_force_N, 1.0},
    ComparedValue{"alive_plate_force_N", &InstabilityRow::alive_plate_force_N, 1.0},
    ComparedValue{"alive_motion_m", &InstabilityRow::alive_motion_m},
    ComparedValue{"alive_work_J", &InstabilityRow::alive_work_J, kPath_m},
    ComparedValue{"crest_share", &InstabilityRow::crest_share},
    ComparedValue{"slow_s", &InstabilityRow::slow_s}};

/// `tolerance`: what the model's own tolerance of replayed forces can change in the value.
bool agree(const std::optional<double>& a, const std::optional<double>& b, Agreement agreement,
           double tolerance) {
  if (agreement == Agreement::exact || !a || !b) return a == b;
  return std::abs(*a - *b) <=
         kClose * std::max(std::abs(*a), std::abs(*b)) + tolerance + kUnit_of_closeness;
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
  const ForceModel& model = *surface.stimulus.model;
  const RecordedTexture texture = recorded_texture(
      model, inputs,
      {attempt.records, static_cast<std::uint64_t>(surface.row.position), attempt.rate_Hz});
  const std::optional<InstabilityRow> again =
      instability_row(perceived_instability(model, inputs, texture));
  if (!again) return "the stored detectors have values, those of the recording are not finite";
  for (const ComparedValue& each : kCompared) {
    const std::optional<double>& stored = *surface.row.instability.*each.value;
    const std::optional<double>& computed = *again.*each.value;
    const double tolerance = each.per_N * surface.stimulus.model->declaration.replay_tolerance_N;
    if (agree(stored, computed, agreement, tolerance)) continue;
    return std::string("the stored value of ") + each.name + " is " + stated(stored) +
           ", that of the recording is " + stated(computed);
  }
  return {};
}

}  // namespace asperity
