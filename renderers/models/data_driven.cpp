// Implements the vibration of autoregressive models over speed and force.

#include "renderers/models/data_driven.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/signals/band_limited.h"
#include "analysis/signals/line_spectrum.h"
#include "renderers/force/contact_fade.h"
#include "renderers/force/layers.h"
#include "renderers/force/motion_gate.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/surface_contact.h"
#include "renderers/recordings/relief_recording.h"
#include "renderers/vibrations/vibration_fit.h"
#include "renderers/vibrations/vibration_map.h"

namespace asperity {
namespace {

VibrationMap map_of(const RendererInputs& inputs) {
  const std::string name = name_of_asset(inputs, kVibrationModelsRole);
  return {vibration_models_in(*inputs.assets.at(kVibrationModelsRole), name),
          choice_of(inputs.parameters, "variance") == "linear" ? VarianceLaw::linear
                                                               : VarianceLaw::logarithmic,
          name};
}

/// The last samples of a signal, contiguous, the latest at the end.
class LatestSamples final {
 public:
  static constexpr std::size_t kCount = 64;

  void clear() noexcept { *this = {}; }
  void push(double value) noexcept {
    twice_[at_] = value;
    twice_[at_ + kCount] = value;
    at_ = (at_ + 1) % kCount;
  }
  std::span<const double> values() const noexcept { return std::span(twice_).subspan(at_, kCount); }

 private:
  std::array<double, 2 * kCount> twice_{};  // so that every kCount of them follow each other
  std::size_t at_ = 0;
};

/// The autoregressive process as a normalised ladder [Gray 1975]: rotations by the arcs of its reflection coefficients κ_m,
/// whose states are the backward prediction errors at unit variance.
///
///   f_p = ξ,   f_{m−1} = √(1 − κ_m²)·f_m + κ_m·b_{m−1}',   b_m = √(1 − κ_m²)·b_{m−1}' − κ_m·f_m,   b_0 = f_0
///   a   = f_0·σ/Π √(1 − κ_m²)                             ' of the sample before
///
/// Rotations keep the energy of the states, so that no change of the κ_m amplifies the vibration; states that are past values
/// of a would be amplified by orders of magnitude where the filter of one speed meets a resonance of another.
class Ladder final {
 public:
  void reset() noexcept { backward_.fill(0.0); }

  /// Takes c_1 … c_p, which it overwrites, and σ.
  void set(std::span<double> coefficients, double sd) noexcept {
    order_ = coefficients.size();
    output_ = sd;
    for (std::size_t k = order_; k > 0; --k) {  // the Levinson recursion downwards
      const double reflection = coefficients[k - 1];
      const double less = 1.0 - reflection * reflection;
      reflections_[k - 1] = reflection;
      cosines_[k - 1] = std::sqrt(std::max(kLeastPart, less));
      output_ /= cosines_[k - 1];
      const double inverse = 1.0 / std::max(kLeastPart, less);
      for (std::size_t j = 0; j < k / 2; ++j) {
        const double front = coefficients[j];
        const double back = coefficients[k - 2 - j];
        coefficients[j] = (front + reflection * back) * inverse;
        coefficients[k - 2 - j] = (back + reflection * front) * inverse;
      }
    }
  }

  double step(double noise) noexcept {
    double forward = noise;
    for (std::size_t m = order_; m > 0; --m) {
      const double before = backward_[m - 1];
      backward_[m] = cosines_[m - 1] * before - reflections_[m - 1] * forward;
      forward = cosines_[m - 1] * forward + reflections_[m - 1] * before;
    }
    backward_[0] = forward;
    return output_ * forward;
  }

 private:
  static constexpr double kLeastPart = 1e-12;  // of a variance, where rounding leaves nothing

