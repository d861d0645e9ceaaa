// Implements the conformance suite.

#include "renderers/conformance/conformance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/number_text.h"
#include "analysis/spectrum.h"
#include "renderers/conformance/heap_calls.h"
#include "renderers/force/layers.h"
#include "renderers/offline/along_path.h"
#include "renderers/servo/servo_thread.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr double kServo_Hz = 1000.0;
constexpr double kStiffness_N_per_m = 1000.0;
constexpr double kGratingAmplitude_m = 1e-4;
constexpr double kBall_m = 0.002;
// Deeper than any texture at its defaults, so that a stroke stays in contact.
constexpr double kDepth_m = 0.002;
constexpr double kSpeed_m_per_s = 0.04;
// Twenty samples in a servo tick: what lies above a declared band is seen, not folded into it.
constexpr double kBandRate_Hz = 20'000.0;
constexpr double kPowerInBand = 0.85;
// The rounding of k·d in a model that computes it from heights of its own.
constexpr double kPlate_N = 1e-9;

RendererInputs inputs_for(const ForceModel& model) {
  const auto grating = std::make_shared<const HeightField>(
      make_surface("sinusoid", {{"amplitude_m", kGratingAmplitude_m}}, {0.04, 400, 1}));
  RendererInputs inputs{};
  inputs.material = {.stiffness_N_per_m = kStiffness_N_per_m, .friction = 0.0};
  inputs.patch = {.extent_m = {1.0, 1.0}, .tiling = Tiling::repeat};
  inputs.seed = 1;
  if (model.declaration.needs_bodies) {
    inputs.surface = std::make_shared<const TexturedMesh>(
        body_mesh(PlateShape{{0.07, 0.03, 0.004}}, grating.get()));
    inputs.tool = std::make_shared<const TexturedMesh>(body_mesh(SphereShape{kBall_m}, nullptr));
    return inputs;
  }
  inputs.height_field = grating;
  add_files_of_relief(inputs, model, *grating);
  return inputs;
}

/// The height of the probe above the plane at which the contact begins.
double contact_height_m(const ForceModel& model) {
  // The frame of the ball has its origin at its centre, and the plate has crests.
  return model.declaration.needs_bodies ? 0.5 * kBall_m + kGratingAmplitude_m : 0.0;
}

double depth_m(const ForceModel& model) {
  return model.declaration.needs_bodies ? kGratingAmplitude_m : kDepth_m;
}

