// The claim of groups: equal in number, also under dropout and for processes that ask at once.

#include <map>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> kGroups{"haptic", "visual", "none"};

/// A study in which participants begin sessions of the protocol "selection".
class GroupAssignment : public testing::Test {
 protected:
  GroupAssignment() : study_(Study::create(folder_ / "s", "x")) {
    protocol_ = study_.add_protocol(some_protocol());
    for (int i = 0; i < 12; ++i) study_.add_participant(some_participant(label_of(i)));
  }

  static std::string label_of(int i) { return "P" + std::to_string(10 + i); }

  SessionRow begin(const std::string& label, SessionMode mode = SessionMode::run, int rows = 1,
                   const std::optional<std::string>& stated = {}) {
    SessionRow session = some_session(protocol_, label);
    session.mode = mode;
    session.group_level = stated;
    return study_.session(study_.add_session(session, {.rows = rows, .groups = kGroups},
                                             [](const SessionRow&) { return some_plan(1); }));
  }
  std::string group(const SessionRow& session) { return session.group_level.value_or("-"); }
  std::vector<int> counts(SessionMode mode = SessionMode::run) {
    return study_.group_counts("selection", kGroups, mode);
  }

  TemporaryFolder folder_{};
  Study study_;
  std::int64_t protocol_ = 0;
};

TEST_F(GroupAssignment, TakesTheGroupWithTheFewestParticipantsInTheDeclaredOrder) {
  std::vector<std::string> given{};
  for (int i = 0; i < 4; ++i) given.push_back(group(begin(label_of(i))));
  EXPECT_THAT(given, ElementsAre("haptic", "visual", "none", "haptic"));
  EXPECT_THAT(counts(), ElementsAre(2, 1, 1));
  EXPECT_THAT(counts(SessionMode::simulate), ElementsAre(0, 0, 0)) << "modes are apart";
  EXPECT_EQ(group(begin(label_of(5), SessionMode::simulate)), "haptic");
  EXPECT_THAT(study_.verify({}), IsEmpty());
}

