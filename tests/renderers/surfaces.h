// Surfaces and strokes that the tests of the models share.

#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "device/probe_state.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"

namespace asperity {

inline constexpr double kTick_s = 0.001;

/// Wide enough that no border is near, unless a test is about the border.
inline SurfacePatch wide_patch() { return {.extent_m = {1.0, 1.0}, .tiling = Tiling::repeat}; }

struct Grating {
  double amplitude_m = 0.0002;
  double wavelength_m = 0.004;
  double pitch_m = 0.00005;
  std::size_t rows = 4;
};

/// h = A sin(2π x/L): mean zero, and a whole number of waves, so that it repeats without a seam.
inline std::shared_ptr<const HeightField> grating(const Grating& wave = {}) {
  const auto columns = static_cast<std::size_t>(std::lround(4 * wave.wavelength_m / wave.pitch_m));
  std::vector<float> heights_m(wave.rows * columns);
  for (std::size_t row = 0; row < wave.rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double x_m =
          (static_cast<double>(column) - 0.5 * (static_cast<double>(columns) - 1.0)) * wave.pitch_m;
      heights_m[row * columns + column] = static_cast<float>(
          wave.amplitude_m * std::sin(2.0 * std::numbers::pi * x_m / wave.wavelength_m));
    }
  }
  return std::make_shared<const HeightField>(HeightField::Grid{wave.rows, columns, wave.pitch_m},
                                             std::move(heights_m));
}

/// A field of one height, which every interpolant reproduces exactly.
inline std::shared_ptr<const HeightField> level(float height_m) {
  return std::make_shared<const HeightField>(HeightField::Grid{16, 16, 0.001},
                                             std::vector<float>(256, height_m));
}

/// The files of the models that need one: those of the grating.
inline std::map<std::string, std::shared_ptr<const std::string>, std::less<>> files_of_models() {
  static const auto kFiles = [] {
    RendererInputs inputs;
    const ModelRegistry registry = built_in_models();
    for (const ForceModel& model : registry.models()) {
      add_files_of_relief(inputs, model, *grating());
    }
    return inputs.assets;
  }();
  return kFiles;
}

/// The built-in models that touch a plane with a point and a spring: what compares models with each
/// other compares these.
inline std::vector<ForceModel> point_models() {
  const ModelRegistry registry = built_in_models();
  std::vector<ForceModel> models = registry.models();
  std::erase_if(models, [](const ForceModel& model) {
    const std::string& id = model.declaration.id;
    return model.declaration.needs_bodies || id == "elastic_halfspace" || id == "winkler";
  });
  return models;
}

/// A stroke along +x at constant height and speed.
struct Stroke {
  double from_x_m = 0.0;
  double height_m = -0.002;
  double speed_m_per_s = 0.060;
  double duration_s = 1.0;
  double rate_Hz = 1000.0;
};

inline std::vector<ProbeState> samples_of(const Stroke& stroke) {
  std::vector<ProbeState> samples;
  const auto count = static_cast<std::int64_t>(std::lround(stroke.duration_s * stroke.rate_Hz));
  for (std::int64_t i = 0; i < count; ++i) {
    ProbeState probe;
    probe.time_ns = std::llround(static_cast<double>(i) * 1e9 / stroke.rate_Hz);
    probe.position_m = {
        stroke.from_x_m + stroke.speed_m_per_s * static_cast<double>(i) / stroke.rate_Hz, 0.0,
        stroke.height_m};
    probe.velocity_m_per_s = {stroke.speed_m_per_s, 0.0, 0.0};
    samples.push_back(probe);
  }
  return samples;
}

/// Ticks of 1 kHz at the last place, of a hand that has just stopped: its velocity varies about zero.
inline void add_rest(std::vector<ProbeState>& path, int ticks) {
  Random jitter(4);
  const double x_m = path.back().position_m.x;
  for (int tick = 0; tick < ticks; ++tick) {
    ProbeState probe = path.back();
    probe.time_ns += 1'000'000;
    probe.position_m.x = x_m + 1e-5 * (static_cast<double>(jitter.below(3)) - 1.0);
    probe.velocity_m_per_s = {0.02 * (static_cast<double>(jitter.below(3)) - 1.0), 0.0, 0.0};
    path.push_back(probe);
  }
}

/// What a renderer answers to a probe that has just come, at 1 kHz.
inline RenderedTick answer(ForceRenderer& renderer, const ProbeState& probe) {
  renderer.reset(probe);
  return renderer.tick(probe, 0.001);
}

/// The same for a probe that touched the surface at another place in the tick before.
inline RenderedTick answer_after(ForceRenderer& renderer, const ProbeState& before,
                                 const ProbeState& probe) {
  answer(renderer, before);
  return renderer.tick(probe, 0.001);
}

inline ProbeState probe_at(const glm::dvec3& position_m) {
  ProbeState probe;
  probe.position_m = position_m;
  return probe;
}

}  // namespace asperity
