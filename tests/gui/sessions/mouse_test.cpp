// Somebody without a device feels their way through a session by the mouse, and one whose device wants
// something is told so.

#include <gtest/gtest.h>

#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

class ByMouse : public SessionRoom {};

TEST_F(ByMouse, FeelsAndAnswersAWholeSession) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start_by_mouse("small");
  take_part(chooses_a(), [&] {
    stroke_by_mouse();
    return !desk->is_running();
  });
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_EQ(stored_session().device, "mouse pointer of a window");
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 1U);
  for (const AttemptRow& attempt : attempts) {
    EXPECT_EQ(attempt.outcome, AttemptOutcome::answered);
    for (const PresentationRow& surface : attempt.presentations) {
      EXPECT_GT(surface.contact_s, 0.3) << "it was felt by the mouse";
    }
    for (const ComplianceRow& row : attempt.compliance) {
      if (row.quantity != "normal_force_N") continue;
      EXPECT_GT(row.mean, 0.0) << "it is judged by the force that was computed";
    }
  }
  for (const EventRow& event : stored_events("input")) {
    EXPECT_NE(event.text, "click") << "a touch is no answer";
  }
}

// Study data, where the study needs the movement alone.
TEST_F(ByMouse, IsARunWhereTheProtocolNeedsNoForce) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start_by_mouse("small", "mode_run");
  take_part(chooses_a(), [&] {
    stroke_by_mouse();
    return !desk->is_running();
  });
  EXPECT_EQ(stored_session().mode, SessionMode::run);
  EXPECT_EQ(stored_session().state, SessionState::completed);
}

TEST_F(ByMouse, FeelsNothingWhileTheMouseIsNotPressed) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start_by_mouse("small");
  wait_for("the first surface", [&] { return is_in(SessionPhase::fore, 1); });
  QTest::mouseMove(&view(), view().rect().center());
  QTest::mouseMove(&view(), view().rect().center() + QPoint(20, 0));
  wait_for("a second of it", [&] {
    const SessionSnapshot now = monitor().snapshot();
    return 1e-9 * static_cast<double>(now.now_ns - now.phase_began_ns) > 1.0;
  });
  EXPECT_TRUE(is_in(SessionPhase::fore, 1)) << "above it, and no virtual hand comes down";
  stroke_by_mouse();
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
}

}  // namespace
}  // namespace asperity
