// The SpaceMouse's driver as it is, on emulated SpaceMice: opening, reports, faults, coming back.

#include "device/spacemouse/spacemouse_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

#include <fnmatch.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/monotonic_clock.h"
#include "renderers/servo/servo_thread.h"
#include "tests/device/emulated_spacemouse.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/eventually.h"
#include "tests/support/patient_servo.h"
#include "tests/support/refusal.h"
#include "tests/support/steady_push.h"

namespace asperity {
namespace {

using spacemouse::RateControl;
using testing::HasSubstr;

constexpr int kFull = 350;
constexpr std::uint16_t kProWireless = 0xc632;
constexpr std::uint16_t kUniversalReceiver = 0xc652;
const glm::dvec3 kHome_m = spacemouse::RateControlSettings{}.home_m;

std::vector<AttachedDevice> found() {
  const DriverRegistry drivers = built_in_drivers();
  return drivers.survey(*drivers.find("spacemouse"), {}).attached;
}

class SpaceMouse : public testing::Test {
 protected:
  void SetUp() override {
    if (!EmulatedBus::is_possible()) GTEST_SKIP() << "not started under umockdev-wrapper";
    bus_.emplace();
  }

  EmulatedBus& bus() { return *bus_; }
  static std::unique_ptr<HapticDevice> open(const std::string& which = {}) {
    return built_in_drivers().open(which.empty() ? "spacemouse" : "spacemouse:" + which, {});
  }

 private:
  std::optional<EmulatedBus> bus_{};
};

std::optional<ProbeState> read(HapticDevice& device) { return device.read(monotonic_now_ns()); }

bool mouse_answers(HapticDevice& device) { return read(device).has_value(); }

// What the device says once it says that; a busy machine may lose the device for a moment.
std::optional<ProbeState> read_until(HapticDevice& device,
                                     const std::function<bool(const ProbeState&)>& is_so) {
  std::optional<ProbeState> state;
  const bool came = eventually([&] {
    state = read(device);
    return state && is_so(*state);
  });
  return came ? state : std::nullopt;
}

// The law of the header, for one axis.
double rate_of(int raw, double full) {
  const double beyond = (std::abs(raw) / 350.0 - 0.05) / 0.95;
  return std::copysign(full * beyond * beyond, raw);
}

TEST_F(SpaceMouse, IsFoundWithModelPlaceAndSerialNumber) {
  EXPECT_TRUE(found().empty());
  EmulatedSpaceMouse compact(bus(), {.port = 3, .serial = "SM042"});
  EmulatedSpaceMouse navigator(bus(), {.port = 1, .vendor = 0x046d, .product = 0xc626});
  const std::vector<AttachedDevice> devices = found();
  ASSERT_EQ(devices.size(), 2U);
  EXPECT_EQ(devices[0].model, "3Dconnexion SpaceNavigator");
  EXPECT_EQ(devices[0].place, "usb 1-1");
  EXPECT_EQ(devices[0].serial, "");
  EXPECT_EQ(devices[1].model, "3Dconnexion SpaceMouse Compact");
  EXPECT_EQ(devices[1].place, "usb 1-3");
  EXPECT_EQ(devices[1].serial, "SM042");
  EXPECT_TRUE(devices[0].is_usable() && devices[1].is_usable());
  EXPECT_THAT(devices[0].remark, HasSubstr("no force is felt"));
  // A look takes nothing from anybody.
  EXPECT_TRUE(compact.is_the_kernels() && navigator.is_the_kernels());
}

TEST_F(SpaceMouse, IsNoMouseOrKeyboardOfTheSameMakers) {
  EmulatedSpaceMouse mouse(bus(),
                           {.port = 1, .vendor = 0x046d, .product = 0xc077, .protocols = {2}});
  EmulatedSpaceMouse cad_mouse(bus(), {.port = 2, .product = 0xc650, .protocols = {2}});
  EmulatedSpaceMouse keyboard(bus(), {.port = 3, .product = 0xc664, .protocols = {1, 0}});
  EXPECT_TRUE(found().empty());
  EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("no SpaceMouse of 3Dconnexion is attached"));
  EXPECT_EQ(mouse.opened() + cad_mouse.opened() + keyboard.opened(), 0);
}

TEST_F(SpaceMouse, IsNotOpenedWhereNothingOfItTellsOfACap) {
  EmulatedSpaceMouse emulated(bus(), {.product = kUniversalReceiver, .protocols = {1, 2}});
  ASSERT_EQ(found().size(), 1U);
  EXPECT_THAT(found()[0].blocker, HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("cannot be opened"));
  EXPECT_TRUE(emulated.is_the_kernels(0) && emulated.is_the_kernels(1));
}

TEST(SpaceMouseRules, LetPeopleOpenEachModel) {
  std::ifstream stream(ASPERITY_SOURCE_DIR "/device/udev/70-asperity.rules");
  std::vector<std::string> rules;
  for (std::string line; std::getline(stream, line);) rules.push_back(line);
  const auto value_of = [](const std::string& rule, const std::string& key) -> std::string {
    const std::size_t at = rule.find(key + "==\"");
    if (at == std::string::npos) return "";
    const std::size_t from = at + key.size() + 3;
    return rule.substr(from, rule.find('"', from) - from);
  };
  const auto hex = [](std::uint16_t number) {
    char four[8]{};
    std::snprintf(four, sizeof four, "%04x", number);
    return std::string(four);
  };
  for (const spacemouse::Model& model : spacemouse::models()) {
    EXPECT_TRUE(std::any_of(rules.begin(), rules.end(), [&](const std::string& rule) {
      const std::string product = value_of(rule, "ATTR{idProduct}");
      return rule.rfind("ATTR", 0) == 0 && rule.find("TAG+=\"uaccess\"") != std::string::npos &&
             value_of(rule, "ATTR{idVendor}") == hex(model.usb.vendor) &&
             (product.empty() || fnmatch(product.c_str(), hex(model.usb.product).c_str(), 0) == 0);
    })) << model.name;
  }
}

TEST_F(SpaceMouse, IsOpenedBySerialNumberOrPlaceWhereTwoAreAlike) {
  EmulatedSpaceMouse one(bus(), {.port = 1});
  EmulatedSpaceMouse other(bus(), {.port = 2, .serial = "SM042"});
  EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("name one by its serial number or place"));
  {
    const auto device = open("SM042");
    EXPECT_EQ(device->capability().serial, "SM042");
    EXPECT_TRUE(other.is_held());
    EXPECT_FALSE(one.is_held());
  }
  EXPECT_FALSE(other.is_held());
  const auto device = open("usb 1-1");
  EXPECT_TRUE(one.is_held());
  EXPECT_FALSE(other.is_held());
}

