// Strokes of a simulated hand over every model, with an oscillation planted in the force on request.

#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"
#include "device/simulated_models.h"
#include "renderers/built_in_models.h"
#include "renderers/force/friction.h"
#include "renderers/offline/perceived_instability.h"
#include "renderers/servo/servo_time.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {

/// A force F·sin(2πft) that the loop adds for a while.
struct PlantedOscillation {
  double amplitude_N = 0.0;
  double frequency_Hz = 0.0;
  double phase_rad = 0.0;
  glm::dvec3 direction{0.0, 0.0, 1.0};
  double from_s = 0.0;
  double duration_s = 0.3;
};

struct PlantedStroke {
  std::string device = "simulated";
  std::uint64_t seed = 1;
  double duration_s = 4.0;
  HandHabits habits{};
  std::optional<PlantedOscillation> planted{};
};

/// The stimulus with the model's defaults: sandpaper for models that need a relief, its recording, or a ball on it.
inline RendererInputs stimulus_of_stroke(const ForceModel& model, std::uint64_t seed) {
  static const auto kField = std::make_shared<const HeightField>(
      make_surface("sandpaper", {{"grain_height_m", 0.0001}, {"grain_spacing_m", 0.001}},
                   SurfaceCanvas{.width_m = 0.05, .pixels = 1024, .seed = 1}));
  static const auto kFiles = [] {
    RendererInputs inputs{};
    const ModelRegistry registry = built_in_models();
    for (const ForceModel& each : registry.models()) add_files_of_relief(inputs, each, *kField);
    return inputs.assets;
  }();
  RendererInputs inputs{};
  inputs.patch = {.extent_m = {0.2, 0.2}, .tiling = Tiling::repeat};
  inputs.height_field = kField;
  inputs.assets = kFiles;
  inputs.seed = seed;
  if (model.declaration.needs_bodies) {
    static const auto kBodies = [] {
      const HeightField relief = make_surface("sinusoid", {{"amplitude_m", 1e-4}}, {0.02, 200, 1});
      return std::pair{
          std::make_shared<const TexturedMesh>(body_mesh(PlateShape{{0.12, 0.06, 0.004}}, &relief)),
          std::make_shared<const TexturedMesh>(
              placed(body_mesh(SphereShape{.diameter_m = 0.002}, nullptr), BodyRole::tool))};
    }();
    std::tie(inputs.surface, inputs.tool) = kBodies;
  }
  return inputs;
}

/// The records of a closed loop at 1 kHz, presentation 1, with the ramp of the beginning.
inline std::vector<TickRecord> planted_stroke(const ForceModel& model, const RendererInputs& inputs,
                                              const PlantedStroke& stroke) {
  constexpr double kStrokeRate_Hz = 1000.0;
  const auto renderer = make_renderer(model, inputs);
  VirtualHand hand(stroke.habits, Random(stroke.seed));
  SimulatedDevice device(hand, simulated_settings(stroke.device).value());
  device.set_limits({.force_N = 8.0});
  hand.stroke();
  const auto ticks = std::llround(stroke.duration_s * kStrokeRate_Hz);
  std::vector<TickRecord> records{};
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    TickRecord record{};
    record.probe = rounded_for_recording(device.read(tick * period_ns_of(kStrokeRate_Hz)).value());
    record.presentation = 1;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.gain = 1.0;
    if (tick == 1) {
      record.flags |= static_cast<std::uint32_t>(TickFlag::first_of_presentation);
      renderer->reset(record.probe);
    }
    const RenderedTick rendered = renderer->tick(record.probe, 1.0 / kStrokeRate_Hz);
    record.rendered = rendered.wrench;
    record.penetration_m = rendered.penetration_m;
    Wrench wanted = rendered.wrench;
    const double time_s = static_cast<double>(tick) / kStrokeRate_Hz;
    if (stroke.planted && time_s >= stroke.planted->from_s &&
        time_s < stroke.planted->from_s + stroke.planted->duration_s) {
      const double phase_rad = 2.0 * std::numbers::pi * stroke.planted->frequency_Hz * time_s +
                               stroke.planted->phase_rad;
      wanted.force_N +=
          stroke.planted->amplitude_N * std::sin(phase_rad) * stroke.planted->direction;
    }
    record.sent = device.push(wanted, 1.0 / kStrokeRate_Hz).value().wrench;
    records.push_back(record);
  }
  return records;
}

inline RecordedTexture texture_in(const ForceModel& model, const RendererInputs& inputs,
                                  std::span<const TickRecord> records) {
  return recorded_texture(model, inputs, {records, 1, 1000.0});
}

inline PerceivedInstability judged_stroke(const ForceModel& model, const RendererInputs& inputs,
                                          std::span<const TickRecord> records) {
  return perceived_instability(model, inputs, texture_in(model, inputs, records));
}

/// Stroke `number` of a series over all models, seeds and simulated devices. Speed and force of the hand are those of
/// participants: 40 to 160 mm/s, 0.5 to 2 N.
struct SeriesStroke {
  const ForceModel* model = nullptr;
  RendererInputs inputs{};
  PlantedStroke stroke{};
};
inline SeriesStroke stroke_of_series(const std::vector<ForceModel>& models, std::uint64_t number,
                                     std::uint64_t seed) {
  static const std::vector<std::string> kDevices{"simulated", "simulated:falcon",
                                                 "simulated:delta.3"};
  Random random = Random(seed).split(number);
  SeriesStroke each{};
  each.model = &models[number % models.size()];
  each.inputs = stimulus_of_stroke(*each.model, number + 1);
  each.stroke.device = kDevices[(number / models.size()) % kDevices.size()];
  each.stroke.seed = seed * 1'000'003 + number;
  each.stroke.habits.speed_m_per_s = 0.040 * std::pow(4.0, random.uniform());
  each.stroke.habits.normal_force_N = 0.5 * std::pow(4.0, random.uniform());
  return each;
}

/// The oscillation of stroke `number`, in 150 to 450 Hz, 0.3 s or longer, in contact, with a given RMS.
inline PlantedOscillation oscillation_of_series(std::uint64_t number, std::uint64_t seed,
                                                double rms_N) {
  Random random = Random(seed).split(number).split("oscillation");
  PlantedOscillation planted{};
  planted.amplitude_N = std::numbers::sqrt2 * rms_N;
  planted.frequency_Hz = 150.0 + 300.0 * random.uniform();
  planted.phase_rad = 2.0 * std::numbers::pi * random.uniform();
  planted.direction = glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
  planted.duration_s = 0.3 + 0.7 * random.uniform();
  planted.from_s = 1.0 + (3.0 - planted.duration_s) * random.uniform();
  return planted;
}

}  // namespace asperity
