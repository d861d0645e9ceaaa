// The force of a recorded hand: what is texture in it and what is not.

#include "renderers/offline/recorded_force.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/offline/replay.h"

namespace asperity {
namespace {

constexpr double kRate_Hz = 1000.0;

/// A hand that strokes to and fro over ±30 mm at 60 mm/s, 2 mm below the plane, for 4 s.
std::vector<TickRecord> to_and_fro(const ForceModel& model, const RendererInputs& inputs) {
  const auto renderer = make_renderer(model, inputs);
  std::vector<TickRecord> records(4000);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const double travelled_m = 0.060 * static_cast<double>(i) / kRate_Hz;
    const double phase = std::fmod(travelled_m, 0.120);
    const bool forth = phase < 0.060;
    TickRecord& record = records[i];
    record.probe.time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    record.probe.position_m = {forth ? phase - 0.030 : 0.090 - phase, 0.0, -0.002};
    record.probe.velocity_m_per_s = {forth ? 0.060 : -0.060, 0.0, 0.0};
    record.presentation = 1;
    record.gain = 1.0;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    if (i == 0) {
      record.flags |= static_cast<std::uint32_t>(TickFlag::first_of_presentation);
      renderer->reset(record.probe);
    }
    const RenderedTick tick = renderer->tick(record.probe, 1.0 / kRate_Hz);
    record.rendered = tick.wrench;
    record.sent = tick.wrench;
    record.penetration_m = tick.penetration_m;
  }
  return records;
}

/// With a friction that follows the normal force at once.
RendererInputs sinusoid(double amplitude_m) {
  RendererInputs inputs{};
  inputs.parameters = {{"amplitude_m", amplitude_m},
                       {"friction_law", std::string("rounded")},
                       {"wavelength_m", 0.002}};
  return inputs;
}

// Friction turns round with the hand, and landing and lifting are the hand's: nothing shakes the tool.
TEST(RecordedShaking, IsNothingOnAFlatPlateHoweverOftenTheHandTurns) {
  const ModelRegistry models = built_in_models();
  RendererInputs inputs = sinusoid(0.0);
  inputs.material.friction = 0.5;
  auto records = to_and_fro(*models.find("sinusoid"), inputs);
  EXPECT_LT(recorded_shaking_m_per_s2({records, 1, kRate_Hz}).value(), 1e-3);
  for (std::size_t i = 3900; i < records.size(); ++i) {  // let go of within 0.1 s
    records[i].sent.force_N *= 0.01 * static_cast<double>(records.size() - i);
  }
  EXPECT_LT(recorded_shaking_m_per_s2({records, 1, kRate_Hz}).value(), 1e-3);
}

// k·A = 50 mN at ω = 2π·30 Hz across the surface, where the tool has its damper only, and friction's
// share of it along the motion, where it has the hand's spring as well.
TEST(RecordedShaking, IsWhatASinusoidDoesToAHeldTool) {
  const ModelRegistry models = built_in_models();
  RendererInputs inputs = sinusoid(1e-4);
  inputs.material = {.stiffness_N_per_m = 500.0, .friction = 0.5};
  const auto records = to_and_fro(*models.find("sinusoid"), inputs);
  constexpr double kOmega_rad_per_s = 2.0 * std::numbers::pi * 30.0;
  constexpr double kForce_N = 0.05;
  const double across = kOmega_rad_per_s * kForce_N / std::hypot(0.05 * kOmega_rad_per_s, 3.0);
  const double along =
      0.5 * kForce_N * kOmega_rad_per_s * kOmega_rad_per_s /
      std::hypot(200.0 - 0.05 * kOmega_rad_per_s * kOmega_rad_per_s, 3.0 * kOmega_rad_per_s);
  const double rms_m_per_s2 = std::hypot(across, along) / std::numbers::sqrt2;
  EXPECT_NEAR(recorded_shaking_m_per_s2({records, 1, kRate_Hz}).value() / rms_m_per_s2, 1.0, 0.03);
  EXPECT_EQ(recorded_force_features({records, 1, kRate_Hz}).shaking_m_per_s2,
            recorded_shaking_m_per_s2({records, 1, kRate_Hz}).value());
}

TEST(RecordedShaking, NeedsAContactThatIsLongEnough) {
  const ModelRegistry models = built_in_models();
  auto records = to_and_fro(*models.find("sinusoid"), sinusoid(1e-4));
  // 0.267 s of beginning, a quarter of a second, 0.1 s of lifting.
  const std::span<const TickRecord> all(records);
  EXPECT_FALSE(recorded_shaking_m_per_s2({all.first(600), 1, kRate_Hz}));
  EXPECT_TRUE(recorded_shaking_m_per_s2({all.first(640), 1, kRate_Hz}));
  EXPECT_EQ(recorded_force_features({all.first(600), 1, kRate_Hz}).shaking_m_per_s2, 0.0);
  // A tool that jumps for 10 ms is still in contact, one that is away for 30 ms is not.
  const auto lift = [&records](std::size_t from, std::size_t ticks) {
    for (std::size_t i = from; i < from + ticks; ++i) records[i].penetration_m = 0.0;
  };
  lift(300, 10);
  EXPECT_TRUE(recorded_shaking_m_per_s2({all.first(640), 1, kRate_Hz}));
  lift(300, 30);
  EXPECT_FALSE(recorded_shaking_m_per_s2({all.first(640), 1, kRate_Hz}));
}

// 2 mm of 500 N/m are 1 N; of what is sent, half the force means twice the compliance.
TEST(RecordedForceFeatures, HaveTheComplianceOfAPlate) {
  const ModelRegistry models = built_in_models();
  auto records = to_and_fro(*models.find("sinusoid"), sinusoid(0.0));
  EXPECT_NEAR(recorded_force_features({records, 1, kRate_Hz}).compliance_m_per_N, 2e-3, 1e-9);
  for (TickRecord& record : records) record.sent.force_N *= 0.5;
  EXPECT_NEAR(recorded_force_features({records, 1, kRate_Hz}).compliance_m_per_N, 4e-3, 1e-9);
  EXPECT_EQ(recorded_force_features({records, 2, kRate_Hz}).compliance_m_per_N, 0.0);
}

std::optional<double> texture_rms_N(const ForceModel& model, const RendererInputs& inputs,
                                    const RecordedSurfaceSpan& surface) {
  return recorded_texture_force_rms_N(recorded_texture(model, inputs, surface), {});
}

TEST(RecordedTextureForce, IsZeroOnAFlatPlateHoweverOftenTheHandTurns) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const RendererInputs inputs = sinusoid(0.0);
  const auto records = to_and_fro(model, inputs);
  EXPECT_NEAR(*texture_rms_N(model, inputs, {records, 1, kRate_Hz}), 0.0, 1e-12);
}

