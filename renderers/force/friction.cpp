// Implements the laws of friction and the declarations of their parameters.

#include "renderers/force/friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

namespace asperity {
namespace {

constexpr const char* kSpeed = "friction_speed_m_per_s";
constexpr const char* kLaw = "friction_law";
constexpr const char* kMass = "friction_mass_kg";
constexpr const char* kDelay = "friction_delay_s";
constexpr const char* kStiffness = "friction_stiffness_N_per_m";
constexpr const char* kSmoothing = "friction_smoothing_s";
constexpr const char* kStaticRatio = "friction_static_ratio";
constexpr const char* kDamping = "friction_damping_N_s_per_m";

// Below this speed a sliding proxy sticks again.
constexpr double kSticking_m_per_s = 1e-3;

// b of `elastoplastic`: 0.17 mm at 0.2 N and the default stiffness, more than the tremor of a hand at rest. A greater one
// makes the beginning of sliding abrupt.
constexpr double kElasticShare = 0.1;
// How much work `elastoplastic` keeps for an increase of the normal force, in units of the energy ½(μN)²/σ of a contact that
// slides: enough to double it. With 1, a reversal under an increasing normal force would meet the bound at zero strain,
// where it is abrupt.
constexpr double kKeptWork = 4.0;
// The low-pass of the normal force of `elastoplastic`, in units of τ_s: 0.5 ms with the default. A position step of 38 µm at
// 500 N/m is a step of the normal force; a longer filter weakens the lateral modulation of fine textures.
constexpr double kNormalSmoothing = 0.2;

glm::dvec2 rounded_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                          FrictionState&) noexcept {
  const double vx = sample.velocity_m_per_s.x;
  const double vy = sample.velocity_m_per_s.y;
  const double v0 = settings.speed_m_per_s;
  const double friction_N_s_per_m =
      settings.coefficient * sample.normal_N / std::sqrt(vx * vx + vy * vy + v0 * v0);
  return {friction_N_s_per_m * vx, friction_N_s_per_m * vy};
}

// The root s of s + c·s/√(s² + a²) = v, for c, a and v not negative, a positive: the speed that friction leaves. The left
// side is concave, so that each step of Newton's method ends below the root and the next one nearer to it.
double bounded_speed(double c, double a, double v) noexcept {
  constexpr int kSteps = 4;
  double s = std::max(v - c, v / (1.0 + c / a));
  for (int step = 0; step < kSteps; ++step) {
    const double square = s * s + a * a;
    const double root = std::sqrt(square);
    s += (v - s - c * s / root) / (1.0 + c * a * a / (square * root));
  }
  return s;
}

glm::dvec2 bounded_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                          FrictionState&) noexcept {
  const double speed_m_per_s = glm::length(sample.velocity_m_per_s);
  if (!(speed_m_per_s > 0.0)) return glm::dvec2(0.0);
  const double sliding_N = settings.coefficient * sample.normal_N;
  const double v_m_per_s = std::max(
      settings.speed_m_per_s, sliding_N / greatest_friction_slope_N_s_per_m(settings, sample.dt_s));
  const double left_m_per_s =
      bounded_speed(sliding_N * sample.dt_s / settings.mass_kg, v_m_per_s, speed_m_per_s);
  const double drag_N =
      sliding_N * left_m_per_s / std::sqrt(left_m_per_s * left_m_per_s + v_m_per_s * v_m_per_s);
  return drag_N / speed_m_per_s * sample.velocity_m_per_s;
}

// The way of the smoothed position since the previous sample; none at the first one of a contact.
glm::dvec2 smoothed_way_m(const FrictionSettings& settings, const FrictionSample& sample,
                          FrictionState& state) noexcept {
  if (!state.in_contact) {
    state.in_contact = true;
    state.halfway_m = sample.position_m;
    state.smooth_m = sample.position_m;
    return glm::dvec2(0.0);
  }
  const double gain =
      settings.smoothing_s > 0.0 ? 1.0 - std::exp(-sample.dt_s / settings.smoothing_s) : 1.0;
  state.halfway_m += gain * (sample.position_m - state.halfway_m);
  const glm::dvec2 way_m = gain * (state.halfway_m - state.smooth_m);
  state.smooth_m += way_m;
  return way_m;
}

glm::dvec2 shortened(const glm::dvec2& vector, double length) noexcept {
  const double present = glm::length(vector);
  return present > length ? length / present * vector : vector;
}