TEST_F(SpaceMouse, IsTakenFromTheKernelAndGivenBack) {
  EmulatedSpaceMouse emulated(bus(), {});
  {
    const auto device = open();
    EXPECT_FALSE(emulated.is_the_kernels());
    EXPECT_TRUE(emulated.is_held());
  }
  EXPECT_FALSE(emulated.is_held());
  EXPECT_TRUE(emulated.is_the_kernels());
}

TEST_F(SpaceMouse, SaysWhichRuleIsMissingWithoutPermission) {
  EmulatedSpaceMouse emulated(bus(), {});
  emulated.forbid();
  std::string complaint;
  std::vector<AttachedDevice> devices;
  // Root may open everything; a thread without its rights may not. glibc's call would take them from
  // the whole process.
  std::thread([&] {
    if (geteuid() == 0) {
      ASSERT_EQ(syscall(SYS_setresuid, -1, 65534, -1), 0);
    }
    complaint = refusal_of([] { open(); });
    devices = found();
  }).join();
  EXPECT_THAT(complaint, HasSubstr("the 3Dconnexion SpaceMouse Compact at usb 1-2 may not be "
                                   "opened by this user"));
  EXPECT_THAT(complaint, HasSubstr("70-asperity.rules"));
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].blocker, complaint);
}

TEST_F(SpaceMouse, SaysThatAnotherProgramUsesIt) {
  EmulatedSpaceMouse emulated(bus(), {});
  {
    // Held past what this program knows of itself: as another one would.
    const UsbSession usb;
    const spacemouse::SpaceMousePort other(usb, "usb 1-2");
    ASSERT_EQ(found().size(), 1U);
    EXPECT_THAT(found()[0].blocker, HasSubstr("is used by another program"));
    EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("is used by another program"));
  }
  EXPECT_TRUE(found()[0].is_usable());
}

