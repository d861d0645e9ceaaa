// The detectors find what is planted and nothing in a stable stroke.

#include "renderers/offline/perceived_instability.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/offline/slow_hand.h"
#include "renderers/offline/unexplained_vibration.h"
#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/planted_strokes.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kJudgedRate_Hz = 1000.0;
constexpr double kFullTurn_rad = 2.0 * std::numbers::pi;

/// The number of docs/instability.md that separates strokes with a buzz from strokes without one.
constexpr double kFlagged = 0.4;

std::vector<glm::dvec3> sine_along_x(double amplitude_N, double frequency_Hz, std::size_t samples) {
  std::vector<glm::dvec3> force_N(samples, glm::dvec3(0.0));
  for (std::size_t i = 0; i < samples; ++i) {
    force_N[i].x = amplitude_N *
                   std::sin(kFullTurn_rad * frequency_Hz * static_cast<double>(i) / kJudgedRate_Hz);
  }
  return force_N;
}

std::vector<glm::dvec3> white_noise_along_z(double rms_N, std::size_t samples, std::uint64_t seed) {
  std::vector<glm::dvec3> force_N(samples, glm::dvec3(0.0));
  Random random(seed);
  for (glm::dvec3& each_N : force_N) each_N.z = rms_N * random.normal();
  return force_N;
}

TEST(UnexplainedVibration, IsTheRmsOfAnOscillationThatTheModelDoesNotContain) {
  const auto delivered_N = sine_along_x(0.1, 240.0, 2000);
  const std::vector<glm::dvec3> nothing_N(2000, glm::dvec3(0.0));
  EXPECT_NEAR(unexplained_vibration({delivered_N, nothing_N, kJudgedRate_Hz})->rms_N,
              0.1 / std::numbers::sqrt2, 1e-4);
  EXPECT_EQ(unexplained_vibration({delivered_N, delivered_N, kJudgedRate_Hz})->rms_N, 0.0);
  const auto slow_N = sine_along_x(1.0, 100.0, 2000);
  EXPECT_LT(unexplained_vibration({slow_N, nothing_N, kJudgedRate_Hz})->rms_N, 1e-4);
  EXPECT_FALSE(unexplained_vibration(
      {std::span(delivered_N).first(299), std::span(nothing_N).first(299), kJudgedRate_Hz}));
}

// Two draws of one spectrum differ by √2 times their RMS, sample by sample, of which √0.7 is above 150 Hz. White noise along
// one axis is the least favourable force: all of its power is in few draws.
TEST(UnexplainedVibration, ExplainsNoiseByOtherNoiseOfTheSameSpectrum) {
  double greatest = 0.0;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto delivered_N = white_noise_along_z(0.1, 4000, seed);
    const auto explained_N = white_noise_along_z(0.1, 4000, 1000 + seed);
    const double ratio =
        unexplained_vibration({delivered_N, explained_N, kJudgedRate_Hz})->rms_N / 0.1;
    greatest = std::max(greatest, ratio);
    sum += ratio;
  }
  EXPECT_LT(greatest, 0.5);
  EXPECT_LT(sum / 40.0, 0.33);
}

TEST(UnexplainedVibration, IsFoundInNoise) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    auto delivered_N = white_noise_along_z(0.1, 4000, seed);
    const auto oscillation_N =
        sine_along_x(0.05 * std::numbers::sqrt2, 150.0 + 7.0 * static_cast<double>(seed), 300);
    for (std::size_t i = 0; i < 300; ++i) delivered_N[1510 + i].z += oscillation_N[i].x;
    const auto explained_N = white_noise_along_z(0.1, 4000, 1000 + seed);
    const auto greatest = unexplained_vibration({delivered_N, explained_N, kJudgedRate_Hz});
    if (greatest->rms_N / 0.1 > kFlagged) ++found;
  }
  EXPECT_GE(found, 36);
}

TEST(UnexplainedVibration, IsWhereTheOscillationIs) {
  std::vector<glm::dvec3> delivered_N(4000, glm::dvec3(0.0));
  const std::vector<glm::dvec3> nothing_N(4000, glm::dvec3(0.0));
  const auto oscillation_N = sine_along_x(0.1, 300.0, 300);
  std::copy(oscillation_N.begin(), oscillation_N.end(), delivered_N.begin() + 1510);
  const auto found = unexplained_vibration({delivered_N, nothing_N, kJudgedRate_Hz});
  EXPECT_NEAR(static_cast<double>(found->middle), 1660.0, 50.0);
}

