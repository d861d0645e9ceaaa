// Implements noise that is indexed by time, or by the length of the hand's path.

#include "renderers/models/stochastic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/numbers/random.h"
#include "renderers/force/contact_fade.h"
#include "renderers/force/layers.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/servo_low_pass.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class NoiseInTime final : public ForceRenderer {
 public:
  explicit NoiseInTime(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        noise_(Random(inputs.seed).split("stochastic")),
        mean_N_(number_of(inputs.parameters, "noise_mean_N")),
        sd_N_(number_of(inputs.parameters, "noise_sd_N")),
        rate_Hz_(number_of(inputs.parameters, "noise_rate_Hz")),
        threshold_m_per_s_(number_of(inputs.parameters, "velocity_threshold_m_per_s")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    first_ns_ = first.time_ns;
    step_ = 0;
    held_ = noise_.split(step_).normal();
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const glm::dvec3& v = probe.velocity_m_per_s;
    if (std::sqrt(v.x * v.x + v.y * v.y) >= threshold_m_per_s_) {
      const double noise_N = mean_N_ + sd_N_ * noise_at(probe.time_ns);
      normal_N = std::max(0.0, normal_N + contact_fade(penetration_m) * noise_N);
    }
    return contact_.force(
        point, probe,
        {.texture_N = {0.0, 0.0, normal_N}, .normal_N = normal_N, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  double noise_at(std::int64_t time_ns) noexcept {
    // Multiplication precedes division: the result is exact wherever a step begins on a whole nanosecond.
    const double steps = static_cast<double>(time_ns - first_ns_) * rate_Hz_ / 1e9;
    const auto step = static_cast<std::uint64_t>(std::max(0.0, std::floor(steps + 0.5)));
    if (step != step_) {
      step_ = step;
      held_ = noise_.split(step).normal();
    }
    return held_;
  }

  SurfaceContact contact_;
  Random noise_;
  double mean_N_ = 0.0;
  double sd_N_ = 0.0;
  double rate_Hz_ = 0.0;
  double threshold_m_per_s_ = 0.0;
  std::int64_t first_ns_ = 0;
  std::uint64_t step_ = 0;
  double held_ = 0.0;
};

class NoiseAlongPath final : public ForceRenderer {
 public:
  explicit NoiseAlongPath(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        noise_(Random(inputs.seed).split("stochastic")),
        mean_N_(number_of(inputs.parameters, "noise_mean_N")),
        sd_N_(number_of(inputs.parameters, "noise_sd_N")),
        steps_per_m_(inputs.patch.motion_scale / number_of(inputs.parameters, "noise_length_m")),
        clock_(number_of(inputs.parameters, "device_step_m")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    clock_.reset(first.position_m);
    length_m_ = 0.0;
    step_ = 0;
    held_N_ = 0.0;
    low_pass_.reset(0.0);
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const double noise_N = noise_up_to(clock_.advance(probe.position_m));
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const double plate_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double normal_N = std::max(0.0, plate_N + contact_fade(penetration_m) * noise_N);
    return contact_.force(
        point, probe,
        {.texture_N = {0.0, 0.0, normal_N}, .normal_N = normal_N, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  /// The noise on the way to this length, in equal steps, below half the servo rate.
  double noise_up_to(double length_m) noexcept {
    const double way_m = (length_m - length_m_) / ServoLowPass::kStepsPerTick;
    double filtered_N = 0.0;
    for (int part = 1; part <= ServoLowPass::kStepsPerTick; ++part) {
      filtered_N = low_pass_.step(noise_at(length_m_ + way_m * part));
    }
    length_m_ = length_m;
    return filtered_N;
  }

  double noise_at(double length_m) noexcept {
    const auto step = static_cast<std::uint64_t>(std::floor(length_m * steps_per_m_ + 0.5));
    if (step != step_) {
      step_ = step;
      held_N_ = mean_N_ + sd_N_ * noise_.split(step).normal();
    }
    return held_N_;
  }

  SurfaceContact contact_;
  Random noise_;
  double mean_N_ = 0.0;
  double sd_N_ = 0.0;
  double steps_per_m_ = 0.0;
  PathClock clock_;
  ServoLowPass low_pass_{};
  double length_m_ = 0.0;
  std::uint64_t step_ = 0;
  double held_N_ = 0.0;
};

TextureBand band_of_noise(const RendererInputs& inputs) {
  if (choice_of(inputs.parameters, "index") == "time") {
    return {.time_Hz = 0.5 * number_of(inputs.parameters, "noise_rate_Hz")};
  }
  return {.per_m =
              0.5 * inputs.patch.motion_scale / number_of(inputs.parameters, "noise_length_m")};
}

}  // namespace

ForceModel stochastic_model() {
  ModelDeclaration declaration{
      .id = "stochastic",
      .version = "2",
      .summary = phrase("Models",
                        "A flat plate with white noise on its normal force while the hand moves"),
      .source =
          "Siira, Pai (1996), Haptic texturing - a stochastic approach, as restated by Wu, "
          "Song, Zou (2009)",
      .needs_height_field = false,
      .amplitude_parameter = "noise_sd_N",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter("noise_sd_N", "N", 0.0, 5.0, 0.05,
                       phrase("Models", "Standard deviation sigma of the noise")),
      number_parameter(
          "noise_mean_N", "N", -5.0, 5.0, 0.0,
          phrase("Models",
                 "Mean of the noise; 0 for a texture whose mean height has been subtracted")),
      number_parameter(
          "noise_rate_Hz", "Hz", 10.0, 10000.0, 1000.0,
          phrase("Models",
                 "Rate at which the noise takes a new value, independent of the servo rate")),
      number_parameter(
          "velocity_threshold_m_per_s", "m/s", 0.0, 0.1, 0.005,
          phrase("Models",
                 "Index time only: speed along the surface below which there is no noise")),
      choice_parameter(
          "index", {"time", "distance"},
          phrase("Models",
                 "time: a new value after each 1/noise_rate_Hz, as in the source; distance: after "
                 "each noise_length_m of the path along the surface")),
      number_parameter(
          "noise_length_m", "m", 5e-5, 0.01, 1e-4,
          phrase("Models",
                 "Index distance only: length of path after which the noise takes a new value")),
      device_step_parameter(phrase(
          "Models",
          "Index distance only: position step of the device; motion of up to two steps, and of up "
          "to 20 µm, does not lengthen the path. A session takes a missing value from its "
          "device"))};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            if (choice_of(inputs.parameters, "index") == "distance") {
              return std::make_unique<NoiseAlongPath>(inputs);
            }
            return std::make_unique<NoiseInTime>(inputs);
          },
          .suggested_by =
              [](const HeightField& field, const Material& material) {
                return ParameterValues{{"noise_sd_N", material.stiffness_N_per_m * field.rms_m()},
                                       {"noise_mean_N", 0.0}};
              },
          .moves_by_itself_with =
              ParameterValues{{"index", std::string("time")}, {"velocity_threshold_m_per_s", 0.0}},
          .band = band_of_noise,
          .band_formula = "noise_rate_Hz/2; with index=distance v/(2*noise_length_m)"};
}

}  // namespace asperity