TEST_F(SpaceMouse, IsListedAndNotTouchedWhileThisProgramUsesIt) {
  EmulatedSpaceMouse emulated(bus(), {.serial = "SM042"});
  EmulatedSpaceMouse free(bus(), {.port = 3});
  const auto device = open("SM042");
  const int before = emulated.opened();
  const std::vector<AttachedDevice> devices = found();
  ASSERT_EQ(devices.size(), 2U);
  EXPECT_EQ(devices[0].serial, "SM042");
  EXPECT_THAT(devices[0].blocker, HasSubstr("This program uses it now"));
  EXPECT_TRUE(devices[1].is_usable());
  EXPECT_THAT(refusal_of([] { open("SM042"); }), HasSubstr("This program uses it now"));
  EXPECT_EQ(emulated.opened(), before);
  EXPECT_TRUE(mouse_answers(*device));
}

TEST_F(SpaceMouse, DeclaresThatNobodyFeelsIt) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  const DeviceCapability& capability = device->capability();
  EXPECT_EQ(capability.name, "spacemouse");
  EXPECT_EQ(capability.model, "3Dconnexion SpaceMouse Compact");
  EXPECT_EQ(capability.sensed_degrees_of_freedom, 6);
  EXPECT_EQ(capability.actuated_degrees_of_freedom, 0);
  EXPECT_FALSE(spacemouse_driver().has_motors);
  EXPECT_EQ(capability.peak_force_N, 0.0);
  EXPECT_EQ(capability.buttons, 1);
  EXPECT_THAT(capability.remarks, HasSubstr("up to 0.1 m/s and 1 rad/s"));
  EXPECT_THAT(capability.remarks, HasSubstr("dead zone of 5 %"));
  ASSERT_TRUE(mouse_answers(*device));
  const auto sent = device->push({.force_N = {1.0, 2.0, 3.0}, .torque_N_m = {1.0, 0.0, 0.0}}, 1e-3);
  ASSERT_TRUE(sent.has_value());
  EXPECT_EQ(sent->wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(sent->wrench.torque_N_m, glm::dvec3(0.0));
}

TEST_F(SpaceMouse, WaitsAtHomeAndIsNotLostWhileItIsSilentAtRest) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(400);
  do {
    const auto state = read(*device);
    ASSERT_TRUE(state.has_value());
    EXPECT_EQ(state->position_m, kHome_m);
    EXPECT_EQ(state->velocity_m_per_s, glm::dvec3(0.0));
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  } while (std::chrono::steady_clock::now() < until);
  EXPECT_EQ(device->complaint(), "");
}

TEST_F(SpaceMouse, DrivesTheProbeByReportsOfPushAndOfTurn) {
  EmulatedSpaceMouse emulated(bus(), {.vendor = 0x046d, .product = 0xc626});
  const auto device = open();
  // 100 right, 200 away, 300 up: the device counts towards the hand and down; turns alike.
  emulated.hold({report_of(1, {100, -200, -300}), report_of(2, {-150, 250, -350})});
  const auto state = read_until(*device, [](const ProbeState& now) {
    return now.velocity_m_per_s != glm::dvec3(0.0) &&
           now.angular_velocity_rad_per_s != glm::dvec3(0.0);
  });
  ASSERT_TRUE(state.has_value());
  EXPECT_LT(glm::distance(state->velocity_m_per_s,
                          glm::dvec3(rate_of(100, 0.1), rate_of(200, 0.1), rate_of(300, 0.1))),
            1e-12);
  EXPECT_LT(glm::distance(state->angular_velocity_rad_per_s,
                          glm::dvec3(rate_of(-150, 1.0), rate_of(-250, 1.0), rate_of(350, 1.0))),
            1e-12);
  // And there it goes, to the corner of its workspace.
  const auto corner = read_until(*device, [](const ProbeState& now) {
    return now.position_m.z == 0.05 && now.position_m.y > 0.01;
  });
  ASSERT_TRUE(corner.has_value());
  EXPECT_GT(corner->position_m.x, 0.0);
  EXPECT_EQ(corner->velocity_m_per_s.z, 0.0);
}