TEST_F(GroupAssignment, IsFreedByWhoeverDroppedOutOrWithdrew) {
  const SessionRow first = begin(label_of(0));
  begin(label_of(1));
  begin(label_of(2));
  study_.end_session(first.id, SessionState::stopped, "2026-03-01T10:00:00Z");
  EXPECT_THAT(counts(), ElementsAre(0, 1, 1));
  EXPECT_EQ(group(begin(label_of(3))), "haptic");
  study_.withdraw(label_of(1), {.data = WithdrawnData::kept, .decided_by = "R. Keeper"});
  EXPECT_EQ(group(begin(label_of(4))), "visual");
  study_.withdraw(label_of(2), {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
  EXPECT_EQ(group(begin(label_of(5))), "none");
  EXPECT_THAT(counts(), ElementsAre(1, 1, 1));
}

TEST_F(GroupAssignment, StaysWithTheParticipantAndCountsThemOnce) {
  const SessionRow first = begin(label_of(0));
  study_.end_session(first.id, SessionState::completed, "2026-03-01T10:00:00Z");
  EXPECT_EQ(group(begin(label_of(0))), "haptic");
  EXPECT_EQ(group(begin(label_of(0))), "haptic");
  EXPECT_THAT(counts(), ElementsAre(1, 0, 0));
  EXPECT_EQ(study_.group_of_participant(label_of(0), "selection", SessionMode::run), "haptic");
  EXPECT_EQ(study_.group_of_participant(label_of(0), "selection", SessionMode::pilot),
            std::nullopt);
  EXPECT_EQ(study_.group_of_participant(label_of(1), "selection", SessionMode::run), std::nullopt);
}

TEST_F(GroupAssignment, StaysWithAParticipantWhoDroppedOut) {
  const SessionRow first = begin(label_of(0));
  study_.end_session(first.id, SessionState::stopped, "2026-03-01T10:00:00Z");
  EXPECT_EQ(group(begin(label_of(1))), "haptic");
  EXPECT_EQ(group(begin(label_of(0))), "haptic") << "and is not given another one";
}

TEST_F(GroupAssignment, ByTheExperimenterIsStoredAndCannotChange) {
  EXPECT_EQ(group(begin(label_of(0), SessionMode::run, 1, "none")), "none");
  EXPECT_THAT(counts(), ElementsAre(0, 0, 1));
  EXPECT_THAT([&] { begin(label_of(0), SessionMode::run, 1, "haptic"); },
              testing::ThrowsMessage<ResultsError>(
                  HasSubstr("the participant is in another group of this protocol")));
  EXPECT_EQ(group(begin(label_of(0), SessionMode::run, 1, "none")), "none");
}

TEST_F(GroupAssignment, IsRefusedToAParticipantWhoseGroupTheProtocolNoLongerHas) {
  begin(label_of(0), SessionMode::run, 1, "smell");
  EXPECT_THAT(
      [&] { begin(label_of(0)); },
      testing::ThrowsMessage<ResultsError>(HasSubstr("has participant P10 in the group smell")));
}

TEST_F(GroupAssignment, CounterbalancesWithinEachGroup) {
  std::map<std::string, std::multiset<int>> rows{};
  for (int i = 0; i < 12; ++i) {
    const SessionRow session = begin(label_of(i), SessionMode::run, 2);
    rows[group(session)].insert(session.counterbalance_row);
  }
  for (const std::string& each : kGroups) {
    EXPECT_THAT(rows[each], ElementsAre(0, 0, 1, 1)) << each;
    EXPECT_THAT(study_.counterbalance_counts("selection", 2, SessionMode::run, each),
                ElementsAre(2, 2));
  }
  EXPECT_THAT(study_.counterbalance_counts("selection", 2, SessionMode::run), ElementsAre(6, 6));
}

TEST_F(GroupAssignment, ThatAToolChangedIsFound) {
  begin(label_of(0));
  begin(label_of(0));
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((folder_ / "s" / "study.sqlite").c_str(), &database), SQLITE_OK);
  const char* const change = "UPDATE session SET group_level = 'visual' WHERE session = 2";
  EXPECT_EQ(sqlite3_exec(database, change, nullptr, nullptr, nullptr), SQLITE_CONSTRAINT);
  sqlite3_exec(database, "DROP TRIGGER session_only_changes_state", nullptr, nullptr, nullptr);
  EXPECT_EQ(sqlite3_exec(database, change, nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
  EXPECT_THAT(study_.verify({}, {}, {StudyPart::rows}),
              testing::Contains(HasSubstr("participant P10: the sessions of the protocol selection "
                                          "are in different groups: haptic,visual")));
}

// Four processes begin sessions of nine participants each: every group gets twelve, every row of it three.
TEST(GroupAssignmentAtOnce, GivesEveryGroupEquallyManyParticipants) {
  constexpr int kProcesses = 4;
  constexpr int kPeople = 9;
  const TemporaryFolder folder;
  const auto label = [](int process, int person) {
    return "V" + std::to_string(process) + std::to_string(person);
  };
  {
    Study study = Study::create(folder / "s", "x");
    study.add_protocol(some_protocol());
    for (int i = 0; i < kProcesses; ++i) {
      for (int j = 0; j < kPeople; ++j) study.add_participant(some_participant(label(i, j)));
    }
  }
  std::vector<pid_t> children;
  for (int i = 0; i < kProcesses; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const std::string message = refusal_of<ResultsError>([&] {
        Study study = Study::open(folder / "s", Access::read_write);
        for (int j = 0; j < kPeople; ++j) {
          SessionRow session = some_session(1, label(i, j));
          session.group_level.reset();
          study.add_session(session, {.rows = 4, .groups = kGroups}, [](const SessionRow& row) {
            return some_plan(static_cast<int>(row.group_level->size()));
          });
        }
      });
      ::_exit(message.empty() ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_THAT(study.group_counts("selection", kGroups, SessionMode::simulate),
              ElementsAre(12, 12, 12));
  for (const std::string& group : kGroups) {
    EXPECT_THAT(study.counterbalance_counts("selection", 4, SessionMode::simulate, group),
                ElementsAre(3, 3, 3, 3));
  }
  for (const SessionRow& row : study.sessions()) {
    EXPECT_EQ(study.plan(row.id).size(), row.group_level->size()) << "planned for its group";
  }
}

}  // namespace
}  // namespace asperity
