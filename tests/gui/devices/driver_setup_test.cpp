// Telling drivers in the window where things are: the drivers themselves judge, on an emulated Falcon, stand-ins for
// the makers' libraries and a stand-in for a maker's service, and whatever opens a device is told the same.

#include "app/gui/devices/driver_setup.h"

#include <fstream>
#include <memory>
#include <optional>

#include <QtCore/QRegularExpression>
#include <QtCore/QSettings>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/devices/device_test_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/start/start_page.h"
#include "app/gui/study/devices_page.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "app/words/phrase_of_error.h"
#include "device/vendor_library.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/device/emulated_falcon.h"
#include "tests/device/vendors/test_dhd.h"
#include "tests/device/vendors/test_hd.h"
#include "tests/device/vendors/test_inverse_service.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr const char* kButton = "“Set up…”";
constexpr const char* kElsewhere = "“Set up…” on the Devices page";

class DriversToSetUp : public testing::Test {
 protected:
  DriversToSetUp()
      : dhd_("the stand-in", {ASPERITY_TEST_DRD}), hd_("the stand-in", {ASPERITY_TEST_HD}) {
    QSettings().clear();
    TestDhdBench bench_of = nullptr;
    dhd_.find("test_dhd_bench", bench_of);
    TestDhdLock lock_of = nullptr;
    dhd_.find("test_dhd_lock", lock_of);
    *bench_of() = test_dhd::Bench{};
    bench = test_dhd::SharedBench(bench_of(), lock_of());
    bench->units.push_back({.serial = 42});
    TestHdReset reset = nullptr;
    hd_.find("test_hd_reset", reset);
    reset();
    make_small_study(folder);
    std::string text = small_protocol();
    text.replace(text.find("\"flow\""), std::string::npos, R"("flow": [{"run": "main"}]})");
    std::filesystem::create_directories(folder / "protocols");
    write_file(folder / "protocols" / "small.json", text, Overwrite::allow);
    for (int i = 0; i < 1000; ++i) firmware.push_back(static_cast<std::uint8_t>(i * 7 + i / 256));
    write_file(right_firmware, std::string(firmware.begin(), firmware.end()), Overwrite::allow);
    write_file(wrong_firmware, "Falcon\n", Overwrite::allow);
  }
  ~DriversToSetUp() override { apply_theme(*qApp, ThemeChoice::light); }
  void SetUp() override {
    if (!EmulatedBus::is_possible()) GTEST_SKIP() << "not started under umockdev-wrapper";
    bus.emplace();
  }

