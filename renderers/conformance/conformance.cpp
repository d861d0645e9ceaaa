// Implements the conformance suite.

#include "renderers/conformance/conformance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/spectrum.h"
#include "renderers/conformance/check_paths.h"
#include "renderers/conformance/finite_check.h"
#include "renderers/conformance/heap_calls.h"
#include "renderers/force/indentation_law.h"
#include "renderers/offline/along_path.h"
#include "renderers/servo/servo_thread.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr double kStiffness_N_per_m = 1000.0;
// Twenty samples in a servo tick: what lies above a declared band is seen, not folded into it.
constexpr double kBandRate_Hz = 20'000.0;
constexpr double kPowerInBand = 0.85;
// The rounding of k·d in a model that computes it from heights of its own.
constexpr double kPlate_N = 1e-9;

RendererInputs inputs_for(const ForceModel& model) {
  const auto grating = std::make_shared<const HeightField>(
      make_surface("sinusoid", {{"amplitude_m", kConformanceGratingAmplitude_m}}, {0.04, 400, 1}));
  RendererInputs inputs{};
  inputs.material = {.stiffness_N_per_m = kStiffness_N_per_m, .friction = 0.0};
  inputs.patch = {.extent_m = {1.0, 1.0}, .tiling = Tiling::repeat};
  inputs.seed = 1;
  if (model.declaration.needs_bodies) {
    inputs.surface = std::make_shared<const TexturedMesh>(
        body_mesh(PlateShape{{0.07, 0.03, 0.004}}, grating.get()));
    inputs.tool =
        std::make_shared<const TexturedMesh>(body_mesh(SphereShape{kConformanceBall_m}, nullptr));
    return inputs;
  }
  inputs.height_field = grating;
  add_files_of_relief(inputs, model, *grating);
  return inputs;
}

bool is_same(const RenderedTick& a, const RenderedTick& b) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  for (int axis = 0; axis < 3; ++axis) {
    if (bits(a.wrench.force_N[axis]) != bits(b.wrench.force_N[axis]) ||
        bits(a.wrench.torque_N_m[axis]) != bits(b.wrench.torque_N_m[axis])) {
      return false;
    }
  }
  return bits(a.penetration_m) == bits(b.penetration_m);
}

std::string percent(double proportion) { return fixed(100.0 * proportion, 1) + " %"; }

std::string microseconds(double time_s) { return fixed(1e6 * time_s, 2) + " µs"; }

ConformanceCheck zero_amplitude(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "zero_amplitude",
                         .required = "the plate: k*depth along +z, within 1e-9 N"};
  if (model.declaration.needs_bodies) {
    check.result = Conformance::not_applicable;
    check.measured = "the model has two bodies, whose plate is not k*depth";
    return check;
  }
  if (!model.declaration.amplitude_parameter) {
    check.result = Conformance::violated;
    check.measured = "the model declares no amplitude parameter";
    return check;
  }
  const auto renderer = make_renderer(model, without_texture(model.declaration, inputs));
  if (dynamic_cast<const IndentationLaw*>(renderer.get()) != nullptr) {
    check.result = Conformance::not_applicable;
    check.measured = "the model has its own law of indentation";
    return check;
  }
  // height_map renders a plate up to a depth limit only, so the stroke is no deeper than 1 mm.
  std::vector<ProbeState> path = stroke(model, 0.2, kConformanceRate_Hz);
  constexpr double kPlateDepth_m = 0.001;
  for (ProbeState& probe : path) probe.position_m.z = -kPlateDepth_m;
  double largest_N = 0.0;
  double largest_m = 0.0;
  for (const RenderedTick& tick : along_path(*renderer, path, kConformanceRate_Hz)) {
    const glm::dvec3 difference_N =
        tick.wrench.force_N - glm::dvec3(0.0, 0.0, kStiffness_N_per_m * kPlateDepth_m);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(difference_N[axis]) <= largest_N)) largest_N = std::abs(difference_N[axis]);
    }
    const double off_m = std::abs(tick.penetration_m - kPlateDepth_m);
    if (!(off_m <= largest_m)) largest_m = off_m;
  }
  const bool is_plate = largest_N <= kPlate_N && largest_m <= kPlate_N / kStiffness_N_per_m;
  check.result = is_plate ? Conformance::met : Conformance::violated;
  check.measured = "largest difference " + number_text(largest_N) + " N, " +
                   number_text(largest_m) + " m of penetration";
  return check;
}

ConformanceCheck deterministic(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "deterministic", .required = "the same bits"};
  const std::vector<ProbeState> path = wandering(model, 0.6);
  const auto first = make_renderer(model, inputs);
  const auto second = make_renderer(model, inputs);
  const std::vector<RenderedTick> once = along_path(*first, path, kConformanceRate_Hz);
  const std::vector<RenderedTick> again = along_path(*second, path, kConformanceRate_Hz);
  const std::vector<RenderedTick> after_reset = along_path(*first, path, kConformanceRate_Hz);
  std::size_t differing = 0;
  std::size_t differing_after_reset = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    differing += is_same(once[i], again[i]) ? 0 : 1;
    differing_after_reset += is_same(once[i], after_reset[i]) ? 0 : 1;
  }
  check.result = differing + differing_after_reset == 0 ? Conformance::met : Conformance::violated;
  check.measured = "differing ticks: " + std::to_string(differing) + " in another renderer, " +
                   std::to_string(differing_after_reset) + " after reset, of " +
                   std::to_string(path.size());
  return check;
}