TEST_F(SpaceMouse, DrivesTheProbeByReportsOfBothInOne) {
  EmulatedSpaceMouse emulated(bus(), {.product = kProWireless});
  const auto device = open();
  emulated.hold({report_of(1, {-350, 0, 120, 0, 90, -60})});
  const auto state = read_until(
      *device, [](const ProbeState& now) { return now.velocity_m_per_s != glm::dvec3(0.0); });
  ASSERT_TRUE(state.has_value());
  EXPECT_LT(glm::distance(state->velocity_m_per_s, glm::dvec3(-0.1, 0.0, rate_of(-120, 0.1))),
            1e-12);
  EXPECT_LT(glm::distance(state->angular_velocity_rad_per_s,
                          glm::dvec3(0.0, rate_of(-90, 1.0), rate_of(60, 1.0))),
            1e-12);
}

TEST_F(SpaceMouse, IsHeardOnEitherInterfaceOfItsReceiverAndLeavesTheOthersAlone) {
  EmulatedSpaceMouse emulated(bus(), {.product = kUniversalReceiver, .protocols = {0, 0, 0, 2, 1}});
  const auto device = open();
  EXPECT_TRUE(emulated.is_held(0) && emulated.is_held(1));
  for (const std::size_t other : {2, 3, 4}) EXPECT_TRUE(emulated.is_the_kernels(other)) << other;
  for (const std::size_t interface : {1, 0}) {
    emulated.hold({report_of(1, {0, -kFull, 0, 0, 0, 0})}, interface);
    EXPECT_TRUE(read_until(*device, [](const ProbeState& now) {
      return now.velocity_m_per_s.y == 0.1;
    })) << interface;
    emulated.hold({}, interface);
    emulated.say(report_of(1, {0, 0, 0, 0, 0, 0}), interface);
    EXPECT_TRUE(read_until(*device, [](const ProbeState& now) {
      return now.velocity_m_per_s.y == 0.0;
    })) << interface;
  }
}

TEST_F(SpaceMouse, TellsTheParticipantsButtonAndGoesHomeByTheOther) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  emulated.hold({report_of(1, {kFull, 0, 0})});
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m.x > 0.02; }));
  emulated.hold({});
  emulated.say(report_of(1, {0, 0, 0}));
  emulated.say({3, 0b01, 0});
  EXPECT_TRUE(read_until(*device, [](const ProbeState& now) { return now.buttons == 1; }));
  emulated.say({3, 0b11, 0});
  const auto homeward =
      read_until(*device, [](const ProbeState& now) { return now.velocity_m_per_s.x < 0.0; });
  ASSERT_TRUE(homeward.has_value());
  EXPECT_EQ(homeward->buttons, 1U);
  EXPECT_NEAR(homeward->velocity_m_per_s.x, -0.1, 1e-12);
  EXPECT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m == kHome_m; }));
}

// hidapi keeps the last thirty: what is left of a burst is its end.
TEST_F(SpaceMouse, GoesByTheLastReportOfABurst) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  for (int i = 0; i < 200; ++i) emulated.say(report_of(1, {kFull, kFull - i, -kFull}));
  emulated.say(report_of(1, {-70, 0, 0}));
  emulated.hold({report_of(1, {-70, 0, 0})});
  ASSERT_TRUE(eventually([&] { return emulated.has_said_all(); }));
  const auto state =
      read_until(*device, [](const ProbeState& now) { return now.velocity_m_per_s.x < 0.0; });
  ASSERT_TRUE(state.has_value());
  EXPECT_NEAR(state->velocity_m_per_s.x, rate_of(-70, 0.1), 1e-15);
  EXPECT_EQ(state->velocity_m_per_s.y, 0.0);
}

TEST_F(SpaceMouse, IsNotMovedByReportsThatAreCutShort) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  const std::vector<std::uint8_t> whole = report_of(1, {kFull, kFull, kFull});
  std::vector<std::vector<std::uint8_t>> cut;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    cut.emplace_back(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
  }
  for (int round = 0; round < 5; ++round) {
    for (const auto& report : cut) emulated.say(report);
  }
  emulated.say({3, 1});  // and after them all
  const auto state = read_until(*device, [](const ProbeState& now) { return now.buttons == 1; });
  ASSERT_TRUE(state.has_value());
  EXPECT_EQ(state->position_m, kHome_m);
  EXPECT_EQ(state->velocity_m_per_s, glm::dvec3(0.0));
}