glm::dvec2 proxy_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                        FrictionState& state) noexcept {
  const glm::dvec2 way_m = smoothed_way_m(settings, sample, state);
  const double sliding_N = settings.coefficient * sample.normal_N;
  const double sticking_N = settings.static_ratio * sliding_N;
  state.strain_m += way_m;
  const double strain_m = glm::length(state.strain_m);
  const double limit_m = (state.slides ? sliding_N : sticking_N) / settings.stiffness_N_per_m;
  if (strain_m > limit_m) {
    state.slides = true;
    state.strain_m = shortened(state.strain_m, sliding_N / settings.stiffness_N_per_m);
  } else if (glm::length(way_m) < kSticking_m_per_s * sample.dt_s ||
             glm::dot(way_m, state.strain_m) < 0.0) {  // has turned round
    state.slides = false;
  }
  const glm::dvec2 drag_N = settings.stiffness_N_per_m * state.strain_m;
  if (state.slides || settings.damping_N_s_per_m == 0.0) return drag_N;
  return shortened(drag_N + settings.damping_N_s_per_m / sample.dt_s * way_m, sticking_N);
}

// The share c after the path of the contact, where z_ss is `sliding_m`: unloaded elastically while it points against the path,
// then loaded, which |c| follows until b and then as dr/du = 1 − q², q = (r − b)/(1 − b). The addition theorem of tanh solves
// that for any u, q⁺ = (q + t)/(1 + qt), with t = tanh(u/(1 − b)) = (1 − E)/(1 + E), E = exp(−2u/(1 − b)).
glm::dvec2 moved_share(const glm::dvec2& share, const glm::dvec2& way_m,
                       double sliding_m) noexcept {
  // Beyond it c is e, also without a normal force, by which a quotient would overflow.
  constexpr double kFar = 1e6;
  constexpr double kSlides = 1.0 - 1e-9;
  constexpr double kYieldingShare = 1.0 - kElasticShare;
  const double length_m = glm::length(way_m);
  if (!(length_m > 0.0)) return share;
  const glm::dvec2 towards = way_m / length_m;
  const double along = glm::dot(share, towards);
  if (along > kSlides) return share;  // c is e already: most ticks of a stroke
  if (length_m > kFar * sliding_m) return towards;
  const double length = length_m / sliding_m;
  const double back = std::clamp(-along, 0.0, length);
  const double square = glm::dot(share, share);
  const double before =
      std::max(square + back * (back + 2.0 * along), kElasticShare * kElasticShare);
  const double after = square + length * (length + 2.0 * along);
  const glm::dvec2 elastic = share + length * towards;
  if (!(after > before)) return elastic;
  const double from = std::sqrt(before);
  const double to = std::sqrt(after);
  // (q + t)/(1 + qt) is up/down, with both times (1 − b)(1 + E): one quotient in the end.
  const double q = from - kElasticShare;
  const double rest = std::exp(-2.0 / kYieldingShare * (to - from));
  const double up = q * (1.0 + rest) + kYieldingShare * (1.0 - rest);
  const double down = kYieldingShare * (1.0 + rest) + q * (1.0 - rest);
  return (kElasticShare * down + kYieldingShare * up) / (down * to) * elastic;
}

// `share` times `most_m`, or shorter: what the work holds, whose square is `longest_m2`.
glm::dvec2 held_strain_m(const glm::dvec2& share, double most_m, double longest_m2) noexcept {
  const double square = glm::dot(share, share);
  return square * most_m * most_m > longest_m2 ? std::sqrt(longest_m2 / square) * share
                                               : most_m * share;
}

// The strain after a step `way_m` from `before_m`, under a share that needs more work than the hand has done, w⁺ = w + (z + z⁺)·d
// in units of σ/2. The longest z⁺ towards c has the square w⁺.
glm::dvec2 bounded_strain_m(FrictionState& state, const glm::dvec2& before_m,
                            const glm::dvec2& way_m, double sliding_m) noexcept {
  const double length = glm::length(state.share);
  const double half_m = length > 0.0 ? 0.5 * glm::dot(state.share, way_m) / length : 0.0;
  const double square_m2 = half_m * half_m + state.work_m2 + glm::dot(before_m, way_m);
  if (square_m2 >= 0.0) {
    const double longest_m = std::max(0.0, half_m + std::sqrt(square_m2));
    return held_strain_m(state.share, sliding_m, longest_m * longest_m);
  }
  // The path turns sharply while the work is spent; an elastic step needs none.
  const glm::dvec2 strain_m = shortened(before_m + way_m, sliding_m);
  state.share = strain_m / sliding_m;
  return strain_m;
}

