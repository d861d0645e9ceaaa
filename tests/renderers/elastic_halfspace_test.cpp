// The models of a rigid tip on a soft surface: the forces of their closed forms in newtons, their torque, their limits.

#include "renderers/models/elastic_halfspace.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "renderers/elastic/surface_dent.h"
#include "renderers/force/indentation_law.h"
#include "renderers/models/winkler.h"
#include "renderers/offline/along_path.h"
#include "renderers/offline/felt_stiffness.h"
#include "renderers/offline/force_matching.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kSoftTip_m = 0.003;
constexpr double kReduced_Pa = 1e5 / 0.75;
constexpr double kFoundation_N_per_m3 = 3e7;

RendererInputs on(std::shared_ptr<const HeightField> field, const ParameterValues& parameters) {
  RendererInputs inputs{};
  inputs.parameters = parameters;
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.height_field = std::move(field);
  return inputs;
}

const ParameterValues kElastic{{"relaxation_ratio", 1.0}};
const ParameterValues kFlatEnd{{"tip", std::string("flat")}, {"relaxation_ratio", 1.0}};

RenderedTick answer_in_depth(const ForceModel& model, const ParameterValues& parameters,
                             double depth_m) {
  const auto renderer = make_renderer(model, on(level(0.0F), parameters));
  return answer(*renderer, probe_at({0.001, 0.002, -depth_m}));
}

std::uint64_t limit_ticks(const ForceRenderer& renderer, std::string_view name) {
  for (const NamedCount& count : renderer.limits()) {
    if (count.name == name) return count.ticks;
  }
  ADD_FAILURE() << "no limit " << name;
  return 0;
}

TEST(ElasticHalfspace, HasTheForceOfHertzAndOfAFlatEnd) {
  for (const double depth_m : {0.0002, 0.0005, 0.002}) {
    const double hertz_N = 4.0 / 3.0 * kReduced_Pa * std::sqrt(kSoftTip_m) * std::pow(depth_m, 1.5);
    const RenderedTick ball = answer_in_depth(elastic_halfspace_model(), kElastic, depth_m);
    EXPECT_NEAR(ball.wrench.force_N.z, hertz_N, 0.02 * hertz_N);
    EXPECT_NEAR(ball.wrench.force_N.x, 0.0, 1e-6);
    EXPECT_NEAR(ball.wrench.torque_N_m.y, 0.0, 1e-9);
    EXPECT_NEAR(ball.penetration_m, depth_m, 0.01 * kSoftTip_m);
    const double flat_N = 2.0 * kReduced_Pa * kSoftTip_m * depth_m;
    EXPECT_NEAR(answer_in_depth(elastic_halfspace_model(), kFlatEnd, depth_m).wrench.force_N.z,
                flat_N, 0.03 * flat_N);
  }
  EXPECT_EQ(answer_in_depth(elastic_halfspace_model(), kElastic, -1e-6).penetration_m, 0.0);
}

TEST(ElasticHalfspace, IsProportionalToTheReducedModulus) {
  const auto force_N = [](const ParameterValues& parameters) {
    return answer_in_depth(elastic_halfspace_model(), parameters, 0.0005).wrench.force_N.z;
  };
  const double usual_N = force_N({});
  EXPECT_NEAR(force_N({{"youngs_modulus_Pa", 3e5}}), 3.0 * usual_N, 1e-5 * usual_N);
  EXPECT_NEAR(force_N({{"poisson_ratio", 0.0}}), 0.75 * usual_N, 1e-5 * usual_N);
}

TEST(ElasticHalfspace, RelaxesToTheForceOfHertz) {
  const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), {}));
  constexpr double kDepth_m = 0.0005;
  const double hertz_N = 4.0 / 3.0 * kReduced_Pa * std::sqrt(kSoftTip_m) * std::pow(kDepth_m, 1.5);
  ProbeState probe = probe_at({0.0, 0.0, -kDepth_m});
  renderer->reset(probe);
  for (int tick = 1; tick <= 300; ++tick) {
    const double force_N = renderer->tick(probe, 0.001).wrench.force_N.z;
    EXPECT_NEAR(force_N, hertz_N * (1.0 + 0.2 * std::exp(-tick / 20.0)), 0.02 * hertz_N) << tick;
  }
}

