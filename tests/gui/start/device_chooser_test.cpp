// Choosing and trying the device of a session, on the page before it: the driver of Force Dimension against a
// stand-in for its maker's library.

#include "app/gui/start/device_chooser.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <semaphore>
#include <vector>

#include <QtCore/QSettings>
#include <QtGui/QStandardItemModel>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/start/start_page.h"
#include "app/session/rig/clock.h"
#include "app/words/utc_time.h"
#include "device/force_dimension/force_dimension_device.h"
#include "device/vendor_library.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/punctual_trial.h"
#include "tests/app/small_study.h"
#include "tests/device/vendors/test_dhd.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr const char* kDevice = "force_dimension:42";
constexpr int kUnknownType = 9999;

class TheDeviceChooser : public testing::Test {
 protected:
  TheDeviceChooser() : library("the stand-in", {ASPERITY_TEST_DRD}) {
    TestDhdBench bench_of = nullptr;
    library.find("test_dhd_bench", bench_of);
    bench = bench_of();
    *bench = test_dhd::Bench{};
    bench->units.push_back({.serial = 42});
    QSettings().clear();
    make_small_study(folder);
    std::string text = small_protocol();
    text.replace(text.find("\"flow\""), std::string::npos, R"("flow": [{"run": "main"}]})");
    std::filesystem::create_directories(folder / "protocols");
    write_file(protocol, text, Overwrite::allow);
  }
  ~TheDeviceChooser() override { apply_theme(*qApp, ThemeChoice::light); }

  /// As in a lab: what the program has itself, and the maker's library. Its driver says what is to be done
  /// while it opens, and waits until the test lets it go on.
  DriverRegistry drivers_of_a_lab() {
    DriverRegistry registry{};
    const DriverRegistry built_in = built_in_drivers();
    for (const Driver& driver : built_in.drivers()) {
      if (driver.id == "simulated" || driver.id == "mouse") registry.add(driver);
    }
    Driver driver = force_dimension_driver();
    driver.find = [this, find = driver.find](DriverOptions options) {
      options.library = ASPERITY_TEST_DRD;
      ++surveys;
      return find(options);
    };
    driver.open = [this, open = driver.open](const std::string& which, DriverOptions options) {
      options.library = ASPERITY_TEST_DRD;
      ++openings;
      options.tell("Pull the grip out.");
      const auto until = std::chrono::steady_clock::now() + kPatience;
      bool may_open = false;
      while (!may_open && !options.stop.stop_requested() &&
             std::chrono::steady_clock::now() < until) {
        may_open = let_it_open.try_acquire_for(std::chrono::milliseconds(5));
      }
      if (options.stop.stop_requested()) throw OpeningStopped("it was let go of");
      EXPECT_TRUE(may_open);
      return open(which, options);
    };
    registry.add(driver);
    return registry;
  }

  void make_page() {
    page.reset();
    study = std::make_unique<OpenStudy>(folder);
    study->set_drivers(drivers_of_a_lab());
    study->set_device_trial(punctual_trial);
    page = std::make_unique<StartPage>(*study);
    page->resize(1146, 768);
    page->show();
    page->choose(protocol, {}, {});
    require([this] { return page->is_read() && !has_reason("being looked for"); }, "the page");
    require([this] { return find<QPushButton>("device_look").isEnabled(); }, "a survey");
  }

  template <class Widget>
  Widget& find(const char* name) const {
    return child<Widget>(*page, name);
  }
  void click(const char* name) const {
    ASSERT_TRUE(find<QPushButton>(name).isEnabled()) << name;
    QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton);
  }
  void pick(const char* device) const {
    auto& box = find<QComboBox>("device");
    const int row = box.findData(QString(device));
    ASSERT_GE(row, 0) << device;
    box.setCurrentIndex(row);
  }
  QString shown(const char* label) const { return find<QLabel>(label).text(); }
  bool is_seen(const char* name) const { return find<QWidget>(name).isVisibleTo(page.get()); }
  bool has_reason(const QString& part) const {
    const std::vector<QString> reasons = page->reasons();
    return std::any_of(reasons.begin(), reasons.end(),
                       [&part](const QString& reason) { return reason.contains(part); });
  }
  bool has_line(const char* check, const QString& part) const {
    const auto* line = page->findChild<QLabel*>(check);
    return line != nullptr && line->text().contains(part);
  }
  bool is_enabled(const char* device) const {
    const auto& box = find<QComboBox>("device");
    const int row = box.findData(QString(device));
    return row >= 0 && qobject_cast<QStandardItemModel*>(box.model())->item(row)->isEnabled();
  }
  /// Presses, and lets the driver open it.
  void press(const char* button) {
    click(button);
    let_it_open.release();
  }
  void try_it() {
    press("device_try");
    require([this] { return shown("device_state").contains("Tried"); }, "answer of the device");
  }

  TemporaryFolder temporary{};
  std::filesystem::path folder = temporary.path() / "study";
  std::filesystem::path protocol = folder / "protocols" / "small.json";
  test_dhd::Bench* bench = nullptr;
  std::atomic<int> surveys{0};
  std::atomic<int> openings{0};
  std::counting_semaphore<100> let_it_open{0};
  std::unique_ptr<OpenStudy> study{};
  std::unique_ptr<StartPage> page{};
  VendorLibrary library;
};