/// Along +x at a constant depth.
std::vector<ProbeState> stroke(const ForceModel& model, double duration_s, double rate_Hz) {
  std::vector<ProbeState> path(static_cast<std::size_t>(std::lround(duration_s * rate_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / rate_Hz;
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m = {kSpeed_m_per_s * time_s - 0.02, 0.0,
                          contact_height_m(model) - depth_m(model)};
    path[i].velocity_m_per_s = {kSpeed_m_per_s, 0.0, 0.0};
  }
  return path;
}

/// To and fro over 60 mm at up to 0.94 m/s, into and out of contact.
std::vector<ProbeState> wandering(const ForceModel& model, double duration_s) {
  constexpr double kAcross_rad_per_s = 2.0 * std::numbers::pi * 5.0;
  constexpr double kDown_rad_per_s = 2.0 * std::numbers::pi * 1.7;
  constexpr double kHalf_m = 0.03;
  std::vector<ProbeState> path(static_cast<std::size_t>(std::lround(duration_s * kServo_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / kServo_Hz;
    const double across_rad = kAcross_rad_per_s * time_s;
    const double down_rad = kDown_rad_per_s * time_s;
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m = {kHalf_m * std::sin(across_rad), 0.3 * kHalf_m * std::sin(down_rad),
                          contact_height_m(model) + depth_m(model) * std::cos(down_rad)};
    path[i].velocity_m_per_s = {kHalf_m * kAcross_rad_per_s * std::cos(across_rad),
                                0.3 * kHalf_m * kDown_rad_per_s * std::cos(down_rad),
                                -depth_m(model) * kDown_rad_per_s * std::sin(down_rad)};
  }
  return path;
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
  // height_map renders a plate up to a depth limit only, so the stroke is no deeper than 1 mm.
  std::vector<ProbeState> path = stroke(model, 0.2, kServo_Hz);
  constexpr double kPlateDepth_m = 0.001;
  for (ProbeState& probe : path) probe.position_m.z = -kPlateDepth_m;
  double largest_N = 0.0;
  double largest_m = 0.0;
  for (const RenderedTick& tick : along_path(*renderer, path, kServo_Hz)) {
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
  const std::vector<RenderedTick> once = along_path(*first, path, kServo_Hz);
  const std::vector<RenderedTick> again = along_path(*second, path, kServo_Hz);
  const std::vector<RenderedTick> after_reset = along_path(*first, path, kServo_Hz);
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

/// The first problem of a result; empty for none. A tool that is coupled to the hand pulls at it without contact.
std::string problem_of(const RenderedTick& tick, bool has_bodies) {
  const glm::dvec3& force_N = tick.wrench.force_N;
  const glm::dvec3& torque_N_m = tick.wrench.torque_N_m;
  double sum = tick.penetration_m;
  for (int axis = 0; axis < 3; ++axis) sum += force_N[axis] + torque_N_m[axis];
  if (!std::isfinite(sum)) return "a number that is not finite";
  if (tick.penetration_m < 0.0) return "a negative penetration";
  if (!has_bodies && tick.penetration_m == 0.0 && force_N != glm::dvec3(0.0)) {
    return "a force without contact";
  }
  return {};
}

/// The given values of each run of `finite`: the defaults, then each own parameter at its limits.
std::vector<ParameterValues> values_at_limits(const ForceModel& model) {
  std::vector<ParameterValues> runs{{}};
  // A body at the limits of its sampling takes minutes.
  if (model.declaration.needs_bodies) return runs;
  std::vector<Parameter> shared{};
  add_layer_parameters(shared);
  for (const Parameter& parameter : model.declaration.parameters) {
    const bool is_shared = std::any_of(shared.begin(), shared.end(), [&](const Parameter& each) {
      return each.name == parameter.name;
    });
    if (is_shared) continue;
    if (parameter.kind == ParameterKind::choice) {
      for (const std::string& choice : parameter.choices)
        runs.push_back({{parameter.name, choice}});
    } else {
      runs.push_back({{parameter.name, parameter.minimum}});
      runs.push_back({{parameter.name, parameter.maximum}});
    }
  }
  return runs;
}

ConformanceCheck finite(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "finite",
                         .required = "finite, no negative penetration, no force without contact"};
  RendererInputs at_limits = inputs;
  at_limits.material.friction = 0.3;
  if (!model.declaration.needs_bodies) at_limits.patch.extent_m = {0.04, 0.04};
  const std::vector<ProbeState> path = wandering(model, 0.3);
  std::size_t ticks = 0;
  std::size_t refused = 0;
  for (const ParameterValues& values : values_at_limits(model)) {
    at_limits.parameters = values;
    std::unique_ptr<ForceRenderer> renderer{};
    try {
      renderer = make_renderer(model, at_limits);
    } catch (const std::invalid_argument&) {
      if (values.empty()) throw;
      ++refused;  // values that contradict the defaults of others
      continue;
    }
    for (const RenderedTick& tick : along_path(*renderer, path, kServo_Hz)) {
      ++ticks;
      std::string problem = problem_of(tick, model.declaration.needs_bodies);
      if (problem.empty()) continue;
      if (!renderer->error().empty()) problem += " (" + std::string(renderer->error()) + ')';
      check.result = Conformance::violated;
      check.measured =
          problem + (values.empty() ? " with default parameters" : ' ' + condition_text(values)) +
          ", in tick " + std::to_string((ticks - 1) % path.size());
      return check;
    }
  }
  check.measured = counted(ticks, "tick", "ticks");
  if (refused > 0) {
    check.measured +=
        "; " + counted(refused, "combination", "combinations") + " refused by the model";
  }
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
  for (const ProbeState& probe : path) renderer->tick(probe, 1.0 / kServo_Hz);
  const std::int64_t calls = heap_calls() - before;
  check.result = calls == 0 ? Conformance::met : Conformance::violated;
  check.measured = counted(static_cast<std::size_t>(calls), "heap call", "heap calls") + " in " +
                   counted(path.size(), "tick", "ticks");
  return check;
}

ConformanceCheck band(const ForceModel& model, const RendererInputs& inputs) {
  ConformanceCheck check{.name = "band"};
  const double twice_Hz = 2.0 * band_Hz(model, inputs, kSpeed_m_per_s);
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
  check.measured = percent(within_N2 / all_N2) + " of " + number_text(std::sqrt(all_N2)) + " N RMS";
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
    renderer->tick(path[i], 1.0 / kServo_Hz);
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

struct NamedCheck {
  const char* name = nullptr;
  ConformanceCheck (*run)(const ForceModel&, const RendererInputs&) = nullptr;
};

constexpr NamedCheck kChecks[]{{"zero_amplitude", zero_amplitude},
                               {"deterministic", deterministic},
                               {"finite", finite},
                               {"no_allocation", no_allocation},
                               {"band", band},
                               {"time_per_tick", time_per_tick}};

}  // namespace

std::vector<ConformanceCheck> conformance_of(const ForceModel& model) {
  std::vector<ConformanceCheck> checks{};
  const RendererInputs inputs = inputs_for(model);
  for (const NamedCheck& check : kChecks) {
    try {
      checks.push_back(check.run(model, inputs));
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