TEST_F(SpaceMouse, StandsStillAtOnceWhenItIsUnpluggedInMidMotionAndContinuesWhenItIsBack) {
  EmulatedSpaceMouse emulated(bus(), {.serial = "SM042"});
  const auto device = open();
  emulated.hold({report_of(1, {kFull, 0, 0}), report_of(2, {0, 0, kFull})});
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m.x > 0.005; }));
  EXPECT_EQ(device->complaint(), "");
  emulated.unplug();
  std::optional<ProbeState> last;
  ASSERT_TRUE(eventually([&] {
    const auto state = read(*device);
    if (state) last = state;
    return !state && device->complaint().find("is unplugged") != std::string::npos;
  }));
  const std::int64_t lost_ns = monotonic_now_ns();
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
  EXPECT_THAT(device->complaint(), HasSubstr("3Dconnexion SpaceMouse Compact SM042 is unplugged"));
  // For long enough to be a decimetre away, had it gone on.
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  while (std::chrono::steady_clock::now() < until) {
    EXPECT_FALSE(mouse_answers(*device));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  emulated.plug_in();
  std::optional<ProbeState> back;
  ASSERT_TRUE(eventually([&] { return (back = read(*device)).has_value(); }));
  EXPECT_EQ(device->complaint(), "");
  EXPECT_EQ(back->velocity_m_per_s, glm::dvec3(0.0));
  EXPECT_EQ(back->angular_velocity_rad_per_s, glm::dvec3(0.0));
  EXPECT_EQ(back->buttons, 0U);
  if (last) {
    const double since_s = 1e-9 * static_cast<double>(lost_ns - last->time_ns);
    EXPECT_LE(back->position_m.x - last->position_m.x, 0.1 * since_s + 1e-9);
  }
  const double from_m = back->position_m.x;
  EXPECT_LT(from_m, 0.1);
  emulated.hold({report_of(1, {-kFull, 0, 0})});
  EXPECT_TRUE(
      read_until(*device, [&](const ProbeState& now) { return now.position_m.x < from_m; }));
}

TEST_F(SpaceMouse, StandsStillOnItsWayHomeToo) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  emulated.hold({report_of(1, {kFull, 0, 0})});
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m.x == 0.1; }));
  emulated.hold({});
  emulated.say(report_of(1, {0, 0, 0}));
  emulated.say({3, 0b10, 0});
  std::optional<ProbeState> last =
      read_until(*device, [](const ProbeState& now) { return now.velocity_m_per_s.x < 0.0; });
  ASSERT_TRUE(last.has_value());
  emulated.unplug();
  ASSERT_TRUE(eventually([&] {
    const auto state = read(*device);
    if (state) last = state;
    return !state;
  }));
  int lost = 0;
  ASSERT_TRUE(eventually([&] {
    EXPECT_FALSE(mouse_answers(*device));
    return ++lost > 100;
  }));
  emulated.plug_in();
  const auto back = read_until(*device, [](const ProbeState&) { return true; });
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->position_m, last->position_m);
  EXPECT_EQ(back->velocity_m_per_s, glm::dvec3(0.0));
}

TEST_F(SpaceMouse, IsLostAtRestTooWhenItIsUnplugged) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  emulated.say({3, 0b01, 0});
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.buttons == 1; }));
  emulated.unplug();
  EXPECT_TRUE(eventually([&] { return !mouse_answers(*device); }));
  emulated.plug_in();
  const auto back = read_until(*device, [](const ProbeState&) { return true; });
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->buttons, 0U);  // whoever held it has let go
}