TEST_F(TheDeviceChooser, ListsWhatCanBeUsedAndSaysOfTheOthersWhyNot) {
  bench->units.push_back({.type = kUnknownType, .serial = 43});
  make_page();
  for (const char* device : {"simulated", "simulated:falcon", "mouse", kDevice}) {
    EXPECT_TRUE(is_enabled(device)) << device;
  }
  EXPECT_FALSE(is_enabled("force_dimension:43"));
  EXPECT_FALSE(is_seen("device_blockers"));
  click("device_why");
  EXPECT_TRUE(is_seen("device_blockers"));
  EXPECT_TRUE(shown("device_blockers").contains(QString::number(kUnknownType)))
      << shown("device_blockers").toStdString();
  EXPECT_EQ(page->order().inputs.device, "simulated") << "as long as nobody chooses another one";
  pick("mouse");
  EXPECT_TRUE(shown("device_text").contains("The participant feels no force"));
  EXPECT_FALSE(is_seen("device_try"));
  EXPECT_EQ(page->order().inputs.device, "mouse");
  bench->units.pop_back();
  click("device_look");
  require([this] { return find<QPushButton>("device_look").isEnabled(); }, "second survey");
  EXPECT_EQ(surveys, 2);
  EXPECT_FALSE(is_seen("device_why"));
  EXPECT_EQ(page->order().inputs.device, "mouse");
}

TEST_F(TheDeviceChooser, OpensAnAttachedDeviceOnlyWhenSomebodyWantsItAndTellsWhatItWants) {
  make_page();
  pick(kDevice);
  find<QCheckBox>("consent_given").click();
  find<QLineEdit>("consent_seen_by").setText("MW");
  require([this] { return has_reason("has not been tried yet"); }, "reason");
  EXPECT_EQ(openings, 0) << "the checklist leaves it alone";
  EXPECT_FALSE(find<QPushButton>("start").isEnabled());

  EXPECT_TRUE(shown("device_text").contains("it has to move by itself"))
      << shown("device_text").toStdString();

  click("device_try");
  EXPECT_FALSE(is_seen("device_question")) << "it knows its zero, and has nothing to ask";
  // The window goes on meanwhile.
  require([this] { return shown("device_state").contains("Pull the grip out."); }, "wish");
  EXPECT_TRUE(has_reason("being tried"));
  EXPECT_FALSE(find<QPushButton>("device_look").isEnabled()) << "a driver does one thing at a time";
  EXPECT_FALSE(find<QComboBox>("device").isEnabled());
  let_it_open.release();
  require([this] { return shown("device_state").contains("Tried"); }, "answer of the device");
  require([this] { return has_line("check_force_zero", "Exactly 0 N was sent in"); },
          "loop's line");
  EXPECT_TRUE(has_line("check_device", "exerts up to 12.0 N at up to"))
      << "as the driver tells of an omega.3";
  EXPECT_TRUE(has_line("check_calibration", "no profile of this device"));
  EXPECT_FALSE(bench->units.front().is_open) << "it is let go of for the session";
}

TEST_F(TheDeviceChooser, StopsTryingWhereSomebodyStopsOrLeaves) {
  make_page();
  pick(kDevice);
  require([this] { return has_reason("has not been tried yet"); }, "reason");
  click("device_try");
  require([this] { return shown("device_state").contains("Pull the grip out."); }, "wish");
  EXPECT_EQ(find<QPushButton>("device_try").text(), "Cancel");
  click("device_try");
  require([this] { return shown("device_state").contains("Not tried yet"); }, "end");
  EXPECT_EQ(find<QPushButton>("device_try").text(), "Try this device");
  require([this] { return has_reason("has not been tried yet"); }, "reason");

  click("device_try");
  require([this] { return shown("device_state").contains("Pull the grip out."); }, "wish");
  page.reset();  // waits for the driver, which waits for a person
  EXPECT_EQ(openings, 2);
  EXPECT_FALSE(bench->units.front().is_open);
}

