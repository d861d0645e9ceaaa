// What a tick of a point model on a body costs: strokes at 200 mm/s and jumps over bumpy bodies of many facets.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "device/monotonic_clock.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/point_strokes.h"
#include "renderers/offline/tick_times.h"
#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/detailed_bodies.h"
#include "stimuli/meshes/surface_search.h"

namespace asperity {
namespace {

constexpr double kSpeed_m_per_s = 0.2;
constexpr double kDepth_m = 0.001;
constexpr double kJumping_m_per_s = 50.0;  // every tick is found anew
constexpr double kStiffness_N_per_m = 1000.0;
constexpr int kWarmUp = 5'000;
constexpr int kCounted = 100'000;
constexpr int kCountedCold = 2'000;
constexpr std::size_t kEvicting_bytes = 32 << 20;  // more than a core's caches hold

struct Case {
  const char* name = "";
  std::uint32_t around = 0;
  std::uint32_t along = 0;
  bool is_cold = false;
  double depth_m = kDepth_m;
  double speed_m_per_s = kSpeed_m_per_s;
};

nlohmann::ordered_json measure(const Case& each) {
  const std::vector<ProbeState> samples = stroke_on_torus(
      kWarmUp + kCounted, {.depth_m = each.depth_m, .speed_m_per_s = each.speed_m_per_s});
  const TriangleMesh mesh = bumpy_torus(each.around, each.along);
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = kStiffness_N_per_m, .friction = 0.3};
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.parameters = {{"amplitude_m", 0.0}};
  const std::int64_t building_ns = monotonic_now_ns();
  inputs.body = std::make_shared<const BodySurface>(mesh);
  const double built_s = 1e-9 * static_cast<double>(monotonic_now_ns() - building_ns);
  const auto renderer = built_in_models().make("sinusoid", inputs);
  renderer->reset(samples.front());

  double greatest_m = 0.0;
  std::vector<double> penetrations_m;
  penetrations_m.reserve(samples.size());
  const TickTimes times = time_ticks({.warm_up = kWarmUp,
                                      .counted = each.is_cold ? kCountedCold : kCounted,
                                      .evicted_bytes = each.is_cold ? kEvicting_bytes : 0},
                                     [&](int i) {
                                       const RenderedTick tick = renderer->tick(
                                           samples[static_cast<std::size_t>(i)], kStrokeTick_s);
                                       penetrations_m.push_back(tick.penetration_m);
                                       greatest_m = std::max(greatest_m, tick.penetration_m);
                                     });
  // Beyond the depth of the probe, as a force: 0 if the proxy always keeps up.
  const SurfaceSearch truth(mesh);
  double excess_N = 0.0;
  for (std::size_t i = 0; i < penetrations_m.size(); i += 10) {
    const double true_m = truth.nearest(samples[i].position_m).distance_m;
    excess_N = std::max(excess_N, kStiffness_N_per_m * (penetrations_m[i] - 1.05 * true_m));
  }
  const auto quantile_ns = [&times](double fraction) {
    return times.quantile_ns(fraction).value_or(0);
  };
  return {{"name", each.name},
          {"unit", "ns"},
          {"p50", quantile_ns(0.5)},
          {"p99", quantile_ns(0.99)},
          {"p99_9", quantile_ns(0.999)},
          {"count", times.undisturbed_ns.size()},
          {"preempted", times.preempted},
          {"facets", mesh.triangles.size()},
          {"built_s", built_s},
          {"greatest_force_N", kStiffness_N_per_m * greatest_m},
          {"force_beyond_1_05_times_true_depth_N", excess_N}};
}

int run() {
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Case& each :
       {Case{"proxy/100k", 316, 159, false}, Case{"proxy/600k", 775, 388, false},
        Case{"proxy/100k/cold", 316, 159, true}, Case{"proxy/600k/cold", 775, 388, true},
        Case{"proxy/100k/above", 316, 159, false, -kDepth_m},
        Case{"proxy/600k/above", 775, 388, false, -kDepth_m},
        Case{"proxy/100k/jumps", 316, 159, false, kDepth_m, kJumping_m_per_s},
        Case{"proxy/600k/jumps", 775, 388, false, kDepth_m, kJumping_m_per_s}}) {
    document["cases"].push_back(measure(each));
  }
  std::puts(document.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace asperity

int main() { return asperity::run(); }
