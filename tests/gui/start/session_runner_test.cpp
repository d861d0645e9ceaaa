// A session on its own thread, into a real store.

#include "app/gui/session/session_runner.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/full_disk.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/patient_servo.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class RunningSession : public testing::Test {
 protected:
  void SetUp() override {
    make_small_study(study);
    write_protocol(small_protocol());
    order.inputs = {.protocol = study / "protocols" / "small.json",
                    .study = study,
                    .participant = "virtual0001",
                    .seed = 7,
                    .mode = SessionMode::simulate,
                    .is_virtual = true,
                    .pacing = RunPacing::stepped};
  }

  void write_protocol(const std::string& text) {
    std::filesystem::create_directories(study / "protocols");
    write_file(study / "protocols" / "small.json", text, Overwrite::allow);
  }

  /// So many trials, and nothing to read or to fill in.
  void write_short_protocol(int trials) {
    std::string text =
        small_protocol(R"(, "pause_before_trial_s": 0, "pause_between_surfaces_s": 0)");
    std::string levels = "1";
    for (int trial = 2; trial <= trials; ++trial) levels += ", " + std::to_string(trial);
    text.replace(text.find("[1, 2, 3]"), 9, "[" + levels + "]");
    const std::size_t flow = text.find("\"flow\"");
    text.replace(flow, std::string::npos, "\"flow\": [{\"run\": \"main\"}]}");
    write_protocol(text);
  }

  std::vector<AttemptRow> stored_attempts() {
    const Study stored = Study::open(study, Access::read_only);
    if (stored.sessions().empty()) return {};
    return stored.attempts(stored.sessions().front().id);
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder.path() / "study";
  SessionOrder order{};
};

/// What a runner says, collected.
struct Listener {
  explicit Listener(SessionRunner& runner)
      : done(&runner, &SessionRunner::attempt_done),
        ended(&runner, &SessionRunner::ended),
        failed(&runner, &SessionRunner::failed) {}
  bool wait() {
    return eventually([this] { return !ended.isEmpty() || !failed.isEmpty(); });
  }
  SessionEnd end() const { return ended.first().first().value<SessionEnd>(); }
  AfterFailure way_on() const { return failed.first().at(1).value<AfterFailure>(); }
  std::string failure() const { return failed.first().first().toString().toStdString(); }
  QSignalSpy done;
  QSignalSpy ended;
  QSignalSpy failed;
};

TEST_F(RunningSession, TakesAVirtualParticipantThroughAndSaysSoAtTheEnd) {
  SessionRunner runner;
  Listener listener(runner);
  EXPECT_FALSE(runner.is_running());
  runner.start(order);
  EXPECT_TRUE(runner.is_running());
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 0) << listener.failure();
  EXPECT_FALSE(runner.is_running());
  EXPECT_EQ(listener.end().state, SessionState::completed);
  EXPECT_EQ(listener.end().attempts, 3);
  EXPECT_GE(listener.done.size(), 1);
  EXPECT_LE(listener.done.size(), 3);
  EXPECT_EQ(stored_attempts().size(), 3U);
}

TEST_F(RunningSession, DoesNotBeginWhenItIsCancelledWhileItIsPrepared) {
  std::atomic<bool> is_cancelled = false;
  SessionRunner runner(nullptr, [&is_cancelled](const SessionOrder&) {
    while (!is_cancelled) std::this_thread::yield();
    return std::unique_ptr<Sound>();
  });
  Listener listener(runner);
  runner.start(order);
  runner.cancel();
  is_cancelled = true;
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 0) << listener.failure();
  EXPECT_EQ(listener.end().state, SessionState::stopped);
  EXPECT_EQ(runner.monitor().snapshot().phase, SessionPhase::ended);
  EXPECT_TRUE(Study::open(study, Access::read_only).sessions().empty());
}

TEST_F(RunningSession, GoesThroughItInRealTime) {
  write_short_protocol(1);
  order.inputs.pacing = RunPacing::real_time;
  order.inputs.servo = patient_servo();
  SessionRunner runner;
  Listener listener(runner);
  runner.start(order);
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 0) << listener.failure();
  EXPECT_EQ(listener.end().state, SessionState::completed);
  const Study stored = Study::open(study, Access::read_only);
  EXPECT_EQ(stored.sessions().front().pacing, "real_time");
}

TEST_F(RunningSession, RefusesAProtocolThatChangedSinceTheCheck) {
  order.protocol_sha256 = sha256_of(small_protocol());
  write_protocol(small_protocol() + "\n");
  SessionRunner runner;
  Listener listener(runner);
  runner.start(order);
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 1);
  EXPECT_NE(listener.failure().find("has changed since it was checked"), std::string::npos);
  EXPECT_NE(listener.failure().find("The session did not begin"), std::string::npos);
  EXPECT_EQ(listener.way_on(), AfterFailure::check_again);
  EXPECT_TRUE(Study::open(study, Access::read_only).sessions().empty());
  const SessionSnapshot seen = runner.monitor().snapshot();
  EXPECT_EQ(seen.phase, SessionPhase::ended);
  ASSERT_TRUE(seen.trouble);
  EXPECT_EQ(seen.trouble->what, listener.failure());
  EXPECT_EQ(seen.trouble->remedy, SessionTrouble::Remedy::try_again);
}

