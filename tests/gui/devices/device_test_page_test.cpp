// Testing a device in the window: nothing moves unasked, a stop is a stop at any moment, and what is measured is
// what the terminal measures.

#include "app/gui/devices/device_test_page.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <semaphore>

#include <QtCore/QRegularExpression>
#include <QtCore/QSettings>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <qcustomplot.h>

#include "app/device_bench/device_choice.h"
#include "app/gui/base/study_table.h"
#include "app/gui/devices/device_test_steps.h"
#include "app/gui/devices/motion_picture.h"
#include "app/gui/devices/response_plot.h"
#include "app/gui/study/devices_page.h"
#include "app/gui/window/study_window.h"
#include "app/session/rig/clock.h"
#include "app/words/utc_time.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/scripted_device.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// What a test knows of the arm on the table, and how it holds the arm's thread.
struct ArmBench {
  std::atomic<int> openings{0};
  std::atomic<bool> is_open{false};
  std::atomic<double> force_N{0.0};  ///< that its motors were last sent
  std::atomic<bool> is_held{false};
  std::counting_semaphore<8> go_on{0};
  /// It is held once, at a reading after so many, while it is pushed.
  std::atomic<int> hold_after{0};
  std::atomic<bool> is_held_on_borders{false};  ///< once, while somebody moves it along them
  std::atomic<bool> has_lost_its_zero{false};
  std::atomic<bool> does_not_let_go{false};  ///< when it is opened; first it waits for the test
};

/// A handle of 80 g on a soft spring, in the place of hardware. Left in peace for long, it jumps to and moves along
/// the borders of its workspace.
std::unique_ptr<HapticDevice> open_arm(ArmBench& bench) {
  auto arm = std::make_unique<ScriptedDevice>(
      DeviceCapability{.name = "arm",
                       .model = "Test arm",
                       .serial = "7",
                       .workspace_minimum_m = glm::dvec3(-0.05, -0.04, -0.03),
                       .workspace_maximum_m = glm::dvec3(0.05, 0.04, 0.03),
                       .peak_force_N = 5.0,
                       .continuous_force_N = 5.0,
                       .maximum_speed_m_per_s = std::numeric_limits<double>::infinity()});
  bench.is_open = true;
  arm->at_close = [&bench] { bench.is_open = false; };
  arm->at_send = [&bench](const Wrench& limited) { bench.force_N = glm::length(limited.force_N); };
  // `quiet` counts the readings since it was last pushed.
  arm->at_read = [&bench, &device = *arm, quiet = 0](ProbeState& state) mutable {
    constexpr double kMass_kg = 0.08;
    constexpr double kStep_s = 0.001;
    const glm::dvec3 force_N = device.last_sent.force_N;
    state.velocity_m_per_s +=
        kStep_s / kMass_kg * (force_N - 200.0 * state.position_m - 4.0 * state.velocity_m_per_s);
    state.position_m += kStep_s * state.velocity_m_per_s;
    if (glm::length(force_N) > 0.0) quiet = 0;
    constexpr int kPeace = 3000;
    if (++quiet > kPeace) {
      const double turn = 1e-3 * (quiet - kPeace);
      state.position_m = {0.048 * std::cos(turn), 0.039 * std::sin(turn),
                          0.028 * std::sin(3.0 * turn)};
      state.velocity_m_per_s = glm::dvec3(0.0);
    }
    device.probe = state;
    if (quiet == 4 * kPeace && bench.is_held_on_borders) {
      bench.is_held = true;
      bench.go_on.acquire();
    }
    const int hold_after = bench.hold_after;
    if (hold_after > 0 && device.reads > hold_after && glm::length(force_N) > 0.3) {
      bench.hold_after = 0;
      bench.is_held = true;
      bench.go_on.acquire();
    }
  };
  return arm;
}