TEST(UnexplainedVibration, IsThatOfTheWindowWithTheMost) {
  constexpr std::size_t kWindow = 300;
  constexpr std::size_t kStep = 100;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto delivered_N = white_noise_along_z(0.1, 2000, seed);
    const auto explained_N = white_noise_along_z(0.1, 2000, 1000 + seed);
    double greatest_N = 0.0;
    for (std::size_t first = 0; first + kWindow <= delivered_N.size(); first += kStep) {
      const auto of_one =
          unexplained_vibration({std::span(delivered_N).subspan(first, kWindow),
                                 std::span(explained_N).subspan(first, kWindow), kJudgedRate_Hz});
      greatest_N = std::max(greatest_N, of_one->rms_N);
    }
    EXPECT_EQ(unexplained_vibration({delivered_N, explained_N, kJudgedRate_Hz})->rms_N, greatest_N);
  }
}

/// Every model on every simulated device; scripts/evidence perceived_instability has a long series.
TEST(Buzz, SeparatesStrokesWithAnOscillationFromStrokesWithoutOne) {
  const std::vector<ForceModel> models = point_models();
  for (std::uint64_t i = 0; i < 3 * models.size(); ++i) {
    SeriesStroke each = stroke_of_series(models, i, 5);
    const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
    const RecordedTexture texture = texture_in(*each.model, each.inputs, records);
    const auto clean = perceived_instability(*each.model, each.inputs, texture);
    EXPECT_LT(clean.buzz.value().ratio, kFlagged)
        << each.model->declaration.id << " on " << each.stroke.device << ", stroke " << i;
    const double texture_N = recorded_texture_force_rms_N(texture, {}).value_or(0.0);
    each.stroke.planted = oscillation_of_series(i, 5, std::max(kLeastTexture_N, 0.5 * texture_N));
    const auto shaken = planted_stroke(*each.model, each.inputs, each.stroke);
    EXPECT_GT(judged_stroke(*each.model, each.inputs, shaken).buzz.value().ratio, kFlagged)
        << each.model->declaration.id << " on " << each.stroke.device << ", stroke " << i;
  }
}

TEST(Buzz, IsRareWithTwoBodies) {
  const ModelRegistry registry = built_in_models();
  const ForceModel& model = *registry.find("pd_gradient");
  const RendererInputs inputs = stimulus_of_stroke(model, 1);
  const PlantedStroke stroke{.duration_s = 0.9};
  const auto records = planted_stroke(model, inputs, stroke);
  EXPECT_LT(judged_stroke(model, inputs, records).buzz.value().ratio, 0.2);
}

// docs/models/limits.md: friction of the law `rounded` vibrates on this device above 0.75 N, and the default
// law does not.
TEST(Buzz, IsThatOfFrictionThatTheDeviceCannotRender) {
  const ModelRegistry registry = built_in_models();
  const ForceModel& model = *registry.find("sinusoid");
  RendererInputs inputs = stimulus_of_stroke(model, 1);
  PlantedStroke stroke{.device = "simulated:falcon"};
  stroke.habits.normal_force_N = 2.0;
  stroke.habits.speed_m_per_s = 0.03;
  inputs.material.friction = 0.4;
  const auto buzz = [&] {
    const auto records = planted_stroke(model, inputs, stroke);
    return judged_stroke(model, inputs, records).buzz.value().ratio;
  };
  EXPECT_LT(buzz(), kFlagged);
  inputs.parameters["friction_law"] = std::string("rounded");
  EXPECT_GT(buzz(), kFlagged);
}

