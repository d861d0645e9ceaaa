// Compares stroke, patch size and period of each surface, and the step of force between neighbours.

#include "app/tasks/warnings/arrangement_warnings.h"

#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/plan.h"
#include "renderers/offline/texture_waves.h"

namespace asperity {
namespace {

constexpr double kFewestPeriods = 10.0;
constexpr double kGreatestStep_N = 0.020;
constexpr double kUsualSpeed_m_per_s = 0.2;  // of a hand whose speed is not limited

std::string in_millimetres(double length_m) {
  return number_text(std::round(1e5 * length_m) / 100.0);
}

/// The stroke of the exploration, if it has a direction along the patches.
std::optional<double> stroke_along_m(const Exploration& exploration, Arrangement::Axis axis) {
  const double along = axis == Arrangement::Axis::x ? std::cos(exploration.direction_rad)
                                                    : std::sin(exploration.direction_rad);
  const Band& length_m = exploration.stroke_length_m;
  const std::optional<double> stroke_m = length_m.target ? length_m.target : length_m.minimum;
  if (!stroke_m) return {};
  return std::abs(along) * *stroke_m;
}

/// The greatest change of the force in a tick while the hand crosses the side of a patch (AdjacentPatches).
double step_of_blend_N(const Protocol& protocol, const PlannedPresentation& planned,
                       double amplitude_m, const Exploration& exploration) {
  const double speed_m_per_s = exploration.speed_m_per_s.maximum.value_or(kUsualSpeed_m_per_s);
  const double difference_N = planned.stimulus.material.stiffness_N_per_m * amplitude_m;
  return 1.5 * difference_N * speed_m_per_s / (protocol.rate_Hz * kBlend_m);
}

/// The time of the strokes of a visit, where the exploration requests their length and speed.
std::optional<double> visit_s(const Exploration& exploration, int strokes) {
  const Band& length_m = exploration.stroke_length_m;
  const Band& speed_m_per_s = exploration.speed_m_per_s;
  const auto length = length_m.target ? length_m.target : length_m.minimum;
  const auto speed = speed_m_per_s.target ? speed_m_per_s.target : speed_m_per_s.maximum;
  if (!length || !speed || *speed <= 0.0) return {};
  return strokes * *length / *speed;
}

}  // namespace

std::vector<Diagnostic> warnings_about_arrangements(const CheckedProtocol& checked,
                                                    StimulusBuilder& builder) {
  const Protocol& protocol = checked.protocol;
  const JsonDocument document(protocol.source, checked.file_name);
  std::vector<Diagnostic> warnings{};
  std::set<std::string> said{};
  const auto warn = [&](const Trial& trial, const std::string& what, Phrase message) {
    if (!said.insert(trial.block + '\n' + what).second) return;
    warnings.push_back(document.at(pointer_to("/blocks", trial.block) + "/arrangement/surfaces",
                                   std::move(message)));
  };
  for (const Trial& trial : checked.trials()) {
    const Arrangement& arrangement = trial.arrangement;
    const Exploration& exploration = exploration_of(protocol, trial);
    if (arrangement.strokes) {
      const auto needed_s = visit_s(exploration, *arrangement.strokes);
      if (needed_s && *needed_s > exploration.maximum_contact_s) {
        const Phrase sentence =
            *arrangement.strokes == 1
                ? phrase("Protocols",
                         "%1 stroke of the exploration %2 takes %3 s, but a visit ends after %4 s; "
                         "state fewer strokes, or raise %5")
                : phrase("Protocols",
                         "%1 strokes of the exploration %2 take %3 s, but a visit ends after %4 s; "
                         "state fewer strokes, or raise %5");
        warn(trial, "exposure " + exploration.name,
             sentence.with(std::to_string(*arrangement.strokes), in_quotes(exploration.name),
                           fixed(*needed_s, 1), number_text(exploration.maximum_contact_s),
                           key_name("maximum_contact_s")));
      }
    }
    if (arrangement.surfaces != Arrangement::Surfaces::side_by_side) continue;
    const bool along_x = arrangement.axis == Arrangement::Axis::x;
    for (const PlannedPresentation& planned : trial.presentations) {
      const double width_m = along_x ? planned.patch.extent_m.x : planned.patch.extent_m.y;
      const auto stroke_m = stroke_along_m(exploration, arrangement.axis);
      if (stroke_m && *stroke_m > width_m) {
        warn(trial, "stroke " + exploration.name,
             phrase("Protocols",
                    "the patches are %1 mm wide, but the exploration %2 requests strokes of %3 mm; "
                    "request shorter strokes, or use a wider surface")
                 .with(in_millimetres(width_m), in_quotes(exploration.name),
                       in_millimetres(*stroke_m)));
      }
      if (!builder.can_make(planned.stimulus)) continue;
      const PreparedStimulus stimulus = builder.unmatched(planned.stimulus);
      const TextureWaves waves = texture_waves(*stimulus.model, stimulus.inputs, builder.models());
      const double step_N =
          step_of_blend_N(protocol, planned, waves.amplitude_m.value_or(0.0), exploration);
      if (step_N > kGreatestStep_N) {
        warn(trial, "step " + planned.stimulus_template,
             phrase("Protocols",
                    "at the edge of a patch of %1 the force can change by %2 mN from tick to tick, "
                    "and a change of more than %3 mN is felt as a step; lower the amplitude, the "
                    "stiffness or the maximum speed of the exploration")
                 .with(in_quotes(planned.stimulus.name), fixed(1e3 * step_N, 0),
                       fixed(1e3 * kGreatestStep_N, 0)));
      }
      const std::optional<double> period_m = waves.wavelength_m;
      if (period_m && width_m < kFewestPeriods * *period_m) {
        warn(trial, "periods " + planned.stimulus_template,
             phrase("Protocols",
                    "the patches are %1 mm wide and contain %2 periods of the stimulus %3 (%4 mm); "
                    "ten or more are needed to feel a texture: use a wider surface or a shorter "
                    "period")
                 .with(in_millimetres(width_m), fixed(width_m / *period_m, 1),
                       in_quotes(planned.stimulus.name), in_millimetres(*period_m)));
      }
    }
  }
  return warnings;
}

}  // namespace asperity
