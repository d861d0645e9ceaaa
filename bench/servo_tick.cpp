// What a servo tick costs: each model alone on a stroke, and the whole tick with a simulated
// device.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/random.h"
#include "device/machine.h"
#include "device/simulated_device.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/force/friction.h"
#include "renderers/offline/point_strokes.h"
#include "renderers/offline/tick_times.h"
#include "renderers/servo/servo_loop.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr int kWarmUp = 20'000;
constexpr int kCounted = 400'000;
constexpr int kCountedOfBodies = 20'000;  // a tick of two bodies takes hundreds of times as long
constexpr int kCountedCold = 2'000;
constexpr std::size_t kEvicting_bytes = 32 << 20;  // more than a core's caches hold
constexpr const char* kPlainest = "sinusoid";
constexpr double kBall_m = 0.002;

// A loop that sleeps between its ticks finds its caches taken over by others.
enum class Caches { warm, cold };

struct Costs {
  std::string name{};
  TickTimes times{};
};

// Every call is timed alone, the reading of the clock included (case `clock`).
Costs measure(const std::string& name, Caches caches, const std::function<void(int)>& work,
              int counted_warm = kCounted) {
  const bool is_cold = caches == Caches::cold;
  return {.name = name + (is_cold ? "/cold" : ""),
          .times = time_ticks({.warm_up = kWarmUp,
                               .counted = is_cold ? kCountedCold : counted_warm,
                               .evicted_bytes = is_cold ? kEvicting_bytes : 0},
                              work)};
}

std::int64_t quantile_ns(const Costs& costs, double fraction) {
  return costs.times.quantile_ns(fraction).value_or(0);
}

// A plate with a grating of 2 mm and a ball of 2 mm on it, for models of two bodies.
void add_bodies(RendererInputs& inputs) {
  static const auto kBodies = [] {
    const HeightField grating = make_surface("sinusoid", {{"amplitude_m", 1e-4}}, {0.02, 200, 1});
    return std::pair{
        std::make_shared<const TexturedMesh>(body_mesh(PlateShape{{0.08, 0.08, 0.004}}, &grating)),
        std::make_shared<const TexturedMesh>(body_mesh(SphereShape{kBall_m}, nullptr))};
  }();
  std::tie(inputs.surface, inputs.tool) = kBodies;
}

// A model with its default law, or with another one that is computed differently.
struct Law {
  const ForceModel* model = nullptr;
  ParameterValues parameters{};
};

std::string name_of(const Law& law) {
  std::string name = law.model->declaration.id;
  for (const auto& [parameter, value] : law.parameters) {
    name += ',' + parameter + '=' + std::get<std::string>(value);
  }
  return name;
}

Costs model_alone(const Law& law, Caches caches, RendererInputs inputs,
                  const std::vector<ProbeState>& samples, double& felt_N) {
  inputs.parameters = law.parameters;
  const bool has_bodies = law.model->declaration.needs_bodies;
  if (has_bodies) add_bodies(inputs);
  const auto renderer = make_renderer(*law.model, inputs);
  renderer->reset(samples.front());
  return measure(
      "model/" + name_of(law), caches,
      [&](int i) {
        const auto& probe = samples[static_cast<std::size_t>(i)];
        felt_N += renderer->tick(probe, kStrokeTick_s).wrench.force_N.z;
      },
      has_bodies ? kCountedOfBodies : kCounted);
}

Costs whole_tick(const ForceModel& model, Caches caches, const RendererInputs& inputs,
                 double& felt_N) {
  VirtualHand hand(HandHabits{}, Random(2));
  SimulatedDevice device(hand, SimulatedDeviceSettings{});
  RecordRing records;
  ServoLoop loop(device, records, ServoSettings{});
  loop.present({.id = 1, .renderer = make_renderer(model, inputs)});
  hand.stroke();
  const Costs costs = measure("servo_tick/" + model.declaration.id, caches, [&](int i) {
    loop.tick((static_cast<std::int64_t>(i) + 1) * 1'000'000);
    loop.heartbeat();
    TickRecord record;
    while (records.pop(record)) felt_N += record.sent.force_N.z;
  });
  return costs;
}

const char* instruction_set() {
#if defined(__AVX512F__)
  return "avx512";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__SSE2__)
  return "sse2";
#else
  return "generic";
#endif
}

