// The charts of a point model on a body: what the model receives in them, and what becomes of its force.

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/force/point_on_body.h"
#include "tests/renderers/points_on_bodies.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

/// What a chart's model received, and its answer below the surface of the body.
struct ChartCalls {
  ProbeState last{};
  double dt_s = 0.0;
  int resets = 0;
  int ticks = 0;
  RenderedTick answer{};
  std::string_view error{};
};

class RecordingModel final : public ForceRenderer {
 public:
  explicit RecordingModel(std::shared_ptr<ChartCalls> calls) : calls_(std::move(calls)) {}
  void reset(const ProbeState&) noexcept override { ++calls_->resets; }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    calls_->last = probe;
    calls_->dt_s = dt_s;
    ++calls_->ticks;
    return probe.position_m.z < 0.0 ? calls_->answer : RenderedTick{};
  }
  std::string_view error() const noexcept override { return calls_->error; }

 private:
  std::shared_ptr<ChartCalls> calls_;
};

/// A recording model on a body, with the calls of the charts of the axes x, y and z.
struct RecordedCharts {
  explicit RecordedCharts(const RendererInputs& inputs) {
    ForceModel model = point_models().front();
    model.make = [this](const RendererInputs&) {
      all.push_back(std::make_shared<ChartCalls>());
      return std::make_unique<RecordingModel>(all.back());
    };
    renderer = make_renderer(model, inputs);
    all.erase(all.begin());  // of the examination of the texture
  }
  ChartCalls& of_axis(std::size_t axis) { return *all.at(axis); }

  std::vector<std::shared_ptr<ChartCalls>> all{};
  std::unique_ptr<ForceRenderer> renderer{};
};

std::shared_ptr<const BodySurface> cube() {
  return std::make_shared<const BodySurface>(
      placed(body_mesh(BoxShape{{0.03, 0.03, 0.03}}, nullptr), BodyRole::surface));
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

struct Side {
  const char* name = "";
  std::size_t axis = 0;
  glm::dvec3 probe_m{0.0};
  glm::dvec3 local_m{0.0};
  glm::dvec3 local_velocity{0.0};  ///< for (1, 2, 3) in the frame of the device
  glm::dvec3 force{0.0};           ///< for (1, 2, 3) in the frame of the chart
};

TEST(PointOnBodyCharts, EverySideHasItsCoordinatesAndItsFrame) {
  const auto body = cube();
  for (const Side& side : {Side{.name = "+z",
                          .axis = 2,
                          .probe_m = {0.003, 0.005, -0.001},
                          .local_m = {0.003, 0.005, -0.001},
                          .local_velocity = {1, 2, 3},
                          .force = {1, 2, 3}},
                           Side{.name = "-z",
                           .axis = 2,
                           .probe_m = {0.003, 0.005, -0.029},
                           .local_m = {-0.003, 0.005, -0.001},
                           .local_velocity = {-1, 2, -3},
                           .force = {-1, 2, -3}},
                           Side{.name = "+y",
                           .axis = 1,
                           .probe_m = {0.003, 0.014, -0.012},
                           .local_m = {-0.003, -0.012, -0.001},
                           .local_velocity = {-1, 3, 2},
                           .force = {-1, 3, 2}},
                           Side{.name = "-y",
                           .axis = 1,
                           .probe_m = {0.003, -0.014, -0.012},
                           .local_m = {0.003, -0.012, -0.001},
                           .local_velocity = {1, 3, -2},
                           .force = {1, -3, 2}},
                           Side{.name = "+x",
                           .axis = 0,
                           .probe_m = {0.014, 0.005, -0.012},
                           .local_m = {0.005, -0.012, -0.001},
                           .local_velocity = {2, 3, 1},
                           .force = {3, 1, 2}},
                           Side{.name = "-x",
                           .axis = 0,
                           .probe_m = {-0.014, 0.005, -0.012},
                           .local_m = {-0.005, -0.012, -0.001},
                           .local_velocity = {-2, 3, -1},
                           .force = {-3, -1, 2}}}) {
    SCOPED_TRACE(side.name);
    RecordedCharts charts(inputs_on_body(body));
    ChartCalls& calls = charts.of_axis(side.axis);
    calls.answer = {.wrench = {.force_N = {1.0, 2.0, 3.0}}, .penetration_m = 0.25};
    ProbeState probe = probe_at(side.probe_m);
    probe.velocity_m_per_s = {1.0, 2.0, 3.0};
    probe.time_ns = 77;
    const RenderedTick tick = charts.renderer->tick(probe, 0.0007);
    EXPECT_EQ(calls.ticks, 1);
    EXPECT_EQ(calls.resets, 1);
    EXPECT_EQ(calls.last.time_ns, 77);
    EXPECT_EQ(calls.dt_s, 0.0007);
    expect_near(calls.last.position_m, side.local_m, 1e-9);
    expect_near(calls.last.velocity_m_per_s, side.local_velocity, 1e-9);
    expect_near(tick.wrench.force_N, side.force, 1e-9);
    EXPECT_NEAR(tick.penetration_m, 0.25, 1e-12);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis != side.axis) {
        EXPECT_EQ(charts.of_axis(axis).ticks, 0);
      }
    }
  }
}