// Under the tip the surface is where the tip is; far from it the displacement is F/(πE*r).
TEST(ElasticHalfspace, ShowsTheDentOfAFlatEnd) {
  constexpr double kDepth_m = 0.0005;
  const glm::dvec2 at_m(0.001, 0.002);
  const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), kFlatEnd));
  const auto* const soft = dynamic_cast<const DentsSurface*>(renderer.get());
  ASSERT_NE(soft, nullptr);
  (void)answer(*renderer, probe_at({at_m, 0.001}));
  EXPECT_FALSE(soft->dent());
  const double force_N = answer(*renderer, probe_at({at_m, -kDepth_m})).wrench.force_N.z;
  const std::optional<SurfaceDent> dent = soft->dent();
  ASSERT_TRUE(dent);
  for (const glm::dvec2& under_m : {glm::dvec2(0.0), {0.002, 0.0}, {-0.001, 0.0015}}) {
    EXPECT_NEAR(dent->depth_at(at_m + under_m), kDepth_m, 0.01 * kDepth_m);
  }
  for (const double r_m : {0.006, 0.02}) {
    const double far_m = force_N / (std::numbers::pi * kReduced_Pa * r_m);
    EXPECT_NEAR(dent->depth_at(at_m + glm::dvec2(0.0, r_m)), far_m, 0.1 * far_m);
  }
}

// A dent that a tip leaves fades with the time constant ρτ = 24 ms.
TEST(ElasticHalfspace, ShowsTheDentThatTheTipLeaves) {
  const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), {}));
  const auto* const soft = dynamic_cast<const DentsSurface*>(renderer.get());
  ASSERT_NE(soft, nullptr);
  ProbeState probe = probe_at({0.0, 0.0, -0.0005});
  renderer->reset(probe);
  for (int tick = 0; tick < 200; ++tick) (void)renderer->tick(probe, 0.001);
  probe.position_m.z = 0.01;
  (void)renderer->tick(probe, 0.001);
  const double left_m = soft->dent().value().depth_at({0.0, 0.0});
  // While the tip lifts, its load decreases to 0 within the tick.
  const double kept = 24.0 * (1.0 - std::exp(-1.0 / 24.0));
  EXPECT_NEAR(left_m, 0.0005 * (1.0 - 1.0 / 1.2) * kept, 1e-6);
  for (int tick = 0; tick < 24; ++tick) (void)renderer->tick(probe, 0.001);
  EXPECT_NEAR(soft->dent().value().depth_at({0.0, 0.0}), left_m / std::numbers::e, 1e-6);
}

TEST(Winkler, ShowsTheDentUnderTheTipOnly) {
  const auto renderer =
      make_renderer(winkler_model(), on(level(0.0F), {{"tip", std::string("flat")}}));
  const auto* const soft = dynamic_cast<const DentsSurface*>(renderer.get());
  ASSERT_NE(soft, nullptr);
  (void)answer(*renderer, probe_at({0.001, 0.0, -0.0005}));
  const std::optional<SurfaceDent> dent = soft->dent();
  ASSERT_TRUE(dent);
  EXPECT_NEAR(dent->depth_at({0.001, 0.002}), 0.0005, 1e-9);
  EXPECT_EQ(dent->depth_at({0.001, 0.0035}), 0.0);
}

// The elastic force of a tilted flat end turns it upright.
TEST(ElasticHalfspace, TurnsATiltedFlatEndBack) {
  ParameterValues turning = kFlatEnd;
  turning["tool_turns"] = std::string("device");
  constexpr double kTilt_rad = 0.02;
  constexpr double kDepth_m = 0.0005;
  ProbeState probe = probe_at({0.0, 0.0, -kDepth_m});
  probe.orientation = glm::angleAxis(kTilt_rad, glm::dvec3(0.0, 1.0, 0.0));
  const auto tilted = [&](const ParameterValues& parameters) {
    return answer(*make_renderer(elastic_halfspace_model(), on(level(0.0F), parameters)), probe)
        .wrench;
  };
  const double torque_N_m = 4.0 / 3.0 * kReduced_Pa * std::pow(kSoftTip_m, 3) * kTilt_rad;
  const Wrench wrench = tilted(turning);
  EXPECT_NEAR(wrench.torque_N_m.y, -torque_N_m, 0.05 * torque_N_m);
  EXPECT_NEAR(wrench.torque_N_m.x, 0.0, 1e-3 * torque_N_m);
  EXPECT_NEAR(wrench.force_N.z, 2.0 * kReduced_Pa * kSoftTip_m * kDepth_m,
              0.03 * 2.0 * kReduced_Pa * kSoftTip_m * kDepth_m);
  EXPECT_NEAR(tilted(kFlatEnd).torque_N_m.y, 0.0, 1e-6 * torque_N_m) << "the tool is fixed";
}

