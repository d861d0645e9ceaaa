// A study whose recorded hands are rendered again, by the recorded force model and by others.

#include "app/tasks/compare_replays.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kAmplitude_m = 5e-5;
constexpr double kStiffness_N_per_m = 500.0;

class ComparedReplays : public SessionTest {
 protected:
  void SetUp() override {
    begin(R"({
  "format": "asperity.protocol/1", "kind": "magnitude", "design": "improved", "name": "gratings",
  "version": "1.0.0", "title": "Gratings",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "estimation": {"factor": "wavelength_m"},
  "factors": {"wavelength_m": {"levels": [0.001, 0.002, 0.0035]}},
  "material": {"stiffness_N_per_m": 500, "friction": 0},
  "stimuli": {"rendered": {"model": "sinusoid",
      "parameters": {"amplitude_m": 5e-5, "wavelength_m": {"factor": "wavelength_m"}}}},
  "explorations": {"short": {"minimum_contact_s": 0.5, "maximum_contact_s": 2}},
  "blocks": {"main": {"crossed": ["wavelength_m"], "presented": [{"stimulus": "rendered"}],
      "exploration": "short", "question": {"name": "size", "prompt": "How strong?"}}},
  "flow": [{"run": "main"}]})");
    person_.at_question = [](int, const Trial&) { return gives(10.0); };
    EXPECT_EQ(run().state, SessionState::completed);
  }

  ReplayComparison compared(OtherModel* other = nullptr, int jobs = 1) const {
    const ReplayComparisonOrder order{.builds = models_, .other = other, .jobs = jobs};
    return compare_replays(*study_, order, {}, {}).value();
  }

  OtherModelSettings sinusoid_of(double amplitude_m) const {
    return {.model = models_.find("sinusoid"), .parameters = {{"amplitude_m", amplitude_m}}};
  }
};

double in_bands_N2_s(const ForceEnergy& energy) {
  return std::accumulate(energy.bands_N2_s.begin(), energy.bands_N2_s.end(), 0.0);
}

TEST_F(ComparedReplays, OfTheSameModelDifferByExactlyNothing) {
  const ReplayComparison found = compared();
  ASSERT_EQ(found.presentations.size(), 3U);
  for (const ComparedPresentation& each : found.presentations) {
    EXPECT_GT(each.forces.samples, 500U);
    EXPECT_GT(each.forces.rms_N(each.forces.recorded), 0.1);
    EXPECT_EQ(each.forces.difference.total_N2_s, 0.0);
    EXPECT_EQ(each.forces.largest_N, 0.0);
    EXPECT_EQ(each.compared_model, "sinusoid");
    EXPECT_EQ(each.ticks_not_finite, 0U);
  }
  EXPECT_EQ(found.pooled.difference.total_N2_s, 0.0);
  EXPECT_GT(in_bands_N2_s(found.pooled.recorded), 0.0);
}

// F = k·max(0, h − d) with h = A·(1 + sin φ): the difference of two amplitudes on the recorded motion, in every tick.
TEST_F(ComparedReplays, OfTwiceTheAmplitudeDifferAsTheFormulaOfTheModel) {
  OtherModel twice(sinusoid_of(2.0 * kAmplitude_m));
  const ReplayComparison found = compared(&twice);
  ASSERT_EQ(found.presentations.size(), 3U);
  const Plan plan = verified_plan();
  const std::vector<AttemptRow> rows = attempts();
  double pooled_N2_s = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RecordedAttempt recorded = recorded_attempt(
        study_->folder(), stored_session(),
        plan.trials.at(static_cast<std::size_t>(rows[i].trial - 1)), rows[i], *builder_);
    const RendererInputs& inputs = recorded.surfaces.at(0).stimulus.inputs;
    const double wavelength_m = std::get<double>(inputs.parameters.at("wavelength_m"));
    double energy_N2_s = 0.0;
    double largest_N = 0.0;
    for (const TickRecord& record : recorded.records) {
      if (!record.has(TickFlag::presenting)) continue;
      const glm::dvec3 place_m = record.probe.position_m - inputs.patch.centre_m;
      const double phase_rad =
          2.0 * std::numbers::pi *
          (place_m.x * inputs.patch.motion_scale + inputs.patch.texture_origin_m.x) / wavelength_m;
      const auto force_N = [&](double amplitude_m) {
        return kStiffness_N_per_m *
               std::max(0.0, amplitude_m * (1.0 + std::sin(phase_rad)) - place_m.z);
      };
      const double difference_N = force_N(2.0 * kAmplitude_m) - force_N(kAmplitude_m);
      energy_N2_s += difference_N * difference_N / recorded.rate_Hz;
      largest_N = std::max(largest_N, difference_N);
    }
    SCOPED_TRACE(wavelength_m);
    const ForceDifference& forces = found.presentations[i].forces;
    EXPECT_NEAR(forces.difference.total_N2_s / energy_N2_s, 1.0, 1e-4);
    EXPECT_NEAR(forces.largest_N / largest_N, 1.0, 1e-4);
    EXPECT_GT(largest_N, kStiffness_N_per_m * kAmplitude_m);
    pooled_N2_s += forces.difference.total_N2_s;
  }
  EXPECT_DOUBLE_EQ(found.pooled.difference.total_N2_s, pooled_N2_s);
}

TEST_F(ComparedReplays, AreTheSameForAnyNumberOfJobs) {
  OtherModel one(sinusoid_of(2.0 * kAmplitude_m));
  OtherModel three(sinusoid_of(2.0 * kAmplitude_m));
  EXPECT_EQ(tsv_of(table_of(compared(&one, 1))), tsv_of(table_of(compared(&three, 3))));
}

TEST_F(ComparedReplays, CountWhatTheModelDoesNotFeel) {
  OtherModel of_bodies({.model = models_.find("pd_gradient")});
  const ReplayComparison found = compared(&of_bodies);
  EXPECT_TRUE(found.presentations.empty());
  EXPECT_EQ(found.of_other_kind, 3U);
}

TEST_F(ComparedReplays, CountAttemptsWithoutARecording) {
  start("p2", 8);
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person_, {.record = false});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  const ReplayComparison found = compared();
  EXPECT_EQ(found.presentations.size(), 3U);
  EXPECT_EQ(found.attempts_without_recording, 3U);
}

TEST_F(ComparedReplays, NameTheFirstAttemptThatCannotBeRead) {
  const std::vector<AttemptRow> rows = attempts();
  for (const std::size_t i : {1U, 2U}) {
    std::ofstream(study_->folder() / rows[i].recording->path, std::ios::trunc) << "no recording";
  }
  EXPECT_THAT([&] { compared(nullptr, 2); },
              ThrowsMessage<std::runtime_error>(HasSubstr("attempt p1/1/2/1")));
}

TEST_F(ComparedReplays, StopWithoutAResult) {
  std::stop_source stop{};
  stop.request_stop();
  const ReplayComparisonOrder order{.builds = models_};
  EXPECT_FALSE(compare_replays(*study_, order, stop.get_token(), {}).has_value());
}

TEST_F(ComparedReplays, LeaveOutParticipantsWhoWithdrew) {
  study_->withdraw("p1", {.decided_by = "R. Keeper"});
  EXPECT_TRUE(compared().presentations.empty());
}

}  // namespace
}  // namespace asperity