TEST_F(SpaceMouse, IsLostWhenItFallsSilentWhileItsCapIsDeflected) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  emulated.hold({report_of(1, {0, 0, -175})});
  ASSERT_TRUE(read_until(
      *device, [](const ProbeState& now) { return now.position_m.z > kHome_m.z + 0.002; }));
  emulated.hold({});
  std::optional<ProbeState> last;
  ASSERT_TRUE(eventually([&] {
    const auto state = read(*device);
    if (state) last = state;
    return !state;
  }));
  EXPECT_THAT(device->complaint(), HasSubstr("has sent nothing for 50 ms although its cap"));
  EXPECT_THAT(device->complaint(), HasSubstr("touch the cap"));
  EXPECT_FALSE(device->push({}, 1e-3).has_value());
  // Time alone heals nothing, nor do buttons, and nothing goes home. (A report that was on its way may come late.)
  emulated.hold({{3, 0b11, 0}, {3, 0b00, 0}});
  int lost_in_a_row = 0;
  EXPECT_TRUE(eventually([&] {
    const auto state = read(*device);
    if (state) last = state;
    lost_in_a_row = state ? 0 : lost_in_a_row + 1;
    return lost_in_a_row > 150;
  }));
  emulated.hold({});
  emulated.say({3, 0, 0});
  emulated.say(report_of(1, {0, 0, 0}));
  const auto back = read_until(*device, [](const ProbeState&) { return true; });
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(device->complaint(), "");
  EXPECT_EQ(back->velocity_m_per_s, glm::dvec3(0.0));
  // From the last reading on the report held for at most 50 ms, at s = 0.45/0.95.
  if (last) {
    EXPECT_LE(back->position_m.z - last->position_m.z, 0.050 * rate_of(175, 0.1) + 1e-9);
    EXPECT_GE(back->position_m.z, last->position_m.z);
  }
}

TEST_F(SpaceMouse, IsFoundAgainByItsSerialNumberAndLeavesItsNeighbourAlone) {
  EmulatedSpaceMouse ours(bus(), {.port = 2, .serial = "SM042"});
  EmulatedSpaceMouse neighbour(bus(), {.port = 1, .serial = "SM043"});
  const auto device = open("SM042");
  ours.unplug();
  ASSERT_TRUE(eventually([&] { return !mouse_answers(*device); }));
  const int before = neighbour.opened();
  // Three searches for it.
  ASSERT_TRUE(eventually([&] {
    EXPECT_FALSE(mouse_answers(*device));
    EXPECT_FALSE(neighbour.is_held());
    return neighbour.opened() >= before + 3;
  }));
  ours.plug_in();
  EXPECT_TRUE(eventually([&] { return mouse_answers(*device); }));
  EXPECT_TRUE(ours.is_held());
  EXPECT_FALSE(neighbour.is_held());
}

TEST_F(SpaceMouse, IsOneOfTwoThatAreUsedAtATime) {
  EmulatedSpaceMouse left(bus(), {.port = 1});
  EmulatedSpaceMouse right(bus(), {.port = 2});
  auto one = open("usb 1-1");
  const auto other = open("usb 1-2");
  left.hold({report_of(1, {-kFull, 0, 0})});
  right.hold({report_of(1, {kFull, 0, 0})});
  EXPECT_TRUE(
      read_until(*one, [](const ProbeState& now) { return now.velocity_m_per_s.x == -0.1; }));
  EXPECT_TRUE(
      read_until(*other, [](const ProbeState& now) { return now.velocity_m_per_s.x == 0.1; }));
  one.reset();
  right.hold({report_of(1, {0, -kFull, 0})});
  EXPECT_TRUE(
      read_until(*other, [](const ProbeState& now) { return now.velocity_m_per_s.y == 0.1; }));
}

TEST_F(SpaceMouse, OutlivesErrorsOfTheBusInBursts) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  int sign = 1;
  for (const int burst : {1, 2, 7, 60}) {
    emulated.fail_transfers(burst);
    sign = -sign;
    emulated.hold({report_of(1, {sign * kFull, 0, 0})});
    EXPECT_TRUE(read_until(*device, [sign](const ProbeState& now) {
      return now.velocity_m_per_s.x == 0.1 * sign;
    })) << burst;
  }
  EXPECT_TRUE(emulated.is_held());
}

