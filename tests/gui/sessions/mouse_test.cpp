// Somebody without a device feels their way through a session by the mouse, and one whose device wants
// something is told so.

#include <QtWidgets/QComboBox>
#include <gtest/gtest.h>

#include "app/gui/start/start_page.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

class ByMouse : public SessionRoom {
 protected:
  void pick_device(const char* device) {
    auto& devices = child<QComboBox>(*window->page("start"), "device");
    devices.setCurrentIndex(devices.findData(QString(device)));
    require(devices.currentData().toString() == device, "there is no such device");
  }
  /// As `start`, on this device.
  void start_on(const char* device) {
    window->show_page("protocols");
    click_row(*window, "protocols_table", "small");
    click(*window, "protocol_start");
    wait_for("the start page", [&] { return window->shown_page() == "start"; });
    click(*window, "mode_pilot");
    pick_device(device);
    agree();
    press_start();
  }
  /// Holds the button on the surface and strokes while it can be felt; lifts when it cannot.
  void stroke() {
    const SessionSnapshot now = monitor().snapshot();
    if (is_in(SessionPhase::contact) && now.contact_s > 0.6 && now.surface != enough_of_) {
      enough_of_ = now.surface;
      key(Qt::Key_Space);
    }
    const bool can_be_felt =
        is_in(SessionPhase::fore) || (is_in(SessionPhase::contact) && now.surface != enough_of_);
    const QPoint middle = view().rect().center();
    if (can_be_felt && !is_down_) {
      QTest::mouseMove(&view(), middle);
      QTest::mousePress(&view(), Qt::LeftButton, {}, middle);
      is_down_ = true;
    } else if (can_be_felt) {
      ++steps_;
      QTest::mouseMove(&view(), middle + QPoint(30 - steps_ % 60, 0));
    } else if (is_down_) {
      QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle);
      is_down_ = false;
    }
  }

 private:
  int enough_of_ = 0;
  bool is_down_ = false;
  int steps_ = 0;
};

TEST_F(ByMouse, FeelsAndAnswersAWholeSession) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start_on("mouse");
  take_part(chooses_a(), [&] {
    stroke();
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

TEST_F(ByMouse, FeelsNothingWhileTheMouseIsNotPressed) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start_on("mouse");
  wait_for("the first surface", [&] { return is_in(SessionPhase::fore, 1); });
  QTest::mouseMove(&view(), view().rect().center());
  QTest::mouseMove(&view(), view().rect().center() + QPoint(20, 0));
  wait_for("a second of it", [&] {
    const SessionSnapshot now = monitor().snapshot();
    return 1e-9 * static_cast<double>(now.now_ns - now.phase_began_ns) > 1.0;
  });
  EXPECT_TRUE(is_in(SessionPhase::fore, 1)) << "above it, and no virtual hand comes down";
  stroke();
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
}

}  // namespace
}  // namespace asperity