  /// A program that has just been started, on the page Devices.
  void start_program() {
    window = std::make_unique<StudyWindow>();
    desk = std::make_unique<SessionDesk>(*window, nullptr);
    window->resize(1280, 720);
    ASSERT_TRUE(window->open_study(folder));
    window->show();
    window->show_page("devices");
    wait_for_the_look();
  }
  QWidget& page() { return *window->page("devices"); }
  void wait_for_the_look() {
    require([this] { return child<QPushButton>(page(), "devices_look").isEnabled(); }, "look");
  }
  void click(const QWidget& in, const std::string& name) const {
    auto& button = child<QPushButton>(in, name.c_str());
    ASSERT_TRUE(button.isEnabled()) << name;
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  DriverSetup& dialog() { return child<DriverSetup>(*window, "driver_setup"); }
  void open_setup(const std::string& driver) {
    click(page(), "device_setup_" + driver);
    EXPECT_TRUE(dialog().isVisible());
  }
  void close_setup() {
    const QPointer<DriverSetup> shown = &dialog();
    click(dialog(), "driver_setup_done");
    require([&] { return shown.isNull(); }, "end of the dialog");
  }
  QLineEdit& field(const std::string& driver) {
    return child<QLineEdit>(dialog(), ("driver_place_" + driver).c_str());
  }
  void browse(const std::string& driver, const std::filesystem::path& file) {
    click(dialog(), "driver_browse_" + driver);
    auto& files = child<QFileDialog>(dialog(), "driver_file_dialog");
    child<QLineEdit>(files, "fileNameEdit").setText(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(&files, "accept");
    wait_for_the_look();
  }
  void type(const std::string& driver, const char* place) {
    field(driver).selectAll();
    QTest::keyClicks(&field(driver), place);
    QTest::keyClick(&field(driver), Qt::Key_Return);
    wait_for_the_look();
  }
  static std::string plain(QString text) {
    text.remove(QRegularExpression("<[^>]*>")).replace("&nbsp;", "").replace("&quot;", "\"");
    return text.toStdString();
  }
  /// Shape and words beside a field.
  std::string found(const std::string& driver) {
    return plain(child<QLabel>(dialog(), ("driver_found_" + driver).c_str()).text());
  }
  static std::string words_in(const QWidget* widget) {
    std::string words{};
    if (widget == nullptr) return words;
    for (const QLabel* label : widget->findChildren<QLabel*>()) words += plain(label->text()) + "|";
    return words;
  }
  std::string card(const std::string& driver) {
    return words_in(page().findChild<QFrame*>(QString::fromStdString("device_" + driver)));
  }
  bool can_be_tested(const char* device) {
    return page().findChild<QPushButton*>(QString("device_test_") + device) != nullptr;
  }
  StartPage& start_page() {
    auto* found_page = qobject_cast<StartPage*>(window->page("start"));
    if (found_page == nullptr) throw std::runtime_error("no page before a session");
    return *found_page;
  }
  void choose_the_protocol() {
    emit window->session_wanted({.protocol = folder / "protocols" / "small.json"});
    require([this] { return start_page().is_read(); }, "the page before a session");
    wait_for_the_choosers_look();
  }
  void wait_for_the_choosers_look() {
    require([this] { return child<QPushButton>(start_page(), "device_look").isEnabled(); },
            "the chooser's look");
  }
  int row_of(const char* device) {
    return child<QComboBox>(start_page(), "device").findData(QString(device));
  }

  TemporaryFolder temporary{};
  std::filesystem::path folder = temporary.path() / "study";
  std::filesystem::path right_firmware = temporary.path() / "falcon.bin";
  std::filesystem::path wrong_firmware = temporary.path() / "readme.txt";
  std::vector<std::uint8_t> firmware{};
  test_dhd::SharedBench bench{};
  std::optional<EmulatedBus> bus{};
  std::unique_ptr<StudyWindow> window{};
  std::unique_ptr<SessionDesk> desk{};

 private:
  VendorLibrary dhd_;
  VendorLibrary hd_;
};

TEST_F(DriversToSetUp, TakeTheFirmwareOfAFalconForTheListAndForItsTest) {
  EmulatedFalcon falcon(*bus, {.runs_firmware = false, .firmware = firmware});
  start_program();
  EXPECT_NE(card("falcon").find("not usable yet"), std::string::npos) << card("falcon");
  EXPECT_NE(card("falcon").find(std::string("software (") + kButton + ")"), std::string::npos)
      << card("falcon");
  EXPECT_FALSE(can_be_tested("falcon:usb 1-2"));

  open_setup("falcon");
  EXPECT_NE(found("falcon").find("has no firmware"), std::string::npos) << found("falcon");
  EXPECT_NE(found("falcon").find("(the field above)"), std::string::npos) << found("falcon");
  EXPECT_FALSE(child<QPushButton>(dialog(), "driver_clear_falcon").isEnabled());
  browse("falcon", wrong_firmware);
  EXPECT_NE(found("falcon").find("is a text file, not the firmware of a Falcon"), std::string::npos)
      << found("falcon");
  EXPECT_NE(card("falcon").find("is a text file, not the firmware of a Falcon"), std::string::npos);
  browse("falcon", right_firmware);
  EXPECT_TRUE(found("falcon").starts_with("✓")) << found("falcon");
  EXPECT_NE(found("falcon").find("firmware of 1000 bytes in"), std::string::npos);
  EXPECT_TRUE(can_be_tested("falcon:usb 1-2"));
  close_setup();
  EXPECT_EQ(falcon.loads(), 0) << "nothing is opened unasked";

  click(page(), "device_test_falcon:usb 1-2");
  auto* test = dynamic_cast<DeviceTestPage*>(window->page("device_test"));
  ASSERT_NE(test, nullptr);
  require([&] { return child<QComboBox>(*test, "device_test_limits").count() > 0; }, "look");
  click(*test, "device_test_begin");
  require([&] { return falcon.runs_firmware(); }, "firmware loaded by the test");
  QTest::keyClick(test, Qt::Key_Escape);
  require([&] { return !test->is_measuring(); }, "end of the test");
  falcon.lose_power();

  window->show_page("devices");
  open_setup("falcon");
  click(dialog(), "driver_clear_falcon");
  wait_for_the_look();
  EXPECT_NE(found("falcon").find("has no firmware"), std::string::npos) << found("falcon");
  EXPECT_FALSE(can_be_tested("falcon:usb 1-2"));
  EXPECT_TRUE(QSettings().allKeys().filter("firmware").isEmpty());
}

TEST_F(DriversToSetUp, HaveALibraryEach) {
  start_program();
  EXPECT_NE(card("force_dimension").find(std::string("name its library with ") + kButton + "."),
            std::string::npos)
      << card("force_dimension");
  open_setup("force_dimension");
  browse("force_dimension", wrong_firmware);
  EXPECT_TRUE(found("force_dimension").starts_with("✕")) << found("force_dimension");
  EXPECT_NE(
      found("force_dimension").find("this is not a shared library; name the file of the library"),
      std::string::npos);
  browse("force_dimension", ASPERITY_TEST_HD);
  EXPECT_NE(found("force_dimension").find("has no function dhdGetDeviceCount"), std::string::npos)
      << found("force_dimension");
  browse("force_dimension", ASPERITY_TEST_DRD);
  EXPECT_TRUE(found("force_dimension").starts_with("✓")) << found("force_dimension");
  EXPECT_TRUE(can_be_tested("force_dimension:42"));
  EXPECT_NE(card("openhaptics").find("OpenHaptics is not installed"), std::string::npos)
      << "it is not told of the other's: " << card("openhaptics");
  close_setup();

  open_setup("openhaptics");
  browse("openhaptics", ASPERITY_TEST_HD);
  EXPECT_TRUE(found("openhaptics").starts_with("✓")) << found("openhaptics");
  EXPECT_TRUE(can_be_tested("force_dimension:42")) << "both can be used";
  EXPECT_NE(card("openhaptics").find("1 ready"), std::string::npos) << card("openhaptics");
  click(dialog(), "driver_clear_openhaptics");
  wait_for_the_look();
  EXPECT_NE(card("openhaptics").find("OpenHaptics is not installed"), std::string::npos);
  EXPECT_TRUE(can_be_tested("force_dimension:42"));
}

TEST_F(DriversToSetUp, TakeTheAddressOfAServiceByReturnAndNothingHalfTyped) {
  TestInverseService service{};
  start_program();
  open_setup("inverse3");
  const std::string place = service.place();
  const std::string nonsense = place + "x";
  type("inverse3", nonsense.c_str());
  EXPECT_NE(found("inverse3").find("it must be HOST:PORT"), std::string::npos) << found("inverse3");
  EXPECT_TRUE(dialog().isVisible()) << "Return takes what is typed, and closes nothing";
  type("inverse3", place.c_str());
  EXPECT_TRUE(found("inverse3").starts_with("✓")) << found("inverse3");
  EXPECT_NE(card("inverse3").find("Inverse3, serial number 049D"), std::string::npos)
      << card("inverse3");

  QTest::keyClicks(&field("inverse3"), "and more");
  const QPointer<DriverSetup> shown = &dialog();
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  require([&] { return shown.isNull(); }, "end of the dialog");
  EXPECT_EQ(driver_place("inverse3"), place);
}

TEST_F(DriversToSetUp, KeepNoFileThatIsNotWrittenInFull) {
  start_program();
  open_setup("falcon");
  type("falcon", "falcon.bin");
  EXPECT_NE(found("falcon").find("Enter the full path"), std::string::npos) << found("falcon");
  click(dialog(), "driver_setup_done");
  EXPECT_TRUE(dialog().isVisible()) << "somebody believes that it was taken";
  EXPECT_TRUE(driver_places().empty());
  QTest::keyClick(&field("falcon"), Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&field("falcon"), Qt::Key_Delete);
  QTest::keyClick(&field("falcon"), Qt::Key_Return);
  EXPECT_EQ(found("falcon").find("Enter the full path"), std::string::npos) << found("falcon");
  close_setup();
}

TEST_F(DriversToSetUp, AreToldTheSameAfterANextStartInTheListAndBeforeASession) {
  start_program();
  open_setup("force_dimension");
  browse("force_dimension", ASPERITY_TEST_DRD);
  close_setup();
  desk.reset();
  start_program();
  EXPECT_TRUE(can_be_tested("force_dimension:42"));
  choose_the_protocol();
  const int row = row_of("force_dimension:42");
  ASSERT_GE(row, 0);
  child<QComboBox>(start_page(), "device").setCurrentIndex(row);
  EXPECT_EQ(start_page().order().inputs.driver_options.library, ASPERITY_TEST_DRD);
  click(start_page(), "device_try");
  require([this] { return child<QLabel>(start_page(), "device_state").text().contains("Tried"); },
          "answer of the device");

  // Elsewhere somebody takes it away: the chooser looks again when it is seen, and says what is missing.
  window->show_page("devices");
  open_setup("force_dimension");
  click(dialog(), "driver_clear_force_dimension");
  close_setup();
  window->show_page("start");
  wait_for_the_choosers_look();
  const std::string said = plain(child<QLabel>(start_page(), "device_text").text());
  EXPECT_NE(said.find(std::string("name its library with ") + kButton + "."), std::string::npos)
      << said;
  EXPECT_TRUE(start_page().order().inputs.driver_options.library.empty());

  // And gives it back from there.
  click(start_page(), "device_set_up");
  browse("force_dimension", ASPERITY_TEST_DRD);
  wait_for_the_choosers_look();
  EXPECT_TRUE(found("force_dimension").starts_with("✓")) << found("force_dimension");
  EXPECT_TRUE(found("falcon").starts_with("·")) << found("falcon");
  close_setup();
  EXPECT_NE(plain(child<QLabel>(start_page(), "device_state").text()).find("Not tried yet"),
            std::string::npos);
}

TEST_F(DriversToSetUp, AreToldWhatIsSetUpByThenWhenASessionIsBegunAgain) {
  start_program();
  choose_the_protocol();
  SessionOrder order = start_page().order();
  order.inputs.device = "force_dimension:42";
  order.inputs.driver_options = driver_options(order.inputs.device);
  order.inputs.consent = "I take part.";
  desk->begin(order);
  require([this] { return child<Banner>(*desk->session_window(), "news").isVisible(); }, "failure");
  const auto& news = child<Banner>(*desk->session_window(), "news");
  EXPECT_TRUE(news.text().contains(QString("name its library with ") + kElsewhere))
      << news.text().toStdString();
  remember_driver_place("force_dimension", ASPERITY_TEST_DRD);
  const QPointer<SessionWindow> before = desk->session_window();
  for (QPushButton* button : news.findChildren<QPushButton*>()) {
    if (button->text() == "Try again") button->click();
  }
  require([&] { return before.isNull() && desk->runner() != nullptr; }, "next go");
  EXPECT_EQ(desk->runner()->order().inputs.driver_options.library, ASPERITY_TEST_DRD);
  require([this] { return bench->units.front().is_open; }, "device of the session");
  desk->session_window()->close();
}

// Nobody at a window can give an option of a command.
TEST_F(DriversToSetUp, AreSpokenOfInWordsOfTheWindow) {
  EmulatedFalcon falcon(*bus, {.runs_firmware = false});
  start_program();
  for (const char* driver : {"falcon", "force_dimension", "openhaptics", "inverse3"}) {
    EXPECT_NE(card(driver).find(kButton), std::string::npos) << card(driver);
  }
  EXPECT_EQ(words_in(&page()).find("--library"), std::string::npos);
  EXPECT_EQ(words_in(&page()).find("--firmware"), std::string::npos);
  EXPECT_EQ(words_in(&page()).find("--service"), std::string::npos);
  EXPECT_NE(card("replay").find("available only at a terminal: asperity run"), std::string::npos)
      << card("replay");
  EXPECT_EQ(page().findChild<QPushButton*>("device_setup_spacemouse"), nullptr)
      << "it needs nothing of the kind";
  bench->units.front().knows_its_zero = false;
  DriverOptions nobody_to_ask{};
  nobody_to_ask.library = ASPERITY_TEST_DRD;
  try {
    built_in_drivers().open("force_dimension:42", nobody_to_ask);
    FAIL() << "it moved";
  } catch (const std::exception& refusal) {
    const QString said = words_of(phrase_of(refusal));
    EXPECT_TRUE(said.contains("First run “Test this device…” on the Devices page, which requests"))
        << said.toStdString();
  }
}

TEST_F(DriversToSetUp, ArePlainToAKeyboardAndAScreenReader) {
  start_program();
  choose_the_protocol();
  click(start_page(), "device_set_up");
  auto* const first = &field("falcon");
  first->setFocus();
  QStringList order{};
  QWidget* at = first;
  do {
    if (at->isEnabled() && (at->focusPolicy() & Qt::TabFocus) != 0 && at->isVisible()) {
      order << at->objectName();
      if (qobject_cast<QPushButton*>(at) != nullptr && at->objectName() != "driver_setup_done") {
        EXPECT_FALSE(at->accessibleName().isEmpty()) << at->objectName().toStdString();
      }
    }
    at = at->nextInFocusChain();
  } while (at != first);
  EXPECT_EQ(order.join(' ').toStdString(),
            "driver_place_falcon driver_browse_falcon driver_place_force_dimension "
            "driver_browse_force_dimension driver_place_openhaptics driver_browse_openhaptics "
            "driver_place_inverse3 driver_setup_done")
      << "what cannot be cleared is passed over";
  EXPECT_EQ(first->accessibleName(), "Novint Falcon: firmware");
  EXPECT_FALSE(first->toolTip().isEmpty());
  close_setup();

  window->show_page("devices");
  wait_for_the_look();
  auto& button = child<QPushButton>(page(), "device_setup_falcon");
  button.setFocus();
  QTest::keyClick(&button, Qt::Key_Space);
  browse("falcon", right_firmware);
  close_setup();
  ASSERT_NE(window->focusWidget(), nullptr);
  EXPECT_EQ(window->focusWidget()->objectName(), "device_setup_falcon")
      << "who set it up is where they were";
}

TEST_F(DriversToSetUp, Pictures) {
  if (qEnvironmentVariable("ASPERITY_SCREENSHOTS").isEmpty()) GTEST_SKIP() << "nobody looks";
  const EmulatedFalcon falcon(*bus, {.runs_firmware = false});
  for (const auto theme_choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, theme_choice);
    QSettings().clear();
    const QString suffix = theme_choice == ThemeChoice::dark ? "-dark" : "";
    start_program();
    auto* area = page().findChild<QScrollArea*>();
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
      const QString at = QString("_%1x%2").arg(size.width()).arg(size.height()) + suffix;
      window->resize(size);
      QTest::qWait(200);
      area->ensureWidgetVisible(page().findChild<QWidget*>("device_openhaptics"), 0, 16);
      take_screenshot(*window, "devices-set-up" + at, size);
    }
    open_setup("force_dimension");
    browse("force_dimension", wrong_firmware);
    take_screenshot(dialog(), "devices-set-up-one" + suffix, dialog().size());
    browse("force_dimension", ASPERITY_TEST_DRD);
    take_screenshot(dialog(), "devices-set-up-one-right" + suffix, dialog().size());
    close_setup();
    choose_the_protocol();
    window->resize(1280, 720);
    QTest::qWait(200);  // until everything has its place
    start_page()
        .findChild<QScrollArea*>("start_form")
        ->ensureWidgetVisible(&child<QWidget>(start_page(), "own_keyboard"));
    take_screenshot(*window, "devices-set-up-start_1280x720" + suffix, {1280, 720});
    click(start_page(), "device_set_up");
    browse("falcon", wrong_firmware);
    wait_for_the_choosers_look();
    take_screenshot(dialog(), "devices-set-up-all" + suffix, dialog().size());
    close_setup();
  }
}

}  // namespace
}  // namespace asperity