// The normal force after a low-pass, whose readings have the mean age T·(1 − g)/g = τ_n at every period with the gain
// g = T/(T + τ_n).
double smoothed_normal_N(const FrictionSettings& settings, const FrictionSample& sample,
                         const FrictionState& state) noexcept {
  if (!state.in_contact) return sample.normal_N;
  const double smoothing_s = kNormalSmoothing * settings.smoothing_s;
  return sample.normal_N +
         smoothing_s / (sample.dt_s + smoothing_s) * (state.normal_N - sample.normal_N);
}

// The normal force changes first, at one place; then the contact moves.
glm::dvec2 elastoplastic_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                                FrictionState& state) noexcept {
  state.normal_N = smoothed_normal_N(settings, sample, state);
  const glm::dvec2 way_m = smoothed_way_m(settings, sample, state);
  const double sliding_m = settings.coefficient * state.normal_N / settings.stiffness_N_per_m;
  const glm::dvec2 before_m = held_strain_m(state.share, sliding_m, state.work_m2);
  state.share = moved_share(state.share, way_m, sliding_m);
  glm::dvec2 strain_m = sliding_m * state.share;
  double work_m2 = state.work_m2 + glm::dot(before_m + strain_m, way_m);
  if (work_m2 < glm::dot(strain_m, strain_m)) {
    strain_m = bounded_strain_m(state, before_m, way_m, sliding_m);
    work_m2 = state.work_m2 + glm::dot(before_m + strain_m, way_m);
  }
  const double most_m2 = std::max(state.work_m2, kKeptWork * sliding_m * sliding_m);
  state.work_m2 = std::max(glm::dot(strain_m, strain_m), std::min(work_m2, most_m2));
  return settings.stiffness_N_per_m * strain_m;
}

glm::dvec2 dahl_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                       FrictionState& state) noexcept {
  const glm::dvec2 way_m = smoothed_way_m(settings, sample, state);
  const double sliding_m = settings.coefficient * sample.normal_N / settings.stiffness_N_per_m;
  state.strain_m = shortened(state.strain_m, sliding_m);
  if (const double length_m = glm::length(way_m); length_m > 0.0 && sliding_m > 0.0) {
    const glm::dvec2 towards_m = sliding_m / length_m * way_m;
    state.strain_m = towards_m + std::exp(-length_m / sliding_m) * (state.strain_m - towards_m);
  }
  return settings.stiffness_N_per_m * state.strain_m;
}

glm::dvec2 lugre_drag_N(const FrictionSettings& settings, const FrictionSample& sample,
                        FrictionState& state) noexcept {
  const glm::dvec2 way_m = smoothed_way_m(settings, sample, state);
  const double kinetic_N = settings.coefficient * sample.normal_N;
  state.strain_m =
      shortened(state.strain_m, settings.static_ratio * kinetic_N / settings.stiffness_N_per_m);
  const double length_m = glm::length(way_m);
  if (!(length_m > 0.0) || !(kinetic_N > 0.0)) return settings.stiffness_N_per_m * state.strain_m;
  const double speed_m_per_s = length_m / sample.dt_s;
  const double part = speed_m_per_s / settings.speed_m_per_s;
  const double level_N = kinetic_N * (1.0 + (settings.static_ratio - 1.0) * std::exp(-part * part));
  const double sliding_m = level_N / settings.stiffness_N_per_m;
  const glm::dvec2 before_m = state.strain_m;
  const glm::dvec2 towards_m = sliding_m / length_m * way_m;
  state.strain_m = towards_m + std::exp(-length_m / sliding_m) * (state.strain_m - towards_m);
  const double damping_N_s_per_m =
      std::min(settings.damping_N_s_per_m, 4.0 * level_N / speed_m_per_s);
  return settings.stiffness_N_per_m * state.strain_m +
         damping_N_s_per_m / sample.dt_s * (state.strain_m - before_m);
}

FrictionNearRest rounded_near_rest(const FrictionSettings& settings, double normal_N,
                                   double) noexcept {
  return {.damper_N_s_per_m = settings.coefficient * normal_N / settings.speed_m_per_s};
}

FrictionNearRest bounded_near_rest(const FrictionSettings& settings, double normal_N,
                                   double period_s) noexcept {
  const double slope_N_s_per_m = std::min(settings.coefficient * normal_N / settings.speed_m_per_s,
                                          greatest_friction_slope_N_s_per_m(settings, period_s));
  // D = B·v' with v' = v − (T/m̂)·D.
  return {.damper_N_s_per_m =
              slope_N_s_per_m / (1.0 + slope_N_s_per_m * period_s / settings.mass_kg)};
}

