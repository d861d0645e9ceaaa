// The list of drivers: names, and which of the attached devices is meant.

#include "device/drivers.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/random.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::string complaint_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST(Drivers, OpenTheSimulatedDeviceInTheHandThatIsGiven) {
  VirtualHand hand(HandHabits{}, Random(1));
  const DriverRegistry drivers = built_in_drivers();
  const auto device = drivers.open("simulated", {.hand = &hand});
  EXPECT_EQ(device->capability().name, "simulated");
  EXPECT_TRUE(device->read(0).has_value());
}

TEST(Drivers, FindTheSimulatedDeviceEverywhere) {
  const DriverRegistry drivers = built_in_drivers();
  const DriverSurvey survey = drivers.drivers().front().find({});
  ASSERT_EQ(survey.attached.size(), 1U);
  EXPECT_TRUE(survey.attached.front().is_usable());
}

TEST(Drivers, NameAllWhenOneIsAskedForThatThereIsNot) {
  const DriverRegistry drivers = built_in_drivers();
  EXPECT_THAT(complaint_of([&] { drivers.open("falkon:17", {}); }),
              HasSubstr("there is no device \"falkon\"; this program has: simulated"));
}

TEST(Drivers, RefuseIdsThatAreTakenOrCannotBeTyped) {
  DriverRegistry drivers;
  drivers.add({.id = "one_2"});
  EXPECT_THROW(drivers.add({.id = "one_2"}), std::invalid_argument);
  for (const char* id : {"", "2one", "One", "one two", "one:2"}) {
    EXPECT_THROW(drivers.add({.id = id}), std::invalid_argument) << id;
  }
}

TEST(Drivers, HandTheSerialNumberOn) {
  std::string asked = "nothing";
  DriverRegistry drivers;
  drivers.add({.id = "one", .open = [&](const std::string& which, const DriverOptions&) {
                 asked = which;
                 return std::unique_ptr<HapticDevice>();
               }});
  drivers.open("one:usb 1-2:7", {});
  EXPECT_EQ(asked, "usb 1-2:7");
  drivers.open("one", {});
  EXPECT_EQ(asked, "");
}

TEST(ChooseAttached, TakesTheOnlyOneOrTheOneThatIsNamed) {
  const std::vector<AttachedDevice> two{{.serial = "A", .place = "usb 1-1"},
                                        {.serial = "B", .place = "usb 1-2"}};
  EXPECT_EQ(choose_attached("Thing", {two[0]}, "").serial, "A");
  EXPECT_EQ(choose_attached("Thing", two, "B").serial, "B");
  EXPECT_EQ(choose_attached("Thing", two, "usb 1-1").serial, "A");
}

TEST(ChooseAttached, SaysWhichThereAre) {
  const std::vector<AttachedDevice> two{{.serial = "A", .place = "usb 1-1"}, {.place = "usb 1-2"}};
  EXPECT_THAT(complaint_of([] { choose_attached("Thing", {}, ""); }),
              HasSubstr("no Thing is attached"));
  EXPECT_THAT(complaint_of([&] { choose_attached("Thing", two, ""); }),
              HasSubstr("serial A at usb 1-1; at usb 1-2"));
  EXPECT_THAT(complaint_of([&] { choose_attached("Thing", two, "C"); }),
              HasSubstr("no Thing is \"C\""));
}

TEST(ChooseAttached, RefusesWithTheHindrance) {
  EXPECT_EQ(complaint_of([] { choose_attached("Thing", {{.hindrance = "It has no power."}}, ""); }),
            "It has no power.");
}

}  // namespace
}  // namespace asperity
