// A session whose servo loop stands still: the force is gone, the trial is repeated, the third time it ends.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/rig/recording_columns.h"
#include "app/session/session_monitor.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Standstill : public SessionTest {
 protected:
  Standstill() { links_.monitor = &monitor_; }

  /// The clock runs on by 4 s without a tick, in the middle of the contacts of these attempts.
  void stand_still_in(std::vector<int> attempts) {
    rig_->at_pass = [this, left = std::move(attempts)]() mutable {
      const SessionSnapshot now = monitor_.snapshot();
      if (left.empty() || static_cast<int>(done_.size()) + 1 != left.front()) return;
      if (now.phase != SessionPhase::contact || now.contact_s < 0.1) return;
      left.erase(left.begin());
      rig_->move_clock_to(rig_->clock().now_ns() + 4'000'000'000);
    };
  }

  std::vector<std::string> kinds_of_events() const {
    std::vector<std::string> kinds{};
    for (const EventRow& event : study_->events(session_.row.id)) {
      if (event.kind.starts_with("fault")) kinds.push_back(event.kind + ' ' + event.text);
    }
    return kinds;
  }

  SessionMonitor monitor_{};
};

TEST_F(Standstill, InvalidatesTheAttemptAndRepeatsTheTrialByItself) {
  begin(small_protocol());
  stand_still_in({1});
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  ASSERT_EQ(rows.size(), 4U);  // three trials
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::device_fault);
  EXPECT_FALSE(rows[0].valid);
  EXPECT_EQ(codes_of(rows[0].invalid_reason.value()), "standstill");
  EXPECT_EQ(rows[0].servo->fault, "standstill");
  EXPECT_EQ(rows[0].invalid_reason->text, "the servo loop stalled for more than 50 ms");
  EXPECT_EQ(rows[1].trial, rows[0].trial);
  EXPECT_EQ(rows[1].attempt, 2);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_THAT(kinds_of_events(), ElementsAre("fault standstill", "fault_cleared "));
  // Felt at full force, and nothing from the first tick after it on.
  const auto records = records_of(read_recording(study_->folder() / rows[0].recording->path));
  double before_N = 0.0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    if (records[i].probe.time_ns - records[i - 1].probe.time_ns > 50'000'000) {
      before_N = records[i - 1].sent.force_N.z;
    }
    if (before_N == 0.0) continue;
    EXPECT_EQ(records[i].sent.force_N, glm::dvec3(0.0)) << i;
    EXPECT_TRUE(records[i].has(TickFlag::fault_latched)) << i;
  }
  EXPECT_GT(before_N, 0.1);
}

TEST_F(Standstill, IsShownToTheExperimenterWhoHasNothingToDo) {
  begin(small_protocol());
  stand_still_in({2});
  links_.experimenter_is_there = true;
  bool waited = false;
  std::string shown{};
  person_.at_question = [&](int, const Trial&) -> Reply {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.trouble) shown = now.trouble->what.english();
    waited = waited || now.phase == SessionPhase::fault;
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_FALSE(waited);
  EXPECT_THAT(shown, HasSubstr("stalled for more than 50 ms"));
}

TEST_F(Standstill, EndsTheSessionTheThirdTimeAndItCanBeResumed) {
  begin(small_protocol());
  stand_still_in({1, 2, 4});
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(),
              HasSubstr("the servo loop stalled for more than 50 ms, 3 times"));
  ASSERT_EQ(attempts().size(), 4U);
  EXPECT_TRUE(attempts()[2].valid);
  EXPECT_THAT(kinds_of_events(),
              ElementsAre("fault standstill", "fault_cleared ", "fault standstill",
                          "fault_cleared ", "fault standstill"));
  reopen_session();
  EXPECT_EQ(run().state, SessionState::completed);
}

// The emergency stop that comes with it is not lifted with it.
TEST_F(Standstill, LeavesAnEmergencyStopThatComesMeanwhile) {
  begin(small_protocol());
  stand_still_in({1});
  const auto stands_still = rig_->at_pass;
  rig_->at_pass = [&, stands_still] {
    stands_still();
    if (rig_->loop().status().fault == Fault::none && done_.size() == 1) rig_->emergency_stop();
  };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(), HasSubstr("emergency stop"));
}

TEST_F(Standstill, WaitsForAPersonWhereTheDeviceDoesNotComeThroughIt) {
  begin(small_protocol());
  stand_still_in({1});
  const SessionEnd end = [&] {
    const auto stands_still = rig_->at_pass;
    rig_->at_pass = [&, stands_still] {
      stands_still();
      if (done_.size() == 1) rig_->loop().lose_device();
    };
    return run();
  }();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(), HasSubstr("the device does not respond"));
}

TEST_F(Standstill, WhileNothingIsFeltIsNone) {
  begin(small_protocol());
  person_.at_question = [&](int, const Trial&) -> Reply {
    rig_->move_clock_to(rig_->clock().now_ns() + 4'000'000'000);
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 3U);
  EXPECT_THAT(kinds_of_events(), ElementsAre());
}

}  // namespace
}  // namespace asperity