// The median relative to that of the same work on the plainest textured plane; 0 without one.
double ratio_to_plainest(const std::vector<Costs>& all, const Costs& costs) {
  const std::size_t slash = costs.name.find('/');
  if (slash == std::string::npos) return 0.0;
  const std::size_t cold = costs.name.find("/cold");
  const std::string plainest = costs.name.substr(0, slash + 1) + kPlainest +
                               (cold == std::string::npos ? "" : costs.name.substr(cold));
  for (const Costs& other : all) {
    if (other.name != plainest) continue;
    return static_cast<double>(quantile_ns(costs, 0.5)) /
           static_cast<double>(std::max<std::int64_t>(1, quantile_ns(other, 0.5)));
  }
  return 0.0;
}

void print_json(const std::vector<Costs>& all) {
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"isa", instruction_set()},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Costs& costs : all) {
    document["cases"].push_back({{"name", costs.name},
                                 {"unit", "ns"},
                                 {"p50", quantile_ns(costs, 0.5)},
                                 {"p99", quantile_ns(costs, 0.99)},
                                 {"p99_9", quantile_ns(costs, 0.999)},
                                 {"count", costs.times.undisturbed_ns.size()},
                                 {"preempted", costs.times.preempted},
                                 {"ratio_to_plainest", ratio_to_plainest(all, costs)}});
  }
  std::puts(document.dump(2).c_str());
}

void print_table(const std::vector<Costs>& all) {
  std::printf("%-36s %8s %8s %8s %9s %9s %7s\n", "case (ns)", "p50", "p99", "p99.9", "count",
              "preempted", "ratio");
  for (const Costs& costs : all) {
    std::printf("%-36s %8lld %8lld %8lld %9zu %9lld %7.2f\n", costs.name.c_str(),
                static_cast<long long>(quantile_ns(costs, 0.5)),
                static_cast<long long>(quantile_ns(costs, 0.99)),
                static_cast<long long>(quantile_ns(costs, 0.999)),
                costs.times.undisturbed_ns.size(), static_cast<long long>(costs.times.preempted),
                ratio_to_plainest(all, costs));
  }
}

int run(bool as_json) {
  constexpr auto kTicks = static_cast<std::size_t>(kWarmUp + kCounted);
  const std::vector<ProbeState> of_a_point = stroke_on_plane(kTicks, -0.0015);
  // The centre of the ball, 0.1 mm below the place where it touches crests.
  const std::vector<ProbeState> of_a_ball = stroke_on_plane(kTicks, 0.5 * kBall_m);
  const ModelRegistry registry = built_in_models();
  const RendererInputs stimulus = rough_plane(registry);
  const std::vector<ForceModel>& models = registry.models();
  std::vector<Law> laws;
  for (const ForceModel& model : models) laws.push_back({.model = &model});
  laws.push_back({registry.find("stochastic"), {{"index", std::string("distance")}}});
  laws.push_back({registry.find("normal_map"), {{"law", std::string("physical")}}});
  laws.push_back({registry.find("periodic"), {{"force_direction", std::string("gradient")}}});
  for (const FrictionLaw& law : friction_laws()) {
    laws.push_back({registry.find(kPlainest), {{"friction_law", std::string(law.name)}}});
  }
  double felt_N = 0.0;  // printed to nobody, but used: the work cannot be left out
  std::vector<Costs> all;
  all.push_back(measure("clock", Caches::warm, [&](int i) { felt_N += i; }));
  for (const Caches caches : {Caches::warm, Caches::cold}) {
    for (const Law& law : laws) {
      const bool has_bodies = law.model->declaration.needs_bodies;
      all.push_back(
          model_alone(law, caches, stimulus, has_bodies ? of_a_ball : of_a_point, felt_N));
    }
    for (const ForceModel& model : models) {
      // Next to a tick of two bodies the rest of the loop takes no time: see bench_pd_tick.
      if (model.declaration.needs_bodies) continue;
      all.push_back(whole_tick(model, caches, stimulus, felt_N));
    }
  }
  as_json ? print_json(all) : print_table(all);
  return std::isfinite(felt_N) ? 0 : 1;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  if (argc > 2 || (argc == 2 && std::strcmp(argv[1], "--json") != 0)) {
    std::fprintf(stderr, "usage: %s [--json]\n", argv[0]);
    return 2;
  }
  return asperity::run(argc == 2);
}