/// A contact of 3 s at full gain; the position of each tick and the force that is added to the rendered one.
template <typename PositionOf, typename AddedForceOf>
std::vector<TickRecord> contact_of_3_s(const ForceModel& model, const RendererInputs& inputs,
                                       const PositionOf& position_m, const AddedForceOf& added_N) {
  const auto renderer = make_renderer(model, inputs);
  std::vector<TickRecord> records(3000);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const double t = static_cast<double>(i) / kJudgedRate_Hz;
    TickRecord& record = records[i];
    record.probe.time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    record.probe.position_m = position_m(t);
    record.probe.velocity_m_per_s = (position_m(t + 1e-4) - position_m(t - 1e-4)) / 2e-4;
    record.presentation = 1;
    record.gain = 1.0;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    if (i == 0) renderer->reset(record.probe);
    const RenderedTick tick = renderer->tick(record.probe, 1.0 / kJudgedRate_Hz);
    record.rendered = tick.wrench;
    record.sent = tick.wrench;
    record.sent.force_N += added_N(t);
    record.penetration_m = tick.penetration_m;
  }
  return records;
}

const auto kNothingAdded = [](double) { return glm::dvec3(0.0); };

struct Grated {
  ModelRegistry registry = built_in_models();
  const ForceModel& model = *registry.find("sinusoid");
  RendererInputs inputs{.parameters = {{"amplitude_m", 1e-4}, {"wavelength_m", 2e-3}}};

  PerceivedInstability judge(const std::vector<TickRecord>& records) const {
    return judged_stroke(model, inputs, records);
  }
};

TEST(Aliveness, IsTheForceOnAHandThatRests) {
  const Grated grated{};
  const auto resting = [](double) { return glm::dvec3(0.0, 0.0, -0.002); };
  const auto pulse = [](double t) {
    return glm::dvec3(0.0, 0.0, 0.1 * std::sin(kFullTurn_rad * 5.0 * t));
  };
  const auto alive =
      grated.judge(contact_of_3_s(grated.model, grated.inputs, resting, pulse)).aliveness;
  ASSERT_TRUE(alive);
  EXPECT_NEAR(alive->force_N, 0.1 / std::numbers::sqrt2, 1e-3);
  EXPECT_LT(alive->plate_N, 1e-9);
  EXPECT_LT(alive->position_m, 1e-9);
  EXPECT_NEAR(alive->resting_s, 3.0, 1e-9);
}

// 0.1 mm at 10 Hz on 500 N/m; both surfaces answer with the same force.
TEST(Aliveness, IsNotTheTrembleOfTheHand) {
  const Grated grated{};
  const auto trembling = [](double t) {
    return glm::dvec3(0.0, 0.0, -0.002 + 1e-4 * std::sin(kFullTurn_rad * 10.0 * t));
  };
  const auto alive =
      grated.judge(contact_of_3_s(grated.model, grated.inputs, trembling, kNothingAdded)).aliveness;
  ASSERT_TRUE(alive);
  EXPECT_NEAR(alive->force_N, 0.05 / std::numbers::sqrt2, 1e-3);
  EXPECT_NEAR(alive->plate_N, alive->force_N, 1e-6);
  EXPECT_NEAR(alive->position_m, 1e-4 / std::numbers::sqrt2, 1e-6);
  EXPECT_NEAR(alive->net_work_J.value(), 0.0, 1e-7);
}

// A force of 50 mN along a circle of 0.1 mm does 2π·0.1 mm·50 mN on each of the three turns.
TEST(Aliveness, HasTheWorkOfTheForceOnClosedParts) {
  const Grated grated{};
  const auto circle = [](double t) {
    return glm::dvec3(1e-4 * std::cos(kFullTurn_rad * t), 1e-4 * std::sin(kFullTurn_rad * t),
                      -0.002);
  };
  const auto along = [](double t) {
    return 0.05 * glm::dvec3(-std::sin(kFullTurn_rad * t), std::cos(kFullTurn_rad * t), 0.0);
  };
  RendererInputs plate = grated.inputs;
  plate.parameters["amplitude_m"] = 0.0;
  plate.material.friction = 0.0;
  const auto alive =
      judged_stroke(grated.model, plate, contact_of_3_s(grated.model, plate, circle, along))
          .aliveness;
  ASSERT_TRUE(alive);
  EXPECT_NEAR(alive->net_work_J.value(), 3.0 * kFullTurn_rad * 1e-4 * 0.05, 3e-6);
}