// −∂U/∂x, with the energy U as the work of pressing the tip in.
TEST(ElasticHalfspace, PushesAlongTheSurfaceByTheGradientOfItsEnergy) {
  const auto field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 1e-4});
  for (const ForceModel& model : {elastic_halfspace_model(), winkler_model()}) {
    const ParameterValues parameters =
        model.declaration.id == "winkler" ? ParameterValues{} : kElastic;
    const auto renderer = make_renderer(model, on(field, parameters));
    constexpr double kDepth_m = 0.0006;
    constexpr double kStep_m = 8e-6;
    constexpr double kAside_m = 1e-4;
    const auto energy_J = [&](double x_m) {
      double sum_J = 0.0;
      for (double z_m = 2e-4; z_m > -kDepth_m + 0.1 * kStep_m; z_m -= kStep_m) {
        sum_J +=
            kStep_m * answer(*renderer, probe_at({x_m, 0.0, z_m - 0.5 * kStep_m})).wrench.force_N.z;
      }
      return sum_J;
    };
    constexpr double kAt_m = 0.0003;
    const double expected_N =
        -(energy_J(kAt_m + kAside_m) - energy_J(kAt_m - kAside_m)) / (2.0 * kAside_m);
    const double found_N = answer(*renderer, probe_at({kAt_m, 0.0, -kDepth_m})).wrench.force_N.x;
    EXPECT_LT(expected_N, -0.003) << model.declaration.id;
    EXPECT_NEAR(found_N, expected_N, 0.01 * std::abs(expected_N)) << model.declaration.id;
  }
}

TEST(ElasticHalfspace, DragsABallThatSlidesOverASurfaceThatRelaxes) {
  const auto drag_N = [](const ParameterValues& parameters, double speed_m_per_s) {
    const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), parameters));
    return along_path(
               *renderer,
               samples_of({.height_m = -0.0005, .speed_m_per_s = speed_m_per_s, .duration_s = 0.4}),
               1000.0)
        .back()
        .wrench.force_N.x;
  };
  EXPECT_NEAR(drag_N(kElastic, 0.06), 0.0, 1e-6);
  EXPECT_LT(drag_N({}, 0.06), -1e-3);
  EXPECT_GT(drag_N({}, -0.06), 1e-3);
}

TEST(ElasticHalfspace, StaysCloseToAFasterLoop) {
  const auto field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 1e-4});
  const auto felt = [&](double rate_Hz) {
    const auto renderer = make_renderer(elastic_halfspace_model(), on(field, {}));
    return along_path(
        *renderer,
        samples_of(
            {.height_m = -0.0006, .speed_m_per_s = 0.06, .duration_s = 0.1, .rate_Hz = rate_Hz}),
        rate_Hz);
  };
  const std::vector<RenderedTick> slow = felt(1000.0);
  const std::vector<RenderedTick> fast = felt(4000.0);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    EXPECT_LT(glm::length(slow[i].wrench.force_N - fast[4 * i].wrench.force_N),
              0.02 * glm::length(fast[4 * i].wrench.force_N))
        << i;
  }
}

TEST(ElasticHalfspace, CountsWhereItsAssumptionsDoNotHold) {
  const auto counted = [](double depth_m, const char* name) {
    const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), {}));
    const ProbeState probe = probe_at({0.0, 0.0, -depth_m});
    renderer->reset(probe);
    for (int tick = 0; tick < 10; ++tick) renderer->tick(probe, 0.001);
    EXPECT_EQ(limit_ticks(*renderer, "contact"), depth_m > 0.0 ? 10U : 0U);
    return limit_ticks(*renderer, name);
  };
  EXPECT_EQ(counted(-0.001, "large_strain"), 0U);
  EXPECT_EQ(counted(0.0002, "large_strain"), 0U);  // a/R = √(δ/R) = 0.26
  EXPECT_EQ(counted(0.0004, "large_strain"), 10U);
  EXPECT_EQ(counted(0.002, "cell_border"), 0U);
  EXPECT_EQ(counted(0.004, "cell_border"), 10U);
  EXPECT_EQ(counted(0.002, "unfinished"), 0U);
}

