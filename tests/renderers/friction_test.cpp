// The laws of friction: each against its formula, its energy, and where a contact begins and ends.

#include "renderers/force/friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/force/layers.h"
#include "renderers/models/sinusoid.h"
#include "renderers/offline/along_path.h"
#include "renderers/offline/force_matching.h"
#include "renderers/offline/sampled_loop.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kMu = 0.3;

/// The parameters of friction, with the defaults of those that are not given.
ParameterValues friction_with(const std::string& law, const ParameterValues& given = {}) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  ParameterValues values = given;
  values["friction_law"] = law;
  return complete_values("friction", declared, values);
}

/// Without the low-passes of the position, whose delay is a subject of its own.
ParameterValues prompt(const std::string& law, double stiffness_N_per_m = 1000.0,
                       double static_ratio = 1.0, double damping_N_s_per_m = 0.0) {
  ParameterValues values{{"friction_smoothing_s", 0.0},
                         {"friction_stiffness_N_per_m", stiffness_N_per_m}};
  values["friction_static_ratio"] = static_ratio;
  values["friction_damping_N_s_per_m"] = damping_N_s_per_m;
  return friction_with(law, values);
}

FrictionSample at(const glm::dvec2& position_m, double normal_N = 1.0, double dt_s = kTick_s) {
  return {.position_m = position_m, .normal_N = normal_N, .dt_s = dt_s};
}

FrictionSample moving(const glm::dvec2& velocity_m_per_s, double normal_N = 1.0) {
  return {.velocity_m_per_s = velocity_m_per_s, .normal_N = normal_N, .dt_s = kTick_s};
}

TEST(FrictionLaws, AreNamed) {
  EXPECT_EQ(friction_law("dahl").name, "dahl");
  EXPECT_THROW(friction_law("sticky"), std::invalid_argument);
  // A model without the parameter.
  EXPECT_EQ(friction_law_of({{"friction_speed_m_per_s", 0.01}}).name, "rounded");
  EXPECT_THROW(friction_settings(0.2, {}), std::invalid_argument);
}

TEST(FrictionLaws, AreElastoplasticWhereNoneIsStated) {
  EXPECT_EQ(friction_law_of(complete_values(sinusoid_model().declaration, {})).name,
            "elastoplastic");
}

TEST(FrictionLaws, AreDeclaredByEveryPointModelOnceAndWithTheSameDefaults) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  for (const ForceModel& model : point_models()) {
    for (const Parameter& parameter : declared) {
      const auto same = [&](const Parameter& other) {
        return other.name == parameter.name && other.default_value == parameter.default_value &&
               other.meaning == parameter.meaning && other.choices == parameter.choices;
      };
      EXPECT_EQ(std::count_if(model.declaration.parameters.begin(),
                              model.declaration.parameters.end(), same),
                1)
          << model.declaration.id << ' ' << parameter.name;
    }
  }
}

// Solutions of equal force are stored under the parameters of their models.
TEST(FrictionLaws, LeaveOutTheParametersOfOtherLaws) {
  using testing::Key;
  EXPECT_THAT(without_unused_layers(friction_with("rounded")),
              testing::ElementsAre(Key("friction_law"), Key("friction_speed_m_per_s")));
  EXPECT_THAT(
      without_unused_layers(friction_with("dahl")),
      testing::ElementsAre(Key("friction_law"), Key("friction_smoothing_s"),
                           Key("friction_speed_m_per_s"), Key("friction_stiffness_N_per_m")))
      << "v₀ is also that of some textures";
}

TEST(RoundedFriction, FollowsItsFormula) {
  Random random(3);
  Friction friction(0.2, friction_with("rounded"));
  for (int i = 0; i < 1000; ++i) {
    const double vx = 0.1 * random.normal();
    const double vy = 0.1 * random.normal();
    const double normal_N = std::abs(random.normal());
    const double v0 = 0.010;
    const double friction_N_s_per_m = 0.2 * normal_N / std::sqrt(vx * vx + vy * vy + v0 * v0);
    const glm::dvec2 drag_N = friction.drag_N(moving({vx, vy}, normal_N));
    EXPECT_EQ(drag_N.x, friction_N_s_per_m * vx);
    EXPECT_EQ(drag_N.y, friction_N_s_per_m * vy);
  }
}