TEST(PointOnBodyCharts, AxesAreTurnedOntoAnInclinedSurface) {
  constexpr double kInclined_rad = 0.5;
  RecordedCharts charts(inputs_on_body(sphere()));
  ChartCalls& calls = charts.of_axis(2);
  ProbeState probe = between_axes(2, 0, kInclined_rad, kGlobeRadius_m - 0.001);
  const glm::dvec3 down{std::cos(kInclined_rad), 0.0, -std::sin(kInclined_rad)};
  const glm::dvec3 out{std::sin(kInclined_rad), 0.0, std::cos(kInclined_rad)};
  probe.velocity_m_per_s = 2.0 * down + glm::dvec3(0.0, 3.0, 0.0) - 5.0 * out;
  calls.answer = {.wrench = {.force_N = {2.0, 3.0, -5.0}}, .penetration_m = 0.001};
  const RenderedTick tick = charts.renderer->tick(probe, kTick_s);
  expect_near(calls.last.velocity_m_per_s, {2.0, 3.0, -5.0}, 0.01);
  expect_near(tick.wrench.force_N, probe.velocity_m_per_s, 0.01);
  EXPECT_NEAR(calls.last.position_m.x, kGlobeRadius_m * std::sin(kInclined_rad), 1e-5);
}

TEST(PointOnBodyCharts, BlendWithTheStatedWeights) {
  RecordedCharts charts(inputs_on_body(sphere()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    charts.of_axis(axis).answer.penetration_m = std::pow(10.0, static_cast<double>(axis));
  }
  const auto blend_at = [&](double angle_rad) {
    return answer(*charts.renderer, between_axes(2, 0, angle_rad, kGlobeRadius_m - 0.001))
        .penetration_m;
  };
  constexpr double kHalf_rad = std::numbers::pi / 4;
  EXPECT_NEAR(blend_at(kHalf_rad), 0.5 * 1.0 + 0.5 * 100.0, 0.5);
  for (const double beside_rad : {-0.12, -0.08, -0.03, 0.03, 0.08, 0.12}) {
    const double angle_rad = kHalf_rad + beside_rad;
    const double u =
        1.0 - std::abs(std::cos(angle_rad) - std::sin(angle_rad)) / 0.15;  // of the lesser one
    const double lesser = u > 0.0 ? u * u * (3.0 - 2.0 * u) : 0.0;
    const double x = beside_rad > 0.0 ? 1.0 : lesser;
    const double z = beside_rad > 0.0 ? lesser : 1.0;
    EXPECT_NEAR(blend_at(angle_rad), (x * 1.0 + z * 100.0) / (x + z), 0.5) << beside_rad;
  }
  const glm::dvec3 between = (kGlobeRadius_m - 0.001) * glm::normalize(glm::dvec3(1.0, 1.0, 1.0)) -
                             glm::dvec3(0.0, 0.0, kGlobeRadius_m);
  EXPECT_NEAR(answer(*charts.renderer, probe_at(between)).penetration_m, 37.0, 0.5);
}

// A chart that is entered continues friction as it was before this tick, also if the other chart was called first.
TEST(PointOnBodyCharts, TheDragOnASeamIsTheSameFromAllSides) {
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.material.friction = 0.8;
  inputs.parameters = {{"amplitude_m", 0.0}, {"friction_law", std::string("proxy")}};
  const auto renderer = built_in_models().make("sinusoid", inputs);
  constexpr double kSeam_rad = std::numbers::pi / 4;
  constexpr double kBeside_rad = 0.11;  // where only one chart has a weight
  const auto drag_N = [&](int from, int to) {
    const ProbeState before =
        between_axes(from, to, kSeam_rad - kBeside_rad, kGlobeRadius_m - 0.003);
    renderer->reset(before);
    renderer->tick(before, kTick_s);
    const glm::dvec3 force_N =
        renderer->tick(between_axes(from, to, kSeam_rad, kGlobeRadius_m - 0.003), kTick_s)
            .wrench.force_N;
    return std::numbers::sqrt2 / 2 * (force_N[from] - force_N[to]);
  };
  const double first_N = drag_N(2, 0);
  EXPECT_GT(first_N, 0.01);
  for (const auto& [from, to] : {std::pair{0, 2}, {2, 1}, {1, 2}, {0, 1}, {1, 0}}) {
    EXPECT_NEAR(drag_N(from, to), first_N, 0.001) << "from " << from << " to " << to;
  }
}

TEST(PointOnBodyCharts, EntersAChartAnewAfterEveryPause) {
  RecordedCharts charts(inputs_on_body(cube()));
  ChartCalls& upper = charts.of_axis(2);
  const ProbeState in = probe_at({0.003, 0.005, -0.001});
  charts.renderer->tick(in, kTick_s);
  charts.renderer->tick(in, kTick_s);
  EXPECT_EQ(upper.resets, 1);
  charts.renderer->reset(in);
  charts.renderer->tick(in, kTick_s);
  EXPECT_EQ(upper.resets, 2) << "after a reset";
  charts.renderer->tick(probe_at({0.003, 0.005, 0.02}), kTick_s);
  charts.renderer->tick(in, kTick_s);
  EXPECT_EQ(upper.resets, 3) << "beyond the reach";
  charts.renderer->tick(probe_at({1.0, 0.005, -0.001}), kTick_s);
  charts.renderer->tick(in, kTick_s);
  EXPECT_EQ(upper.resets, 4) << "outside the patch";
  charts.renderer->tick(probe_at({0.014, 0.005, -0.012}), kTick_s);
  charts.renderer->tick(in, kTick_s);
  EXPECT_EQ(upper.resets, 5) << "in another chart";
  EXPECT_EQ(upper.ticks, 6);
}

TEST(PointOnBodyCharts, ForgetTheSideOfAThinPlateOutsideTheirPatchAndAtAReset) {
  RendererInputs inputs = inputs_on_body(flat_plate());
  inputs.patch.extent_m = {0.02, 0.02};
  inputs.patch.edge_width_m = 0.0;
  const ProbeState above = probe_at({0.0095, 0.0, -0.001});
  const ProbeState through = probe_at({0.0095, 0.0, -0.003});
  const ProbeState beside = probe_at({0.0105, 0.0, -0.003});
  RecordedCharts charts(inputs);
  const double& z_m = charts.of_axis(2).last.position_m.z;
  const auto push_through = [&] {
    charts.renderer->reset(above);
    charts.renderer->tick(above, kTick_s);
    charts.renderer->tick(through, kTick_s);
    EXPECT_NEAR(z_m, -0.003, 1e-9);
  };
  push_through();
  charts.renderer->tick(beside, kTick_s);
  charts.renderer->tick(through, kTick_s);
  EXPECT_NEAR(z_m, -0.001, 1e-9);
  push_through();
  charts.renderer->reset(through);
  charts.renderer->tick(through, kTick_s);
  EXPECT_NEAR(z_m, -0.001, 1e-9);
}

TEST(PointOnBodyCharts, TheBorderActsOnlyInContactAndFadesWithItsWidth) {
  RendererInputs inputs = inputs_on_body(flat_plate());
  inputs.patch = {.extent_m = {0.02, 0.02}, .edge = PatchEdge::wall};
  RecordedCharts walled(inputs);
  walled.of_axis(2).answer = {.wrench = {.force_N = {0.0, 0.0, 2.0}}, .penetration_m = 0.001};
  const ProbeState inside = probe_at({0.009, 0.0, -0.001});
  expect_near(answer_after(*walled.renderer, inside, probe_at({0.011, 0.0, 0.001})).wrench.force_N,
              glm::dvec3(0.0), 0.0);
  expect_near(answer_after(*walled.renderer, inside, probe_at({0.011, 0.0, -0.001})).wrench.force_N,
              {-1.0, 0.0, 2.0}, 1e-9);
  inputs.patch = {.extent_m = {0.02, 0.02}, .edge = PatchEdge::fade, .edge_width_m = 0.004};
  RecordedCharts faded(inputs);
  faded.of_axis(2).answer = {.wrench = {.force_N = {0.0, 0.0, 2.0}}, .penetration_m = 0.001};
  const RenderedTick half = answer(*faded.renderer, probe_at({0.008, 0.0, -0.001}));
  EXPECT_NEAR(half.wrench.force_N.z, 1.0, 1e-9);
  EXPECT_EQ(half.penetration_m, 0.001);
}

TEST(PointOnBodyCharts, ReportTheErrorOfEveryChart) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RecordedCharts charts(inputs_on_body(sphere()));
    EXPECT_EQ(charts.renderer->error(), "");
    charts.of_axis(axis).error = "too deep";
    EXPECT_EQ(charts.renderer->error(), "too deep") << axis;
  }
}

