// A mouse and a pen over the participant's view, as the device "mouse" is told of them.

#include "app/gui/participant/pointer_feed.h"

#include <algorithm>
#include <vector>

#include <QtCore/QTemporaryDir>
#include <QtGui/QPointingDevice>
#include <QtGui/QTabletEvent>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <gtest/gtest.h>

#include "app/gui/participant/live_workspace.h"
#include "app/gui/participant/participant_view.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

using Scene = ParticipantScene;

/// One trial with a surface of 20 × 20 mm that lies 30 mm to the right.
class APointerFeed : public testing::Test {
 protected:
  APointerFeed() {
    PlannedPresentation surface{};
    surface.position = 1;
    surface.stimulus.patch.centre_m = {0.03, 0.0, 0.0};
    surface.stimulus.patch.extent_m = {0.02, 0.02};
    surface.patch = surface.stimulus.patch;
    Trial trial{};
    trial.ordinal = 1;
    trial.presentations = {surface};
    plan_ = std::make_shared<const Plan>(Plan{.trials = {trial}, .steps = {}});
    begin(false);
    monitor.show({.kind = Scene::Kind::feel, .surfaces = {{.code = "A"}}});
    view.set_pointer_is_probe(true);
    view.resize(800, 600);
    view.show();
  }
  void begin(bool mirrored) {
    monitor.set_facts(
        {.protocol = std::make_shared<const Protocol>(), .plan = plan_, .mirrored = mirrored});
    monitor.update([](SessionSnapshot& now) {
      now.trial = 1;
      now.surface = 1;
    });
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button = Qt::NoButton,
             Qt::MouseButtons held = Qt::NoButton) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  }
  void pen(QEvent::Type type, QPointF at, double pressure) {
    QTabletEvent event(type, &pen_, at, view.mapToGlobal(at), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                       Qt::NoModifier, Qt::LeftButton, Qt::LeftButton);
    QApplication::sendEvent(&view, &event);
  }
  PointerSample sample() {
    PointerSample newest{.pressure = -1.0};
    EXPECT_TRUE(samples.take(newest)) << "nothing was told";
    return newest;
  }

  QTemporaryDir folder{};
  SessionMonitor monitor{};
  LatestValue<PointerSample> samples{};
  ParticipantView view{monitor, folder.path().toStdString(), ParticipantView::Role::participant};
  PointerFeed feed{view, monitor, samples};

  std::shared_ptr<const Plan> plan_{};
  QPointingDevice pen_{"pen",
                       1,
                       QInputDevice::DeviceType::Stylus,
                       QPointingDevice::PointerType::Pen,
                       QInputDevice::Capability::Pressure,
                       1,
                       1};
};

TEST_F(APointerFeed, HasTheSurfaceWhereItIsShown) {
  ASSERT_TRUE(eventually([&] { return view.surface_rect().has_value(); }));
  const QRectF shown = *view.surface_rect();
  EXPECT_NEAR(shown.width(), shown.height(), 1.0) << "of 20 × 20 mm";
  mouse(QEvent::MouseMove, shown.center());
  EXPECT_NEAR(sample().position_m.x, 0.03, 1e-12);
  mouse(QEvent::MouseMove, shown.topRight());
  const PointerSample corner = sample();
  EXPECT_NEAR(corner.position_m.x, 0.04, 1e-4);
  EXPECT_NEAR(corner.position_m.y, 0.01, 1e-4);
  mouse(QEvent::MouseButtonPress, shown.center(), Qt::LeftButton, Qt::LeftButton);
  EXPECT_TRUE(sample().is_held) << "nothing lies over it";
}

TEST_F(APointerFeed, HasTheSurfaceInTheMiddleOfATableWhereNothingIsSeen) {
  monitor.show({.kind = Scene::Kind::blank});
  ASSERT_TRUE(eventually([&] { return !view.surface_rect().has_value(); }));
  mouse(QEvent::MouseMove, {400.0, 300.0});
  PointerSample now = sample();
  EXPECT_NEAR(now.position_m.x, 0.03, 1e-12);
  EXPECT_NEAR(now.position_m.y, 0.0, 1e-12);
  EXPECT_FALSE(now.is_held);
  // 600 pixels are 1.2 times the 20 mm of the surface: 0.04 mm each. Up is away.
  mouse(QEvent::MouseMove, {650.0, 50.0});
  now = sample();
  EXPECT_NEAR(now.position_m.x, 0.04, 1e-12);
  EXPECT_NEAR(now.position_m.y, 0.01, 1e-12);
  begin(true);
  mouse(QEvent::MouseMove, {400.0, 300.0});
  EXPECT_NEAR(sample().position_m.x, -0.03, 1e-12) << "where a mirrored session has it";
}