  std::size_t order_ = 0;
  double output_ = 0.0;
  std::array<double, kMostSpectralLines> reflections_{};
  std::array<double, kMostSpectralLines> cosines_{};
  std::array<double, kMostSpectralLines + 1> backward_{};
};

/// The process at 1 kHz, and its value at the times of the servo loop.
class VibrationProcess final {
 public:
  VibrationProcess(VibrationMap map, const Random& noise) : map_(std::move(map)), noise_(noise) {}

  void reset() noexcept {
    samples_.clear();
    ladder_.reset();
    step_ = 0;
    passed_ = 0.0;
    period_ = 0.0;
    triangle_ = 0;
  }

  /// The acceleration after another tick, in m/s².
  double advance(const VibrationMap::Place& place, double dt_s) noexcept {
    const double dt = dt_s * kVibrationRate_Hz;
    period_ = period_ == 0.0 ? dt : period_ + (dt - period_) * dt / (dt + kRateSteadiness);
    passed_ += dt;
    if (passed_ >= 1.0) {
      const double sd = map_.filter_at(place, triangle_, coefficients_);
      ladder_.set(std::span(coefficients_).first(map_.order()), sd);
      // After a standstill of the loop the process continues where it was.
      passed_ = std::min(passed_, static_cast<double>(kMostStepsPerTick) + 0.5);
      for (; passed_ >= 1.0; passed_ -= 1.0) {
        samples_.push(ladder_.step(noise_.split(step_++).normal()));
      }
    }
    const double rate = std::clamp(1.0 / period_, kLowestRate, 1.0);
    const double lag = BandLimitedInterpolation::kReach / rate;
    const double latest = static_cast<double>(LatestSamples::kCount - 1);
    return between_.value(samples_.values(), latest + passed_ - lag, rate);
  }

 private:
  static constexpr int kMostStepsPerTick = 32;
  static constexpr double kLowestRate = 0.5;  // of 1 kHz; the samples that are kept reach to it
  static constexpr double kRateSteadiness = 500.0;  // in samples: single late ticks change nothing