TEST(BoundedFriction, HasASlopeThatTheLoopCarries) {
  for (const double delay_s : {0.0, 0.0025, 0.0045}) {
    for (const double mu : {0.1, 0.5, 2.0}) {
      const ParameterValues values = friction_with("bounded", {{"friction_delay_s", delay_s}});
      const double greatest =
          greatest_friction_slope_N_s_per_m(friction_settings(mu, values), kTick_s);
      EXPECT_NEAR(greatest, 0.25 * steepest_damper_N_s_per_m(0.05, delay_s, kTick_s), 1e-12);
      Friction friction(mu, values);
      double last_N = 0.0;
      constexpr double kStep_m_per_s = 1e-5;
      for (int i = 1; i < 20'000; ++i) {
        const double drag_N = friction.drag_N(moving({i * kStep_m_per_s, 0.0}, 2.0)).x;
        EXPECT_GT(drag_N, last_N);
        EXPECT_LE(drag_N - last_N, greatest * kStep_m_per_s);
        EXPECT_LT(drag_N, 2.0 * mu);
        last_N = drag_N;
      }
    }
  }
}

TEST(BoundedFriction, IsTheForceAtTheEndOfAnImplicitStep) {
  const ParameterValues values = friction_with("bounded", {{"friction_delay_s", 0.0}});
  const FrictionSettings settings = friction_settings(kMu, values);
  Friction friction(kMu, values);
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 v = 0.05 * glm::dvec2(random.normal(), random.normal());
    const double normal_N = 3.0 * std::abs(random.normal());
    const glm::dvec2 drag_N = friction.drag_N(moving(v, normal_N));
    const glm::dvec2 after = v - kTick_s / settings.mass_kg * drag_N;
    const double least =
        std::max(settings.speed_m_per_s,
                 kMu * normal_N / greatest_friction_slope_N_s_per_m(settings, kTick_s));
    const glm::dvec2 expected_N =
        kMu * normal_N / std::sqrt(glm::dot(after, after) + least * least) * after;
    EXPECT_LT(glm::length(drag_N - expected_N), 1e-10 * (1.0 + normal_N));
  }
  EXPECT_EQ(friction.drag_N(moving({0.0, 0.0})), glm::dvec2(0.0));
}

TEST(ProxyFriction, LosesTheAreaOfItsLoopInACycle) {
  constexpr double kContact_N_per_m = 1000.0;
  constexpr double kAmplitude_m = 2e-3;
  constexpr double kNormal_N = 2.0;
  Friction friction(kMu, prompt("proxy", kContact_N_per_m));
  constexpr int kSteps = 40'000;  // of a triangular motion
  double work_J = 0.0;
  double last_m = 0.0;
  double last_N = 0.0;
  for (int i = 0; i <= 3 * kSteps; ++i) {
    const double phase = static_cast<double>(i) / kSteps;
    const double place = phase - std::floor(phase);
    const double x_m = kAmplitude_m * (place < 0.25   ? 4.0 * place
                                       : place < 0.75 ? 2.0 - 4.0 * place
                                                      : 4.0 * place - 4.0);
    const double drag_N = friction.drag_N(at({x_m, 0.0}, kNormal_N)).x;
    if (i > 2 * kSteps) work_J += 0.5 * (drag_N + last_N) * (x_m - last_m);
    last_m = x_m;
    last_N = drag_N;
  }
  const double strain_m = kMu * kNormal_N / kContact_N_per_m;
  EXPECT_NEAR(work_J, 4.0 * kMu * kNormal_N * (kAmplitude_m - strain_m), 1e-6 * work_J);
}

TEST(ProxyFriction, DoesNotCreepUnderAForceBelowStaticFriction) {
  constexpr double kStrain_m = kMu / 1000.0;
  Friction friction(kMu, prompt("proxy"));
  friction.drag_N(at({0.0, 0.0}));
  for (int cycle = 0; cycle < 100'000; ++cycle) {
    friction.drag_N(at({0.5 * kStrain_m, 0.0}));
    friction.drag_N(at({-0.5 * kStrain_m, 0.0}));
  }
  EXPECT_NEAR(friction.drag_N(at({0.0, 0.0})).x, 0.0, 1e-12) << "the anchor has moved";
}

