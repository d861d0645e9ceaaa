// Gaps between ticks in contact, counted for the surface that was touched: in a session, and found again in its recording.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/attempt_measures.h"
#include "app/tasks/verify/verify_study.h"
#include "renderers/force/adjacent_patches.h"
#include "results_schema/sqlite.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class GapsInContact : public SessionTest {
 protected:
  GapsInContact() { links_.monitor = &monitor_; }

  std::vector<std::string> problems_in_replay() {
    return verify_study(*study_, models_, true, {}, [](double) {}).problems;
  }

  SessionMonitor monitor_{};
};

// The loop stalls twice for 10 ms while the second surface of the first trial is felt.
TEST_F(GapsInContact, AreCountedForTheSurfaceThatWasTouchedAndNotForTheOther) {
  begin(small_protocol());
  rig_->at_pass = [this, stalls = 0]() mutable {
    if (stalls == 2 || rig_->loop().status().presentation != 2) return;
    if (monitor_.snapshot().contact_s < 0.1) return;
    ++stalls;
    rig_->move_clock_to(rig_->clock().now_ns() + 10'000'000);
  };
  ASSERT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_TRUE(rows[0].valid);
  EXPECT_EQ(rows[0].presentations.at(0).gaps_in_contact, 0);
  EXPECT_EQ(rows[0].presentations.at(1).gaps_in_contact, 2);
  EXPECT_EQ(rows[0].servo.value().gaps_in_contact, 2);
  for (const PresentationRow& surface : rows[1].presentations) {
    EXPECT_EQ(surface.gaps_in_contact, 0);
  }

  EXPECT_THAT(problems_in_replay(), ElementsAre());
  Database(study_->folder(), study_->folder() / "study.sqlite", Database::Mode::read_write)
      .execute(
          "DROP TRIGGER presentation_no_update; "
          "UPDATE presentation SET gaps_in_contact = 3 WHERE attempt_id = (SELECT min(id) FROM "
          "attempt) AND position = 2");
  EXPECT_THAT(problems_in_replay(),
              Contains(HasSubstr("surface 2 (" + rows[0].presentations[1].model +
                                 "): the stored number of gaps in contact is 3, that of the "
                                 "recording is 2")));
}

/// A record of the loop at a surface (0: free space) that is touched, after a gap or not.
TickRecord felt(std::uint64_t surface, bool is_after_gap = false) {
  TickRecord record{};
  record.presentation = surface;
  const auto set = [&record](TickFlag flag) { record.flags |= static_cast<std::uint32_t>(flag); };
  if (surface != 0) {
    record.penetration_m = 1e-4;
    set(TickFlag::presenting);
  }
  if (is_after_gap) set(TickFlag::gap_in_contact);
  return record;
}

// Its force was held in the gap; the records of a hand that has left it have another surface, or none.
TEST(GapsOfASurface, IncludeThoseInWhichTheHandLeftIt) {
  const std::vector<TickRecord> lifted{felt(1), felt(0, true), felt(0), felt(2)};
  EXPECT_EQ(gaps_in_contact_of(lifted, 1), 1);
  EXPECT_EQ(gaps_in_contact_of(lifted, 2), 0);
  const std::vector<TickRecord> slid_over{felt(1), felt(2, true), felt(2)};
  EXPECT_EQ(gaps_in_contact_of(slid_over, 1), 1);
  EXPECT_EQ(gaps_in_contact_of(slid_over, 2), 1);
}

TEST(GapsOfASurface, ExcludeThoseBetweenPatches) {
  const std::vector<TickRecord> between{felt(1), felt(kSideBySide), felt(kSideBySide, true),
                                        felt(2)};
  EXPECT_EQ(gaps_in_contact_of(between, 1), 0);
  EXPECT_EQ(gaps_in_contact_of(between, 2), 0);
  EXPECT_EQ(servo_quality_of(between, 1000.0, 0).gaps_in_contact, 1);
}

TEST(GapsOfASurface, ExcludeATickAboveTheSurface) {
  TickRecord above = felt(1, true);
  above.penetration_m = 0.0;
  EXPECT_EQ(gaps_in_contact_of(std::vector{felt(2), above}, 1), 0);
  EXPECT_EQ(gaps_in_contact_of(std::vector{felt(2), above}, 2), 1);
}

}  // namespace
}  // namespace asperity