  VibrationMap map_;
  Random noise_;
  BandLimitedInterpolation between_{};
  std::array<double, kMostSpectralLines> coefficients_{};
  Ladder ladder_{};
  LatestSamples samples_{};
  std::uint64_t step_ = 0;  ///< n
  double passed_ = 0.0;     ///< since the last sample, in samples
  double period_ = 0.0;     ///< of the servo loop, in samples
  std::size_t triangle_ = 0;
};

enum class VibrationAxis { binormal, motion, normal };

VibrationAxis vibration_axis_of(const ParameterValues& parameters) {
  const std::string& axis = choice_of(parameters, "axis");
  if (axis == "motion") return VibrationAxis::motion;
  return axis == "normal" ? VibrationAxis::normal : VibrationAxis::binormal;
}

class DataDriven final : public ForceRenderer {
 public:
  explicit DataDriven(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        process_(map_of(inputs), Random(inputs.seed).split("data_driven")),
        force_per_acceleration_kg_(number_of(inputs.parameters, "gain") *
                                   number_of(inputs.parameters, "effective_mass_kg")),
        rest_speed_m_per_s_(number_of(inputs.parameters, "friction_speed_m_per_s")),
        motion_scale_(inputs.patch.motion_scale),
        axis_(vibration_axis_of(inputs.parameters)),
        clock_(number_of(inputs.parameters, "device_step_m")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    clock_.reset(first.position_m);
    gate_.reset();
    process_.reset();
    half_filtered_m_per_s_ = 0.0;
    speed_m_per_s_ = 0.0;
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const glm::dvec3& v = probe.velocity_m_per_s;
    const double square = v.x * v.x + v.y * v.y;
    const double part = kSpeedFilter_per_s * dt_s / (1.0 + kSpeedFilter_per_s * dt_s);
    half_filtered_m_per_s_ += part * (motion_scale_ * std::sqrt(square) - half_filtered_m_per_s_);
    speed_m_per_s_ += part * (half_filtered_m_per_s_ - speed_m_per_s_);
    const double gate = gate_.advance(clock_.advance(probe.position_m), dt_s);
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = std::max(0.0, -point.height_m);
    double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double texture_N =
        force_per_acceleration_kg_ * gate * contact_fade(penetration_m) *
        process_.advance({.speed_m_per_s = speed_m_per_s_, .normal_N = normal_N}, dt_s);
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const double per_speed_N =
        texture_N / std::sqrt(square + rest_speed_m_per_s_ * rest_speed_m_per_s_);
    glm::dvec3 force_N{0.0, 0.0, normal_N};
    switch (axis_) {
      case VibrationAxis::binormal:
        force_N.x = per_speed_N * v.y;
        force_N.y = -per_speed_N * v.x;
        break;
      case VibrationAxis::motion:
        force_N.x = per_speed_N * v.x;
        force_N.y = per_speed_N * v.y;
        break;
      case VibrationAxis::normal:
        normal_N = std::max(0.0, normal_N + texture_N);
        force_N.z = normal_N;
        break;
    }
    return contact_.force(
        point, probe, {.texture_N = force_N, .normal_N = normal_N, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  static constexpr double kSpeedFilter_per_s = 125.0;  // of the source, "20 Hz"

  SurfaceContact contact_;
  VibrationProcess process_;
  double force_per_acceleration_kg_ = 0.0;
  double rest_speed_m_per_s_ = 0.0;
  double motion_scale_ = 1.0;
  VibrationAxis axis_ = VibrationAxis::binormal;
  PathClock clock_;
  MotionGate gate_{};
  double half_filtered_m_per_s_ = 0.0;
  double speed_m_per_s_ = 0.0;
};

std::vector<Parameter> parameters_of_vibration() {
  std::vector<Parameter> parameters{
      number_parameter("gain", "1", 0.0, 1000.0, 1.0,
                       phrase("Models", "Factor on the force of the vibration")),
      number_parameter(
          "effective_mass_kg", "kg", 0.001, 10.0, kEffectiveMass_kg,
          phrase("Models",
                 "Mass of handle and hand that the vibration accelerates; the force is this mass "
                 "times the acceleration of the models")),
      choice_parameter(
          "axis", {"motion", "binormal", "normal"},
          phrase("Models",
                 "Direction of the vibration: along the motion, along the surface across the "
                 "motion (binormal, as in the source), or along the normal")),
      choice_parameter(
          "variance", {"logarithmic", "linear"},
          phrase("Models",
                 "Whether the logarithm of the variance is interpolated between models, or the "
                 "variance, as in the toolkit, whose sets have silent models")),
      device_step_parameter()};
  add_layer_parameters(parameters);
  return parameters;
}

}  // namespace

ForceModel data_driven_model() {
  return {
      .declaration =
          {.id = "data_driven",
           .version = "2",
           .summary = phrase("Models",
                             "A flat plate with the vibration of autoregressive models over "
                             "speed and force"),
           .source = "Culbertson, Lopez Delgado, Kuchenbecker (2014), One hundred "
                     "data-driven haptic texture models",
           .needs_height_field = false,
           .amplitude_parameter = "gain",
           .replay_tolerance_N = 1e-6,  // of logarithms and exponentials in a recursion
           .parameters = parameters_of_vibration(),
           .assets = {{kVibrationModelsRole,
                       phrase("Models",
                              "autoregressive models of a texture at several speeds and normal "
                              "forces, a table that asperity fit-model writes")}}},
      .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
        return std::make_unique<DataDriven>(inputs);
      },
      .files_of_relief =
          [](const HeightField& field) {
            return std::map<std::string, std::string>{
                {kVibrationModelsRole,
                 tsv_of(fitted_vibrations(recording_of_relief(field), "the relief").set)}};
          },
      .band = [](const RendererInputs&) { return TextureBand{.time_Hz = 0.5 * kVibrationRate_Hz}; },
      .band_formula = "500, half of the rate of the models"};
}

}  // namespace asperity