class DeviceTests : public testing::Test {
 protected:
  DeviceTests() {
    QSettings().clear();
    make_small_study(folder);
    std::filesystem::create_directories(folder / "protocols");
  }
  ~DeviceTests() override {
    bench.go_on.release();  // whatever waits
    apply_theme(*qApp, ThemeChoice::light);
  }

  DriverRegistry drivers_with_an_arm() {
    DriverRegistry registry = built_in_drivers();
    registry.add({.id = "arm",
                  .summary = "an arm on the table",
                  .find =
                      [](const DriverOptions&) {
                        return DriverSurvey{.attached = {{.model = "Test arm", .serial = "7"}}};
                      },
                  .open = [this](const std::string&,
                                 const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
                    if (bench.has_lost_its_zero &&
                        !(options.may_move && options.may_move("It moves to find its zero."))) {
                      throw std::runtime_error("was not confirmed that it moves");
                    }
                    ++bench.openings;
                    if (bench.does_not_let_go) {
                      bench.is_held = true;
                      bench.go_on.acquire();
                      throw std::runtime_error("It may still move: switch it off.");
                    }
                    return open_arm(bench);
                  }});
    return registry;
  }
  static TestedDevice arm() {
    return {.device = "arm:7",
            .handle = "Test arm 7",
            .name = "Test arm, serial number 7",
            .which = {"arm", "", "7"}};
  }
  static TestedDevice simulated() {
    return {.device = "simulated",
            .name = "Simulated device",
            .which = {"simulated", "", ""},
            .is_simulated = true};
  }
  /// On a clock of its own: as fast as the machine can.
  static MeasureOrder stepped() {
    MeasureOrder order{};
    order.test.mechanics = StagePacing::stepped;
    order.test.timing = StagePacing::stepped;
    return order;
  }

  void make_page(const MeasureOrder& order, const TestedDevice& device) {
    page.reset();
    study = std::make_unique<OpenStudy>(folder);
    study->set_drivers(drivers_with_an_arm());
    page = std::make_unique<DeviceTestPage>(*study, order, nullptr);
    page->resize(1100, 740);
    page->show_device(device);
    page->show();
    require([this] { return find<QComboBox>("device_test_limits").count() > 0; }, "look");
  }
  template <class Widget>
  Widget& find(const char* name) const {
    return child<Widget>(*page, name);
  }
  void click(const char* name) const {
    ASSERT_TRUE(find<QPushButton>(name).isVisible()) << name;
    ASSERT_TRUE(find<QPushButton>(name).isEnabled()) << name;
    QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton);
  }
  std::string shown(const char* label) const {
    QString text = find<QLabel>(label).text();
    text.remove(QRegularExpression("<[^>]*>")).replace("&nbsp;", "");
    return text.toStdString();
  }
  /// Whether it is in the list of those to come.
  bool has_step(const QString& name) const {
    for (const QLabel* label : page->findChild<DeviceTestSteps*>()->findChildren<QLabel*>()) {
      if (label->text().endsWith(name)) return label->isVisible();
    }
    throw std::runtime_error("no step " + name.toStdString());
  }
  std::string news() const { return page->findChild<Banner*>()->text().toStdString(); }
  void wait_until_it_ended() const {
    require([this] { return !page->is_measuring() && page->findChild<Banner*>()->isVisible(); },
            "end");
  }
  bool has_profiles() const { return std::filesystem::exists(folder / "profiles"); }

  TemporaryFolder temporary{};
  std::filesystem::path folder = temporary.path() / "study";
  ArmBench bench{};
  std::unique_ptr<OpenStudy> study{};
  std::unique_ptr<DeviceTestPage> page{};
};

nlohmann::json without_date(const std::string& profile) {
  auto json = nlohmann::json::parse(profile);
  json.erase("measured_utc");
  return json;
}