/// Rises or has no finite force where a function of the place says so.
class PlacedModel final : public ForceRenderer {
 public:
  using Answer = RenderedTick (*)(const glm::dvec3& position_m, const RendererInputs& inputs);
  PlacedModel(Answer answer, const RendererInputs& inputs) : answer_(answer), inputs_(inputs) {}
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    return answer_(probe.position_m, inputs_);
  }

 private:
  Answer answer_;
  RendererInputs inputs_;
};

std::string refusal_of_model(PlacedModel::Answer answer, const RendererInputs& inputs) {
  ForceModel model = point_models().front();
  model.make = [answer](const RendererInputs& complete) {
    return std::make_unique<PlacedModel>(answer, complete);
  };
  return refusal_of([&] { make_renderer(model, inputs); });
}

TEST(PointOnBodyCharts, TheExaminationOfTheTextureCoversItsWholeArea) {
  RendererInputs inputs = inputs_on_body(sphere());
  // A hill of 8 mm by 8 mm in a corner of the square of 0.1 m, and of a wider height field.
  EXPECT_THAT(refusal_of_model(
                  [](const glm::dvec3& at_m, const RendererInputs&) {
                    const bool is_high = at_m.x > 0.042 && at_m.y < -0.042;
                    return RenderedTick{.penetration_m = is_high ? 0.001 : 0.0};
                  },
                  inputs),
              testing::HasSubstr("rises more than 0.01 m"));
  inputs.height_field = std::make_shared<const HeightField>(HeightField::Grid{64, 300, 0.001},
                                                            std::vector<float>(64 * 300, 0.0F));
  inputs.patch.motion_scale = 0.5;  // 0.6 m of the device
  EXPECT_THAT(refusal_of_model(
                  [](const glm::dvec3& at_m, const RendererInputs&) {
                    const bool is_high = at_m.x < -0.27 && at_m.y > 0.27;
                    return RenderedTick{.penetration_m = is_high ? 0.001 : 0.0};
                  },
                  inputs),
              testing::HasSubstr("rises more than"));
  EXPECT_EQ(refusal_of_model(
                [](const glm::dvec3&, const RendererInputs&) { return RenderedTick{}; }, inputs),
            "");
}

