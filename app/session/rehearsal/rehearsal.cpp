// Can this device render what a plan can reach? Every stimulus against a measured profile.

#include "app/session/rehearsal/rehearsal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/number_text.h"
#include "app/session/attempt_measures.h"
#include "app/session/rehearsal/friction_rehearsal.h"
#include "app/session/session_setup.h"
#include "app/study_files/parameter_json.h"
#include "device/drivers.h"
#include "protocols/design/json_pointer.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/plan.h"
#include "renderers/offline/composed_relief.h"
#include "renderers/offline/contact_loss.h"
#include "renderers/offline/felt_stiffness.h"
#include "renderers/offline/force_matching.h"
#include "renderers/offline/sampled_loop.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/pd_gradient/geometry/finest_wave.h"
#include "results_schema/sha256.h"

namespace asperity {
namespace {

/// The stiffest spring that `device-test` tries: no limit of a device that held it in a loop as fast.
constexpr double kStiffestTried_N_per_m = 8000.0;
constexpr const char* kResonance = "resonance_Hz";
/// What stimuli are compared with, beside the workspace.
constexpr std::array kComparedTraits{DeviceTrait::friction,      DeviceTrait::force_resolution,
                                     DeviceTrait::position_step, DeviceTrait::damping,
                                     DeviceTrait::latency,       DeviceTrait::moving_mass,
                                     DeviceTrait::stiffness,     DeviceTrait::resonance};
/// Of a stroke: a stimulus that is left for less is still felt as a surface.
constexpr double kContactMayBeLost = 0.05;
/// Below what arithmetic leaves of a force without a texture there is none.
constexpr double kNoForce_N = 1e-9;

std::string in_um(double value_m) { return in_three_digits(1e6 * value_m); }

/// What distinguishes a stimulus from others of the same name: a factor may choose its bodies and its files.
std::string rehearsed_key(const StimulusDescription& stimulus) {
  std::string key =
      stimulus.name + '\n' + stimulus.model + '\n' + json_text_of(stimulus.parameters);
  for (const auto* const body : {&stimulus.surface, &stimulus.tool}) {
    key += '\n' + (*body ? (*body)->name : std::string{});
  }
  for (const StimulusAsset& asset : assets_of(stimulus)) {
    key += '\n' + asset.role + '\t' + asset.path;
  }
  return key;
}

std::optional<double> number_among(const ParameterValues& values, const char* name) {
  const auto found = values.find(name);
  if (found == values.end()) return {};
  const double* const number = std::get_if<double>(&found->second);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

/// How high and how long a texture's waves are on the device.
struct TextureWaves {
  std::optional<double> amplitude_m{};
  std::optional<double> wavelength_m{};
};

/// Of a texture that is nowhere in particular (noise in time) or has no height: none.
TextureWaves waves_of(const PreparedStimulus& stimulus, const ModelRegistry& models) {
  const ModelDeclaration& declaration = stimulus.model->declaration;
  const ParameterValues& own = stimulus.inputs.parameters;
  if (declaration.amplitude_parameter &&
      number_among(own, declaration.amplitude_parameter->c_str()) == 0.0) {
    return {};
  }
  ParameterValues suggested{};
  if (number_among(own, "amplitude_m") && number_among(own, "wavelength_m")) {
    suggested = own;
  } else if (declaration.needs_height_field && stimulus.inputs.height_field) {
    const ForceModel* const sinusoid = models.find("sinusoid");
    if (sinusoid == nullptr || !sinusoid->suggested_by) return {};
    suggested = sinusoid->suggested_by(*stimulus.inputs.height_field, stimulus.inputs.material);
  }
  TextureWaves waves{number_among(suggested, "amplitude_m"),
                     number_among(suggested, "wavelength_m")};
  if (waves.amplitude_m && stimulus.inputs.height_field) {
    *waves.amplitude_m *= number_among(own, "height_scale").value_or(1.0);
  }
  if (waves.wavelength_m) *waves.wavelength_m /= stimulus.inputs.patch.motion_scale;
  return waves;
}

/// Two springs, one behind the other.
double in_series(double one_N_per_m, double other_N_per_m) {
  return one_N_per_m * other_N_per_m / (one_N_per_m + other_N_per_m);
}

/// Between the hand and a simulated tool.
struct CouplingAsked {
  double stiffness_N_per_m = 0.0;
  double damping_N_s_per_m = 0.0;
};

/// What a stimulus of two bodies is to the hand: a point on the relief that both make (composed_relief.h), behind
/// the spring of the virtual coupling where there is one.
struct BodiesAsRelief {
  /// The model of a point whose force is −k·δ·∇δ; the stiffness is that of the contact.
  PreparedStimulus point{};
  TextureWaves waves{};
  double contact_damping_N_s_per_m = 0.0;
  std::optional<CouplingAsked> coupling{};
};

BodiesAsRelief as_relief(const PreparedStimulus& bodies, const HandHabits& habits,
                         const ModelRegistry& models) {
  const ParameterValues& own = bodies.inputs.parameters;
  const GainedBody tool{.mesh = *bodies.inputs.tool,
                        .gain = number_among(own, "tool_texture_gain").value_or(1.0)};
  const GainedBody surface{.mesh = *bodies.inputs.surface,
                           .gain = number_among(own, "texture_gain").value_or(1.0)};
  BodiesAsRelief relief{};
  relief.point.model = models.find("height_map");
  if (relief.point.model == nullptr) {
    throw std::runtime_error("this program has no force model height_map");
  }
  RendererInputs& inputs = relief.point.inputs;
  inputs.material = bodies.inputs.material;
  inputs.patch = bodies.inputs.patch;
  const double finest_m =
      std::min(finest_wave_m(tool.mesh, tool.gain), finest_wave_m(surface.mesh, surface.gain));
  // A body is straight between texels: differences over fewer of them would be of that.
  constexpr double kSamplesOfWave = 16.0;
  inputs.height_field = std::make_shared<const HeightField>(
      composed_relief(tool, surface,
                      {.length_m = habits.stroke_length_m,
                       .direction_rad = habits.direction_rad,
                       .cell_m = number_among(own, "cell_m").value_or(TipStroke{}.cell_m),
                       .pitch_m = std::isfinite(finest_m) ? finest_m / kSamplesOfWave : 0.0}));
  inputs.parameters = complete_values(relief.point.model->declaration,
                                      {{"lateral_gradient_gain", 1.0}, {"depth_limit_m", 0.05}});
  if (std::isfinite(finest_m)) {
    relief.waves = {.amplitude_m = std::numbers::sqrt2 * inputs.height_field->rms_m(),
                    .wavelength_m = finest_m};
  }
  relief.contact_damping_N_s_per_m = number_of(own, "contact_damping_N_s_per_m");
  if (has_virtual_coupling(own)) {
    relief.coupling = {.stiffness_N_per_m = number_of(own, "coupling_stiffness_N_per_m"),
                       .damping_N_s_per_m = number_of(own, "coupling_damping_N_s_per_m")};
  }
  return relief;
}

/// Along the relief. Its samples are the model, and not what is between them: over one of them, differences are those
/// of three.
StiffnessSearch along(const HeightField& relief) {
  constexpr double kCellsOfBorder = 4.0;
  const double pitch_m = relief.grid().pitch_m;
  return {.extent_m = glm::dvec2(std::max(relief.width_m() - kCellsOfBorder * pitch_m, 0.0), 0.0),
          .step_m = 0.5 * pitch_m};
}

DampedResponse damped_response_of(const DeviceProfile& profile) {
  return {.moving_mass_kg = profile.value("moving_mass_kg"),
          .latency_s = profile.value("latency_s").value_or(0.0),
          .velocity = velocity_window_of(profile.name, profile.model)};
}

class DeviceRehearsal final {
 public:
  DeviceRehearsal(const Protocol& protocol, const DeviceProfile& profile, StimulusBuilder& builder)
      : protocol_(protocol), profile_(profile), builder_(builder) {}

  std::vector<RehearsalWarning> run(const RehearsalCourse& course) {
    check_limits();
    for (RehearsalWarning& warning :
         friction_warnings(protocol_, builder_.models(), damped_response_of(profile_))) {
      warn(std::move(warning));
    }
    std::set<std::string> seen{};
    const std::vector<Trial> trials = possible_trials(protocol_);
    double done = 0.0;
    for (const Trial& trial : trials) {
      if (course.stop.stop_requested()) break;
      if (course.progress) course.progress(done / static_cast<double>(trials.size()));
      ++done;
      const Exploration& exploration = exploration_of(protocol_, trial);
      for (const PlannedPresentation& planned : trial.presentations) {
        const StimulusDescription& stimulus = planned.stimulus;
        if (!seen.insert(rehearsed_key(stimulus) + '\n' + exploration.name).second) continue;
        check_workspace(stimulus.patch);
        at_ = pointer_to("/stimuli", planned.stimulus_template);
        try {
          if (stimulus.surface && stimulus.tool) {
            check_bodies(planned, exploration);
          } else {
            check(planned, exploration);
          }
        } catch (const std::exception& error) {
          warn({.id = "not_rehearsed",
                .stimulus = stimulus.name,
                .text = phrase("Rehearsal", "\"%1\" cannot be compared with the device: %2")
                            .with(stimulus.name, phrase_of(error))
                            .as_sentence()});
        }
      }
    }
    return std::move(warnings_);
  }

 private:
  /// Once, at what asks for it: the stimulus, where nothing else is named.
  void warn(RehearsalWarning warning) {
    if (warning.pointer.empty()) warning.pointer = at_;
    const bool is_told =
        std::any_of(warnings_.begin(), warnings_.end(), [&](const RehearsalWarning& one) {
          return one.id == warning.id && one.text == warning.text;
        });
    if (!is_told) warnings_.push_back(std::move(warning));
  }

  void check_limits() {
    for (const auto& [name, limit] : protocol_.device_limits) {
      const DeviceQuantity* const quantity = device_quantity(name);
      if (quantity == nullptr || (quantity->is_timing && profile_.is_simulated)) continue;
      check_limit(*quantity, limit);
    }
  }

  void check_limit(const DeviceQuantity& quantity, double limit) {
    const std::string name = quantity.name;
    const std::string asked = in_three_digits(limit);
    const bool at_most = quantity.bound == DeviceItem::Bound::at_most;
    if (const std::optional<double> value = profile_.value(name)) {
      if (keeps(*value, quantity.bound, limit)) return;
      const Phrase text = at_most ? phrase("Rehearsal",
                                           "The protocol requires a device whose %1 is at most %2; "
                                           "the measured value is %3.")
                                  : phrase("Rehearsal",
                                           "The protocol requires a device whose %1 is at least "
                                           "%2; the measured value is %3.");
      warn({.id = "limit_" + name,
            .pointer = pointer_to("/device/limits", name),
            .asked = limit,
            .device = *value,
            .text = text.with(name, asked, in_three_digits(*value))});
      return;
    }
    // Most often there is none, which keeps every limit; unless nobody knows.
    if (name == kResonance && !profile_.is_unknown(name)) return;
    const Phrase text =
        at_most
            ? phrase(
                  "Rehearsal",
                  "The protocol requires a device whose %1 is at most %2, which was not measured.")
            : phrase("Rehearsal",
                     "The protocol requires a device whose %1 is at least %2, which was not "
                     "measured.");
    warn({.id = "unmeasured_" + name,
          .pointer = pointer_to("/device/limits", name),
          .asked = limit,
          .text = text.with(name, asked)});
  }

  void check(const PlannedPresentation& planned, const Exploration& exploration) {
    const PreparedStimulus stimulus = builder_.unmatched(planned.stimulus);
    const HandHabits habits = habits_for(exploration, planned.stimulus.patch);
    check_force(planned.stimulus.name, [&] { return texture_force_N(planned, stimulus, habits); });
    const TextureWaves waves = waves_of(stimulus, builder_.models());
    check_waves(planned.stimulus.name, waves, fastest_m_per_s(exploration, habits));
    check_stiffness(planned.stimulus.name, stimulus, {}, 0.0);
    check_contact(planned.stimulus.name, stimulus, habits);
  }

  void check_bodies(const PlannedPresentation& planned, const Exploration& exploration) {
    const std::string& name = planned.stimulus.name;
    const HandHabits habits = habits_for(exploration, planned.stimulus.patch);
    const BodiesAsRelief relief =
        as_relief(builder_.unmatched(planned.stimulus), habits, builder_.models());
    if (relief.coupling) {
      check_coupling(name, *relief.coupling);
    } else {
      check_stiffness(name, relief.point, along(*relief.point.inputs.height_field),
                      relief.contact_damping_N_s_per_m);
    }
    if (!relief.waves.wavelength_m) return;  // neither has a texture that could be lost
    check_force(name, [&] { return texture_force_N(planned, relief, habits); });
    check_waves(name, relief.waves, fastest_m_per_s(exploration, habits));
  }

  static double fastest_m_per_s(const Exploration& exploration, const HandHabits& habits) {
    return exploration.speed_m_per_s.maximum.value_or(habits.speed_m_per_s);
  }

  /// Within the strokes, where the relief is: not repeated, whatever lies beyond them.
  double texture_force_N(const PlannedPresentation& planned, const BodiesAsRelief& relief,
                         const HandHabits& habits) const {
    if (planned.equal_force && planned.equal_force->rms_N) return *planned.equal_force->rms_N;
    constexpr double kCellsOfBorder = 4.0;
    RendererInputs inputs = relief.point.inputs;
    if (relief.coupling) {
      inputs.material.stiffness_N_per_m =
          in_series(inputs.material.stiffness_N_per_m, relief.coupling->stiffness_N_per_m);
    }
    const HeightField& field = *inputs.height_field;
    const double length_m = field.width_m() - kCellsOfBorder * field.grid().pitch_m;
    return texture_force_rms_N(*relief.point.model, inputs,
                               {.speed_m_per_s = habits.speed_m_per_s,
                                .duration_s = length_m / habits.speed_m_per_s,
                                .dropped_s = 0.0,
                                .rate_Hz = protocol_.rate_Hz,
                                .mean_normal_force_N = habits.normal_force_N});
  }

  double texture_force_N(const PlannedPresentation& planned, const PreparedStimulus& stimulus,
                         const HandHabits& habits) {
    if (planned.equal_force && planned.equal_force->rms_N) return *planned.equal_force->rms_N;
    const TextureForcePath path{.speed_m_per_s = habits.speed_m_per_s,
                                .rate_Hz = protocol_.rate_Hz,
                                .mean_normal_force_N = habits.normal_force_N};
    if (!planned.equal_force) return texture_force_rms_N(*stimulus.model, stimulus.inputs, path);
    StimulusDescription reference = planned.stimulus;
    reference.model = planned.equal_force->to_model;
    reference.parameters.clear();
    const PreparedStimulus other = builder_.unmatched(reference);
    return texture_force_rms_N(*other.model, other.inputs, path);
  }

  /// Asks for the texture's force only where it is compared.
  void check_force(const std::string& name, const std::function<double()>& texture_force_N) {
    const std::optional<double> friction_N = profile_.value("friction_N");
    const std::optional<double> resolution_N = profile_.value("force_resolution_N");
    if (!friction_N && !resolution_N) return;
    const double force_N = texture_force_N();
    if (force_N < kNoForce_N) return;
    if (friction_N && force_N < *friction_N) {
      warn({.id = "friction",
            .stimulus = name,
            .asked = force_N,
            .device = *friction_N,
            .text = phrase("Rehearsal",
                           "The texture of \"%1\" corresponds to a force of %2 N RMS, and the "
                           "device's own friction is %3 N, which masks the texture.")
                        .with(name, in_three_digits(force_N), in_three_digits(*friction_N))});
    } else if (resolution_N && force_N < *resolution_N) {
      warn({.id = "force_resolution",
            .stimulus = name,
            .asked = force_N,
            .device = *resolution_N,
            .text = phrase("Rehearsal",
                           "The texture of \"%1\" corresponds to a force of %2 N RMS, and the "
                           "smallest force that moves the device is %3 N.")
                        .with(name, in_three_digits(force_N), in_three_digits(*resolution_N))});
    }
  }

  void check_waves(const std::string& name, const TextureWaves& waves, double speed_m_per_s) {
    const std::optional<double> resolution_m = profile_.value("position_resolution_m");
    if (resolution_m && waves.amplitude_m && *waves.amplitude_m > 0.0 &&
        *waves.amplitude_m < *resolution_m) {
      warn(
          {.id = "position_resolution",
           .stimulus = name,
           .asked = *waves.amplitude_m,
           .device = *resolution_m,
           .text =
               phrase("Rehearsal",
                      "The texture of \"%1\" has an amplitude of %2 µm (√2 times its RMS), and the "
                      "device reads positions in steps of %3 µm.")
                   .with(name, in_um(*waves.amplitude_m), in_um(*resolution_m))});
    }
    if (!waves.wavelength_m) return;
    if (resolution_m && *waves.wavelength_m < 2.0 * *resolution_m) {
      warn({.id = "wavelength",
            .stimulus = name,
            .asked = *waves.wavelength_m,
            .device = *resolution_m,
            .text = phrase("Rehearsal",
                           "A wave of \"%1\" is %2 µm long, and the device reads positions in "
                           "steps of %3 µm: at least two steps per wave are needed.")
                        .with(name, in_um(*waves.wavelength_m), in_um(*resolution_m))});
    }
    double bandwidth_Hz = 0.5 * protocol_.rate_Hz;
    if (const auto resonance_Hz = profile_.value(kResonance)) {
      bandwidth_Hz = std::min(bandwidth_Hz, *resonance_Hz);
    }
    const double frequency_Hz = speed_m_per_s / *waves.wavelength_m;
    if (frequency_Hz > bandwidth_Hz) {
      warn({.id = "bandwidth",
            .stimulus = name,
            .asked = frequency_Hz,
            .device = bandwidth_Hz,
            .text = phrase("Rehearsal",
                           "When \"%1\" is stroked at %2 mm/s, %3 waves per second pass under the "
                           "probe, and the bandwidth of the device is %4 Hz.")
                        .with(name, in_three_digits(1e3 * speed_m_per_s),
                              in_three_digits(frequency_Hz), in_three_digits(bandwidth_Hz))});
    }
  }

  /// The stiffest spring that the device holds in a loop of the protocol's rate, as far as that was measured.
  std::optional<double> holds_N_per_m() const {
    std::optional<double> holds{};
    if (const auto damping = profile_.value("damping_N_s_per_m")) {
      holds = 2.0 * *damping * protocol_.rate_Hz;
    }
    const auto held = profile_.value("stiffness_N_per_m");
    // A slower loop holds less: of what was held in a faster one, as of 2b/T, the share of the rates.
    const double share =
        profile_.rate_Hz > 0.0 ? std::min(protocol_.rate_Hz / profile_.rate_Hz, 1.0) : 1.0;
    if (held && (share < 1.0 || *held < 0.99 * kStiffestTried_N_per_m)) {
      const double held_N_per_m = *held * share;
      holds = std::min(holds.value_or(held_N_per_m), held_N_per_m);
    }
    return holds;
  }

  double period_s() const { return 1.0 / protocol_.rate_Hz; }
  /// The spring that asks as much of a device as this one and its damper.
  double as_spring_N_per_m(double stiffness_N_per_m, double damper_N_s_per_m) const {
    return 2.0 * passive_damping_N_s_per_m(stiffness_N_per_m, damper_N_s_per_m, period_s()) /
           period_s();
  }

  /// The device feels the coupling's spring and damper whatever its tool touches (sampled_loop.h).
  void check_coupling(const std::string& name, const CouplingAsked& coupling) {
    const std::optional<double> holds = holds_N_per_m();
    if (!holds) return;
    const double asked_N_s_per_m = passive_damping_N_s_per_m(
        coupling.stiffness_N_per_m, coupling.damping_N_s_per_m, period_s());
    const double device_N_s_per_m = passive_damping_N_s_per_m(*holds, 0.0, period_s());
    if (asked_N_s_per_m <= device_N_s_per_m) return;
    warn({.id = "coupling",
          .stimulus = name,
          .asked = asked_N_s_per_m,
          .device = device_N_s_per_m,
          .text = phrase("Rehearsal",
                         "The virtual coupling of \"%1\", %2 N/m and %3 N s/m, requires a device "
                         "with a damping of %4 N s/m at %5 Hz; the measured stiffness of this one "
                         "corresponds to %6 N s/m. "
                         "Lower coupling_damping_N_s_per_m or coupling_stiffness_N_per_m.")
                      .with(name, in_three_digits(coupling.stiffness_N_per_m),
                            in_three_digits(coupling.damping_N_s_per_m),
                            in_three_digits(asked_N_s_per_m), in_three_digits(protocol_.rate_Hz),
                            in_three_digits(device_N_s_per_m))});
  }

  void check_stiffness(const std::string& name, const PreparedStimulus& stimulus,
                       StiffnessSearch search, double damper_N_s_per_m) {
    const std::optional<double> holds = holds_N_per_m();
    if (!holds) return;
    search.force_limit_N = protocol_.force_limit_N;
    const auto felt = felt_stiffness(*stimulus.model, stimulus.inputs, search);
    if (!felt) {
      warn({.id = "not_rehearsed",
            .stimulus = name,
            .device = *holds,
            .text = phrase("Rehearsal",
                           "The stiffness of \"%1\" could not be determined or compared with the "
                           "%2 N/m that the device renders without oscillation: at every place "
                           "examined its force jumps or does not increase.")
                        .with(name, in_three_digits(*holds))});
      return;
    }
    const double stiffest_N_per_m = as_spring_N_per_m(felt->stiffness_N_per_m, damper_N_s_per_m);
    if (stiffest_N_per_m <= *holds) return;
    const Phrase text =
        felt->force_N >= protocol_.force_limit_N
            ? phrase("Rehearsal",
                     "At the force limit of %2 N, the greatest stiffness of \"%1\" is %3 N/m; the "
                     "device renders up to %4 N/m without oscillation.")
            : phrase("Rehearsal",
                     "At the greatest force that \"%1\" exerts at its stiffest place, %2 N, its "
                     "stiffness is %3 N/m; the device renders up to %4 N/m without oscillation.");
    const Phrase sentence = text.with(name, in_three_digits(felt->force_N),
                                      in_three_digits(stiffest_N_per_m), in_three_digits(*holds));
    warn({.id = "stiffness",
          .stimulus = name,
          .asked = stiffest_N_per_m,
          .device = *holds,
          .text = damper_N_s_per_m == 0.0
                      ? sentence
                      : phrase("Rehearsal",
                               "%1 The contact damping of %2 N s/m accounts for %3 N/m of it.")
                            .with(sentence, in_three_digits(damper_N_s_per_m),
                                  in_three_digits(as_spring_N_per_m(0.0, damper_N_s_per_m)))});
  }

  /// A mass on a spring leaves a surface that falls away faster than the hand presses it down.
  void check_contact(const std::string& name, const PreparedStimulus& stimulus,
                     const HandHabits& habits) {
    const std::optional<double> mass_kg = profile_.value("moving_mass_kg");
    const DeviceItem* const damping = profile_.item("damping_N_s_per_m");
    if (!mass_kg || damping == nullptr || !damping->value) return;
    constexpr std::size_t kAcross = 2;
    const double damping_N_s_per_m =
        damping->by_axis.size() > kAcross ? damping->by_axis[kAcross] : *damping->value;
    const double share = share_out_of_contact(*stimulus.model, stimulus.inputs,
                                              {.mass_kg = *mass_kg,
                                               .damping_N_s_per_m = damping_N_s_per_m,
                                               .force_N = habits.normal_force_N,
                                               .speed_m_per_s = habits.speed_m_per_s,
                                               .rate_Hz = protocol_.rate_Hz});
    if (share <= kContactMayBeLost) return;
    warn({.id = "contact",
          .stimulus = name,
          .asked = share,
          .device = kContactMayBeLost,
          .text = phrase("Rehearsal",
                         "With a force of %2 N and a speed of %3 mm/s, contact with \"%1\" is "
                         "expected to be lost for about %4 % of a stroke: a mass of %5 g with a "
                         "damping of %6 N s/m, as measured for the device, does not follow the "
                         "height of the surface. Lower stiffness_N_per_m, the texture's amplitude "
                         "or the speed, or request a higher pressing force.")
                      .with(name, in_three_digits(habits.normal_force_N),
                            in_three_digits(1e3 * habits.speed_m_per_s), fixed(100.0 * share, 0),
                            in_three_digits(1e3 * *mass_kg), in_three_digits(damping_N_s_per_m))});
  }

  void check_workspace(const SurfacePatch& patch) {
    const glm::dvec3 low_m = profile_.reached_minimum_m.value_or(profile_.workspace_minimum_m);
    const glm::dvec3 high_m = profile_.reached_maximum_m.value_or(profile_.workspace_maximum_m);
    for (int axis = 0; axis < 2; ++axis) {
      const double from_m = patch.centre_m[axis] - 0.5 * patch.extent_m[axis];
      const double to_m = patch.centre_m[axis] + 0.5 * patch.extent_m[axis];
      if (from_m >= low_m[axis] && to_m <= high_m[axis]) continue;
      warn(
          {.id = "workspace",
           .pointer = "/surface",
           .asked = std::max(low_m[axis] - from_m, to_m - high_m[axis]),
           .device = 0.0,
           .text = phrase("Rehearsal",
                          "The surface lies from %1 to %2 mm along %3, and the handle reaches from "
                          "%4 to %5 mm.")
                       .with(fixed(1e3 * from_m, 1), fixed(1e3 * to_m, 1), axis == 0 ? "x" : "y",
                             fixed(1e3 * low_m[axis], 1), fixed(1e3 * high_m[axis], 1))});
    }
  }

  const Protocol& protocol_;
  const DeviceProfile& profile_;
  StimulusBuilder& builder_;
  std::string at_{};  ///< the stimulus that is compared
  std::vector<RehearsalWarning> warnings_{};
};

}  // namespace

std::string in_three_digits(double value) {
  const double size = std::abs(value);
  if (size >= 100.0 || size == 0.0) return fixed(value, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(size)));
  return fixed(value, std::clamp(decimals, 0, 12));
}

std::vector<RehearsalWarning> rehearse_on_device(const Protocol& protocol,
                                                 const DeviceProfile& profile,
                                                 StimulusBuilder& builder,
                                                 const RehearsalCourse& course) {
  return DeviceRehearsal(protocol, profile, builder).run(course);
}

std::vector<DeviceTrait> not_compared(const std::vector<DeviceTrait>& not_known) {
  return traits_without(kComparedTraits, traits_without(kDeviceTraits, not_known));
}

std::vector<RehearsalWarning> RehearsalMemory::recall(
    const std::string& key, const std::stop_token& stop,
    const std::function<std::vector<RehearsalWarning>()>& compare) {
  const std::lock_guard lock(mutex_);
  if (key_ == key) return warnings_;
  std::vector<RehearsalWarning> warnings = compare();
  if (stop.stop_requested()) return warnings;
  key_ = key;
  warnings_ = std::move(warnings);
  return warnings_;
}

std::vector<Diagnostic> RehearsalMemory::problems_once(
    const std::string& key, const std::function<std::vector<Diagnostic>()>& rehearse) {
  const std::lock_guard lock(mutex_);
  if (sound_key_ == key) return {};
  std::vector<Diagnostic> problems = rehearse();
  if (problems.empty()) sound_key_ = key;
  return problems;
}

std::string content_key(const Protocol& protocol, const std::filesystem::path& study) {
  std::string key = sha256_of(protocol.source) + '\n';
  for (const StimulusFileRow& file : hash_files(protocol, study)) {
    key += file.path + ' ' + file.sha256 + '\n';
  }
  return key;
}

std::vector<RehearsalWarning> rehearse_once(RehearsalMemory* memory, const Protocol& protocol,
                                            const DeviceProfile& profile,
                                            const std::filesystem::path& study,
                                            StimulusBuilder& builder,
                                            const RehearsalCourse& course) {
  const auto compare = [&] { return rehearse_on_device(protocol, profile, builder, course); };
  if (memory == nullptr) return compare();
  return memory->recall(content_key(protocol, study) + json_text_of(profile), course.stop, compare);
}

}  // namespace asperity