TEST_F(DeviceTests, MeasureInTheWindowWhatTheTerminalDoesAndKeepIt) {
  make_page(stepped(), simulated());
  EXPECT_FALSE(find<QPushButton>("device_test_not_now").isVisible()) << "nothing moves";
  click("device_test_begin");
  wait_until_it_ended();
  const std::vector<DeviceProfile> kept = profiles_in(folder, {.name = "simulated"}).profiles;
  ASSERT_EQ(kept.size(), 1U) << news();

  VirtualHand hand = hand_to_measure();
  DriverOptions options{};
  options.hand = &hand;
  const auto device = built_in_drivers().open("simulated", options);
  const DeviceProfile at_terminal = measure_device(*device, stepped(), {}).profile;
  EXPECT_EQ(without_date(json_text_of(kept.front())), without_date(json_text_of(at_terminal)));

  EXPECT_NE(news().find("stored as profiles/simulated-"), std::string::npos) << news();
  EXPECT_NE(
      news().find("Not measured, although a limit applies: Fraction of the workspace reached"),
      std::string::npos)
      << news();
  EXPECT_EQ(find<StudyTable>("device_test_profiles").shown_rows(), 0) << "until it is read again";
  require([this] { return find<StudyTable>("device_test_profiles").shown_rows() == 1; }, "row");
  for (const DeviceItem& item : at_terminal.items) {
    EXPECT_NE(page->findChild<QLabel*>("item_" + QString::fromStdString(item.name)), nullptr)
        << item.name;
  }
  EXPECT_EQ(shown("result_limiter"), "✓ pass");
  EXPECT_EQ(shown("result_workspace_reached"), "▲ not measured");
  EXPECT_EQ(shown("result_moving_mass_kg"), "· no limit");
  EXPECT_EQ(shown("limit_workspace_reached"), "≥ 80 %");
  const double mass_g =
      QString::fromStdString(shown("value_moving_mass_kg")).split(' ')[0].toDouble();
  EXPECT_NEAR(mass_g, 1e3 * at_terminal.value("moving_mass_kg").value(), 0.1);
  EXPECT_EQ(find<ResponsePlot>("response_plot").points(), 3 * 24);
  EXPECT_FALSE(find<QPushButton>("device_test_stop").isVisible());
}

TEST_F(DeviceTests, SayWhatWillMoveAndOpenNothingWhenTheAnswerIsNo) {
  make_page(stepped(), arm());
  const std::string told = shown("device_test_what");
  EXPECT_NE(told.find("Test arm 7 will move by itself"), std::string::npos) << told;
  EXPECT_NE(told.find("with a force of at most 3.0 N"), std::string::npos) << told;
  QSignalSpy back(page.get(), &DeviceTestPage::back_wanted);
  click("device_test_not_now");
  EXPECT_EQ(back.size(), 1);
  EXPECT_EQ(bench.openings, 0);
  EXPECT_FALSE(has_profiles());
}

TEST_F(DeviceTests, PromiseNoMotionOfADeviceWithoutMotors) {
  TestedDevice device = arm();
  device.has_motors = false;
  make_page(stepped(), device);
  EXPECT_NE(shown("device_test_what").find("has no motors"), std::string::npos);
  EXPECT_EQ(shown("device_test_what").find("will move"), std::string::npos);
  EXPECT_EQ(find<QPushButton>("device_test_begin").text(), "Begin the test");
  bench.hold_after = 5000;
  click("device_test_begin");
  EXPECT_TRUE(has_step("Zero force and timing"));
  EXPECT_TRUE(has_step("Workspace"));
  EXPECT_FALSE(has_step("Safety"));
  EXPECT_FALSE(has_step("Weakest force"));
}

