// The devices: what each one needs to become usable.

#include "app/gui/study/devices_page.h"

#include <vector>

#include <QtTest/QSignalSpy>
#include <QtWidgets/QPushButton>

#include "app/gui/base/settings.h"
#include "app/gui/devices/driver_words.h"
#include "app/gui/look/words.h"
#include "tests/gui/study/pages_of_a_window.h"

namespace asperity {
namespace {

/// A survey of two drivers: one of a device that is not set up yet, one without its maker's library.
std::vector<SurveyedDriver> found_devices(bool has_firmware) {
  AttachedDevice falcon{.model = "Novint Falcon", .serial = "A7", .place = "usb 1-2"};
  if (!has_firmware) falcon.blocker = "Name the file of its firmware.";
  return {{.id = "simulated", .summary = "no participant feels it"},
          {.id = "falcon", .summary = "over USB", .survey = {.attached = {falcon}}},
          {.id = "openhaptics",
           .survey = {.blocker = "OpenHaptics is not installed. Name it with --library FILE."}}};
}

TEST_F(StudyPages, StateInGermanWhatDriversState) {
  open_demo();
  apply_language("de");
  const DriverRegistry drivers = built_in_drivers();
  for (const Driver& driver : drivers.drivers()) {
    EXPECT_NE(words_of(phrase_of_driver(driver.summary)), text(driver.summary)) << driver.id;
  }
  DevicesPage page(
      *window_.study(),
      [](const std::stop_token&) {
        const AttachedDevice falcon{.model = "Novint Falcon",
                                    .remark = "Its firmware is loaded when it is opened."};
        return std::vector<SurveyedDriver>{
            {.id = "falcon", .name = "Falcon", .summary = "", .survey = {.attached = {falcon}}}};
      },
      nullptr);
  QSignalSpy counted(&page, &StudyPage::counted);
  page.show();
  ASSERT_TRUE(eventually([&] { return counted.size() == 1; }));
  QStringList texts{};
  for (const QLabel* const label : page.findChildren<QLabel*>()) texts.append(label->text());
  EXPECT_TRUE(texts.contains("Seine Firmware wird beim Öffnen geladen."));
  apply_language("en");
}

TEST_F(PagesToRead, SayOfEveryDeviceWhatWouldMakeItUsableAndLookAgain) {
  bool has_firmware = false;
  DevicesPage page(
      *window_.study(),
      [&has_firmware](const std::stop_token&) { return found_devices(has_firmware); }, nullptr);
  QSignalSpy counted(&page, &StudyPage::counted);
  EXPECT_EQ(counted.size(), 0) << "nobody has looked at it yet";
  page.show();
  const auto texts_of = [&page](const char* card) {
    QString texts{};
    const auto* found = page.findChild<QFrame*>(card);
    if (found == nullptr) return texts;
    for (const QLabel* label : found->findChildren<QLabel*>()) texts += label->text() + "|";
    return texts;
  };
  ASSERT_TRUE(eventually([&] { return counted.size() == 1; }));
  EXPECT_EQ(page.count(), "1 ready");
  EXPECT_TRUE(texts_of("device_falcon").contains("Novint Falcon, serial number A7, at usb 1-2"));
  EXPECT_TRUE(texts_of("device_falcon").contains("Name the file of its firmware."));
  EXPECT_TRUE(texts_of("device_falcon").contains("not usable yet"));
  // What is attached stands above what only stands for it, and is reached first.
  const auto* falcon = page.findChild<QFrame*>("device_falcon");
  const auto* models = page.findChild<QFrame*>("device_models");
  ASSERT_TRUE(falcon != nullptr && models != nullptr);
  EXPECT_LT(falcon->mapTo(&page, QPoint(0, 0)).y(), models->mapTo(&page, QPoint(0, 0)).y());
  const QWidget* at = falcon->findChildren<QPushButton*>().value(0);
  ASSERT_NE(at, nullptr);
  while (!models->isAncestorOf(at)) {
    at = at->nextInFocusChain();
    ASSERT_NE(at->objectName(), "devices_look") << "once around";
  }
  const auto* udev = page.findChild<QLabel*>("devices_udev");
  ASSERT_NE(udev, nullptr);
  EXPECT_TRUE(udev->text().contains(QString::fromStdString(missing_udev_rule().english())));
  EXPECT_EQ(udev->isVisibleTo(&page), !missing_udev_rule().empty());
  EXPECT_TRUE(texts_of("device_openhaptics").contains("Name it with “Set up…”."))
      << "the window's own control, and no option of a command";
  EXPECT_EQ(page.findChild<QFrame*>("device_simulated"), nullptr) << "it has its card already";
  EXPECT_TRUE(texts_of("device_models").contains("delta.3"));
  TestedDevice wanted{};
  QObject::connect(&page, &DevicesPage::test_wanted,
                   [&wanted](const TestedDevice& device) { wanted = device; });
  page.findChild<QPushButton*>("device_test_simulated:falcon")->click();
  EXPECT_EQ(wanted.device, "simulated:falcon");
  EXPECT_EQ(wanted.which.model, "in place of Novint Falcon") << "whose profiles it has";
  EXPECT_TRUE(wanted.is_simulated);

  has_firmware = true;
  page.findChild<QPushButton*>("devices_look")->click();
  ASSERT_TRUE(eventually([&] { return counted.size() == 2; }));
  EXPECT_EQ(page.count(), "2 ready");
  EXPECT_FALSE(texts_of("device_falcon").contains("firmware"));
  EXPECT_TRUE(texts_of("device_falcon").contains("1 ready"));
}

}  // namespace
}  // namespace asperity