TEST_F(APointerFeed, PressesWhileTheButtonIsHeldAndLiftsWhenItLeaves) {
  mouse(QEvent::MouseButtonPress, {400.0, 300.0}, Qt::LeftButton, Qt::LeftButton);
  EXPECT_TRUE(sample().is_held);
  mouse(QEvent::MouseMove, {410.0, 300.0}, Qt::NoButton, Qt::LeftButton);
  EXPECT_TRUE(sample().is_held);
  mouse(QEvent::MouseButtonRelease, {410.0, 300.0}, Qt::LeftButton);
  EXPECT_FALSE(sample().is_held);
  for (const QEvent::Type gone : {QEvent::Leave, QEvent::WindowDeactivate}) {
    mouse(QEvent::MouseButtonPress, {410.0, 300.0}, Qt::LeftButton, Qt::LeftButton);
    EXPECT_TRUE(sample().is_held);
    QEvent event(gone);
    QApplication::sendEvent(&view, &event);
    EXPECT_FALSE(sample().is_held);
    mouse(QEvent::MouseMove, {420.0, 300.0}, Qt::NoButton, Qt::LeftButton);
    EXPECT_FALSE(sample().is_held) << "it is pressed anew or not at all";
  }
}

TEST_F(APointerFeed, DoesNotPressWhereSomethingElseIsPressed) {
  monitor.show({.kind = Scene::Kind::text, .text = "Read this."});
  QPointF button{};
  ASSERT_TRUE(eventually([&] {
    for (const ParticipantItem& item : view.items()) {
      if (item.action) button = item.rect.center();
    }
    return !button.isNull();
  }));
  mouse(QEvent::MouseButtonPress, button, Qt::LeftButton, Qt::LeftButton);
  EXPECT_FALSE(sample().is_held);
}

TEST_F(APointerFeed, TakesAPensPressureAndNotWhatQtMakesOfItForAMouse) {
  pen(QEvent::TabletPress, {400.0, 300.0}, 0.25);
  PointerSample now = sample();
  EXPECT_DOUBLE_EQ(now.pressure, 0.25);
  EXPECT_FALSE(now.is_held) << "or it would press as hard as a mouse";
  EXPECT_NEAR(now.position_m.x, 0.03, 1e-12);
  QMouseEvent made_of_it(QEvent::MouseButtonPress, QPointF(400.0, 300.0), QPointF(400.0, 300.0),
                         Qt::LeftButton, Qt::LeftButton, Qt::NoModifier, &pen_);
  QApplication::sendEvent(&view, &made_of_it);
  EXPECT_FALSE(samples.take(now));
  pen(QEvent::TabletMove, {400.0, 300.0}, 0.75);
  EXPECT_DOUBLE_EQ(sample().pressure, 0.75);
  pen(QEvent::TabletRelease, {400.0, 300.0}, 0.75);
  EXPECT_DOUBLE_EQ(sample().pressure, 0.0);
}

TEST_F(APointerFeed, IsWhereItPointsInAWorkspaceThatIsSeen) {
  auto* workspace = new LiveWorkspace(monitor, folder.path().toStdString(), SurfaceLook::plain);
  view.set_workspace(workspace);
  monitor.show({.kind = Scene::Kind::feel, .surfaces = {{.code = "A"}}, .show_workspace = true});
  ASSERT_TRUE(eventually([&] { return workspace->isVisible(); }));
  const WorkspaceView& seen = workspace->view();
  ASSERT_TRUE(eventually([&] { return seen.is_drawn(); }));
  const QPointF corner = view.mapFromGlobal(seen.mapToGlobal(QPointF(0.0, 0.0)));
  // The camera stands in front: what lies further up in the picture is further away.
  std::vector<glm::dvec2> places{};
  for (const double up : {0.7, 0.5, 0.3}) {
    mouse(QEvent::MouseMove, corner + QPointF(0.5 * seen.width(), up * seen.height()));
    places.push_back(sample().position_m);
  }
  for (const glm::dvec2& place_m : places) EXPECT_NEAR(place_m.x, 0.03, 2e-4);
  EXPECT_LT(places[0].y, places[1].y);
  EXPECT_LT(places[1].y, places[2].y);
  const auto back = seen.place_at(QPointF(0.5 * seen.width(), 0.5 * seen.height()));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->y, places[1].y, 1e-3);
}

}  // namespace
}  // namespace asperity