// A sampled block on a spring that is pulled: by hand from the two levels, in docs/models/friction.md.
double stick_slip_period_s(double rate_Hz) {
  constexpr double kMass_kg = 0.1;
  constexpr double kSpring_N_per_m = 400.0;
  constexpr double kContact_N_per_m = 1000.0;
  constexpr double kPull_m_per_s = 0.9e-3;
  constexpr double kNormal_N = 1.0;
  const double critical_N_s_per_m = 2.0 * std::sqrt(kContact_N_per_m * kMass_kg);
  Friction friction(kMu, prompt("proxy", kContact_N_per_m, 4.0 / 3.0, critical_N_s_per_m));
  const double period_s = 1.0 / rate_Hz;
  const int substeps = static_cast<int>(20'000.0 / rate_Hz);
  const double step_s = period_s / substeps;
  double x_m = 0.0;
  double v_m_per_s = 0.0;
  std::vector<double> slips_s{};
  bool slipping = false;
  for (double time_s = 0.0; slips_s.size() < 8; time_s += period_s) {
    const double drag_N = friction.drag_N(at({x_m, 0.0}, kNormal_N, period_s)).x;
    for (int i = 0; i < substeps; ++i) {
      const double pull_N = kSpring_N_per_m * (kPull_m_per_s * (time_s + i * step_s) - x_m);
      v_m_per_s += step_s / kMass_kg * (pull_N - drag_N);
      x_m += step_s * v_m_per_s;
    }
    const bool fast = v_m_per_s > 5.0 * kPull_m_per_s;
    if (fast && !slipping) slips_s.push_back(time_s);
    slipping = fast;
    if (time_s > 60.0) return 0.0;
  }
  return (slips_s.back() - slips_s[2]) / static_cast<double>(slips_s.size() - 3);
}

TEST(ProxyFriction, SticksAndSlipsWithThePeriodOfItsTwoLevels) {
  // (μ_s − μ_k)·N·(2/k_h + 1/k_f)/v + π·√(m/k_h)
  const double expected_s =
      kMu / 3.0 * (2.0 / 400.0 + 1.0 / 1000.0) / 0.9e-3 + std::numbers::pi * std::sqrt(0.1 / 400.0);
  const double at_1_kHz_s = stick_slip_period_s(1000.0);
  EXPECT_NEAR(at_1_kHz_s / expected_s, 1.0, 0.03);
  for (const double rate_Hz : {2000.0, 5000.0, 10'000.0}) {
    EXPECT_NEAR(stick_slip_period_s(rate_Hz) / at_1_kHz_s, 1.0, 0.02) << rate_Hz;
  }
}

/// The energy that a held force returns to a hand on a path, and what a damper of 1 N s/m takes from it.
struct Energies {
  double returned_J = 0.0;
  double damped_J_per_N_s_per_m = 0.0;
};

/// The positions are sampled; between them the hand moves evenly.
Energies energies(Friction& friction, std::span<const glm::dvec2> path_m, double normal_N = 1.0) {
  Energies sums{};
  for (std::size_t i = 0; i + 1 < path_m.size(); ++i) {
    const glm::dvec2 drag_N = friction.drag_N(at(path_m[i], normal_N));
    const glm::dvec2 way_m = path_m[i + 1] - path_m[i];
    sums.returned_J -= glm::dot(drag_N, way_m);
    sums.damped_J_per_N_s_per_m += glm::dot(way_m, way_m) / kTick_s;
  }
  return sums;
}

// b > k_f·T/2 [Colgate 1997]: a zigzag at half the sampling rate is the worst of all paths.
TEST(SpringFriction, IsPassiveOnADeviceWithTheDampingOfItsStiffness) {
  constexpr double kContact_N_per_m = 1000.0;
  constexpr double kNeeded_N_s_per_m = 0.5 * kContact_N_per_m * kTick_s;
  for (const std::string law : {"proxy", "elastoplastic", "dahl"}) {
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
      const double size_m = std::pow(10.0, -6.0 + 3.0 * random.uniform());
      const double drift_m = 0.1 * size_m * random.normal();
      std::vector<glm::dvec2> path_m(500, glm::dvec2(0.0));
      for (std::size_t i = 1; i < path_m.size(); ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        path_m[i] = {drift_m * static_cast<double>(i) + sign * size_m * (1.0 + random.normal()),
                     size_m * random.normal()};
      }
      Friction friction(kMu, prompt(law, kContact_N_per_m));
      const Energies sums = energies(friction, path_m);
      EXPECT_LE(sums.returned_J, kNeeded_N_s_per_m * sums.damped_J_per_N_s_per_m + 1e-15) << law;
    }
  }
  std::vector<glm::dvec2> zigzag_m{{0.0, 0.0}};
  for (int i = 0; i < 1000; ++i) zigzag_m.push_back({i % 2 == 0 ? 1e-5 : -1e-5, 0.0});
  Friction friction(kMu, prompt("proxy", kContact_N_per_m));
  const Energies sums = energies(friction, zigzag_m);
  EXPECT_NEAR(sums.returned_J / sums.damped_J_per_N_s_per_m, kNeeded_N_s_per_m,
              2e-3 * kNeeded_N_s_per_m);
}

// Without the low-passes: that of the normal force is a test of ElastoplasticFriction.
TEST(SpringFriction, IsNeverAboveSlidingFrictionAndOpposesMotion) {
  for (const std::string law : {"proxy", "elastoplastic", "dahl"}) {
    Friction friction(kMu, friction_with(law, {{"friction_smoothing_s", 0.0}}));
    Random random(6);
    glm::dvec2 place_m{0.0};
    for (int i = 0; i < 20'000; ++i) {
      const double normal_N = 1.0 + std::sin(0.013 * i);
      place_m += 1e-4 * glm::dvec2(random.normal(), random.normal());
      const double drag_N = glm::length(friction.drag_N(at(place_m, normal_N)));
      ASSERT_LE(drag_N, kMu * normal_N * (1.0 + 1e-12)) << law << ' ' << i;
    }
    EXPECT_EQ(friction.drag_N(at(place_m, 0.0)), glm::dvec2(0.0)) << law;
    friction.reset();
    glm::dvec2 drag_N{0.0};
    for (int i = 0; i < 1000; ++i) drag_N = friction.drag_N(at({6e-5 * i, -8e-5 * i}));
    EXPECT_NEAR(drag_N.x, 0.6 * kMu, 1e-9) << law;
    EXPECT_NEAR(drag_N.y, -0.8 * kMu, 1e-9) << law;
  }
}

/// dz/dℓ = e − z/z_ss along a line, by the classical method of Runge and Kutta.
glm::dvec2 relaxed_m(glm::dvec2 strain_m, const glm::dvec2& way_m, double sliding_m) {
  constexpr int kSteps = 2000;
  const double step_m = glm::length(way_m) / kSteps;
  const glm::dvec2 towards = glm::normalize(way_m);
  const auto rate = [&](const glm::dvec2& z) { return towards - z / sliding_m; };
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec2 a = rate(strain_m);
    const glm::dvec2 b = rate(strain_m + 0.5 * step_m * a);
    const glm::dvec2 c = rate(strain_m + 0.5 * step_m * b);
    const glm::dvec2 d = rate(strain_m + step_m * c);
    strain_m += step_m / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return strain_m;
}

TEST(DahlFriction, SolvesItsDifferentialEquationExactlyInStepsOfAnyLength) {
  constexpr double kContact_N_per_m = 700.0;
  const std::array<glm::dvec2, 6> kCorners_m{
      {{0.0, 0.0}, {4e-4, 0.0}, {-3e-4, 2e-4}, {-2.5e-4, -9e-4}, {3e-3, -9e-4}, {3e-3, 1e-4}}};
  for (const int steps : {1, 3, 50}) {
    Friction friction(kMu, prompt("dahl", kContact_N_per_m));
    glm::dvec2 drag_N = friction.drag_N(at(kCorners_m[0]));
    glm::dvec2 strain_m{0.0};
    for (std::size_t i = 1; i < kCorners_m.size(); ++i) {
      const glm::dvec2 way_m = kCorners_m[i] - kCorners_m[i - 1];
      for (int step = 1; step <= steps; ++step) {
        drag_N = friction.drag_N(
            at(kCorners_m[i - 1] + static_cast<double>(step) / steps * way_m, 1.0, 1e-3 / steps));
      }
      strain_m = relaxed_m(strain_m, way_m, kMu / kContact_N_per_m);
      EXPECT_LT(glm::length(drag_N - kContact_N_per_m * strain_m), 1e-10) << steps << ' ' << i;
    }
  }
}

TEST(DahlFriction, HasABoundedSlope) {
  constexpr double kContact_N_per_m = 700.0;
  Friction friction(kMu, prompt("dahl", kContact_N_per_m));
  double last_N = friction.drag_N(at({0.0, 0.0})).x;
  double last_m = 0.0;
  double steepest_N_per_m = 0.0;
  for (int i = 1; i < 4000; ++i) {
    const double x_m = 3e-3 * std::sin(0.003 * i);
    const double drag_N = friction.drag_N(at({x_m, 0.0})).x;
    steepest_N_per_m = std::max(steepest_N_per_m, std::abs((drag_N - last_N) / (x_m - last_m)));
    last_N = drag_N;
    last_m = x_m;
  }
  EXPECT_LE(steepest_N_per_m, 2.0 * kContact_N_per_m);
  EXPECT_GT(steepest_N_per_m, 1.95 * kContact_N_per_m) << "at a reversal";
}

TEST(SpringFriction, SmoothsThePositionByTwoLowPasses) {
  constexpr double kStep_m = 1e-6;
  for (const std::string law : {"proxy", "elastoplastic", "dahl"}) {
    Friction friction(kMu, friction_with(law, {{"friction_smoothing_s", 0.004},
                                               {"friction_stiffness_N_per_m", 10.0}}));
    friction.drag_N(at({0.0, 0.0}));
    const double gain = 1.0 - std::exp(-0.25);
    for (int n = 1; n < 40; ++n) {
      const double share = 1.0 - std::pow(1.0 - gain, n) * (1.0 + n * gain);
      EXPECT_NEAR(friction.drag_N(at({kStep_m, 0.0})).x, 10.0 * kStep_m * share, 1e-9) << law;
    }
  }
}

// The drag continues on a stiffer contact; on a softer one it would need more energy, ½D²/σ, than was stored.
TEST(SpringFriction, ContinuesOnASurfaceOfAnotherStiffnessWithoutMoreEnergy) {
  for (const char* const law : {"proxy", "dahl", "lugre"}) {
    for (const double ratio : {0.25, 1.0, 4.0}) {
      Friction left(kMu, prompt(law));
      left.drag_N(at({0.0, 0.0}));
      const double before_N = left.drag_N(at({1e-4, 0.0})).x;
      Friction entered(kMu, prompt(law, ratio * 1000.0));
      entered.continue_contact_of(left);
      EXPECT_NEAR(entered.drag_N(at({1e-4, 0.0})).x, before_N * std::min(1.0, std::sqrt(ratio)),
                  1e-12)
          << law << ' ' << ratio;
    }
  }
}

// The law of a session is in its parameters, and its path in its recording.
TEST(FrictionOfModels, GivesTheSameBytesForTheSamePath) {
  for (const ForceModel& model : point_models()) {
    for (const FrictionLaw& law : friction_laws()) {
      RendererInputs inputs{.parameters = {{"friction_law", std::string(law.name)}},
                            .patch = wide_patch(),
                            .height_field = grating(),
                            .assets = files_of_models(),
                            .seed = 3};
      const auto one = make_renderer(model, inputs);
      const auto other = make_renderer(model, inputs);
      const std::vector<ProbeState> path = samples_of({.duration_s = 0.2});
      const std::vector<RenderedTick> felt = along_path(*one, path, 1000.0);
      const std::vector<RenderedTick> again = along_path(*other, path, 1000.0);
      const std::vector<RenderedTick> anew = along_path(*one, path, 1000.0);  // resets
      for (std::size_t i = 0; i < path.size(); ++i) {
        ASSERT_EQ(felt[i].wrench.force_N, again[i].wrench.force_N) << model.declaration.id;
        ASSERT_EQ(felt[i].wrench.force_N, anew[i].wrench.force_N) << model.declaration.id;
      }
    }
  }
}

TEST(FrictionOfModels, EndsWithTheContactAndStartsOverWithTheNextOne) {
  for (const ForceModel& model : point_models()) {
    for (const FrictionLaw& law : friction_laws()) {
      RendererInputs inputs{.parameters = {{"friction_law", std::string(law.name)}},
                            .patch = wide_patch(),
                            .height_field = grating(),
                            .assets = files_of_models(),
                            .seed = 3};
      if (model.declaration.amplitude_parameter) {
        inputs.parameters[*model.declaration.amplitude_parameter] = 0.0;
      }
      const auto used = make_renderer(model, inputs);
      const auto fresh = make_renderer(model, inputs);
      const std::vector<ProbeState> first = samples_of({.duration_s = 0.2});
      along_path(*used, first, 1000.0);
      ProbeState lifted = first.back();
      lifted.position_m.z = 0.001;
      EXPECT_EQ(used->tick(lifted, kTick_s).wrench.force_N, glm::dvec3(0.0))
          << model.declaration.id << ' ' << law.name;
      fresh->reset(first.front());
      double largest_N = 0.0;
      for (const ProbeState& probe :
           samples_of({.from_x_m = 0.02, .speed_m_per_s = -0.05, .duration_s = 0.2})) {
        const glm::dvec3 force_N = used->tick(probe, kTick_s).wrench.force_N;
        ASSERT_EQ(force_N, fresh->tick(probe, kTick_s).wrench.force_N)
            << model.declaration.id << ' ' << law.name;
        largest_N = std::max(largest_N, force_N.x);
      }
      EXPECT_GT(largest_N, 0.1) << model.declaration.id << ' ' << law.name;
      EXPECT_LT(largest_N, 0.201) << model.declaration.id << ' ' << law.name;
    }
  }
}

// The drag of a law that remembers builds up on the prescribed path; that is no texture.
TEST(FrictionOfModels, IsNoTextureForceOfAPlate) {
  for (const FrictionLaw& law : friction_laws()) {
    const RendererInputs plate{
        .parameters = {{"friction_law", std::string(law.name)}, {"amplitude_m", 0.0}}};
    EXPECT_LT(texture_force_rms_N(sinusoid_model(), plate), 1e-12) << law.name;
  }
}

// A contact that slides from the flat surface to a patch keeps its strain: the border is not felt.
TEST(FrictionOfModels, ContinuesAcrossAdjacentSurfaces) {
  const ModelRegistry models = built_in_models();
  const ForceModel* const model = models.find("sinusoid");
  const SurfacePatch workspace{.extent_m = {0.1, 0.1}, .edge_width_m = 0.005};
  RendererInputs inputs{.parameters = {{"friction_law", std::string("dahl")}, {"amplitude_m", 0.0}},
                        .patch = workspace};
  inputs.parameters = complete_values(model->declaration, inputs.parameters);
  inputs.patch.centre_m.x = 0.02;
  inputs.patch.extent_m = {0.04, 0.06};
  AdjacentPatches surfaces(std::vector<AdjacentPatch>{{model, inputs}}, workspace, inputs.material,
                           0.002);
  double least_N = 1.0;
  surfaces.reset({});
  for (int i = 0; i < 1000; ++i) {
    ProbeState probe{};
    probe.position_m = {-0.03 + 6e-5 * i, 0.0, -0.002};
    const double drag_N = -surfaces.tick(probe, kTick_s).wrench.force_N.x;
    if (i > 300) least_N = std::min(least_N, drag_N);
  }
  EXPECT_NEAR(least_N, 0.2, 1e-3);
}

// The force [N] of a probe that slides along y at this place, without a texture, once its friction is steady.
double drag_along_y_N(ForceRenderer& renderer, double x_m, double speed_m_per_s,
                      double duration_s) {
  ProbeState probe{.position_m = {x_m, 0.0, -0.002}, .velocity_m_per_s = {0.0, speed_m_per_s, 0.0}};
  renderer.reset(probe);
  double drag_N = 0.0;
  for (double t_s = 0.0; t_s < duration_s; t_s += kTick_s) {
    probe.position_m.y = speed_m_per_s * t_s;
    drag_N = -renderer.tick(probe, kTick_s).wrench.force_N.y;
  }
  return drag_N;
}

// With surfaces in random positions, a gap that follows the first surface would be a cue to the correct response.
TEST(FrictionOfModels, BetweenAdjacentSurfacesDoesNotDependOnTheirOrder) {
  const ModelRegistry models = built_in_models();
  const ForceModel* const model = models.find("sinusoid");
  const SurfacePatch workspace{.extent_m = {0.1, 0.1}, .edge_width_m = 0.005};
  const auto patch = [&](double x_m, const ParameterValues& friction) {
    ParameterValues parameters = friction;
    parameters["amplitude_m"] = 0.0;
    AdjacentPatch one{model, {.parameters = complete_values(model->declaration, parameters)}};
    one.inputs.patch = workspace;
    one.inputs.patch.centre_m.x = x_m;
    one.inputs.patch.extent_m.x = 0.047;
    return one;
  };
  const auto drag_in_gap_N = [&](const ParameterValues& left, const ParameterValues& right) {
    const std::vector<AdjacentPatch> patches{patch(-0.0265, left), patch(0.0265, right)};
    AdjacentPatches surfaces(patches, workspace, patches.front().inputs.material, 0.002);
    return drag_along_y_N(surfaces, 0.0, 0.02, 0.05);
  };
  using Values = ParameterValues;
  const std::string law = "friction_law";
  const std::string stiffness = "friction_stiffness_N_per_m";
  const Values soft{{stiffness, 100.0}};
  const Values stiff{{stiffness, 1000.0}};
  const Values usual{};
  const Values proxy{{law, std::string("proxy")}};
  const Values rounded{{law, std::string("rounded")}};
  const Values lubricated{{law, std::string("rounded")}, {"friction_speed_m_per_s", 0.1}};
  for (const auto& [a, b] : {std::pair(soft, stiff), std::pair(usual, proxy),
                             std::pair(proxy, rounded), std::pair(stiff, rounded)}) {
    EXPECT_EQ(drag_in_gap_N(a, b), drag_in_gap_N(b, a));
  }
  EXPECT_EQ(drag_in_gap_N(soft, stiff), drag_in_gap_N(usual, usual)) << "the default";
  EXPECT_EQ(drag_in_gap_N(rounded, proxy), drag_in_gap_N(usual, usual)) << "the default law";
  EXPECT_GT(drag_in_gap_N(stiff, stiff), 1.5 * drag_in_gap_N(soft, soft)) << "where it is shared";
  EXPECT_GT(drag_in_gap_N(rounded, rounded), 1.5 * drag_in_gap_N(lubricated, lubricated));
}

// On the crest of a texture above the plane the flat surface has no contact of its own to continue.
TEST(FrictionOfModels, ContinuesFromAPatchToTheFlatSurface) {
  const ModelRegistry models = built_in_models();
  const ForceModel* const model = models.find("sinusoid");
  const SurfacePatch workspace{.extent_m = {0.1, 0.1}, .edge_width_m = 0.005};
  RendererInputs inputs{.parameters = {{"friction_law", std::string("dahl")},
                                       {"friction_stiffness_N_per_m", 10.0},
                                       {"amplitude_m", 1e-3},
                                       {"wavelength_m", 0.02}},
                        .patch = workspace};
  inputs.parameters = complete_values(model->declaration, inputs.parameters);
  inputs.patch.extent_m = {0.06, 0.06};
  AdjacentPatches surfaces(std::vector<AdjacentPatch>{{model, inputs}}, workspace, inputs.material,
                           0.002);
  ProbeState probe{.position_m = {0.005, -0.015, 0.0005}};  // a quarter of the wave: the crest
  surfaces.reset(probe);
  double least_N = 1.0;
  for (; probe.position_m.y < 0.032; probe.position_m.y += 5e-5) {
    probe.position_m.z = probe.position_m.y < 0.027 ? 0.0005 : -0.001;
    const double drag_N = -surfaces.tick(probe, kTick_s).wrench.force_N.y;
    if (probe.position_m.y > 0.027) least_N = std::min(least_N, drag_N);
  }
  EXPECT_GT(least_N, 0.09) << "0.1 N is the greatest drag of the flat surface";
}

}  // namespace
}  // namespace asperity