TEST(PointOnBodyCharts, TheExaminationOfTheTextureIncludesItsLowestSample) {
  // A model that renders the field upside down.
  constexpr std::size_t kSide = 300;
  std::vector<float> heights_m(kSide * kSide, 0.0F);
  heights_m[10'150] = -0.012F;
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.height_field = std::make_shared<const HeightField>(HeightField::Grid{kSide, kSide, 0.001},
                                                            std::move(heights_m));
  EXPECT_THAT(refusal_of_model(
                  [](const glm::dvec3& at_m, const RendererInputs&) {
                    // Sample (33, 250): 0.1 m right of the middle and 0.1165 m above it.
                    const bool is_high =
                        std::abs(at_m.x - 0.1005) < 2e-4 && std::abs(at_m.y - 0.1165) < 2e-4;
                    return RenderedTick{.penetration_m = is_high ? 0.002 : 0.0};
                  },
                  inputs),
              testing::HasSubstr("rises more than"));
}

/// Is in contact unless it is reset where it is called, as a model that fills the way from its last place.
class RestingModel final : public ForceRenderer {
 public:
  void reset(const ProbeState& first) noexcept override { first_m_ = first.position_m; }
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    return {.penetration_m = first_m_ == probe.position_m ? 0.0 : 0.001};
  }

 private:
  glm::dvec3 first_m_{std::numeric_limits<double>::max()};
};

TEST(PointOnBodyCharts, TheExaminationOfTheTextureResetsTheModelAtEveryPlace) {
  ForceModel model = point_models().front();
  model.make = [](const RendererInputs&) { return std::make_unique<RestingModel>(); };
  EXPECT_EQ(refusal_of([&] { make_renderer(model, inputs_on_body(sphere())); }), "");
}

TEST(PointOnBodyCharts, TheExaminationOfTheTextureRefusesEveryNumberThatIsNotFinite) {
  const RendererInputs inputs = inputs_on_body(sphere());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const PlacedModel::Answer answer :
       {+[](const glm::dvec3&, const RendererInputs&) {
          return RenderedTick{.wrench = {.force_N = {kNone, 0.0, 0.0}}};
        },
        +[](const glm::dvec3&, const RendererInputs&) {
          return RenderedTick{.wrench = {.force_N = {0.0, kNone, 0.0}}};
        },
        +[](const glm::dvec3&, const RendererInputs&) {
          return RenderedTick{.wrench = {.force_N = {0.0, 0.0, 1.0 / 0.0}}};
        },
        +[](const glm::dvec3&, const RendererInputs&) {
          return RenderedTick{.penetration_m = kNone};
        }}) {
    EXPECT_EQ(refusal_of_model(answer, inputs),
              "the model computes no finite force above the body; correct the model or its "
              "parameters");
  }
}

}  // namespace
}  // namespace asperity
