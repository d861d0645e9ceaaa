// Implements stochastic resonance as a layer around the renderer of a surface.

#include "renderers/force/resonance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "analysis/numbers/random.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/contact_fade.h"
#include "renderers/force/servo_low_pass.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

constexpr const char* kRatio = "resonance_ratio";
constexpr const char* kThreshold = "resonance_threshold_N";
constexpr double kStepsPerSecond = 20.0 * kResonanceCutoff_Hz;
constexpr std::int64_t kMostStepsPerTick = 64;

double given_number(const ParameterValues& parameters, const char* name) noexcept {
  const auto found = parameters.find(name);
  const double* const value =
      found == parameters.end() ? nullptr : std::get_if<double>(&found->second);
  return value == nullptr ? 0.0 : *value;
}

/// √Σh_i²: the standard deviation of filtered white noise with variance 1.
double gain_of_low_pass() noexcept {
  constexpr int kResponse = 2000;  // steps; its end is below 1e-15
  ServoLowPass filter{};
  filter.reset(0.0);
  double power = 0.0;
  for (int i = 0; i < kResponse; ++i) {
    const double response = filter.step(i == 0 ? 1.0 : 0.0);
    power += response * response;
  }
  return std::sqrt(power);
}

class ResonantSurface final : public ForceRenderer {
 public:
  ResonantSurface(std::unique_ptr<ForceRenderer> surface, const RendererInputs& inputs)
      : surface_(std::move(surface)),
        place_(inputs.patch, inputs.material, inputs.parameters),
        noise_(Random(inputs.seed).split("resonance")),
        scale_N_(resonance_sd_N(inputs.parameters) / gain_of_low_pass()) {}

  void reset(const ProbeState& first) noexcept override {
    surface_->reset(first);
    begin_ns_ = first.time_ns;
    begin_filter(-1);
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    RenderedTick result = surface_->tick(probe, dt_s);
    if (!(result.penetration_m > 0.0)) return result;
    const double noise_N =
        scale_N_ * filtered_at(1e-9 * static_cast<double>(probe.time_ns - begin_ns_));
    double& normal_N = result.wrench.force_N.z;
    const double gain = contact_fade(result.penetration_m) * place_.locate(probe.position_m).gain;
    normal_N = std::max(0.0, normal_N + gain * noise_N);
    return result;
  }

  Friction* friction() noexcept override { return surface_->friction(); }
  TipOnCharts* tip() noexcept override { return surface_->tip(); }
  std::span<const NamedCount> limits() const noexcept override { return surface_->limits(); }
  std::string_view error() const noexcept override { return surface_->error(); }

 private:
  void begin_filter(std::int64_t step) noexcept {
    step_ = step;
    filtered_ = 0.0;
    filter_.reset(0.0);
  }

  /// L(ξ) at this time since the first sample; times do not decrease.
  double filtered_at(double time_s) noexcept {
    const auto step = static_cast<std::int64_t>(std::floor(time_s * kStepsPerSecond));
    if (step - step_ > kMostStepsPerTick) begin_filter(step - kMostStepsPerTick);
    while (step_ < step) {
      ++step_;
      filtered_ = filter_.step(noise_.split(static_cast<std::uint64_t>(step_)).normal());
    }
    return filtered_;
  }

  std::unique_ptr<ForceRenderer> surface_;
  SurfaceContact place_;
  Random noise_;
  double scale_N_ = 0.0;
  ServoLowPass filter_{};
  std::int64_t begin_ns_ = 0;
  std::int64_t step_ = -1;
  double filtered_ = 0.0;
};

}  // namespace

void add_resonance_parameters(std::vector<Parameter>& parameters) {
  parameters.push_back(number_parameter(
      kRatio, "1", 0.0, 10.0, 0.0,
      phrase("Models",
             "Stochastic resonance: standard deviation of the added noise relative to "
             "resonance_threshold_N; 0: no noise")));
  parameters.push_back(
      number_parameter(kThreshold, "N", 0.0, 1.0, 0.0,
                       phrase("Models",
                              "Stochastic resonance: the participant's measured detection "
                              "threshold as a force")));
}

double resonance_sd_N(const ParameterValues& parameters) noexcept {
  return given_number(parameters, kRatio) * given_number(parameters, kThreshold);
}

ParameterValues without_unused_resonance(const ParameterValues& parameters) {
  if (given_number(parameters, kRatio) > 0.0) return parameters;
  ParameterValues used = parameters;
  used.erase(kRatio);
  used.erase(kThreshold);
  return used;
}

std::unique_ptr<ForceRenderer> with_resonance(std::unique_ptr<ForceRenderer> surface,
                                              const RendererInputs& inputs) {
  if (!(given_number(inputs.parameters, kRatio) > 0.0)) return surface;
  if (!(given_number(inputs.parameters, kThreshold) > 0.0)) {
    throw PhrasedRefusal(
        phrase("Models",
               "resonance_threshold_N is 0, and resonance_ratio is relative to it; give it the "
               "participant's detection threshold in newtons"));
  }
  return std::make_unique<ResonantSurface>(std::move(surface), inputs);
}

}  // namespace asperity