// The outermost cells are 15.5 cells of R/15 from the axis, where the ball has risen by 0.534 R. Beyond, force is lost.
TEST(Winkler, CountsContactsThatReachTheBorderOfItsCells) {
  const auto renderer = make_renderer(winkler_model(), on(level(0.0F), {}));
  const auto counted = [&](double depth_m, const char* name) {
    const std::uint64_t before = limit_ticks(*renderer, name);
    const ProbeState probe = probe_at({0.0, 0.0, -depth_m});
    for (int tick = 0; tick < 10; ++tick) renderer->tick(probe, 0.001);
    return limit_ticks(*renderer, name) - before;
  };
  renderer->reset({});
  EXPECT_EQ(counted(-0.001, "contact"), 0U);
  EXPECT_EQ(counted(0.001, "contact"), 10U);
  EXPECT_EQ(counted(0.53 * kSoftTip_m, "cell_border"), 0U);
  EXPECT_EQ(counted(0.54 * kSoftTip_m, "cell_border"), 10U);
  renderer->reset({});  // keeps the counts
  EXPECT_EQ(limit_ticks(*renderer, "cell_border"), 10U);
  const double whole_N =
      std::numbers::pi * kFoundation_N_per_m3 * kSoftTip_m * std::pow(kSoftTip_m, 2);
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -kSoftTip_m})).wrench.force_N.z, 0.90 * whole_N,
              0.01 * whole_N);
}

// A flat end that slides by a cell in every tick; at rest the iterations are made up for.
TEST(ElasticHalfspace, CountsContactsThatChangeFasterThanItsIterations) {
  const auto field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.001, .pitch_m = 2.5e-5});
  const auto renderer = make_renderer(elastic_halfspace_model(), on(field, kFlatEnd));
  const auto at = [](int tick) { return probe_at({0.0002 * tick, 0.0, -0.0003}); };
  renderer->reset(at(0));
  constexpr int kMoving = 20;
  for (int tick = 1; tick <= kMoving; ++tick) renderer->tick(at(tick), 0.001);
  const std::uint64_t moving = limit_ticks(*renderer, "unfinished");
  EXPECT_GT(moving, 10U);
  for (int tick = 0; tick < 30; ++tick) renderer->tick(at(kMoving), 0.001);
  EXPECT_LE(limit_ticks(*renderer, "unfinished"), moving + 2U);
  EXPECT_EQ(limit_ticks(*renderer, "contact"), 50U);
}

TEST(ElasticHalfspace, HasNoForceOutsideItsPatchAndHalfOfItInTheFadingBorder) {
  RendererInputs inputs = on(level(0.0F), kElastic);
  inputs.patch = {.extent_m = {0.04, 0.04}, .edge = PatchEdge::fade, .edge_width_m = 0.004};
  const auto renderer = make_renderer(elastic_halfspace_model(), inputs);
  const double middle_N = answer(*renderer, probe_at({0.0, 0.0, -0.001})).wrench.force_N.z;
  EXPECT_NEAR(answer(*renderer, probe_at({0.018, 0.0, -0.001})).wrench.force_N.z, 0.5 * middle_N,
              1e-3 * middle_N);
  const RenderedTick outside = answer(*renderer, probe_at({0.021, 0.0, -0.001}));
  EXPECT_EQ(outside.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(outside.penetration_m, 0.0);
}

TEST(ElasticHalfspace, HasFrictionOfItsNormalForce) {
  RendererInputs inputs = on(level(0.0F), kElastic);
  inputs.material.friction = 0.5;
  inputs.parameters["friction_law"] = std::string("rounded");
  const auto renderer = make_renderer(elastic_halfspace_model(), inputs);
  ProbeState probe = probe_at({0.0, 0.0, -0.001});
  probe.velocity_m_per_s = {1.0, 0.0, 0.0};
  const glm::dvec3 force_N = answer(*renderer, probe).wrench.force_N;
  EXPECT_NEAR(force_N.x, -0.5 * force_N.z, 1e-3 * force_N.z);
}

// In closed form, against differences of the force directly after a change of depth.
TEST(ElasticHalfspace, DeclaresItsStiffnessUnderAForce) {
  constexpr double kStep_m = 5e-6;
  for (const ForceModel& model : {elastic_halfspace_model(), winkler_model()}) {
    for (const char* tip : {"ball", "flat"}) {
      ParameterValues parameters{{"tip", std::string(tip)}};
      constexpr double kDepth_m = 0.0008;
      const auto renderer = make_renderer(model, on(level(0.0F), parameters));
      ProbeState probe = probe_at({0.0, 0.0, -kDepth_m});
      renderer->reset(probe);
      double force_N = 0.0;
      for (int tick = 0; tick < 300; ++tick) {
        force_N = renderer->tick(probe, 0.001).wrench.force_N.z;
      }
      probe.position_m.z -= kStep_m;
      double stepped_N = 0.0;
      for (int tick = 0; tick < 20; ++tick) {
        stepped_N = renderer->tick(probe, 1e-6).wrench.force_N.z;
      }
      const double expected_N_per_m = (stepped_N - force_N) / kStep_m;
      const auto felt =
          felt_stiffness(model, on(level(0.0F), parameters), {.force_limit_N = force_N});
      ASSERT_TRUE(felt);
      EXPECT_NEAR(felt->stiffness_N_per_m, expected_N_per_m, 0.05 * expected_N_per_m)
          << model.declaration.id << ' ' << tip;
      EXPECT_EQ(felt->force_N, force_N);
    }
  }
}

// Under a foundation of twice the stiffness, the force along the normal is the same with half the relief, and the force along
// the surface with the whole relief.
TEST(ElasticHalfspace, CanBeMatchedInItsTextureForce) {
  const auto field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 1e-4});
  const TextureForcePath path{.duration_s = 0.4, .dropped_s = 0.1, .mean_normal_force_N = 0.3};
  const ParameterValues flat{{"tip", std::string("flat")}};
  EXPECT_GT(texture_force_rms_N(elastic_halfspace_model(), on(field, kFlatEnd), path), 0.005);
  const double usual_N = texture_force_rms_N(winkler_model(), on(field, flat), path);
  EXPECT_GT(usual_N, 0.005);
  ParameterValues stiffer = flat;
  stiffer["foundation_N_per_m3"] = 2.0 * kFoundation_N_per_m3;
  const SolvedAmplitude solved =
      solve_amplitude(winkler_model(), on(field, stiffer), usual_N, path);
  EXPECT_GT(solved.value, 0.5);
  EXPECT_LT(solved.value, 1.0);
  stiffer["height_scale"] = solved.value;
  EXPECT_NEAR(texture_force_rms_N(winkler_model(), on(field, stiffer), path), usual_N,
              5e-3 * usual_N);
}