TEST_F(RunningSession, AsksToCheckAgainWhereAStimulusIsRefused) {
  std::filesystem::remove(study / "stimuli" / "grain.png");
  SessionRunner runner;
  Listener listener(runner);
  runner.start(order);
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 1);
  EXPECT_NE(listener.failure().find("grain.png"), std::string::npos) << listener.failure();
  EXPECT_EQ(listener.way_on(), AfterFailure::check_again);
}

TEST_F(RunningSession, IsRefusedWhileTheSameParticipantSitsElsewhere) {
  const StudyLock elsewhere(study, Study::session_lock_name("virtual0001"));
  SessionRunner runner;
  Listener listener(runner);
  runner.start(order);
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 1);
  EXPECT_NE(listener.failure().find("is in use by process "), std::string::npos)
      << listener.failure();
  EXPECT_EQ(listener.way_on(), AfterFailure::start_again);
  EXPECT_TRUE(Study::open(study, Access::read_only).sessions().empty());
}

TEST_F(RunningSession, SaysWhatIsSafeWhenTheDiskIsFullAndLosesNothing) {
  write_short_protocol(60);  // long enough to fill the disk after the first trial
  std::string said{};
  qsizetype announced = 0;
  {
    SessionRunner runner;
    Listener listener(runner);
    runner.start(order);
    ASSERT_TRUE(eventually([&] { return !listener.done.isEmpty(); }));
    const FullDisk full(4096);
    ASSERT_TRUE(listener.wait());
    ASSERT_EQ(listener.failed.size(), 1);
    said = listener.failure();
    announced = listener.done.size();
    EXPECT_EQ(listener.way_on(), AfterFailure::go_on);
    EXPECT_EQ(runner.monitor().snapshot().phase, SessionPhase::ended);
  }
  EXPECT_NE(said.find("Every completed trial is stored"), std::string::npos) << said;
  EXPECT_NE(said.find("resume this session on the Sessions page"), std::string::npos) << said;
  const std::vector<AttemptRow> attempts = stored_attempts();
  EXPECT_GE(static_cast<qsizetype>(attempts.size()), announced);
  EXPECT_LT(attempts.size(), 60U);
  Study stored = Study::open(study, Access::read_write);
  stored.mark_crashed_sessions();
  EXPECT_EQ(stored.verify({}), std::vector<std::string>{});

  // Once there is room again it goes on where it stopped.
  order.inputs.resume = true;
  SessionRunner again;
  Listener listener(again);
  again.start(order);
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 0) << listener.failure();
  EXPECT_EQ(listener.end().state, SessionState::completed);
}

TEST_F(RunningSession, StopsTheForceInAnEmergencyAndWaitsForTheExperimenter) {
  write_short_protocol(60);
  SessionRunner runner;
  Listener listener(runner);
  runner.start(order);
  ASSERT_TRUE(eventually([&] { return !listener.done.isEmpty(); }));
  runner.requests().emergency_stop();
  ASSERT_TRUE(eventually([&] { return runner.monitor().snapshot().phase == SessionPhase::fault; }));
  EXPECT_TRUE(runner.is_running());
  EXPECT_EQ(runner.monitor().snapshot().fault, Fault::emergency_stop);
  runner.requests().clear_fault();
  ASSERT_TRUE(listener.wait());
  ASSERT_EQ(listener.failed.size(), 0) << listener.failure();
  EXPECT_EQ(listener.end().state, SessionState::completed);
}

TEST_F(RunningSession, IsAbortedAndStoredWhenItsOwnerGoesAway) {
  write_short_protocol(200);
  {
    SessionRunner runner;
    Listener listener(runner);
    runner.start(order);
    ASSERT_TRUE(eventually([&] { return !listener.done.isEmpty(); }));
  }
  const Study stored = Study::open(study, Access::read_only);
  ASSERT_EQ(stored.sessions().size(), 1U);
  EXPECT_EQ(stored.sessions().front().state, SessionState::stopped);
  const std::size_t attempts = stored.attempts(stored.sessions().front().id).size();
  EXPECT_GE(attempts, 1U);
  EXPECT_LT(attempts, 200U);
}

TEST_F(RunningSession, LetsGoOfAPersonWhoIsInTheMiddleOfATrial) {
  order.inputs.participant = "P001";
  order.inputs.mode = SessionMode::pilot;
  order.inputs.is_virtual = false;
  order.inputs.pacing = RunPacing::real_time;
  order.inputs.servo = patient_servo();
  order.inputs.consent = "I take part.";
  order.inputs.new_person = ParticipantRow{.label = "P001"};
  order.consent_seen_by = "MW";
  {
    SessionRunner runner;
    runner.start(order);
    // The first screen waits for a confirmation that never comes.
    ASSERT_TRUE(eventually(
        [&] { return runner.monitor().snapshot().scene->kind == ParticipantScene::Kind::text; }));
  }
  const Study stored = Study::open(study, Access::read_only);
  ASSERT_EQ(stored.sessions().size(), 1U);
  const SessionRow row = stored.sessions().front();
  EXPECT_EQ(row.state, SessionState::stopped);
  EXPECT_TRUE(row.consent_utc);
  const std::vector<EventRow> events = stored.events(row.id);
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const EventRow& event) {
    return event.kind == "consent_seen" && event.text == "consent witnessed by MW";
  }));
}

}  // namespace
}  // namespace asperity
