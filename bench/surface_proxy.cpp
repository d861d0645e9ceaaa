// What a tick of a point model on a body costs: strokes at 200 mm/s and jumps over bumpy bodies of many facets.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numbers>
#include <sys/resource.h>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/machine.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/proxy/body_surface.h"
#include "renderers/servo/servo_thread.h"
#include "stimuli/meshes/surface_search.h"
#include "tests/renderers/meshes.h"

namespace asperity {
namespace {

constexpr double kSpeed_m_per_s = 0.2;
constexpr double kTick_s = 0.001;
constexpr double kDepth_m = 0.001;
constexpr double kJumping_m_per_s = 50.0;  // every tick is found anew
constexpr double kStiffness_N_per_m = 1000.0;
constexpr int kWarmUp = 5'000;
constexpr int kCounted = 100'000;
constexpr int kCountedCold = 2'000;
constexpr std::size_t kEvicting_bytes = 32 << 20;  // more than a core's caches hold

std::int64_t context_switches() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw + usage.ru_nvcsw;
}

/// A stroke over the tube of bumpy_torus, below its surface.
std::vector<ProbeState> stroke(double depth_m, double speed_m_per_s) {
  std::vector<ProbeState> samples(kWarmUp + kCounted);
  double a = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double b = 2.0 * std::numbers::pi * std::sin(0.7 * a);
    const double tube_m =
        0.012 * (1.0 + 0.15 * std::sin(5.0 * a + 0.3) * std::cos(3.0 * b)) - depth_m;
    const double radius_m = 0.03 + tube_m * std::cos(b);
    samples[i].position_m = {radius_m * std::cos(a), radius_m * std::sin(a), tube_m * std::sin(b)};
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    if (i > 0) {
      samples[i].velocity_m_per_s = (samples[i].position_m - samples[i - 1].position_m) / kTick_s;
    }
    a += speed_m_per_s * kTick_s / std::hypot(0.042, 4.4 * 0.0138);
  }
  return samples;
}

struct Case {
  const char* name = "";
  std::uint32_t around = 0;
  std::uint32_t along = 0;
  bool is_cold = false;
  double depth_m = kDepth_m;
  double speed_m_per_s = kSpeed_m_per_s;
};

nlohmann::ordered_json measure(const Case& each) {
  const std::vector<ProbeState> samples = stroke(each.depth_m, each.speed_m_per_s);
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

  std::vector<char> others(each.is_cold ? kEvicting_bytes : 0);
  std::vector<std::int64_t> ticks_ns;
  std::int64_t preempted = 0;
  double greatest_m = 0.0;
  const int counted = each.is_cold ? kCountedCold : kCounted;
  std::vector<double> penetrations_m;
  for (int i = 0; i < kWarmUp + counted; ++i) {
    for (std::size_t byte = 0; byte < others.size(); byte += 64) ++others[byte];
    const std::int64_t switches = context_switches();
    const std::int64_t started_ns = monotonic_now_ns();
    const RenderedTick tick = renderer->tick(samples[static_cast<std::size_t>(i)], kTick_s);
    const std::int64_t took_ns = monotonic_now_ns() - started_ns;
    penetrations_m.push_back(tick.penetration_m);
    greatest_m = std::max(greatest_m, tick.penetration_m);
    if (i < kWarmUp) continue;
    if (context_switches() == switches) {
      ticks_ns.push_back(took_ns);
    } else {
      ++preempted;
    }
  }
  // Beyond the depth of the probe, as a force: 0 if the proxy always keeps up.
  const SurfaceSearch truth(mesh);
  double excess_N = 0.0;
  for (std::size_t i = 0; i < penetrations_m.size(); i += 10) {
    const double true_m = truth.nearest(samples[i].position_m).distance_m;
    excess_N = std::max(excess_N, kStiffness_N_per_m * (penetrations_m[i] - 1.05 * true_m));
  }
  std::sort(ticks_ns.begin(), ticks_ns.end());
  const auto quantile_ns = [&ticks_ns](double fraction) {
    return ticks_ns[static_cast<std::size_t>(fraction * static_cast<double>(ticks_ns.size() - 1))];
  };
  return {{"name", each.name},
          {"unit", "ns"},
          {"p50", quantile_ns(0.5)},
          {"p99", quantile_ns(0.99)},
          {"p99_9", quantile_ns(0.999)},
          {"count", ticks_ns.size()},
          {"preempted", preempted},
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