TEST(ElasticHalfspace, NamesAForceThatStrainsItTooMuch) {
  const auto problem = [](const ParameterValues& given, double force_N) {
    const auto renderer = make_renderer(elastic_halfspace_model(), on(level(0.0F), given));
    return dynamic_cast<const IndentationLaw&>(*renderer).indentation_problem(force_N);
  };
  // a/R = 0.3 at F = (4/3)·E*·R²·0.027
  const double limit_N = 4.0 / 3.0 * kReduced_Pa * kSoftTip_m * kSoftTip_m * 0.027;
  EXPECT_FALSE(problem({}, 0.99 * limit_N));
  ASSERT_TRUE(problem({}, 1.01 * limit_N));
  const std::string at_one_newton = problem({}, 1.0).value_or("").english();
  EXPECT_NE(at_one_newton.find("sinks in by 2.19 mm"), std::string::npos) << at_one_newton;
  EXPECT_NE(at_one_newton.find("0.85"), std::string::npos) << at_one_newton;
  EXPECT_FALSE(problem({{"tip", std::string("flat")}}, 0.7));
  EXPECT_TRUE(problem({{"tip", std::string("flat")}}, 0.8));
}

TEST(Winkler, HasTheForceOfABallAndOfAFlatEnd) {
  for (const double depth_m : {0.0005, 0.001, 0.002}) {
    const double ball_N = std::numbers::pi * kFoundation_N_per_m3 * kSoftTip_m * depth_m * depth_m;
    EXPECT_NEAR(answer_in_depth(winkler_model(), {}, depth_m).wrench.force_N.z, ball_N,
                0.02 * ball_N);
    const double flat_N =
        std::numbers::pi * kFoundation_N_per_m3 * kSoftTip_m * kSoftTip_m * depth_m;
    EXPECT_NEAR(
        answer_in_depth(winkler_model(), {{"tip", std::string("flat")}}, depth_m).wrench.force_N.z,
        flat_N, 0.02 * flat_N);
  }
  EXPECT_EQ(answer_in_depth(winkler_model(), {}, -1e-6).penetration_m, 0.0);
}

TEST(Winkler, DoesNoWorkAroundALoop) {
  const auto renderer =
      make_renderer(winkler_model(),
                    on(grating({.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 1e-4}), {}));
  double net_J = 0.0;
  double gross_J = 0.0;
  constexpr int kSteps = 4000;
  const auto place_m = [](int step) {
    const double angle = 2.0 * std::numbers::pi * step / kSteps;
    return glm::dvec3(0.001 * std::cos(angle), 0.0005 * std::sin(angle + 1.0),
                      -0.0008 + 0.0003 * std::sin(angle + 0.4));
  };
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 middle_m = 0.5 * (place_m(step) + place_m(step + 1));
    const double work_J = glm::dot(answer(*renderer, probe_at(middle_m)).wrench.force_N,
                                   place_m(step + 1) - place_m(step));
    net_J += work_J;
    gross_J += std::abs(work_J);
  }
  EXPECT_LT(std::abs(net_J), 1e-6 * gross_J);
}

}  // namespace
}  // namespace asperity
