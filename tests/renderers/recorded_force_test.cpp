// The force of a recorded hand: what is texture in it and what is not.

#include "renderers/offline/recorded_force.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

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

RendererInputs sinusoid(double amplitude_m) {
  RendererInputs inputs{};
  inputs.parameters = {{"amplitude_m", amplitude_m}, {"wavelength_m", 0.002}};
  return inputs;
}

TEST(RecordedTextureForce, IsZeroOnAFlatPlateHoweverOftenTheHandTurns) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const RendererInputs inputs = sinusoid(0.0);
  const auto records = to_and_fro(model, inputs);
  EXPECT_NEAR(*recorded_texture_force_rms_N(model, inputs, {records, 1, kRate_Hz}, {}), 0.0, 1e-12);
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
  EXPECT_NEAR(*recorded_texture_force_rms_N(model, inputs, {records, 1, kRate_Hz}, {}), expected_N,
              0.03 * expected_N);
}

TEST(RecordedTextureForce, IsNothingWithoutAQuarterSecondOfContact) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = *models.find("sinusoid");
  const RendererInputs inputs = sinusoid(1e-4);
  auto records = to_and_fro(model, inputs);
  for (std::size_t i = 0; i < records.size(); i += 200) records[i].penetration_m = 0.0;
  EXPECT_FALSE(recorded_texture_force_rms_N(model, inputs, {records, 1, kRate_Hz}, {}));
  EXPECT_FALSE(recorded_texture_force_rms_N(model, inputs, {records, 2, kRate_Hz}, {}));
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
