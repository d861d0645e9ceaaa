// Implements the vibration of a recorded texture.

#include "renderers/models/recorded.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/contact_fade.h"
#include "renderers/force/layers.h"
#include "renderers/force/motion_gate.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/servo_low_pass.h"
#include "renderers/force/surface_contact.h"
#include "renderers/recordings/recorded_spectra.h"
#include "renderers/recordings/relief_recording.h"

namespace asperity {
namespace {

SpectrumAxis axis_of(const ParameterValues& parameters) {
  return choice_of(parameters, "axis_of_spectrum") == "temporal" ? SpectrumAxis::temporal
                                                                 : SpectrumAxis::spatial;
}

RecordedSpectra spectra_of(const RendererInputs& inputs) {
  return {texture_recording_in(*inputs.assets.at(kRecordingRole),
                               name_of_asset(inputs, kRecordingRole)),
          axis_of(inputs.parameters), number_of(inputs.parameters, "force_exponent")};
}

/// Σ_k A_k·cos(2π·k·n/N + φ_k) for n = 0 … N − 1 as a Hartley transform, which is its own inverse up to the factor N: a
/// real spectrum gives it in N·log N steps.
std::vector<double> sum_of_waves(const std::vector<double>& amplitudes,
                                 const std::vector<double>& phases, std::size_t count) {
  std::vector<double> hartley(count, 0.0);
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    // A·cos(ωn + φ) = ½·A·[(cos φ − sin φ)·cas(ωn) + (cos φ + sin φ)·cas(−ωn)], cas x = cos x + sin x.
    const double cosine = 0.5 * amplitudes[i] * std::cos(phases[i]);
    const double sine = 0.5 * amplitudes[i] * std::sin(phases[i]);
    hartley[i + 1] = cosine - sine;
    hartley[count - i - 1] = cosine + sine;
  }
  const std::vector<std::complex<double>> transform = real_spectrum(hartley);
  std::vector<double> wave(count);
  for (std::size_t n = 0; n < count; ++n) {
    // Σ x_k·cas(2πkn/N) = Re X_n − Im X_n; beyond N/2 X is the conjugate.
    wave[n] = 2 * n <= count ? transform[n].real() - transform[n].imag()
                             : transform[count - n].real() + transform[count - n].imag();
  }
  return wave;
}

/// One period of the vibration at each of several speeds, from the recorded ones and 7 between each two.
class WavesAtSpeeds final {
 public:
  WavesAtSpeeds(const RecordedSpectra& spectra, const Random& random) {
    // Four samples for the shortest wave.
    const std::size_t count = std::bit_ceil(4 * std::max<std::size_t>(1, spectra.lines()));
    mask_ = count - 1;
    samples_per_unit_ = static_cast<double>(count) * spectra.spacing();
    std::vector<double> phases{};
    for (std::size_t i = 0; i < spectra.lines(); ++i) {
      phases.push_back(2.0 * std::numbers::pi * random.split(i).uniform());
    }
    const std::vector<double>& speeds = spectra.speeds_m_per_s();
    for (const double speed : speeds) log_speeds_.push_back(std::log(speed));
    const std::size_t tables = (speeds.size() - 1) * kSteps + 1;
    for (std::size_t table = 0; table < tables; ++table) {
      const std::size_t pair = std::min(table / kSteps, speeds.size() - 1);
      const double part = static_cast<double>(table - pair * kSteps) / kSteps;
      const double speed = part == 0.0
                               ? speeds[pair]
                               : speeds[pair] * std::pow(speeds[pair + 1] / speeds[pair], part);
      std::vector<double> amplitudes = spectra.amplitudes_at(speed);
      for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        // Linear interpolation between the samples multiplies a wave by sinc².
        const double half =
            std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(count);
        amplitudes[i] *= half * half / (std::sin(half) * std::sin(half));
      }
      for (const double value : sum_of_waves(amplitudes, phases, count)) {
        waves_.push_back(static_cast<float>(value));
      }
    }
  }

  /// The vibration along a part of the path, at one speed.
  struct Mix {
    const float* slower = nullptr;
    const float* faster = nullptr;
    double part = 0.0;  ///< of the faster one
  };

