// What a tick of the models of a rigid tip on a soft surface costs: strokes over a grating, and presses, at 1 kHz.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/servo/servo_thread.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr int kWarmUp = 1'000;
constexpr int kCounted = 20'000;

std::int64_t context_switches() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw + usage.ru_nvcsw;
}

struct Case {
  const char* name = "";
  const char* model = "";
  double depth_m = 0.0;        ///< of the middle of the motion
  double pressing_m = 0.0;     ///< amplitude along the normal, at 2 Hz
  double speed_m_per_s = 0.0;  ///< along the surface
};

nlohmann::ordered_json measure(const Case& each) {
  RendererInputs inputs;
  inputs.material.friction = 0.3;
  inputs.patch = {.extent_m = {1.0e3, 1.0e3}, .tiling = Tiling::repeat};
  inputs.height_field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.002, .pitch_m = 5e-5});
  const auto renderer = built_in_models().make(each.model, inputs);
  std::vector<std::int64_t> ticks_ns;
  std::int64_t preempted = 0;
  ProbeState probe{};
  for (int i = 0; i < kWarmUp + kCounted; ++i) {
    const double time_s = 1e-3 * i;
    probe.time_ns = std::llround(1e9 * time_s);
    probe.position_m = {
        each.speed_m_per_s * time_s, 0.3 * each.speed_m_per_s * time_s,
        -each.depth_m - each.pressing_m * std::sin(4.0 * std::numbers::pi * time_s)};
    probe.velocity_m_per_s = {each.speed_m_per_s, 0.3 * each.speed_m_per_s, 0.0};
    if (i == 0) renderer->reset(probe);
    const std::int64_t switches = context_switches();
    const std::int64_t started_ns = monotonic_now_ns();
    renderer->tick(probe, 1e-3);
    const std::int64_t took_ns = monotonic_now_ns() - started_ns;
    if (i < kWarmUp) continue;
    if (context_switches() == switches) {
      ticks_ns.push_back(took_ns);
    } else {
      ++preempted;
    }
  }
  std::sort(ticks_ns.begin(), ticks_ns.end());
  const auto quantile_ns = [&ticks_ns](double fraction) {
    return ticks_ns[static_cast<std::size_t>(fraction * static_cast<double>(ticks_ns.size() - 1))];
  };
  nlohmann::ordered_json result{{"name", each.name},           {"unit", "ns"},
                                {"p50", quantile_ns(0.5)},     {"p99", quantile_ns(0.99)},
                                {"p99_9", quantile_ns(0.999)}, {"count", ticks_ns.size()},
                                {"preempted", preempted}};
  for (const NamedCount& count : renderer->limits()) {
    result[std::string(count.name) + "_ticks"] = count.ticks;
  }
  return result;
}

int run() {
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Case& each :
       {Case{"elastic_halfspace/stroke_60", "elastic_halfspace", 0.0007, 0.0, 0.06},
        Case{"elastic_halfspace/stroke_200", "elastic_halfspace", 0.0007, 0.0, 0.2},
        Case{"elastic_halfspace/deep_200", "elastic_halfspace", 0.0025, 0.0, 0.2},
        Case{"elastic_halfspace/press", "elastic_halfspace", 0.001, 0.0015, 0.0},
        Case{"elastic_halfspace/rest", "elastic_halfspace", 0.0007, 0.0, 0.0},
        Case{"winkler/stroke_200", "winkler", 0.0007, 0.0, 0.2}}) {
    document["cases"].push_back(measure(each));
  }
  std::puts(document.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace asperity

int main() { return asperity::run(); }