ConformanceCheck no_allocation(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "no_allocation", .required = "0 heap calls"};
  if (!kCountsHeapCalls) {
    check.result = Conformance::not_applicable;
    check.measured = "not counted in a build with sanitizers";
    return check;
  }
  const auto renderer = make_renderer(model, inputs);
  const std::vector<ProbeState> path = wandering(model, 1.0);
  const std::int64_t before = heap_calls();
  renderer->reset(path.front());
  for (const ProbeState& probe : path) renderer->tick(probe, 1.0 / kConformanceRate_Hz);
  const std::int64_t calls = heap_calls() - before;
  check.result = calls == 0 ? Conformance::met : Conformance::violated;
  check.measured = counted(static_cast<std::size_t>(calls), "heap call", "heap calls") + " in " +
                   counted(path.size(), "tick", "ticks");
  return check;
}

ConformanceCheck band(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "band"};
  const double twice_Hz = 2.0 * band_Hz(model, inputs, kConformanceSpeed_m_per_s);
  check.required = "at least " + percent(kPowerInBand) + " of the power below " +
                   fixed(twice_Hz, 1) + " Hz, twice the declared band";
  if (!std::isfinite(twice_Hz) || !(twice_Hz > 0.0)) {
    check.result = Conformance::violated;
    check.measured = "the declared band is not a positive number";
    return check;
  }
  const auto renderer = make_renderer(model, inputs);
  const std::vector<RenderedTick> ticks =
      along_path(*renderer, stroke(model, 0.6, kBandRate_Hz), kBandRate_Hz);
  const std::size_t begin = ticks.size() / 6;  // without the onset of filters
  double all_N2 = 0.0;
  double within_N2 = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> force_N{};
    for (std::size_t i = begin; i < ticks.size(); ++i) {
      force_N.push_back(ticks[i].wrench.force_N[axis]);
    }
    const PowerSpectrum spectrum =
        welch_spectrum(force_N, {.rate_Hz = kBandRate_Hz, .length = force_N.size() / 2});
    all_N2 += band_power(spectrum, {0.0, 0.5 * kBandRate_Hz});
    within_N2 += band_power(spectrum, {0.0, twice_Hz});
  }
  if (!std::isfinite(all_N2)) {
    check.result = Conformance::violated;
    check.measured = "the force is not finite";
    return check;
  }
  constexpr double kNothing_N = 1e-9;
  if (all_N2 < kNothing_N * kNothing_N) {
    check.measured = "no texture with the default parameters";
    return check;
  }
  check.result = within_N2 >= kPowerInBand * all_N2 ? Conformance::met : Conformance::violated;
  check.measured =
      percent(within_N2 / all_N2) + " of " + fixed(1e3 * std::sqrt(all_N2), 2) + " mN RMS";
  return check;
}

ConformanceCheck time_per_tick(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "time_per_tick",
                         .required = "median at most " + microseconds(kLongestMedianTick_s)};
  const auto renderer = make_renderer(model, inputs);
  const std::vector<ProbeState> path = wandering(model, 2.0);
  std::vector<std::int64_t> times_ns(path.size());
  renderer->reset(path.front());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::int64_t before_ns = monotonic_now_ns();
    renderer->tick(path[i], 1.0 / kConformanceRate_Hz);
    times_ns[i] = monotonic_now_ns() - before_ns;
  }
  std::sort(times_ns.begin(), times_ns.end());
  const auto quantile_s = [&](std::size_t percentile) {
    return 1e-9 * static_cast<double>(times_ns[times_ns.size() * percentile / 100]);
  };
  check.result = quantile_s(50) <= kLongestMedianTick_s ? Conformance::met : Conformance::violated;
  check.measured = "median " + microseconds(quantile_s(50)) + ", 99th percentile " +
                   microseconds(quantile_s(99));
  return check;
}

using RunCheck = ConformanceCheck (*)(const ForceModel&, const RendererInputs&,
                                      const ConformanceCourse&);

/// A check that takes too little time to be stopped.
template <ConformanceCheck (*check)(const ForceModel&, const RendererInputs&)>
ConformanceCheck short_check(const ForceModel& model, const RendererInputs& inputs,
                             const ConformanceCourse&) {
  return check(model, inputs);
}

struct NamedCheck {
  const char* name = nullptr;
  RunCheck run = nullptr;
};

constexpr std::array kChecks{NamedCheck{"zero_amplitude", short_check<zero_amplitude>},
                             NamedCheck{"deterministic", short_check<deterministic>},
                             NamedCheck{"finite", finite_check},
                             NamedCheck{"no_allocation", short_check<no_allocation>},
                             NamedCheck{"band", short_check<band>},
                             NamedCheck{"time_per_tick", short_check<time_per_tick>}};

}  // namespace

std::vector<ConformanceCheck> conformance_of(const ForceModel& model,
                                             const ConformanceCourse& course) {
  std::vector<ConformanceCheck> checks{};
  const RendererInputs inputs = inputs_for(model);
  for (const NamedCheck& check : kChecks) {
    if (course.stop.stop_requested()) break;
    if (course.progress) {
      course.progress(static_cast<double>(checks.size()) / static_cast<double>(kChecks.size()));
    }
    try {
      checks.push_back(check.run(model, inputs, course));
    } catch (const std::exception& error) {
      checks.push_back({.name = check.name,
                        .result = Conformance::violated,
                        .measured = error.what(),
                        .required = "a renderer that runs"});
    }
  }
  return checks;
}

bool is_conformant(const std::vector<ConformanceCheck>& checks) {
  return std::none_of(checks.begin(), checks.end(), [](const ConformanceCheck& check) {
    return check.result == Conformance::violated;
  });
}

}  // namespace asperity