TEST_F(TheDeviceChooser, LetsAnArmMoveByAYesToItsDriversOwnWordsAlone) {
  make_page();
  pick(kDevice);
  bench->units.front().knows_its_zero = false;
  const auto has_moved = [this] {
    return std::count(bench->calls.begin(), bench->calls.end(), "drdAutoInit 3") > 0;
  };
  const auto asks_of = [this](const QString& who) {
    require([this] { return is_seen("device_yes"); }, "question");
    const QString question = shown("device_question");
    EXPECT_TRUE(question.contains("The handle of " + who + " will move by itself") &&
                question.contains("keep hands and hair away"))
        << question.toStdString();
    EXPECT_FALSE(bench->units.front().is_open) << "nothing is held while somebody thinks";
  };
  press("device_try");
  asks_of("omega.3 42");
  EXPECT_FALSE(find<QPushButton>("start").isEnabled());
  click("device_no");
  EXPECT_FALSE(is_seen("device_question"));
  EXPECT_TRUE(shown("device_state").contains("Not tried yet"));

  press("device_try");
  asks_of("omega.3 42");
  bench->units.front().type = 34;  // another one stands there now
  press("device_yes");
  require([this] { return openings == 3 && shown("device_question").contains("omega.6"); },
          "question anew");
  asks_of("omega.6 42");
  EXPECT_FALSE(has_moved());

  press("device_yes");
  require([this] { return shown("device_state").contains("Tried"); }, "answer of the device");
  EXPECT_TRUE(has_moved());
}

// By a click on the button, by each key wherever the focus is, and by going to another page.
TEST_F(TheDeviceChooser, StopsAnArmThatMovesByItself) {
  make_page();
  pick(kDevice);
  bench->units.front().knows_its_zero = false;
  bench->units.front().searches_on = true;
  TestDhdLock lock_of = nullptr;
  library.find("test_dhd_lock", lock_of);
  const auto moves = [&] {
    const std::lock_guard held(*lock_of());
    return bench->units.front().regulation_is_on;
  };
  const auto key = [](Qt::Key which, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return [which, modifiers](QWidget& at) { QTest::keyClick(&at, which, modifiers); };
  };
  const std::vector<std::function<void(QWidget&)>> ways{[this](QWidget&) { click("device_try"); },
                                                        key(Qt::Key_Escape),
                                                        key(Qt::Key_F12),
                                                        key(Qt::Key_Pause),
                                                        key(Qt::Key_Space, Qt::ControlModifier),
                                                        [this](QWidget&) { page->hide(); }};
  for (std::size_t way = 0; way < ways.size(); ++way) {
    SCOPED_TRACE(way);
    page->show();
    bench->calls.clear();
    press("device_try");
    require([this] { return is_seen("device_yes"); }, "question");
    click("device_yes");
    EXPECT_TRUE(shown("device_state").contains("Keep hands away"))
        << shown("device_state").toStdString();
    let_it_open.release();
    require(moves, "movement");
    ways[way](find<QComboBox>("device"));
    require([this] { return find<QPushButton>("device_try").text() == "Try this device"; }, "end");
    EXPECT_TRUE(shown("device_state").contains("its handle sinks"))
        << shown("device_state").toStdString();
    const test_dhd::Unit& unit = bench->units.front();
    EXPECT_FALSE(unit.regulation_is_on || unit.force_is_on || unit.is_open || unit.knows_its_zero);
    const auto at_rest = std::find(bench->calls.begin(), bench->calls.end(), "at rest 3");
    ASSERT_NE(at_rest, bench->calls.end());
    EXPECT_EQ(std::find(bench->calls.begin(), at_rest, "drdClose 3"), at_rest)
        << "while it still moved";
  }
}

TEST_F(TheDeviceChooser, OrdersASessionOnTheDeviceAndTriesItAnewForTheNext) {
  make_page();
  pick(kDevice);
  find<QCheckBox>("consent_given").click();
  find<QLineEdit>("consent_seen_by").setText("MW");
  QSignalSpy wanted(page.get(), &StartPage::start_wanted);
  try_it();
  require([this] { return !has_reason("Running the checks"); }, "checklist");
  ASSERT_TRUE(find<QPushButton>("start").isEnabled()) << shown("start_reason").toStdString();
  click("start");
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(wanted.first().first().value<SessionOrder>().inputs.device, kDevice);
  page->hide();
  page->show();
  require([this] { return has_reason("has not been tried yet"); }, "reason");
}