  Mix at_speed(double speed_m_per_s) const noexcept {
    const double log_speed = std::log(std::max(1e-6, speed_m_per_s));
    std::size_t pair = 0;
    while (pair + 2 < log_speeds_.size() && log_speed > log_speeds_[pair + 1]) ++pair;
    double place = 0.0;
    if (log_speeds_.size() > 1) {
      place =
          static_cast<double>(kSteps) *
          (static_cast<double>(pair) +
           std::clamp((log_speed - log_speeds_[pair]) / (log_speeds_[pair + 1] - log_speeds_[pair]),
                      0.0, 1.0));
    }
    const std::size_t last = waves_.size() / (mask_ + 1) - 1;
    const auto table = std::min(static_cast<std::size_t>(place), last);
    return {.slower = waves_.data() + table * (mask_ + 1),
            .faster = waves_.data() + std::min(table + 1, last) * (mask_ + 1),
            .part = place - static_cast<double>(table)};
  }

  double value(const Mix& mix, double u) const noexcept {
    const double place = u * samples_per_unit_;
    const double floor = std::floor(place);
    const double part = place - floor;
    const std::size_t i = static_cast<std::size_t>(floor) & mask_;
    const std::size_t j = (i + 1) & mask_;
    const double slower = (1.0 - part) * mix.slower[i] + part * mix.slower[j];
    const double faster = (1.0 - part) * mix.faster[i] + part * mix.faster[j];
    return slower + mix.part * (faster - slower);
  }

 private:
  static constexpr std::size_t kSteps = 8;

  std::size_t mask_ = 0;  ///< the number of samples of a period, a power of two, less 1
  double samples_per_unit_ = 0.0;
  std::vector<double> log_speeds_{};
  std::vector<float> waves_{};
};

