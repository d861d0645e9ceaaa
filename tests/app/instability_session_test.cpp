// The detectors of perceived instability in a session: stored, judged, and found again in the recording.

#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/attempt_instability.h"
#include "app/tasks/verify/verify_instability.h"
#include "app/words/coded_phrases.h"
#include "device/simulated_models.h"
#include "tests/app/scripted_session.h"
#include "tests/support/hanging_push.h"

namespace asperity {
namespace {

using testing::HasSubstr;

class InstabilityOfSession : public SessionTest {
 protected:
  /// Friction that the simulated model of this device cannot render (docs/models/limits.md), on a plate without texture.
  void begin_with_vibration(const std::optional<InstabilityRule>& rule) {
    begin(small_protocol());
    protocol_.instability = rule;
    protocol_.material.friction = 1.0;
    protocol_.explorations.at("short").normal_force_N.target = 2.0;
    protocol_.blocks.at("main").presented.pop_back();
    for (auto& [name, stimulus] : protocol_.stimuli) {
      stimulus.parameters["friction_law"] = {ParameterValue{std::string("rounded")}, ""};
      stimulus.parameters["height_scale"] = {ParameterValue{0.0}, ""};
    }
    session_.course.emplace(protocol_, Allocation{.seed = 7});
    RigSettings settings{};
    settings.device = as_model("falcon", {});
    rig_ = std::make_unique<WatchedRig>(settings, 0);
  }
};

TEST(InstabilityRow, IsMissingWhereANumberOfADetectorIsNotFinite) {
  const PerceivedInstability judged{.buzz = Buzz{.ratio = 0.5, .force_N = 0.1, .time_ns = 7},
                                    .aliveness = Aliveness{.resting_s = 1.0, .net_work_J = 1e-6},
                                    .ridge = Ridge{.crest_share = 0.3, .slow_s = 1.0}};
  ASSERT_TRUE(instability_row(judged));
  EXPECT_EQ(instability_row(judged)->buzz, 0.5);
  for (const double number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    PerceivedInstability wrong = judged;
    wrong.buzz->ratio = number;
    EXPECT_FALSE(instability_row(wrong));
    wrong = judged;
    wrong.aliveness->plate_N = number;
    EXPECT_FALSE(instability_row(wrong));
    wrong = judged;
    wrong.aliveness->net_work_J = number;
    EXPECT_FALSE(instability_row(wrong));
    wrong = judged;
    wrong.ridge->crest_share = number;
    EXPECT_FALSE(instability_row(wrong));
  }
}

/// A plate whose ticks do not return while a test wants them to hang.
JudgedSurface surface_that_hangs(int position, const std::shared_ptr<Hang>& hang) {
  JudgedSurface surface{.position = position};
  surface.model.declaration.id = "hanging_" + std::to_string(position);
  surface.model.make = [hang](const RendererInputs&) {
    return std::make_unique<HangingPush>(hang);
  };
  return surface;
}

std::vector<TickRecord> records_of_two_surfaces() {
  constexpr int kTicks = 300;
  std::vector<TickRecord> records{};
  for (int i = 0; i < 2 * kTicks; ++i) {
    TickRecord& record = records.emplace_back();
    record.presentation = i < kTicks ? 1 : 2;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.probe.time_ns = 1'000'000 * i;
  }
  return records;
}

// A participant who has answered a question must not wait for a model.
TEST(AttemptInstability, LeavesAReplayThatDoesNotReturnAndNamesItsModel) {
  const auto hang = std::make_shared<Hang>();
  const auto idle = std::make_shared<Hang>();
  const HangEnds ends(hang);
  hang->is_wanted = true;
  const std::vector<TickRecord> records = records_of_two_surfaces();
  const JudgedSurface first = surface_that_hangs(1, idle);
  const JudgedSurface second = surface_that_hangs(2, hang);
  for (const bool begins : {true, false}) {
    AttemptInstability instability(std::chrono::milliseconds(200));
    if (begins) instability.begin({first, second}, records, 1000.0);
    for (const JudgedSurface& surface : {second, first}) {
      const ReplayedMeasures values = instability.take(surface, records, 1000.0);
      EXPECT_FALSE(values.texture_force_N);
      EXPECT_FALSE(values.instability);
    }
    EXPECT_EQ(instability.hanging_model(), "hanging_2");
  }
}

TEST(AttemptInstability, WaitsForAReplayWhoseTicksReturnHoweverLongAllOfThemTake) {
  const auto idle = std::make_shared<Hang>();
  JudgedSurface surface = surface_that_hangs(1, idle);
  surface.model.make = [](const RendererInputs&) {
    class Slow final : public ForceRenderer {
      void reset(const ProbeState&) noexcept override {}
      RenderedTick tick(const ProbeState&, double) noexcept override {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return {};
      }
    };
    return std::make_unique<Slow>();
  };
  AttemptInstability instability(std::chrono::milliseconds(300));  // 0.6 s and more in all
  const std::vector<TickRecord> records = records_of_two_surfaces();
  EXPECT_TRUE(instability.take(surface, records, 1000.0).instability);
  EXPECT_EQ(instability.hanging_model(), std::nullopt);
}

TEST_F(InstabilityOfSession, IsStoredForEverySurfaceAndFoundAgainInTheRecording) {
  begin(small_protocol());
  run();
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  for (const AttemptRow& row : rows) {
    EXPECT_FALSE(row.flagged);
    const Trial& trial = session_.course->plan().trials.at(static_cast<std::size_t>(row.trial - 1));
    RecordedAttempt recorded =
        recorded_attempt(study_->folder(), session_.row, trial, row, *builder_);
    for (RecordedSurface& surface : recorded.surfaces) {
      ASSERT_TRUE(surface.row.instability);
      EXPECT_LT(surface.row.instability->buzz.value(), 0.4);
      EXPECT_EQ(surface.row.instability->no_buzz, std::nullopt);
      EXPECT_EQ(surface.row.instability->no_crest_share, "no_crests");
      EXPECT_EQ(differing_instability(recorded, surface, Agreement::exact), std::nullopt);
      *surface.row.instability->buzz += 0.1;
      EXPECT_THAT(differing_instability(recorded, surface, Agreement::close).value_or(""),
                  HasSubstr("the stored value of buzz is "));
      surface.row.instability.reset();
      EXPECT_EQ(differing_instability(recorded, surface, Agreement::exact), std::nullopt);
    }
  }
}

TEST_F(InstabilityOfSession, FlagsAnAttemptWithMoreVibrationThanAllowed) {
  begin_with_vibration(InstabilityRule{.buzz_max = 0.4});
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  for (const AttemptRow& row : rows) {
    EXPECT_TRUE(row.valid);
    EXPECT_TRUE(row.flagged);
    EXPECT_THAT(row.flag_reason.value().text, HasSubstr("surface 1 vibrated: buzz "));
    EXPECT_THAT(row.flag_reason->text, HasSubstr(", at most 0.4 allowed"));
    EXPECT_THAT(codes_of(*row.flag_reason), HasSubstr("buzz_too_strong"));
  }
}

TEST_F(InstabilityOfSession, RepeatsAnAttemptWithMoreVibrationThanAllowedTwiceAndThenFlagsIt) {
  begin_with_vibration(
      InstabilityRule{.buzz_max = 0.02, .on = InstabilityRule::OnExcess::repeat_now});
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 9U);  // of each of the three trials two that do not count
  for (const AttemptRow& row : rows) {
    EXPECT_GT(row.presentations.at(0).instability.value().buzz.value(), 0.02);
    EXPECT_EQ(row.valid, row.attempt == 3) << row.trial;
    EXPECT_EQ(row.flagged, row.attempt == 3) << row.trial;
    const auto& reason = row.valid ? row.flag_reason : row.invalid_reason;
    EXPECT_THAT(codes_of(reason.value()), HasSubstr("buzz_too_strong"));
  }
}

TEST_F(InstabilityOfSession, JudgesNothingWithoutALimit) {
  begin_with_vibration({});
  run();
  for (const AttemptRow& row : attempts()) {
    EXPECT_FALSE(row.flagged);
    EXPECT_GT(row.presentations.at(0).instability.value().buzz.value(), 0.4);
  }
}

TEST_F(InstabilityOfSession, IsAbsentInAnInterruptedAttempt) {
  begin(small_protocol());
  rig_->at_pass = [this] {
    if (rig_->loop().status().presentation == 2) rig_->emergency_stop();
  };
  run();
  const AttemptRow row = attempts().at(0);
  EXPECT_EQ(row.outcome, AttemptOutcome::emergency_stop);
  for (const PresentationRow& surface : row.presentations) EXPECT_FALSE(surface.instability);
}

}  // namespace
}  // namespace asperity