TEST_F(TheDeviceChooser, SaysWhyADeviceCouldNotBeOpened) {
  make_page();
  pick(kDevice);
  bench->units.front().knows_its_zero = false;
  bench->units.front().finds_its_zero = false;
  press("device_try");
  require([this] { return is_seen("device_yes"); }, "question");
  press("device_yes");
  require([this] { return has_reason("the handle was held"); }, "reason");
  EXPECT_TRUE(shown("device_state").contains("the handle was held"))
      << shown("device_state").toStdString();
  EXPECT_TRUE(find<QPushButton>("device_try").isEnabled());
}

TEST_F(TheDeviceChooser, RemembersTheDeviceOfAStudyAndTakesNoOtherInItsPlace) {
  make_page();
  pick(kDevice);
  make_page();
  EXPECT_EQ(page->order().inputs.device, kDevice);
  bench->units.clear();
  make_page();
  EXPECT_EQ(page->order().inputs.device, kDevice);
  require([this] { return has_reason("The device is not connected"); }, "reason");
  EXPECT_FALSE(find<QPushButton>("start").isEnabled());
  EXPECT_FALSE(find<QPushButton>("device_try").isEnabled());
  bench->units.push_back({.serial = 42});
  click("device_look");
  require([this] { return has_reason("has not been tried yet"); }, "reason");

  page.reset();
  folder = temporary.path() / "other";
  protocol = folder / "protocols" / "small.json";
  make_small_study(folder);
  std::filesystem::create_directories(folder / "protocols");
  write_file(protocol, small_protocol(), Overwrite::allow);
  make_page();
  EXPECT_EQ(page->order().inputs.device, "simulated") << "another study has its own";
}

TEST_F(TheDeviceChooser, GivesAVirtualParticipantASimulatedDeviceAndPeopleTheirsBack) {
  make_page();
  pick(kDevice);
  page->set_mode(SessionMode::simulate);
  EXPECT_EQ(page->order().inputs.device, "simulated");
  EXPECT_EQ(find<QComboBox>("device").findData("mouse"), -1);
  EXPECT_EQ(find<QComboBox>("device").findData(kDevice), -1);
  EXPECT_FALSE(is_seen("device_try"));
  pick("simulated:falcon");
  EXPECT_EQ(page->order().inputs.device, "simulated:falcon");
  page->set_mode(SessionMode::pilot);
  EXPECT_EQ(page->order().inputs.device, kDevice);
}

TEST_F(TheDeviceChooser, ShowsTheProfilesAgeAndWhatIsBeyondTheDevice) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const DeviceProfile profile{
      .name = "force_dimension",
      .serial = "42",
      .measured_utc = utc_text(
          std::chrono::duration_cast<std::chrono::nanoseconds>(now - std::chrono::hours(12 * 24))
              .count()),
      .rate_Hz = 1000.0,
      .workspace_minimum_m = glm::dvec3(-1.0),
      .workspace_maximum_m = glm::dvec3(1.0),
      .items = {{.name = "friction_N", .status = DeviceItem::Status::pass, .value = 0.9}}};
  std::filesystem::create_directories(folder / "profiles");
  write_file(profile_path(folder, profile), json_text_of(profile), Overwrite::allow);
  bench->units.push_back({.type = kUnknownType, .serial = 43});
  for (const auto theme_choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, theme_choice);
    const QString suffix = theme_choice == ThemeChoice::dark ? "-dark" : "";
    make_page();
    pick(kDevice);
    try_it();
    require([this] { return has_line("check_rehearsal", "0.900 N"); }, "warning");
    EXPECT_TRUE(has_line("check_calibration", "Measured 12 days ago"));
    require([this] { return has_line("check_force_zero", "0 N"); }, "loop's line");
    const auto show_device = [this] {
      page->resize(1366, 768);
      QTest::qWait(50);  // until everything has its place
      page->findChild<QScrollArea*>("start_form")
          ->ensureWidgetVisible(&find<QWidget>("own_keyboard"));
    };
    show_device();
    take_screenshot(*page, "start-page-device" + suffix);
    click("device_why");
    bench->units.front().knows_its_zero = false;
    press("device_try");
    require([this] { return is_seen("device_yes"); }, "question");
    bench->units.front().knows_its_zero = true;
    show_device();
    take_screenshot(*page, "start-page-device-question" + suffix);
    pick("mouse");
    require([this] { return has_line("check_device", "no motors"); }, "line of the mouse");
    show_device();
    take_screenshot(*page, "start-page-mouse" + suffix);
  }
}

}  // namespace
}  // namespace asperity