class Recorded final : public ForceRenderer {
 public:
  Recorded(const RendererInputs& inputs, const RecordedSpectra& spectra)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        waves_(spectra, Random(inputs.seed).split("recorded")),
        gain_(number_of(inputs.parameters, "gain")),
        exponent_(number_of(inputs.parameters, "force_exponent")),
        rest_speed_m_per_s_(number_of(inputs.parameters, "friction_speed_m_per_s")),
        motion_scale_(inputs.patch.motion_scale),
        is_spatial_(axis_of(inputs.parameters) == SpectrumAxis::spatial),
        is_along_motion_(choice_of(inputs.parameters, "axis") == "motion"),
        clock_(number_of(inputs.parameters, "device_step_m")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    clock_.reset(first.position_m);
    gate_.reset();
    low_pass_.reset(0.0);
    reached_ = 0.0;
    speed_m_per_s_ = 0.0;
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const glm::dvec3& v = probe.velocity_m_per_s;
    const double square = v.x * v.x + v.y * v.y;
    speed_m_per_s_ +=
        (motion_scale_ * std::sqrt(square) - speed_m_per_s_) * dt_s / (dt_s + kSmoothing_s);
    const double length_m = clock_.advance(probe.position_m);
    const double gate = gate_.advance(length_m, dt_s);
    const double vibration_N = gain_ * gate *
                               vibration_up_to(is_spatial_ ? motion_scale_ * length_m
                                                           : reached_ + (gate > 0.0 ? dt_s : 0.0));
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double texture_N =
        contact_fade(penetration_m) * vibration_N * std::pow(normal_N, exponent_);
    glm::dvec3 force_N{0.0};
    if (is_along_motion_) {
      const double per_speed_N =
          texture_N / std::sqrt(square + rest_speed_m_per_s_ * rest_speed_m_per_s_);
      force_N = {per_speed_N * v.x, per_speed_N * v.y, normal_N};
    } else {
      normal_N = std::max(0.0, normal_N + texture_N);
      force_N.z = normal_N;
    }
    return contact_.force(
        point, probe, {.texture_N = force_N, .normal_N = normal_N, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  static constexpr double kSmoothing_s = 0.010;  // amplitudes change slowly with the speed

  /// In equal steps, below half the servo rate.
  double vibration_up_to(double u) noexcept {
    const WavesAtSpeeds::Mix mix = waves_.at_speed(speed_m_per_s_);
    const double way = (u - reached_) / ServoLowPass::kStepsPerTick;
    double filtered_N = 0.0;
    for (int part = 1; part <= ServoLowPass::kStepsPerTick; ++part) {
      filtered_N = low_pass_.step(waves_.value(mix, reached_ + way * part));
    }
    reached_ = u;
    return filtered_N;
  }

  SurfaceContact contact_;
  WavesAtSpeeds waves_;
  double gain_ = 1.0;
  double exponent_ = 1.0;
  double rest_speed_m_per_s_ = 0.0;
  double motion_scale_ = 1.0;
  bool is_spatial_ = true;
  bool is_along_motion_ = true;
  PathClock clock_;
  MotionGate gate_{};
  ServoLowPass low_pass_{};
  double reached_ = 0.0;  ///< u of the last tick
  double speed_m_per_s_ = 0.0;
};

std::unique_ptr<ForceRenderer> make_recorded(const RendererInputs& inputs) {
  const RecordedSpectra spectra = spectra_of(inputs);
  if (spectra.speeds_m_per_s().size() < 2 &&
      choice_of(inputs.parameters, "single_speed") == "refused") {
    throw PhrasedRefusal(
        phrase(
            "Models",
            "recording: all strokes have a speed near %1 m/s, and the texture at other speeds is "
            "unknown; record a second speed that differs by at least 10 %, or set single_speed "
            "to accepted")
            .with(fixed(spectra.speeds_m_per_s().front(), 3)));
  }
  return std::make_unique<Recorded>(inputs, spectra);
}

std::vector<Parameter> parameters_of_playback() {
  std::vector<Parameter> parameters{
      number_parameter("gain", "1", 0.0, 1000.0, 1.0,
                       phrase("Models", "Factor applied to the recorded force")),
      number_parameter(
          "force_exponent", "1", 0.0, 3.0, 1.0,
          phrase("Models",
                 "Power of the normal force to which the texture force is proportional; 0: the "
                 "texture force is independent of the normal force")),
      choice_parameter(
          "axis", {"motion", "normal"},
          phrase("Models",
                 "Direction of the texture force: along the motion, or along the normal")),
      choice_parameter(
          "axis_of_spectrum", {"spatial", "temporal"},
          phrase("Models",
                 "spatial: waves along the path, whose frequency in hertz is proportional to the "
                 "speed; "
                 "temporal: frequencies in hertz, interpolated between speeds as in the source")),
      choice_parameter(
          "single_speed", {"refused", "accepted"},
          phrase("Models",
                 "Whether a recording with a single speed is accepted; its spectrum is then used "
                 "at every speed")),
      device_step_parameter()};
  add_layer_parameters(parameters);
  return parameters;
}

}  // namespace

ForceModel recorded_model() {
  return {.declaration =
              {.id = "recorded",
               .version = "2",
               .summary = phrase("Models", "A flat plate with the vibration of a recorded texture"),
               .source = "Vasudevan, Manivannan (2006), Recordable haptic textures",
               .needs_height_field = false,
               .amplitude_parameter = "gain",
               .replay_tolerance_N = 1e-6,  // of tables in single precision
               .parameters = parameters_of_playback(),
               .assets = {{kRecordingRole,
                           phrase("Models",
                                  "the forces of strokes over a texture at two speeds or more, a "
                                  "table that asperity texture-recording writes")}}},
          .make = make_recorded,
          .files_of_relief =
              [](const HeightField& field) {
                return std::map<std::string, std::string>{
                    {kRecordingRole, tsv_of(recording_of_relief(field))}};
              },
          .band =
              [](const RendererInputs& inputs) {
                const double band = spectra_of(inputs).band();
                return axis_of(inputs.parameters) == SpectrumAxis::spatial
                           ? TextureBand{.per_m = inputs.patch.motion_scale * band}
                           : TextureBand{.time_Hz = band};
              },
          .band_formula =
              "v*(waves per metre below which the recording has 99 % of its power); with "
              "axis_of_spectrum=temporal that frequency"};
}

}  // namespace asperity