TEST_F(DeviceTests, SayWhatIsKnownOfADeviceThatIsStoodForAndLeaveTheRestOut) {
  make_page(stepped(), simulated());
  click("device_test_begin");
  EXPECT_TRUE(has_step("Frequency sweep"));
  wait_until_it_ended();
  make_page(stepped(), {.device = "simulated:delta.3",
                        .name = "Simulated: delta.3",
                        .which = which_device("simulated:delta.3"),
                        .is_simulated = true});
  click("device_test_begin");
  for (const char* name : {"Safety", "Slow sweeps", "Force steps"}) {
    EXPECT_TRUE(has_step(name)) << name;
  }
  for (const char* name : {"Frequency sweep", "Stiff springs", "Weakest force"}) {
    EXPECT_FALSE(has_step(name)) << name;
  }
  wait_until_it_ended();
  EXPECT_EQ(shown("profile_summary").substr(0, 3), "▲") << "a limit is open";
  EXPECT_TRUE(find<QLabel>("profile_known").isVisible());
  const std::string known = shown("profile_known");
  EXPECT_TRUE(known.starts_with("Simulated model of delta.3; known: workspace, peak force,"))
      << known;
  EXPECT_NE(known.find("unknown: continuous force, position resolution"), std::string::npos);
  EXPECT_NE(news().find("The device met every limit that was measured. Not measured, although a "
                        "limit applies: Fraction of the workspace reached. Measure the device "
                        "again. The profile has been stored as"),
            std::string::npos)
      << news();
}

TEST_F(DeviceTests, AskOnceMoreBeforeADeviceMovesToFindItsZero) {
  bench.has_lost_its_zero = true;
  make_page(stepped(), arm());
  click("device_test_begin");
  require([this] { return find<QPushButton>("device_test_no").isVisible(); }, "question");
  EXPECT_NE(shown("device_test_question").find("moves to find its zero"), std::string::npos);
  EXPECT_EQ(bench.openings, 0);
  click("device_test_no");
  wait_until_it_ended();
  EXPECT_NE(news().find("was not confirmed"), std::string::npos) << news();
  EXPECT_EQ(bench.openings, 0);

  click("device_test_begin");
  require([this] { return find<QPushButton>("device_test_yes").isVisible(); }, "question");
  bench.hold_after = 5000;
  click("device_test_yes");
  require([this] { return bench.is_held.load(); }, "push");
  EXPECT_EQ(bench.openings, 1);
  QTest::keyClick(page.get(), Qt::Key_Escape);
  bench.go_on.release();
  wait_until_it_ended();
}

TEST_F(DeviceTests, MayBeLeftWhileTheyAsk) {
  bench.has_lost_its_zero = true;
  make_page(stepped(), arm());
  click("device_test_begin");
  require([this] { return find<QPushButton>("device_test_yes").isVisible(); }, "question");
  page.reset();  // waits for the thread, which waits for an answer
  EXPECT_EQ(bench.openings, 0);
}

// Whoever has stopped has to know that the arm did not.
TEST_F(DeviceTests, TellWhatADeviceRefusesAlsoAfterTheStop) {
  bench.does_not_let_go = true;
  make_page(stepped(), arm());
  click("device_test_begin");
  require([this] { return bench.is_held.load(); }, "opening");
  click("device_test_stop");
  bench.go_on.release();
  wait_until_it_ended();
  EXPECT_NE(news().find("It may still move: switch it off."), std::string::npos) << news();
}

