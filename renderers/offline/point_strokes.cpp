// Moves the probe to and fro on a plane and around a torus, and renders at the models' defaults.

#include "renderers/offline/point_strokes.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>

#include "analysis/numbers/random.h"

namespace asperity {

std::vector<ProbeState> stroke_on_plane(std::size_t ticks, double height_m) {
  std::vector<ProbeState> samples(ticks);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) * kStrokeTick_s;
    constexpr double kPhase_rad_per_s = std::numbers::pi;
    ProbeState& probe = samples[i];
    probe.time_ns = std::llround(time_s * 1e9);
    probe.position_m = {0.030 * std::sin(kPhase_rad_per_s * time_s), 0.030 * std::sin(0.1 * time_s),
                        height_m};
    probe.velocity_m_per_s = {0.030 * kPhase_rad_per_s * std::cos(kPhase_rad_per_s * time_s),
                              0.003 * std::cos(0.1 * time_s), 0.0};
  }
  return samples;
}

std::vector<ProbeState> stroke_on_torus(std::size_t ticks) {
  constexpr double kDepth_m = 0.001;
  constexpr double kSpeed_m_per_s = 0.2;
  std::vector<ProbeState> samples(ticks);
  double a = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double b = 2.0 * std::numbers::pi * std::sin(0.7 * a);
    const double tube_m =
        0.012 * (1.0 + 0.15 * std::sin(5.0 * a + 0.3) * std::cos(3.0 * b)) - kDepth_m;
    const double radius_m = 0.03 + tube_m * std::cos(b);
    samples[i].position_m = {radius_m * std::cos(a), radius_m * std::sin(a), tube_m * std::sin(b)};
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    if (i > 0) {
      samples[i].velocity_m_per_s =
          (samples[i].position_m - samples[i - 1].position_m) / kStrokeTick_s;
    }
    a += kSpeed_m_per_s * kStrokeTick_s / std::hypot(0.042, 4.4 * 0.0138);
  }
  return samples;
}

RendererInputs rough_plane(const ModelRegistry& models) {
  constexpr std::size_t kSide = 2000;
  std::vector<float> heights_m(kSide * kSide);
  Random random(1);
  for (float& height_m : heights_m) height_m = static_cast<float>(0.0001 * random.normal());
  RendererInputs inputs;
  inputs.height_field = std::make_shared<const HeightField>(
      HeightField::Grid{kSide, kSide, 0.00005}, std::move(heights_m));
  for (const ForceModel& model : models.models()) {
    add_files_of_relief(inputs, model, *inputs.height_field);
  }
  inputs.seed = 1;
  return inputs;
}

}  // namespace asperity
