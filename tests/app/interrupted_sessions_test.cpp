// Which sessions are listed as interrupted.

#include "app/tasks/interrupted_sessions.h"

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

class InterruptedSessions : public testing::Test {
 protected:
  InterruptedSessions() {
    protocol_ = made_.add_protocol("one", "recognition");
    for (const char* label : {"P1", "P2"}) made_.add_person(label, "F");
    made_.add_virtual("virtual0001", "F");
    made_.add_session("P1", protocol_, {{.surfaces = {surface_of("wood", "height_map", "wood")}}});
  }

  /// A second session, which nobody has ended.
  std::int64_t begin(const std::string& participant, SessionMode mode = SessionMode::run) {
    SessionRow row = made_.study().sessions()[0];
    row.participant = participant;
    row.session = 0;
    row.mode = mode;
    row.state = SessionState::open;
    row.ended_utc.reset();
    return made_.study().add_session(
        row, {PlannedTrialRow{.trial = 1, .block = "only", .phase = "main"}});
  }
  std::vector<std::int64_t> found() {
    std::vector<std::int64_t> ids{};
    for (const InterruptedSession& session : interrupted_sessions(made_.study(), {})) {
      ids.push_back(session.row.id);
    }
    return ids;
  }

  MadeUpStudy made_{};
  std::int64_t protocol_ = 0;
};

using Ids = std::vector<std::int64_t>;

TEST_F(InterruptedSessions, AreThoseThatNoProcessHoldsAndThoseThatCrashed) {
  EXPECT_EQ(found(), Ids{});  // the one that is there is complete
  const std::int64_t id = begin("P1");
  EXPECT_EQ(found(), Ids{id});
  {
    const StudyLock runs(made_.folder(), Study::session_lock_name("P1"));
    EXPECT_EQ(found(), Ids{});
  }
  made_.study().mark_crashed_sessions();
  EXPECT_EQ(found(), Ids{id});
  made_.study().reopen_session(id);
  made_.study().end_session(id, SessionState::stopped, "2001-02-03T05:05:06Z");
  EXPECT_EQ(found(), Ids{}) << "a stop was intended";
}

TEST_F(InterruptedSessions, NameHumanParticipantsFirstAndTheLatestOfThem) {
  const std::int64_t earlier = begin("P1");
  const std::int64_t later = begin("P2");
  const std::int64_t simulated = begin("virtual0001", SessionMode::simulate);
  EXPECT_EQ(found(), (Ids{later, earlier, simulated}));
}

TEST_F(InterruptedSessions, LeaveOutWhatIsExcluded) {
  const std::int64_t id = begin("P1");
  made_.study().add_decision(id, {.verdict = Verdict::exclude,
                                  .reason = "the fire alarm",
                                  .decided_by = "MW",
                                  .decided_utc = "2001-02-03T05:05:06Z"});
  EXPECT_EQ(found(), Ids{});
}

TEST_F(InterruptedSessions, StateWhetherTheTextThatTheyBeganWithIsStillThere) {
  begin("P1");
  const InterruptedSession without = interrupted_sessions(made_.study(), {}).at(0);
  EXPECT_FALSE(without.protocol_file);
  EXPECT_EQ(without.protocol_name, "one");
  EXPECT_EQ(without.trials, 1);
  EXPECT_EQ(without.trials_done, 0);
  const std::filesystem::path file = made_.folder() / "protocols" / "same.json";
  write_file(file, made_.study().protocol(protocol_).source, Overwrite::refuse);
  EXPECT_EQ(interrupted_sessions(made_.study(), {}).at(0).protocol_file, file);
}

}  // namespace
}  // namespace asperity