TEST_F(DeviceTests, LeaveZeroForceAndNoProfileWhereTheyAreStopped) {
  make_page(stepped(), arm());
  bench.hold_after = 5000;
  click("device_test_begin");
  require([this] { return bench.is_held.load(); }, "push");
  require([this] { return shown("device_test_do_now").find("along x") != std::string::npos; },
          "words of the sweep");
  require([this] { return find<MotionPicture>("motion_picture").points() > 100; }, "picture");
  EXPECT_GT(bench.force_N.load(), 0.3) << "it is being pushed";
  EXPECT_TRUE(study->examiner().is_held()) << "the servo loop needs the processor";
  EXPECT_GT(find<QProgressBar>("device_test_progress").value(), 0);
  EXPECT_FALSE(page->property("keep").toString().isEmpty());
  EXPECT_FALSE(find<QPushButton>("device_test_back").isVisible());
  click("device_test_stop");
  EXPECT_FALSE(find<QPushButton>("device_test_stop").isEnabled());
  bench.go_on.release();
  wait_until_it_ended();
  EXPECT_FALSE(study->examiner().is_held());
  EXPECT_EQ(bench.force_N.load(), 0.0);
  EXPECT_FALSE(bench.is_open);
  EXPECT_FALSE(has_profiles());
  EXPECT_NE(news().find("nothing was stored"), std::string::npos) << news();
  EXPECT_TRUE(page->property("keep").toString().isEmpty());
  EXPECT_TRUE(find<QPushButton>("device_test_begin").isVisible());
  EXPECT_EQ(page->focusWidget(), &find<QPushButton>("device_test_back"))
      << "a second press of Space begins nothing";
}

TEST_F(DeviceTests, StopByTheirKeysWhereverTheFocusIs) {
  for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_F12, Qt::Key_Pause}) {
    make_page(stepped(), arm());
    bench.is_held = false;
    bench.hold_after = 5000;
    click("device_test_begin");
    require([this] { return bench.is_held.load(); }, "push");
    QDialog over{};
    over.show();
    QTest::keyClick(&over, key);
    EXPECT_FALSE(find<QPushButton>("device_test_stop").isEnabled());
    bench.go_on.release();
    wait_until_it_ended();
    EXPECT_EQ(bench.force_N.load(), 0.0);
  }
  EXPECT_FALSE(has_profiles());
}

TEST_F(DeviceTests, StopByCtrlSpaceWhichAgreesToNothing) {
  bench.has_lost_its_zero = true;
  make_page(stepped(), arm());
  click("device_test_begin");
  require([this] { return find<QPushButton>("device_test_yes").isVisible(); }, "question");
  auto& yes = find<QPushButton>("device_test_yes");
  yes.setFocus();
  QTest::keyClick(&yes, Qt::Key_Space, Qt::ControlModifier);
  wait_until_it_ended();
  EXPECT_EQ(bench.openings, 0);
  EXPECT_NE(news().find("nothing was stored"), std::string::npos) << news();
}

// A dialog would take the button that stops the arm out of reach.
TEST_F(DeviceTests, LetTheWindowOpenNoDialogOverThem) {
  StudyWindow window{};
  ASSERT_TRUE(window.open_study(folder));
  window.study()->set_drivers(drivers_with_an_arm());
  auto* shown_page = qobject_cast<DeviceTestPage*>(window.page("device_test"));
  shown_page->show_device(arm());
  window.show_page("device_test");
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, kPatience_ms));
  bench.hold_after = 1;
  shown_page->findChild<QPushButton*>("device_test_begin")->click();
  require([this] { return bench.is_held.load(); }, "push");
  for (const Qt::Key key : {Qt::Key_N, Qt::Key_O}) {
    QTest::keyClick(&window, key, Qt::ControlModifier);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr)
        << QKeySequence(key).toString().toStdString();
    delete QApplication::activeModalWidget();
    EXPECT_NE(window.banner().text().toStdString().find("is being measured"), std::string::npos);
    window.banner().hide();
  }
  EXPECT_TRUE(shown_page->is_measuring());
  bench.go_on.release();
  window.show_page("devices");  // which stops it
  require([&] { return !shown_page->is_measuring(); }, "end");
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  EXPECT_NE(QApplication::activeModalWidget(), nullptr);
}

TEST_F(DeviceTests, StopWhenTheirPageGoesOutOfSight) {
  make_page(stepped(), arm());
  bench.hold_after = 5000;
  click("device_test_begin");
  require([this] { return bench.is_held.load(); }, "push");
  page->hide();
  bench.go_on.release();
  require([this] { return !page->is_measuring(); }, "end");
  EXPECT_EQ(bench.force_N.load(), 0.0);
  EXPECT_FALSE(has_profiles());
}