// Two low-passes with the weights g·(1 − g)^k on readings kT old: their mean age is 2T·(1 − g)/g.
double lag_of_smoothing_s(const FrictionSettings& settings, double period_s) noexcept {
  return settings.smoothing_s > 0.0 ? 2.0 * period_s / std::expm1(period_s / settings.smoothing_s)
                                    : 0.0;
}

FrictionNearRest dahl_near_rest(const FrictionSettings& settings, double,
                                double period_s) noexcept {
  return {.stiffness_N_per_m = settings.stiffness_N_per_m,
          .lag_s = lag_of_smoothing_s(settings, period_s)};
}

FrictionNearRest proxy_near_rest(const FrictionSettings& settings, double normal_N,
                                 double period_s) noexcept {
  FrictionNearRest near_rest = dahl_near_rest(settings, normal_N, period_s);
  near_rest.contact_damper_N_s_per_m = settings.damping_N_s_per_m;
  return near_rest;
}

constexpr std::array<std::string_view, 1> kOfRounded{kSpeed};
constexpr std::array<std::string_view, 3> kOfBounded{kSpeed, kMass, kDelay};
constexpr std::array<std::string_view, 4> kOfProxy{kStiffness, kSmoothing, kStaticRatio, kDamping};
constexpr std::array<std::string_view, 2> kOfAdhesion{kStiffness, kSmoothing};
constexpr std::array<std::string_view, 5> kOfLugre{kStiffness, kSmoothing, kStaticRatio, kDamping,
                                                   kSpeed};

constexpr std::array<FrictionLaw, 6> kLaws{{
    {.name = "rounded",
     .meaning =
         [] {
           return phrase("Models",
                         "mu N v / sqrt(v^2 + v0^2), with the velocity that the device reports");
         },
     .parameters = kOfRounded,
     .drag_N = rounded_drag_N,
     .near_rest = rounded_near_rest},
    {.name = "bounded",
     .meaning =
         [] {
           return phrase(
               "Models",
               "the same with an implicit step, and with a slope that is limited so that the "
               "servo loop remains stable");
         },
     .parameters = kOfBounded,
     .drag_N = bounded_drag_N,
     .near_rest = bounded_near_rest},
    {.name = "proxy",
     .meaning =
         [] {
           return phrase(
               "Models",
               "adhesion of a given stiffness that breaks, with stick-slip for a static ratio "
               "above 1");
         },
     .parameters = kOfProxy,
     .remembers = true,
     .drag_N = proxy_drag_N,
     .near_rest = proxy_near_rest},
    {.name = "elastoplastic",
     .meaning =
         [] {
           return phrase(
               "Models",
               "adhesion of a given stiffness that yields smoothly, with a drag that follows the "
               "normal force while sliding");
         },
     .parameters = kOfAdhesion,
     .remembers = true,
     .drag_N = elastoplastic_drag_N,
     .near_rest = dahl_near_rest},
    {.name = "dahl",
     .meaning =
         [] {
           return phrase(
               "Models",
               "adhesion of a given stiffness that creeps, with a smooth transition to sliding");
         },
     .parameters = kOfAdhesion,
     .remembers = true,
     .drag_N = dahl_drag_N,
     .near_rest = dahl_near_rest},
    {.name = "lugre",
     .meaning =
         [] {
           return phrase(
               "Models",
               "the same with a static friction that decreases with speed (Stribeck) and with "
               "damping of the adhesion");
         },
     .parameters = kOfLugre,
     .remembers = true,
     .drag_N = lugre_drag_N,
     .near_rest = proxy_near_rest},
}};

std::string names_of_laws() {
  std::string names{};
  for (const FrictionLaw& law : kLaws) {
    names += (names.empty() ? "" : ", ") + std::string(law.name);
  }
  return names;
}

Parameter law_parameter() {
  Parameter parameter{.name = kLaw,
                      .kind = ParameterKind::choice,
                      .unit = "1",
                      .choices = {},
                      .default_value = std::string("elastoplastic"),
                      .meaning = phrase("Models", "Friction law")};
  for (const FrictionLaw& law : kLaws) {
    parameter.choices.emplace_back(law.name);
    parameter.meaning =
        Phrase("%1; %2: %3").with(parameter.meaning, std::string(law.name), law.meaning());
  }
  return parameter;
}

}  // namespace

std::span<const FrictionLaw> friction_laws() noexcept { return kLaws; }

const FrictionLaw& friction_law(std::string_view name) {
  for (const FrictionLaw& law : kLaws) {
    if (law.name == name) return law;
  }
  throw std::invalid_argument("there is no friction law \"" + std::string(name) +
                              "\"; choose one of: " + names_of_laws());
}