TEST(RecordedTextureForce, IsThatOfTheSinusoidAndOfTheFrictionItMakes) {
  // Normal force k·A·sin: RMS k·A/√2; friction μ times that along the motion. 60 mm/s over 2 mm is
  // 30 Hz, inside the band. The texture's mean height A is left out by the band.
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const RendererInputs inputs = sinusoid(1e-4);
  const auto records = to_and_fro(model, inputs);
  const double normal_N = 500.0 * 1e-4 / std::numbers::sqrt2;
  // Friction from the constant part A of the height turns with the hand; it is the texture's too.
  const double expected_N = normal_N * std::sqrt(1.0 + 0.2 * 0.2);
  EXPECT_NEAR(*texture_rms_N(model, inputs, {records, 1, kRate_Hz}), expected_N, 0.03 * expected_N);
}

TEST(RecordedTextureForce, IsNothingWithoutAQuarterSecondOfContact) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const RendererInputs inputs = sinusoid(1e-4);
  auto records = to_and_fro(model, inputs);
  for (std::size_t i = 0; i < records.size(); i += 200) records[i].penetration_m = 0.0;
  EXPECT_FALSE(texture_rms_N(model, inputs, {records, 1, kRate_Hz}));
  EXPECT_FALSE(texture_rms_N(model, inputs, {records, 2, kRate_Hz}));
}

constexpr double kSide_m = 0.047;
constexpr double kBlendOfPatches_m = 0.002;

/// Two patches of 47 mm around ±26.5 mm: noise of its own clock, and a grating with resonance, whose noise is drawn anew
/// after each reset.
std::vector<AdjacentPatch> noisy_patches(const ModelRegistry& models) {
  std::vector<AdjacentPatch> patches{{models.find("stochastic"), {}},
                                     {models.find("sinusoid"), sinusoid(1e-4)}};
  patches[1].inputs.parameters["resonance_ratio"] = 0.5;
  patches[1].inputs.parameters["resonance_threshold_N"] = 0.05;
  double centre_x_m = -0.0265;
  for (AdjacentPatch& patch : patches) {
    patch.inputs.seed = 7;
    patch.inputs.material.friction = 0.0;  // whose contact continues from one surface to the next
    patch.inputs.patch.centre_m.x = centre_x_m;
    patch.inputs.patch.extent_m = {kSide_m, 0.1};
    centre_x_m += 0.053;
  }
  return patches;
}