// On the servo's own thread, in the time that really goes by.
TEST_F(DeviceTests, LeaveZeroForceWhereTheWindowIsClosed) {
  make_page({}, arm());
  click("device_test_begin");
  require([this] { return bench.force_N > 0.0; }, "push of the safety's checks");
  bool was_open_at_release = true;
  QObject::connect(&study->examiner(), &StimulusExaminer::held_changed,
                   [&] { was_open_at_release = bench.is_open; });
  page.reset();
  EXPECT_FALSE(study->examiner().is_held());
  EXPECT_FALSE(was_open_at_release) << "the servo loop needs the processor to its end";
  EXPECT_EQ(bench.force_N.load(), 0.0);
  EXPECT_FALSE(bench.is_open);
  EXPECT_FALSE(has_profiles());
}

TEST_F(DeviceTests, ShowTheBordersThatAPersonReaches) {
  make_page(stepped(), arm());
  bench.is_held_on_borders = true;
  click("device_test_begin");
  require([this] { return bench.is_held.load(); }, "person at the borders");
  require([this] { return find<QWidget>("border_plot_above").isVisible(); }, "view from above");
  EXPECT_NE(shown("device_test_do_now").find("take the handle"), std::string::npos);
  EXPECT_FALSE(find<QWidget>("motion_plot").isVisible());
  require([this] { return find<MotionPicture>("motion_picture").path_points() > 100; }, "path");
  bench.go_on.release();
  wait_until_it_ended();
  EXPECT_EQ(shown("result_workspace_reached"), "✓ pass");
  EXPECT_EQ(shown("value_workspace_reached"), "93.3 %") << "2 · 28 of 60 mm in height";
}

TEST(MotionPicture, WidensItsAxisToTheNextOfOneTwoAndFive) {
  MotionPicture picture{};
  const auto& axis = *child<QCustomPlot>(picture, "motion_plot").yAxis;
  std::int64_t time_ns = 0;
  for (const auto& [moved_mm, shown_mm] :
       {std::pair(0.0, 1.0), {1.5, 2.0}, {4.0, 5.0}, {8.0, 10.0}, {15.0, 20.0}}) {
    MotionBin bin{.stage = 1, .begins_ns = time_ns += MotionBins::kBin_ns};
    bin.position_maximum_m[1] = 1e-3 * moved_mm;
    picture.take({bin});
    EXPECT_NEAR(axis.range().upper, shown_mm, 1e-9) << moved_mm;
    EXPECT_NEAR(axis.range().lower, -shown_mm, 1e-9) << moved_mm;
  }
}

TEST_F(DeviceTests, GoOnWithTheirDeviceOnAPageThatIsMadeAnew) {
  make_page(stepped(), arm());
  page.reset();
  page = std::make_unique<DeviceTestPage>(*study, stepped(), nullptr);
  page->show();
  EXPECT_EQ(shown("device_test_name"), "Test arm, serial number 7");
  EXPECT_TRUE(find<QPushButton>("device_test_begin").isVisible());
}

TEST_F(DeviceTests, HoldADeviceToTheLimitsOfAChosenProtocol) {
  std::string text = small_protocol();
  text.insert(text.find("\"textures\""),
              R"("device": {"limits": {"moving_mass_kg": 0.01, "latency_s": 0.05}}, )");
  write_file(folder / "protocols" / "small.json", text, Overwrite::allow);
  make_page(stepped(), simulated());
  auto& limits = find<QComboBox>("device_test_limits");
  ASSERT_EQ(limits.count(), 2);
  limits.setCurrentIndex(1);
  click("device_test_begin");
  wait_until_it_ended();
  EXPECT_EQ(shown("result_moving_mass_kg"), "✕ fail");
  EXPECT_EQ(shown("limit_moving_mass_kg"), "≤ 10 g");
  EXPECT_EQ(shown("result_latency_s"), "✓ pass");
  EXPECT_NE(
      news().find("did not meet every limit: Moving mass. Repair it and measure it again, or "
                  "choose another device. Not measured, although a limit applies: Fraction of the "
                  "workspace reached. Measure the device again. The profile has been stored as"),
      std::string::npos)
      << news();
  EXPECT_FALSE(find<QLabel>("profile_known").isVisible()) << "it stands for no real device";
  EXPECT_EQ(latest_profile(folder, {.name = "simulated"})->item("moving_mass_kg")->limit, 0.01);
}