TEST(Aliveness, IsNotJudgedInAStroke) {
  const Grated grated{};
  const auto stroke = [](double t) { return glm::dvec3(0.01 * t, 0.0, -0.002); };
  const auto judged =
      grated.judge(contact_of_3_s(grated.model, grated.inputs, stroke, kNothingAdded));
  EXPECT_FALSE(judged.aliveness);
  EXPECT_EQ(judged.no_aliveness, NotJudged::too_short);
}

// The crest of A·sin(2πx/L) is at a quarter of L; 30 % of even motion is within 15 % of it.
TEST(Ridge, IsTheShareOfSlowContactNearCrests) {
  const Grated grated{};
  const auto even = [](double t) { return glm::dvec3(0.01 * t, 0.0, -0.002); };
  const auto judged =
      grated.judge(contact_of_3_s(grated.model, grated.inputs, even, kNothingAdded));
  EXPECT_NEAR(judged.ridge.value().crest_share, 0.3, 0.01);
  EXPECT_NEAR(judged.ridge->slow_s, 3.0, 1e-9);
  const auto on_crest = [](double t) {
    return glm::dvec3(0.5e-3 + 1e-4 * std::sin(kFullTurn_rad * t), 0.0, -0.002);
  };
  EXPECT_EQ(grated.judge(contact_of_3_s(grated.model, grated.inputs, on_crest, kNothingAdded))
                .ridge.value()
                .crest_share,
            1.0);
  const auto in_valley = [](double t) {
    return glm::dvec3(1.5e-3 + 1e-4 * std::sin(kFullTurn_rad * t), 0.0, -0.002);
  };
  EXPECT_EQ(grated.judge(contact_of_3_s(grated.model, grated.inputs, in_valley, kNothingAdded))
                .ridge.value()
                .crest_share,
            0.0);
  const auto fast = [](double t) { return glm::dvec3(0.08 * t, 0.0, -0.002); };
  EXPECT_EQ(grated.judge(contact_of_3_s(grated.model, grated.inputs, fast, kNothingAdded)).no_ridge,
            NotJudged::too_short);
}

TEST(Ridge, IsNotJudgedOnABody) {
  Grated grated{};
  const auto even = [](double t) { return glm::dvec3(0.01 * t, 0.0, -0.002); };
  grated.inputs.body =
      std::make_shared<const BodySurface>(body_mesh(PlateShape{{0.1, 0.02, 0.01}}, nullptr));
  const auto judged =
      grated.judge(contact_of_3_s(grated.model, grated.inputs, even, kNothingAdded));
  EXPECT_EQ(judged.no_ridge, NotJudged::no_crests);
  EXPECT_TRUE(judged.buzz);
}

TEST(PerceivedInstability, HasNoNumbersWithoutAForce) {
  const Grated grated{};
  const auto stroke = [](double t) { return glm::dvec3(0.01 * t, 0.0, -0.002); };
  auto records = contact_of_3_s(grated.model, grated.inputs, stroke, kNothingAdded);
  for (TickRecord& record : records) record.sent = {};
  EXPECT_EQ(grated.judge(records).no_buzz, NotJudged::no_force);
  const ForceModel& without_crests = *grated.registry.find("stochastic");
  EXPECT_EQ(judged_stroke(without_crests, {}, records).no_ridge, NotJudged::no_crests);
  EXPECT_EQ(perceived_instability(without_crests, {},
                                  recorded_texture(without_crests, {}, {records, 1, 200.0}))
                .no_buzz,
            NotJudged::low_rate);
}

// An oscillation at 200 Hz is removed, a stroke passes.
TEST(SlowHand, KeepsTheStrokeAndLosesTheVibration) {
  const Grated grated{};
  const auto shaken = [](double t) {
    return glm::dvec3(0.05 * t, 1e-3 * std::sin(kFullTurn_rad * 200.0 * t), -0.002);
  };
  const auto records = contact_of_3_s(grated.model, grated.inputs, shaken, kNothingAdded);
  const auto slow = slow_hand(records, kJudgedRate_Hz);
  for (std::size_t i = 200; i < 2800; ++i) {
    EXPECT_NEAR(slow[i].probe.position_m.x, records[i].probe.position_m.x, 1e-9);
    EXPECT_LT(std::abs(slow[i].probe.position_m.y), 1e-6);
    EXPECT_EQ(slow[i].probe.time_ns, records[i].probe.time_ns);
  }
}

}  // namespace
}  // namespace asperity
