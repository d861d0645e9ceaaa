// Drift checks in breaks: the numbers, what is stored, and what the experimenter is shown.

#include "app/session/drift_check.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/session/session_monitor.h"
#include "tests/app/scripted_session.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t kReadingTick_ns = 1'000'000;

std::vector<TickRecord> readings_m(const std::vector<glm::dvec3>& positions_m) {
  std::vector<TickRecord> records{};
  for (const glm::dvec3& position_m : positions_m) {
    TickRecord& record = records.emplace_back();
    record.probe.time_ns =
        5'000'000'000 + static_cast<std::int64_t>(records.size()) * kReadingTick_ns;
    record.probe.position_m = position_m;
  }
  return records;
}

// A line from x = 0 to 4 µm and y = 3 to 0 µm: 5 µm in 4 ms, mean (2, 1.5, 7) µm.
TEST(RestReading, HasTheDriftOfAReadingThatMovesEvenly) {
  std::vector<glm::dvec3> line_m{};
  for (int i = 0; i <= 4; ++i) line_m.push_back(1e-6 * glm::dvec3{1.0 * i, 3.0 - 0.75 * i, 7.0});
  const RestReading reading = rest_reading(readings_m(line_m));
  EXPECT_EQ(reading.ticks, 5U);
  EXPECT_NEAR(reading.duration_s, 0.004, 1e-12);
  EXPECT_NEAR(reading.drift_m, 5e-6, 1e-15);
  EXPECT_NEAR(reading.noise_m, 0.0, 1e-15);
  EXPECT_NEAR(reading.position_m.x, 2e-6, 1e-15);
  EXPECT_NEAR(reading.position_m.y, 1.5e-6, 1e-15);
  EXPECT_NEAR(reading.position_m.z, 7e-6, 1e-15);
}

// x = 1, −1, −1, 1 µm: no slope, Σr² = 4 µm², n − 2 = 2.
TEST(RestReading, HasTheNoiseAboutTheLine) {
  const RestReading reading =
      rest_reading(readings_m({{1e-6, 0, 0}, {-1e-6, 0, 0}, {-1e-6, 0, 0}, {1e-6, 0, 0}}));
  EXPECT_NEAR(reading.drift_m, 0.0, 1e-15);
  EXPECT_NEAR(reading.noise_m, std::sqrt(2.0) * 1e-6, 1e-15);
}

TEST(RestReading, HasNoNoiseOfASingleTick) {
  EXPECT_EQ(rest_reading({}).ticks, 0U);
  EXPECT_EQ(rest_reading(readings_m({{1e-3, 0, 0}})).noise_m, 0.0);
}

TEST(DriftCheck, IsLimitedByTenStepsOfThePosition) {
  DeviceCapability device{};
  EXPECT_EQ(rest_limit_m(device), std::nullopt) << "the step is not known";
  EXPECT_EQ(DriftCheck{}.is_passed(), std::nullopt);
  device.position_resolution_m = 1e-6;
  DriftCheck check{.limit_m = rest_limit_m(device)};
  EXPECT_DOUBLE_EQ(check.limit_m.value(), 1e-5);
  check.reading.noise_m = 9e-6;
  EXPECT_EQ(check.is_passed(), true);
  check.reading.drift_m = 11e-6;
  EXPECT_EQ(check.is_passed(), false);
  EXPECT_THAT(drift_text(kHandOff, check).english(),
              AllOf(StartsWith("Handle at rest: position (0.000, 0.000, 0.000) mm, noise 0.009 mm, "
                               "drift 0.011 mm"),
                    HasSubstr("exceeds the limit of this device, 0.010 mm: check that nothing "
                              "touches the handle")));
  EXPECT_THAT(drift_text(kTipHeld, check).english(),
              HasSubstr("exceeds the limit of this device, 0.010 mm: check that the tip is held "
                        "still"))
      << "a hand holds it";
}