TEST_F(DeviceTests, ListEarlierProfilesOfTheDeviceWithTheirAgeAndShowTheOneThatIsChosen) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto keep = [&](int days, const std::string& serial, double friction_N) {
    const DeviceProfile profile{
        .name = "arm",
        .model = "Test arm",
        .serial = serial,
        .measured_utc = utc_text(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                     now - std::chrono::hours(days * 24))
                                     .count()),
        .rate_Hz = 1000.0,
        .items = {{.name = "friction_N",
                   .status = friction_N > 0.2 ? DeviceItem::Status::fail : DeviceItem::Status::pass,
                   .value = friction_N,
                   .limit = 0.2}}};
    std::filesystem::create_directories(folder / "profiles");
    write_file(profile_path(folder, profile), json_text_of(profile), Overwrite::refuse);
  };
  keep(40, "7", 0.3);
  keep(12, "7", 0.1);
  keep(3, "8", 0.5);  // another arm
  write_file(folder / "profiles" / "arm-9.json", "{\"format\":", Overwrite::refuse);
  make_page(stepped(), arm());
  auto& table = find<StudyTable>("device_test_profiles");
  ASSERT_EQ(table.shown_rows(), 2);
  EXPECT_EQ(table.text_at(0, 1).toStdString(), "12 days") << "the latest first";
  EXPECT_EQ(table.text_at(1, 1).toStdString(), "40 days");
  EXPECT_EQ(shown("value_friction_N"), "0.1 N") << "the latest is shown";
  table.selectRow(1);
  EXPECT_EQ(shown("value_friction_N"), "0.3 N");
  EXPECT_EQ(shown("result_friction_N"), "✕ fail");
  EXPECT_EQ(bench.openings, 0) << "looking opens nothing";
  EXPECT_NE(shown("device_test_profile_problems").find("arm-9.json"), std::string::npos)
      << "one that cannot be read is told, and hides no other";
}

/// A session of P001 that began and has not ended.
void begin_a_session(const std::filesystem::path& folder) {
  Study writing = Study::open(folder, Access::read_write);
  writing.add_participant({.label = "P001", .created_utc = "2026-03-02T08:00:00Z"});
  ProtocolRow protocol{};
  protocol.name = "small";
  protocol.version = "1.0.0";
  protocol.kind = "selection";
  protocol.design = "chapter";
  protocol.source = small_protocol();
  SessionRow session{};
  session.participant = "P001";
  session.protocol_id = writing.add_protocol(protocol);
  session.seed = "1";
  session.generator = "none";
  session.program_version = "0.2.0";
  session.program_commit = "none";
  session.program_build = "test";
  session.instruction_set = "sse2";
  session.os = "none";
  session.device = "simulated";
  session.device_json = "{}";
  session.pacing = "real_time";
  session.scheduling = "other";
  session.rate_Hz = 1000.0;
  session.started_utc = "2026-03-02T09:00:00Z";
  writing.add_session(session, {});
}

TEST_F(DeviceTests, OpenNothingWhileASessionOfTheStudyRuns) {
  begin_a_session(folder);
  auto running = std::make_unique<StudyLock>(folder, Study::session_lock_name("P001"));
  make_page(stepped(), arm());
  click("device_test_begin");
  wait_until_it_ended();
  EXPECT_NE(news().find("A session of P001 is running"), std::string::npos) << news();
  EXPECT_EQ(bench.openings, 0);
  running.reset();  // the session was interrupted
  click("device_test_begin");
  wait_until_it_ended();
  EXPECT_EQ(bench.openings, 1);
}