const FrictionLaw& friction_law_of(const ParameterValues& parameters) {
  return parameters.contains(kLaw) ? friction_law(choice_of(parameters, kLaw)) : kLaws.front();
}

FrictionSettings friction_settings(double coefficient, const ParameterValues& parameters) {
  FrictionSettings settings{.coefficient = coefficient,
                            .speed_m_per_s = number_of(parameters, kSpeed)};
  const auto take = [&parameters](const char* name, double& value) {
    if (parameters.contains(name)) value = number_of(parameters, name);
  };
  take(kMass, settings.mass_kg);
  take(kDelay, settings.delay_s);
  take(kStiffness, settings.stiffness_N_per_m);
  take(kSmoothing, settings.smoothing_s);
  take(kStaticRatio, settings.static_ratio);
  take(kDamping, settings.damping_N_s_per_m);
  return settings;
}

double greatest_friction_slope_N_s_per_m(const FrictionSettings& settings,
                                         double period_s) noexcept {
  // As steepest_damper_N_s_per_m of offline/sampled_loop.h, which servo code must not depend on.
  const double delay_ticks = settings.delay_s / period_s;
  return 0.5 * settings.mass_kg / period_s *
         std::sin(0.5 * std::numbers::pi / (2.0 * delay_ticks + 1.0));
}

Parameter friction_speed_parameter() {
  return number_parameter(
      kSpeed, "m/s", 1e-4, 0.1, 0.010,
      phrase("Models",
             "Speed v0 below which Coulomb friction decreases to zero at rest: mu N v / "
             "sqrt(v^2 + v0^2). Law lugre: speed at which 37 % of the difference between static "
             "and kinetic friction remains"));
}

void add_friction_parameters(std::vector<Parameter>& parameters) {
  const FrictionSettings defaults{};
  parameters.push_back(friction_speed_parameter());
  parameters.push_back(law_parameter());
  parameters.push_back(
      number_parameter(kStiffness, "N/m", 10.0, 5000.0, defaults.stiffness_N_per_m,
                       phrase("Models",
                              "Laws proxy, elastoplastic, dahl and lugre: stiffness of the contact "
                              "along the surface before it slides")));
  parameters.push_back(
      number_parameter(kSmoothing, "s", 0.0, 0.02, defaults.smoothing_s,
                       phrase("Models",
                              "Laws proxy, elastoplastic, dahl and lugre: time constant of each of "
                              "the two low-pass filters that smooth the position steps of the "
                              "device; law elastoplastic: the normal force is smoothed by a fifth "
                              "of it; 0: no filter")));
  parameters.push_back(
      number_parameter(kStaticRatio, "1", 1.0, 5.0, defaults.static_ratio,
                       phrase("Models",
                              "Laws proxy and lugre: ratio of static to kinetic friction; the "
                              "friction of the material is the kinetic friction")));
  parameters.push_back(number_parameter(
      kDamping, "N s/m", 0.0, 20.0, defaults.damping_N_s_per_m,
      phrase("Models",
             "Law proxy: damping along the surface while the contact sticks; law lugre: "
             "damping of the adhesion")));
  parameters.push_back(
      number_parameter(kMass, "kg", 0.001, 1.0, defaults.mass_kg,
                       phrase("Models", "Law bounded: moving mass of device and hand")));
  parameters.push_back(number_parameter(kDelay, "s", 0.0, 0.05, defaults.delay_s,
                                        phrase("Models",
                                               "Law bounded: delay of the velocity, the sum of the "
                                               "latency and the lag of the estimate")));
}

ParameterValues friction_values_of(const ParameterValues& parameters) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  ParameterValues values{};
  for (const Parameter& parameter : declared) {
    const auto found = parameters.find(parameter.name);
    if (found != parameters.end()) values.insert(*found);
  }
  return values;
}

ParameterValues without_unused_friction(const ParameterValues& parameters) {
  const FrictionLaw& law = friction_law_of(parameters);
  ParameterValues used = parameters;
  for (const auto& [name, value] : friction_values_of(parameters)) {
    const bool is_used =
        name == kLaw || name == kSpeed ||
        std::find(law.parameters.begin(), law.parameters.end(), name) != law.parameters.end();
    if (!is_used) used.erase(name);
  }
  return used;
}

Friction::Friction(double coefficient, const ParameterValues& parameters)
    : law_(&friction_law_of(parameters)), settings_(friction_settings(coefficient, parameters)) {}

}  // namespace asperity
