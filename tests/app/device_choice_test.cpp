// What a session may run on, as a list: by which name, and why not.

#include "app/device_bench/device_choice.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/drivers.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

std::vector<SurveyedDriver> survey_of_a_lab() {
  return {{.id = "simulated", .survey = {.attached = {{.model = "simulated hand and probe"}}}},
          {.id = "falcon",
           .survey = {.attached = {{.model = "Novint Falcon", .serial = "A7", .place = "usb 1-2"},
                                   {.model = "Novint Falcon",
                                    .place = "usb 1-3",
                                    .blocker = "It has no permission."}}}},
          {.id = "openhaptics", .survey = {.blocker = "OpenHaptics is not installed."}},
          {.id = "inverse3"},
          {.id = "mouse", .survey = {.blocker = "There is no window."}}};
}

std::vector<std::string> names(const std::vector<DeviceChoice>& choices) {
  std::vector<std::string> names{};
  for (const DeviceChoice& choice : choices) names.push_back(choice.device);
  return names;
}

TEST(DeviceChoices, NameWhatIsAttachedBySerialNumberOrPlaceAfterWhatIsAlwaysThere) {
  std::vector<std::string> expected = names(devices_without_hardware());
  ASSERT_EQ(expected.front(), "simulated");
  ASSERT_EQ(expected.back(), "mouse");
  for (const char* name : {"falcon:A7", "falcon:usb 1-3", "openhaptics"}) expected.push_back(name);
  EXPECT_EQ(names(device_choices(survey_of_a_lab())), expected);
}

TEST(DeviceChoices, SayWhyWhatCannotBeUsed) {
  const std::vector<DeviceChoice> choices = device_choices(survey_of_a_lab());
  for (const DeviceChoice& choice : choices) {
    const bool is_hindered = choice.device == "falcon:usb 1-3" || choice.device == "openhaptics";
    EXPECT_EQ(choice.is_usable(), !is_hindered) << choice.device;
  }
  EXPECT_EQ(choices.back().blocker, "OpenHaptics is not installed.");
}

TEST(DeviceChoices, KnowTheirKindByTheirName) {
  for (const DeviceChoice& choice : device_choices(survey_of_a_lab())) {
    EXPECT_EQ(kind_of_device(choice.device), choice.kind) << choice.device;
  }
  EXPECT_THROW(kind_of_device("simulated:gamma.3"), std::runtime_error);
}

TEST(DeviceChoices, AreRefusedAsTheOptionThatNamesThem) {
  const auto refusal = [](const char* device) {
    return refusal_of([device] { require_device("--device", device); });
  };
  for (const char* device : {"simulated", "simulated:falcon,mass_kg=0.2", "falcon:A7", "mouse"}) {
    EXPECT_EQ(refusal(device), "") << device;
  }
  EXPECT_THAT(
      refusal("phantom"),
      testing::HasSubstr("--device phantom: there is no such device; choose one of: simulated"));
  EXPECT_THAT(refusal("simulated:falcon,mass=1"),
              testing::HasSubstr("--device simulated:falcon,mass=1: the simulated device has no "
                                 "property \"mass\""));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg=-1"),
              testing::HasSubstr("--device simulated:falcon,mass_kg=-1: mass_kg"));
}

TEST(DeviceChoices, HaveTheProfilesOfTheirOwn) {
  EXPECT_EQ(which_device("falcon:A7").name, "falcon");
  EXPECT_EQ(which_device("falcon:A7").serial, "A7");
  EXPECT_EQ(which_device("simulated:falcon").model, "in place of Novint Falcon");
  EXPECT_EQ(which_device("simulated:falcon").serial, "");
  EXPECT_EQ(which_device("simulated:falcon,mass_kg=0.2").model,
            "in place of Novint Falcon with mass_kg=0.2");
}

}  // namespace
}  // namespace asperity