TEST_F(DeviceTests, AreReachedFromTheListOfDevices) {
  StudyWindow window{};
  ASSERT_TRUE(window.open_study(folder));
  window.show();
  window.show_page("devices");
  auto* button = window.page("devices")->findChild<QPushButton*>("device_test_simulated");
  ASSERT_NE(button, nullptr);
  button->click();
  EXPECT_EQ(window.shown_page(), "device_test");
  window.page("device_test")->findChild<QPushButton*>("device_test_back")->click();
  EXPECT_EQ(window.shown_page(), "devices");
}

TEST_F(DeviceTests, Pictures) {
  if (qEnvironmentVariable("ASPERITY_SCREENSHOTS").isEmpty()) GTEST_SKIP() << "nobody looks";
  std::string text = small_protocol();
  text.insert(text.find("\"textures\""),
              R"("device": {"limits": {"moving_mass_kg": 0.05, "latency_s": 0.005}}, )");
  write_file(folder / "protocols" / "small.json", text, Overwrite::allow);
  for (const auto theme_choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, theme_choice);
    const QString suffix = theme_choice == ThemeChoice::dark ? "-dark" : "";
    StudyWindow window{};
    ASSERT_TRUE(window.open_study(folder));
    window.study()->set_drivers(drivers_with_an_arm());
    auto* shown_page = dynamic_cast<DeviceTestPage*>(window.page("device_test"));
    ASSERT_NE(shown_page, nullptr);
    const auto pictures = [&](const QString& name) {
      take_screenshot(window, name + "_1280x800" + suffix, {1280, 800});
      take_screenshot(window, name + "_880x640" + suffix, {880, 640});
    };
    window.resize(1280, 800);
    const auto button = [&](const char* name) {
      QTest::mouseClick(shown_page->findChild<QPushButton*>(name), Qt::LeftButton);
    };
    window.show_page("devices");
    window.show();
    shown_page->show_device(arm());
    window.show_page("device_test");
    auto* limits = shown_page->findChild<QComboBox*>("device_test_limits");
    require([&] { return limits->count() == 2; }, "look");
    pictures("device-test-before");
    limits->setCurrentIndex(1);
    button("device_test_begin");
    const auto* do_now = shown_page->findChild<QLabel*>("device_test_do_now");
    require([&] { return do_now->text().contains("along x"); }, "sweep");
    QTest::qWait(5000);
    pictures("device-test-course");
    button("device_test_stop");
    require([&] { return !shown_page->is_measuring(); }, "end");
    window.resize(1280, 800);
    shown_page->show_device(simulated());
    require([&] { return limits->count() == 2; }, "look");
    limits->setCurrentIndex(1);
    button("device_test_begin");
    require([&] { return !shown_page->is_measuring(); }, "end");
    QTest::qWait(500);
    pictures("device-test-result");
    auto* area = shown_page->findChild<QScrollArea*>();
    const int at_result = area->verticalScrollBar()->value();
    area->verticalScrollBar()->setValue(0);
    pictures("device-test-again");
    area->verticalScrollBar()->setValue(at_result);
    area->verticalScrollBar()->setValue(area->verticalScrollBar()->value() + 500);
    pictures("device-test-items");
    make_page(stepped(), arm());
    bench.is_held = false;
    bench.is_held_on_borders = true;
    click("device_test_begin");
    require([this] { return bench.is_held.load(); }, "person at the borders");
    QTest::qWait(200);
    take_screenshot(*page, "device-test-borders" + suffix, {1070, 776});
    bench.go_on.release();
    wait_until_it_ended();
    std::filesystem::remove_all(folder / "profiles");
  }
}

}  // namespace
}  // namespace asperity