/// A hand that enters each of the two patches three times, with the flags of a servo loop.
std::vector<TickRecord> over_both_patches(const std::vector<AdjacentPatch>& patches) {
  AdjacentPatches renderer(patches, {.extent_m = {0.1, 0.1}}, patches.front().inputs.material,
                           kBlendOfPatches_m);
  std::vector<TickRecord> records(3000);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const double turns = static_cast<double>(i) / 1000.0;
    TickRecord& record = records[i];
    record.probe.time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    record.probe.position_m = {-0.04 * std::cos(2.0 * std::numbers::pi * turns), 0.001, -0.002};
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.gain = 1.0;
    if (i == 0) {
      record.flags |= static_cast<std::uint32_t>(TickFlag::first_of_presentation);
      renderer.reset(record.probe);
    }
    const RenderedTick tick = renderer.tick(record.probe, 1.0 / kRate_Hz);
    record.rendered = record.sent = tick.wrench;
    record.penetration_m = tick.penetration_m;
    record.presentation = tick.part != 0 ? tick.part : kSideBySide;
  }
  return records;
}

TEST(RecordsAsFelt, RepeatTheForcesOfAPatchBitForBitAtEveryEntry) {
  const ModelRegistry models = built_in_models();
  const std::vector<AdjacentPatch> patches = noisy_patches(models);
  const std::vector<TickRecord> records = over_both_patches(patches);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const std::vector<TickRecord> felt = records_as_felt({records, i + 1, kRate_Hz});
    const auto alone = make_renderer(*patches[i].model, without_border(patches[i].inputs));
    const std::vector<RenderedTick> again = replay(*alone, felt, kRate_Hz);
    std::size_t entries = 0;
    std::size_t inside = 0;
    for (std::size_t tick = 0; tick < felt.size(); ++tick) {
      if (felt[tick].has(TickFlag::first_of_presentation)) ++entries;
      const double from_centre_m =
          felt[tick].probe.position_m.x - patches[i].inputs.patch.centre_m.x;
      if (std::abs(from_centre_m) > 0.5 * kSide_m - kBlendOfPatches_m) continue;
      ++inside;
      ASSERT_EQ(again[tick].wrench.force_N, felt[tick].rendered.force_N)
          << patches[i].model->declaration.id << ", entry " << entries << ", tick " << tick;
    }
    EXPECT_GE(entries, 3U);
    EXPECT_GT(inside, 900U);
  }
}

// A surface that is felt in turn with others: the servo loop sets the flag wherever it resets the renderer.
TEST(RecordsAsFelt, AreUnchangedWhereASurfaceWasNotLeft) {
  const ModelRegistry models = built_in_models();
  auto records = to_and_fro(*models.find("sinusoid"), sinusoid(1e-4));
  for (std::size_t i = 1000; i < 1100; ++i) {  // a fault: nothing was rendered
    records[i].flags = 0;
    records[i].presentation = 0;
  }
  const std::vector<TickRecord> felt = records_as_felt({records, 1, kRate_Hz});
  ASSERT_EQ(felt.size(), 3900U);
  for (std::size_t i = 1; i < felt.size(); ++i) {
    EXPECT_FALSE(felt[i].has(TickFlag::first_of_presentation)) << i;
  }
}

TEST(RecordedForceFeatures, PeakInTheBandOfTheWavelength) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const auto records = to_and_fro(model, sinusoid(1e-4));
  const ForceFeatures features = recorded_force_features({records, 1, kRate_Hz});
  const auto borders_m = feature_band_borders_m();
  std::size_t loudest = 0;
  for (std::size_t band = 1; band < kFeatureBands; ++band) {
    if (features.spectrum[band] > features.spectrum[loudest]) loudest = band;
  }
  EXPECT_GE(borders_m[loudest], 0.002);
  EXPECT_LE(borders_m[loudest + 1], 0.002);
}

}  // namespace
}  // namespace asperity