TEST_F(SpaceMouse, EndsAtOnceWhateverItsDeviceDoes) {
  EmulatedSpaceMouse emulated(bus(), {});
  EXPECT_TRUE(ends_soon(open()));
  auto device = open();
  emulated.hold({report_of(1, {kFull, 0, 0})});
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m.x > 0.0; }));
  EXPECT_TRUE(ends_soon(std::move(device)));
  device = open();
  emulated.unplug();
  EXPECT_TRUE(ends_soon(std::move(device)));
  emulated.plug_in();
  device = open();
  emulated.fail_transfers(1'000'000);
  EXPECT_TRUE(ends_soon(std::move(device)));
}

TEST_F(SpaceMouse, IsReadWithoutTouchingTheHeap) {
  EmulatedSpaceMouse emulated(bus(), {});
  emulated.hold({report_of(1, {kFull, 40, -kFull}), report_of(2, {30, kFull, 0})});
  const auto device = open();
  ASSERT_TRUE(read_until(*device, [](const ProbeState& now) { return now.position_m.x > 0.0; }));
  const AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    device->read(monotonic_now_ns());
    device->push({.force_N = {9.0, 9.0, 9.0}}, 1e-3);
  }
  device->zero_force();
  EXPECT_EQ(guard.count(), 0);
}

// The whole way: reports, servo thread, records; unplugged, the fault of every lost device; back, somebody goes on.
TEST_F(SpaceMouse, IsFollowedByAServoThreadThroughAnUnplug) {
  EmulatedSpaceMouse emulated(bus(), {});
  const auto device = open();
  RecordRing ring(32768);
  TickRecord last{};
  ProbeState before{};  // the last reading: a lost device's records repeat it
  bool is_even = true;  // from reading to reading, no farther than a report carries
  double travelled_m = 0.0;
  const auto drain = [&] {
    TickRecord record;
    while (ring.pop(record)) {
      EXPECT_EQ(record.sent.force_N, glm::dvec3(0.0));  // nobody felt what the renderer meant
      last = record;
      if (record.has(TickFlag::device_lost)) continue;
      if (before.time_ns > 0) {
        const double dt_s = 1e-9 * static_cast<double>(record.probe.time_ns - before.time_ns);
        const double step_m = glm::distance(record.probe.position_m, before.position_m);
        is_even = is_even && step_m <= 0.1 * std::min(dt_s, 0.050) + 1e-8;
        travelled_m += step_m;
      }
      before = record.probe;
    }
  };
  {
    ServoLoop loop(*device, ring, patient_servo());
    loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
    const ServoThread thread(loop, *device, Scheduling::normal);
    const auto reached = [&](const std::function<bool()>& condition) {
      return eventually([&] {
        drain();
        return condition();
      });
    };
    // A busy machine may keep the emulated device from telling anything for 50 ms: a loss like another.
    const auto goes_on_until = [&](const std::function<bool()>& condition) {
      return reached([&] {
        if (loop.status().fault != Fault::none && !last.has(TickFlag::device_lost)) {
          loop.clear_fault(loop.status().fault);
        }
        return condition();
      });
    };
    emulated.hold({report_of(1, {kFull, 0, 0}), report_of(2, {0, 0, 0})});
    ASSERT_TRUE(goes_on_until([&] { return last.probe.position_m.x > 0.02; }));
    emulated.unplug();
    ASSERT_TRUE(reached([&] { return last.has(TickFlag::device_lost); }));
    EXPECT_EQ(loop.status().fault, Fault::device_lost);
    const glm::dvec3 stopped_m = last.probe.position_m;
    EXPECT_LT(stopped_m.x, 0.1);
    emulated.plug_in();
    ASSERT_TRUE(reached([&] { return !last.has(TickFlag::device_lost); }));
    EXPECT_EQ(loop.status().fault, Fault::device_lost);  // until somebody has lifted it
    EXPECT_LT(glm::distance(last.probe.position_m, stopped_m), 0.1 * 0.050 + 1e-8);
    loop.clear_fault(loop.status().fault);
    emulated.hold({report_of(1, {-kFull, 0, 0}), report_of(2, {0, 0, 0})});
    EXPECT_TRUE(goes_on_until([&] {
      return loop.status().fault == Fault::none && last.probe.position_m.x < stopped_m.x - 0.005;
    }));
  }
  drain();
  EXPECT_TRUE(is_even);
  EXPECT_GT(travelled_m, 0.025);
  EXPECT_EQ(ring.lost(), 0U);
}

}  // namespace
}  // namespace asperity