class DriftCheckedSession : public SessionTest {
 protected:
  /// A break at the beginning and one between the two runs of the block.
  void begin_checked() {
    const std::string pause =
        R"({"minimum_s": 0, "text": "Rest.", "drift_check": {"text": "Let go.",
            "tip_text": "Hold the tip.", "duration_s": 0.5}})";
    begin(replaced(estimated_protocol(), R"("flow": [{"run": "main", "for_each": "tip"}])",
                   R"("flow": [{"break": )" + pause +
                       R"(}, {"run": "main", "for_each": "tip", "pause": )" + pause + "}]"));
    person_.at_question = [](int, const Trial&) { return gives(5.0); };
  }
  std::vector<EventRow> events_of(const std::string& kind) const {
    std::vector<EventRow> events = study_->events(session_.row.id);
    std::erase_if(events, [&kind](const EventRow& event) { return event.kind != kind; });
    return events;
  }
};

TEST_F(DriftCheckedSession, StoresTheReadingsOfEveryBreak) {
  begin_checked();
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::string> kinds{};
  for (const EventRow& event : study_->events(session_.row.id)) {
    if (event.kind == "break_began" || event.kind == "force_zeroed" ||
        event.kind == "drift_checked" || event.kind == "break_ended") {
      kinds.push_back(event.kind);
    }
  }
  EXPECT_THAT(kinds, ElementsAre("break_began", "force_zeroed", "drift_checked", "drift_checked",
                                 "break_ended", "break_began", "force_zeroed", "drift_checked",
                                 "drift_checked", "break_ended"));
  const std::vector<EventRow> checks = events_of("drift_checked");
  std::vector<std::string> parts{};
  for (const EventRow& check : checks) {
    parts.push_back(check.text);
    const auto data = nlohmann::json::parse(check.data_json);
    EXPECT_NEAR(data.at("ticks").get<double>(), 500.0, 2.0);
    EXPECT_NEAR(data.at("duration_s").get<double>(), 0.5, 2e-3);
    EXPECT_EQ(data.at("position_m").size(), 3U);
    // The compared position is that of the same part in the first break.
    EXPECT_EQ(data.contains("shift_m"), parts.size() > 2);
  }
  EXPECT_THAT(parts, ElementsAre("hand_off", "tip", "hand_off", "tip"));
  // At a terminal the participant reads the requests.
  std::vector<std::string> read{};
  for (const std::string& text : person_.texts) {
    if (text == "Let go." || text == "Hold the tip." || text == "Rest.") read.push_back(text);
  }
  EXPECT_THAT(
      read, ElementsAre("Let go.", "Hold the tip.", "Rest.", "Let go.", "Hold the tip.", "Rest."));
}

TEST_F(DriftCheckedSession, AsksTheExperimenterAndShowsTheResult) {
  begin_checked();
  SessionMonitor monitor{};
  SessionRequests requests{};
  links_.monitor = &monitor;
  links_.requests = &requests;
  links_.experimenter_is_there = true;
  person_.is_at_window = true;
  std::vector<std::string> shown{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor.snapshot();
    if (!now.trouble || now.trouble->remedy != SessionTrouble::Remedy::confirm) return;
    EXPECT_EQ(rig_->loop().status().presentation, 0U) << "nothing is rendered";
    shown.push_back(now.trouble->what.english());
    requests.confirm();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_EQ(shown.size(), 8U);
  EXPECT_EQ(shown[0], "Let go.");
  EXPECT_THAT(shown[1], StartsWith("Handle at rest: position ("));
  EXPECT_EQ(shown[2], "Hold the tip.");
  EXPECT_THAT(shown[3], StartsWith("Tip at its reference: position ("));
  EXPECT_THAT(shown[5], HasSubstr("Distance from the first check of the session: "));
  for (const std::string& text : person_.texts) EXPECT_NE(text, "Let go.");
}

}  // namespace
}  // namespace asperity
