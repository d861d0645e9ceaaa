// A person takes part on a computer with one screen: both windows share it.

#include <utility>

#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QPushButton>

#include "tests/gui/session/clipped.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

class OneScreen : public SessionRoom {
 protected:
  /// In a program of its own, whose only screen has this size: off screen there is but one size.
  static bool is_shown_on(QSize size) {
    if (QGuiApplication::primaryScreen()->size() == size) return true;
    if (!qEnvironmentVariableIsEmpty(kInside)) {
      ADD_FAILURE() << "the screen is not as large as it was asked to be";
      return false;
    }
    const QTemporaryDir folder{};
    QFile screens(folder.filePath("screens.json"));
    EXPECT_TRUE(screens.open(QIODevice::WriteOnly));
    screens.write(
        QString(R"({"screens": [{"name": "only", "x": 0, "y": 0, "width": %1, "height": %2}]})")
            .arg(size.width())
            .arg(size.height())
            .toUtf8());
    screens.close();
    QProcess program{};
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen:configfile=" + screens.fileName());
    environment.insert(kInside, "1");
    environment.remove("GTEST_OUTPUT");
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    program.start(QCoreApplication::applicationFilePath(),
                  {QString("--gtest_filter=%1.%2").arg(test.test_suite_name(), test.name())});
    EXPECT_TRUE(program.waitForFinished(300'000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAll().toStdString();
    return false;
  }

  /// With the experimenter's as wide as this.
  void expect_both_windows_side_by_side(int width) {
    make_study();
    add_protocol({.minimum_contact_s = 0.3});
    open();
    const QRect room = window->screen()->availableGeometry();
    window->setGeometry(room);
    const auto& start_button = child<QPushButton>(*window->page("start"), "start");
    start("small");
    const QRect of_start(start_button.mapToGlobal(QPoint(0, 0)), start_button.size());
    ParticipantWindow& theirs = *desk->participant_window();
    SessionWindow& ours = experimenter();
    wait_for("frames", [&] { return ours.frameGeometry() != ours.geometry(); });
    const QRect our_place(room.left(), room.top(), width, room.height());
    const QRect their_place = room.adjusted(width, 0, 0, 0);
    const auto expect_places = [&](const char* when) {
      EXPECT_EQ(ours.frameGeometry(), our_place) << when;
      EXPECT_EQ(theirs.frameGeometry(), their_place) << when;
    };
    wait_for("its place", [&] { return ours.frameGeometry() == our_place; });
    expect_places("at once");
    // A second press of the click that started the session stops nothing.
    const auto& stop = child<QPushButton>(ours, "emergency_stop");
    const QRect of_stop(stop.mapToGlobal(QPoint(0, 0)), stop.size());
    EXPECT_FALSE(of_stop.intersects(of_start));
    EXPECT_TRUE(our_place.contains(of_stop));

    wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
    EXPECT_TRUE(until([&] { return clipped_in(ours).isEmpty(); }))
        << clipped_in(ours).join("\n").toStdString();
    expect_places("while a surface is felt");

    theirs.showMinimized();
    theirs.move(0, 0);
    key(Qt::Key_F9);
    EXPECT_FALSE(theirs.isMinimized());
    expect_places("brought back");
    click(ours, "abort");
    QTest::qWait(0);
    expect_places("with a question");
  }

 private:
  static constexpr const char* kInside = "ASPERITY_TEST_ONE_SCREEN";
};

TEST_F(OneScreen, OfALaptopIsSharedByHalves) {
  if (is_shown_on({1366, 768})) expect_both_windows_side_by_side(683);
}

TEST_F(OneScreen, OfASmallLaptopLeavesTheExperimenterWhatTheSessionNeeds) {
  if (is_shown_on({1280, 720})) expect_both_windows_side_by_side(682);
}

}  // namespace
}  // namespace asperity
