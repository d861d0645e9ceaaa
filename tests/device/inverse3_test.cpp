// The driver of the Inverse3, unmodified, against a service on the loopback that speaks the documented messages.

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <stop_token>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include "device/inverse3/inverse3_device.h"
#include "device/inverse3/inverse3_shutdown.h"
#include "device/inverse3/web_socket.h"
#include "renderers/servo/servo_loop.h"
#include "renderers/servo/servo_thread.h"
#include "tests/device/hanging_tick.h"
#include "tests/device/read_and_push.h"
#include "tests/device/vendors/test_inverse_service.h"
#include "tests/device/watchdog_child.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/eventually.h"
#include "tests/support/patience.h"
#include "tests/support/patient_servo.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Inverse3Messages, AreReadAsDocumented) {
  const auto inventory =
      inventory_from(R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{
      "gravity_compensation":{"enabled":true,"scaling_factor":1.0},"handedness":"right","preset":"defaults",
      "torque_scaling":{"enabled":false},"basis":{"permutation":"XZY"},
      "filters":{"force_gate":{"gain":0.3},"damping":{"scalar":0.0}}}},{"device_id":"1234"}]})");
  ASSERT_TRUE(inventory.has_value());
  EXPECT_TRUE(inventory->has_session);
  EXPECT_TRUE(inventory->grips.empty());
  ASSERT_EQ(inventory->devices.size(), 2U);
  EXPECT_EQ(inventory->devices[0].axes, "XZY");
  EXPECT_EQ(filters_of(inventory->devices[0]),
            "The service modifies the force: force gate 0.3, damping 0, gravity compensation 1, "
            "torque scaling off.");
  EXPECT_EQ(filters_of(inventory->devices[1]),
            "The service modifies the force: force gate not reported, damping not reported, "
            "gravity compensation not reported, torque scaling not reported.");
}

TEST(Inverse3Messages, MeanNoTurnAndNoWayByWhatTheyLeaveOut) {
  const auto full =
      state_from(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1,"y":2,"z":3}}},
      {"device_id":"B","state":{"cursor_position":{"z":-0.5},"current_cursor_force":{"y":0.25}}}],
      "wireless_verse_grip":[{"device_id":"F","state":{"buttons":{"b":true}}},
      {"device_id":"G","state":{"buttons":{"a":true,"c":true}}}]})",
                 "B", "G");
  ASSERT_TRUE(full.has_value());
  EXPECT_EQ(full->position_m, glm::dvec3(0.0, 0.0, -0.5));
  EXPECT_EQ(full->force_N, glm::dvec3(0.0, 0.25, 0.0));
  EXPECT_EQ(full->grip, glm::dquat(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(full->buttons, 5U);
}

TEST(Inverse3Messages, WithoutAPositionTellOfNoHand) {
  for (const char* state :
       {R"({})", R"({"state":{}})", R"({"state":null})", R"({"state":{"cursor_position":{}}})",
        R"({"state":{"cursor_position":{"x":"far"}}})",
        R"({"state":{"current_cursor_force":{"z":1}}})"}) {
    std::string device = state;
    device.insert(1, device == "{}" ? R"("device_id":"A")" : R"("device_id":"A",)");
    EXPECT_FALSE(state_from(R"({"inverse3":[)" + device + "]}", "A").has_value()) << device;
  }
}

TEST(Inverse3Messages, TellOfAGripOnlyItsOwnAndOnlyATurn) {
  const auto grip = [](const std::string& orientation, const std::string& id) {
    return state_from(
               R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1}}}],
               "wireless_verse_grip":[{"device_id":"G","state":{"orientation":)" +
                   orientation + R"(,"buttons":{"a":true}}}]})",
               "A", id)
        .value();
  };
  EXPECT_EQ(grip(R"({"w":0,"z":2})", "G").grip, std::nullopt);
  EXPECT_EQ(grip(R"({"w":0,"x":0,"y":0,"z":0})", "G").grip, std::nullopt);
  EXPECT_EQ(grip(R"({"z":1})", "G").grip, glm::dquat(0.0, 0.0, 0.0, 1.0));
  EXPECT_EQ(grip(R"({"w":0.6,"x":0.8})", "F").grip, std::nullopt);
  EXPECT_EQ(grip(R"({"w":0.6,"x":0.8})", "").buttons, 0U);
}

TEST(Inverse3Messages, OfAnyOtherKindAreNone) {
  for (const char* text : {"", "{", "7", "[]", "null", R"({"inverse3":7})",
                           R"({"inverse3":[3,"x",null]})", R"({"inverse3":{"a":{}}})"}) {
    EXPECT_FALSE(state_from(text, "A").has_value()) << text;
  }
  EXPECT_FALSE(inventory_from("{").has_value());
  EXPECT_FALSE(inventory_from("[1]").has_value());
  EXPECT_TRUE(inventory_from("{}")->devices.empty());
}

TEST(Inverse3Messages, SpellAForceInBothWays) {
  EXPECT_EQ(
      force_command("049D", ForceSpelling::vector, {0.0, -0.5, 1.5}),
      R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"vector":{"x":0,"y":-0.5,"z":1.5}}}}]})");
  EXPECT_EQ(
      force_command("0\"4", ForceSpelling::values, {}, "us"),
      R"({"session":{"configure":{"profile":{"name":"us"}}},"inverse3":[{"device_id":"0\"4","commands":{"set_cursor_force":{"values":{"x":0,"y":0,"z":0}}}}]})");
}

TEST(InverseServicePlace, IsTheUsualOneUnlessSaid) {
  EXPECT_EQ(InverseServicePlace::of("").text(), "127.0.0.1:10001");
  EXPECT_EQ(InverseServicePlace::of("rig").text(), "rig:10001");
  EXPECT_EQ(InverseServicePlace::of("rig:10020").text(), "rig:10020");
  EXPECT_EQ(InverseServicePlace::of(":7").text(), "127.0.0.1:7");
  for (const char* text : {"rig:", "rig:0", "rig:70000", "rig:12x"}) {
    EXPECT_THROW(InverseServicePlace::of(text), std::runtime_error) << text;
  }
}

class Inverse3 : public testing::Test {
 protected:
  // A busy machine may keep the stand-in waiting for long; where being late is the matter, it is `hurried`.
  static constexpr Inverse3Patience kPatient{
      .connection = kPatience, .inventory = kPatience, .update = kPatience};
  static constexpr Inverse3Patience kHurried{
      .connection = kPatience, .inventory = kPatience, .update = std::chrono::milliseconds(100)};
  TestInverseService service{};
  const Driver driver = inverse3_driver(kPatient);
  const DriverOptions options{.service = service.place()};

  std::unique_ptr<HapticDevice> open() { return driver.open("", options); }
  std::unique_ptr<HapticDevice> open_hurried() {
    return inverse3_driver(kHurried).open("", options);
  }
  // A change of the bench, or a look at it.
  template <typename Change>
  auto bench(Change change) {
    const std::lock_guard lock(service.bench().mutex);
    return change(service.bench());
  }
  bool has_force() {
    return bench([](auto& it) { return it.force_N; }) != std::array{0.0, 0.0, 0.0};
  }
  // What was sent last may be on its way for a while.
  bool ends_without_force() {
    return eventually([this] { return !has_force(); });
  }
};

TEST_F(Inverse3, SaysWhatToStartWhenNobodyListens) {
  std::string place;
  {
    const TestInverseService gone;
    place = gone.place();
  }
  EXPECT_THAT(driver.find({.service = place}).blocker,
              AllOf(HasSubstr(place), HasSubstr("Inverse Service"), HasSubstr("start")));
  EXPECT_THAT(refusal_of([&] { driver.open("", {.service = place}); }), HasSubstr(place));
  bench([](auto& it) { it.talks_nonsense = true; });
  EXPECT_THAT(driver.find(options).blocker, HasSubstr("does not list devices"));
}

TEST_F(Inverse3, ListsWhatTheServiceKnowsAndItsFilters) {
  bench([](auto& it) { it.ids = {"049D", "0C1A"}; });
  const DriverSurvey survey = driver.find(options);
  EXPECT_THAT(survey.found, HasSubstr(service.place()));
  ASSERT_EQ(survey.attached.size(), 2U);
  EXPECT_EQ(survey.attached[1].serial, "0C1A");
  EXPECT_THAT(survey.attached[1].remark,
              HasSubstr("force gate 0.3, damping 0.5, gravity compensation 0.75"));
  EXPECT_THAT(refusal_of([&] { open(); }), AllOf(HasSubstr("049D"), HasSubstr("0C1A")));
  const auto device = driver.open("0C1A", options);
  EXPECT_EQ(device->capability().serial, "0C1A");
  EXPECT_EQ(device->capability().pacing, Pacing::theirs);
  EXPECT_THAT(device->capability().remarks, HasSubstr("force gate 0.3"));
  // In the first message, and in no other.
  EXPECT_THAT(bench([](auto& it) { return it.profiles; }), ElementsAre("asperity"));
  const DriverSurvey meanwhile = driver.find(options);
  EXPECT_TRUE(meanwhile.attached.at(0).is_usable());
  EXPECT_THAT(meanwhile.attached.at(1).blocker, HasSubstr("This program uses it"));
  EXPECT_THAT(refusal_of([&] { driver.open("0C1A", options); }), HasSubstr("uses it"));
}

TEST_F(Inverse3, IsRefusedWhereItsAxesOrItsMillimetresAreNotOurs) {
  bench([](auto& it) { it.axes = "XZY"; });
  EXPECT_THAT(refusal_of([&] { open(); }),
              AllOf(HasSubstr("049D"), HasSubstr("\"XZY\""), HasSubstr("\"defaults\"")));
  bench([](auto& it) {
    it.axes = "XYZ";
    it.preset = "led_front";
  });
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("\"led_front\""));
  bench([](auto& it) {
    it.preset = "arm_front";
    it.scale = 2.0;
  });
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("scales"));
  EXPECT_EQ(bench([](auto& it) { return it.strongest_N; }), 0.0);  // and before any force
  bench([](auto& it) { it.scale = 1.0; });
  open();
}

TEST_F(Inverse3, CountsFromTheMiddleWhereTheServiceDoes) {
  bench([](auto& it) {
    it.preset = "arm_front_centered";
    it.position_m = {0.01, 0.02, 0.03};
  });
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  EXPECT_EQ(servo.probe().position_m, glm::dvec3(0.01, 0.02, 0.03));
}

TEST_F(Inverse3, FindsOutHowTheServiceSpellsForces) {
  for (const char* field : {"vector", "values"}) {
    bench([&](auto& it) { it.force_field = field; });
    const auto device = open();
    EXPECT_THAT(device->capability().remarks, HasSubstr("\"" + std::string(field) + "\"."));
    EXPECT_LE(bench([](auto& it) { return it.strongest_N; }), 0.02);
    EXPECT_THAT(bench([](auto& it) { return it.force_N; }), ElementsAre(0.0, 0.0, 0.0));
  }
  // One that does not tell: by its version.
  bench([](auto& it) { it.tells_forces = false; });
  EXPECT_THAT(open()->capability().remarks,
              AllOf(HasSubstr("\"vector\""), HasSubstr("did not confirm")));
  bench([](auto& it) { it.numbers_sessions = false; });
  EXPECT_THAT(open()->capability().remarks,
              AllOf(HasSubstr("\"values\""), HasSubstr("did not confirm")));
}

TEST_F(Inverse3, TicksOnceForEachUpdateAndSendsOneMessageForEach) {
  const auto device = open();
  const int before = bench([](auto& it) { return it.messages; });
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(30);
  device->stop_calls();
  const int messages = bench([](auto& it) { return it.messages; }) - before;
  // The last message says zero and its update is no tick; nor is that of the message that was under way at the end.
  EXPECT_GE(messages, servo.ticks + 1);
  EXPECT_LE(messages, servo.ticks + 2);
  EXPECT_EQ(servo.unread, 0);
}

TEST_F(Inverse3, TellsThePoseAboutWhereTheHandleRests) {
  bench([](auto& it) {
    it.position_m = {0.01, -0.10, 0.18};
    it.grips = {"G"};
  });
  const auto device = open();
  EXPECT_EQ(device->capability().sensed_degrees_of_freedom, 6);
  EXPECT_EQ(device->capability().buttons, 3);
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(8);
  const ProbeState probe = servo.probe();
  EXPECT_NEAR(glm::distance(probe.position_m, glm::dvec3(0.01, 0.02, 0.03)), 0.0, 1e-12);
  EXPECT_NEAR(
      glm::distance(probe.orientation * glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)), 0.0,
      1e-12);
  EXPECT_EQ(probe.buttons, 2U);
  EXPECT_NEAR(glm::length(probe.velocity_m_per_s), 0.0, 1e-12);
}

TEST_F(Inverse3, KeepsItsTurnWhereTheGripTellsNone) {
  bench([](auto& it) { it.grips = {"G"}; });
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(3);
  bench([](auto& it) { it.turns = false; });
  servo.wait_for(8);
  const ProbeState probe = servo.probe();
  EXPECT_NEAR(
      glm::distance(probe.orientation * glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)), 0.0,
      1e-12);
  EXPECT_NEAR(glm::length(probe.angular_velocity_rad_per_s), 0.0, 1e-9);
}

TEST_F(Inverse3, DoesNotReadAGripThatMayBeAnybodys) {
  bench([](auto& it) { it.grips = {"G", "H"}; });
  {
    const auto device = open();
    EXPECT_EQ(device->capability().sensed_degrees_of_freedom, 3);
    EXPECT_EQ(device->capability().buttons, 0);
    EXPECT_THAT(device->capability().remarks, HasSubstr("grip is not read"));
    ReadAndPush servo{device.get()};
    servo.start();
    servo.wait_for(2);
    EXPECT_EQ(servo.probe().buttons, 0U);
  }
  bench([](auto& it) {
    it.grips = {"G"};
    it.ids = {"049D", "0C1A"};
  });
  EXPECT_EQ(driver.open("049D", options)->capability().sensed_degrees_of_freedom, 3);
}

TEST_F(Inverse3, DoesNotAnswerWhileNoPositionIsTold) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  EXPECT_EQ(servo.unread, 0);
  bench([](auto& it) {
    it.omits_identity = true;
    it.position_m = {0.0, 0.0, 0.0};
  });
  while (servo.unread == 0) std::this_thread::yield();
}

TEST_F(Inverse3, IsRefusedWhereNoPositionIsTold) {
  bench([](auto& it) {
    it.omits_identity = true;
    it.position_m = {0.0, 0.0, 0.0};
  });
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("does not report the position"));
}

// The tick, that is reading and pushing in it; the messages between two ticks do.
TEST_F(Inverse3, DoesNotTouchTheHeapInATick) {
  struct CountingTick {
    HapticDevice* device = nullptr;
    std::atomic<int> ticks{0};
    std::int64_t allocations = 0;
    static void run(void* self) noexcept {
      auto* tick = static_cast<CountingTick*>(self);
      const AllocationGuard guard;
      tick->device->read(tick->ticks * 1'000'000);
      tick->device->push({.force_N = {0.0, 0.0, 0.1}}, 1e-3);
      tick->allocations += guard.count();
      ++tick->ticks;
    }
  } tick;
  const auto device = open();
  tick.device = device.get();
  device->start_calls({.function = &CountingTick::run, .argument = &tick});
  while (tick.ticks < 20) std::this_thread::yield();
  device->stop_calls();
  EXPECT_EQ(tick.allocations, 0);
}

TEST_F(Inverse3, SendsTheForceOfATickWithTheNextMessageAndEndsAtZero) {
  const auto device = open();
  device->set_limits({.force_N = 50.0, .torque_N_m = 0.1, .slew_N = 1e6});
  ReadAndPush servo{device.get(), {.force_N = {0.25, -0.5, 1.0}}};
  servo.start();
  const std::array<double, 3> asked_N{0.25, -0.5, 1.0};
  while (bench([](auto& it) { return it.force_N; }) != asked_N) std::this_thread::yield();
  device->stop_calls();
  servo.wanted.force_N = {0.0, 0.0, 40.0};
  servo.start();
  servo.wait_for(3);
  device->stop_calls();
  EXPECT_NEAR(bench([](auto& it) { return it.strongest_N; }), 5.0, 1e-12);
  EXPECT_THAT(bench([](auto& it) { return it.force_N; }), ElementsAre(0.0, 0.0, 0.0));
}

TEST_F(Inverse3, AsksAgainWithoutForceForAnUpdateThatDoesNotCome) {
  const auto device = open_hurried();
  ReadAndPush servo{device.get(), {.force_N = {0.0, 0.0, 0.3}}};
  servo.start();
  servo.wait_for(3);
  bench([](auto& it) { it.answers_to_drop = 3; });
  while (bench([](auto& it) { return it.answers_to_drop; }) > 0) std::this_thread::yield();
  servo.wait_for(5);
  device->stop_calls();
  EXPECT_EQ(bench([](auto& it) { return it.after_a_drop_N; }), 0.0);
  EXPECT_GT(bench([](auto& it) { return it.strongest_N; }), 0.29);
}

// Four updates come after they were asked for again: had they been taken for those of later messages, every tick from
// then on would see the hand four messages ago.
TEST_F(Inverse3, DoesNotLagAfterLateUpdates) {
  const auto device = open_hurried();
  ReadAndPush servo{device.get()};
  bench([](auto& it) { it.counts_in_position = true; });
  servo.start();
  servo.wait_for(3);
  bench([](auto& it) {
    it.delay_ms = 150;
    it.answers_to_delay = 4;
  });
  while (bench([](auto& it) { return it.delay_ms; }) > 0) std::this_thread::yield();
  servo.wait_for(20);
  device->stop_calls();
  const double seen = servo.probe().position_m.x;
  // The last answer is to the zero at the end; some more may have been on their way when we stopped.
  EXPECT_GE(seen, bench([](auto& it) { return it.answers; }) - 4);
}

TEST_F(Inverse3, DoesNotAnswerWhileTheServiceDoesNotSeeIt) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  bench([](auto& it) { it.ids = {"0C1A"}; });
  while (servo.unread == 0) std::this_thread::yield();
  EXPECT_THAT(device->trouble(), AllOf(HasSubstr("049D"), HasSubstr("cable")));
  bench([](auto& it) { it.ids = {"049D"}; });
  while (!device->trouble().empty()) std::this_thread::yield();
  const int refused = servo.refused;
  servo.wait_for(3);
  EXPECT_EQ(servo.refused, refused);
}

TEST_F(Inverse3, ConnectsAgainAfterTheConnectionEnded) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(3);
  bench([](auto& it) { it.refuses_connections = true; });
  service.disconnect();
  while (device->trouble().empty()) std::this_thread::yield();
  EXPECT_THAT(device->trouble(), AllOf(HasSubstr(service.place()), HasSubstr("was lost")));
  const int ticks = servo.ticks;
  const int connections = bench([](auto& it) { return it.connections; });
  bench([](auto& it) { it.refuses_connections = false; });
  while (!device->trouble().empty()) std::this_thread::yield();
  servo.wait_for(3);
  EXPECT_GT(servo.ticks, ticks);
  EXPECT_GT(bench([](auto& it) { return it.connections; }), connections);
}

// What pushed the hand up would push it sideways.
TEST_F(Inverse3, GetsNoForceWhereItComesBackWithOtherAxesOrFromAnotherOrigin) {
  const auto device = open();
  device->set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  ReadAndPush servo{device.get(), {.force_N = {0.0, 0.0, 1.0}}};
  servo.start();
  servo.wait_for(3);
  for (const bool is_turned : {true, false}) {
    bench([&](auto& it) {
      it.axes = is_turned ? "XZY" : "XYZ";
      it.preset = is_turned ? "defaults" : "arm_front_centered";
    });
    service.disconnect();
    while (device->trouble().find("in other axes") == std::string::npos) {
      std::this_thread::yield();
    }
    EXPECT_THAT(device->trouble(), AllOf(HasSubstr("049D"), HasSubstr("Device Manager")));
    bench([](auto& it) { it.strongest_N = 0.0; });
    const int ticks = servo.ticks;
    const int connections = bench([](auto& it) { return it.connections; });
    while (bench([](auto& it) { return it.connections; }) < connections + 2) {
      std::this_thread::yield();
    }
    EXPECT_EQ(servo.ticks, ticks);
    EXPECT_EQ(bench([](auto& it) { return it.strongest_N; }), 0.0);
    bench([](auto& it) {
      it.axes = "XYZ";
      it.preset = "defaults";
    });
    servo.wait_for(3);
    EXPECT_EQ(device->trouble(), "");
  }
}

/// A program that pushes by 1 N until it is killed.
class Inverse3Victim : public Inverse3 {
 protected:
  pid_t start_victim() {
    const pid_t victim = fork();
    if (victim == 0) {
      execl(ASPERITY_INVERSE3_VICTIM, ASPERITY_INVERSE3_VICTIM, service.place().c_str(), nullptr);
      _exit(1);
    }
    return victim;
  }
  bool is_pushed() {
    return bench([](auto& it) { return it.force_N == std::array{0.0, 0.0, 1.0}; });
  }
  bool is_at_zero() {
    return bench([](auto& it) { return it.force_N == std::array{0.0, 0.0, 0.0}; });
  }
};

TEST_F(Inverse3Victim, HasZeroAskedForHoweverItDies) {
  for (const int signal : {SIGKILL, SIGSEGV, SIGABRT, SIGINT}) {
    const pid_t victim = start_victim();
    EXPECT_TRUE(eventually([&] { return is_pushed(); }));
    kill(victim, signal);
    waitpid(victim, nullptr, 0);
    EXPECT_TRUE(eventually([&] { return is_at_zero(); })) << signal;
  }
}

// The service keeps the last force as long as the connection is open.
TEST_F(Inverse3Victim, HasZeroAskedForWhileItStandsStillAndContinuesAfterwards) {
  const pid_t victim = start_victim();
  EXPECT_TRUE(eventually([&] { return is_pushed(); }));
  const int connections = bench([](auto& it) { return it.connections; });
  kill(victim, SIGSTOP);
  EXPECT_TRUE(eventually([&] { return is_at_zero(); }));
  const int messages = bench([](auto& it) { return it.messages; });
  EXPECT_TRUE(
      eventually([&] { return bench([](auto& it) { return it.messages; }) > messages + 3; }));
  EXPECT_TRUE(is_at_zero());
  kill(victim, SIGCONT);
  EXPECT_TRUE(eventually([&] { return is_pushed(); }));
  EXPECT_EQ(bench([](auto& it) { return it.connections; }), connections);
  kill(victim, SIGKILL);
  waitpid(victim, nullptr, 0);
}

// In 7 bits, or in 16 where the message is longer than 125 bytes: the service takes no other spelling.
TEST_F(Inverse3, IsShutDownByAFrameOfAnyLength) {
  for (const std::size_t length : {100U, 125U, 126U, 300U}) {
    WebSocket socket("127.0.0.1", std::stoi(service.place().substr(service.place().find(':') + 1)),
                     kPatience);
    ASSERT_TRUE(socket.receive(kPatience).has_value());
    bench([](auto& it) { it.force_N = {9.0, 9.0, 9.0}; });
    std::string message = force_command("049D", ForceSpelling::vector, {});
    message.insert(message.size() - 1, std::string(length - std::min(length, message.size()), ' '));
    const Inverse3Shutdown zero = Inverse3Shutdown::over(socket.file(), message);
    shut_down_inverse3(WatchdogProcess::Cause::ended, &zero);
    EXPECT_TRUE(eventually([&] {
      return bench([](auto& it) { return it.force_N == std::array{0.0, 0.0, 0.0}; });
    })) << length;
  }
  EXPECT_THROW(Inverse3Shutdown::over(-1, std::string(600, ' ')), std::length_error);
}

// An end at once, with answers of the service on their way, would take the message along.
TEST(Inverse3Shutdown, HearsTheServiceOutBeforeTheConnectionEnds) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const Inverse3Shutdown zero = Inverse3Shutdown::over(ends[0], "{}");
  std::atomic<bool> has_ended{false};
  std::thread process([&] {
    shut_down_inverse3(WatchdogProcess::Cause::ended, &zero);
    has_ended = true;
  });
  std::array<char, 64> heard{};
  EXPECT_EQ(recv(ends[1], heard.data(), heard.size(), 0), static_cast<ssize_t>(zero.length));
  EXPECT_EQ(recv(ends[1], heard.data(), heard.size(), 0), 0) << "the last word";
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(has_ended) << "the service has not answered yet";
  close(ends[1]);
  EXPECT_TRUE(eventually([&] { return has_ended.load(); }));
  process.join();
  close(ends[0]);
}

TEST_F(Inverse3, GetsNoForceOnceTheProcessThatWouldTakeItAwayIsGone) {
  const auto device = open();
  ReadAndPush servo{device.get(), {.force_N = {0.0, 0.0, 1.0}}};
  servo.start();
  servo.wait_for(3);
  pid_t watchdog = -1;
  ASSERT_TRUE(eventually([&] { return (watchdog = watchdog_child()) > 0; }));
  ASSERT_EQ(kill(watchdog, SIGKILL), 0);
  EXPECT_TRUE(eventually([&] {
    return device->trouble().find("if this program crashes has ended") != std::string::npos;
  }));
  EXPECT_TRUE(eventually([&] {
    return bench([](auto& it) { return it.force_N == std::array{0.0, 0.0, 0.0}; });
  }));
  // What gives it a new connection gives it a new watchdog.
  service.disconnect();
  EXPECT_TRUE(eventually([&] { return device->trouble().empty(); }));
  EXPECT_TRUE(eventually([&] {
    return bench([](auto& it) { return it.force_N == std::array{0.0, 0.0, 1.0}; });
  }));
}

// The other end takes nothing off the line, until no more goes into it.
TEST(WebSocket, IsClosedWhenAMessageIsNotTakenInTimeAndSendsItNeverAgain) {
  TestInverseService service;
  {
    const std::lock_guard lock(service.bench().mutex);
    service.bench().stalls = true;
  }
  const std::string place = service.place();
  WebSocket socket("127.0.0.1", std::stoi(place.substr(place.find(':') + 1)), kPatience);
  ASSERT_TRUE(socket.receive(kPatience).has_value());
  const std::string text = force_command("049D", ForceSpelling::vector, {0.0, 0.0, 1.0},
                                         std::string(std::size_t{1} << 20, 'x'));
  constexpr int kMostTexts = 100;  // 100 MB: more than any line holds
  int sent = 0;
  while (sent < kMostTexts && socket.send(text)) ++sent;
  EXPECT_LT(sent, kMostTexts);
  EXPECT_FALSE(socket.is_open());
  EXPECT_FALSE(socket.send("{}"));
  const std::lock_guard lock(service.bench().mutex);
  service.bench().stalls = false;
}

TEST_F(Inverse3, StopsThoughTheServiceFellSilent) {
  const auto device = open_hurried();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(3);
  bench([](auto& it) { it.answers_to_drop = 1'000'000; });
  const auto dropped = [&] {
    return 1'000'000 - bench([](auto& it) { return it.answers_to_drop; });
  };
  while (dropped() < 2) std::this_thread::yield();
  const int ticks = servo.ticks;
  device->stop_calls();
  EXPECT_EQ(servo.ticks, ticks);
}

TEST_F(Inverse3, IsLostWithItsWordsOnItAndWithoutForceAfterFiftyMillisecondsOfSilence) {
  const auto device = inverse3_driver().open("", options);
  device->set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  RecordRing ring(16384);
  ServoLoop loop(*device, ring, patient_servo());
  EXPECT_EQ(1e9 * loop.settings().silence_to_fault_s, 50e6);
  const ServoThread thread(loop, *device, Scheduling::normal);
  bench([](auto& it) { it.answers_to_drop = 1'000'000; });
  while (loop.status().fault != Fault::device_lost) std::this_thread::yield();
  EXPECT_THAT(device->complaint(),
              AllOf(HasSubstr("The Inverse Service at " + service.place()),
                    HasSubstr("the Inverse3 049D"), HasSubstr("for more than 50 ms")));
  bench([](auto& it) { it.force_N = {9.0, 9.0, 9.0}; });
  const int messages = bench([](auto& it) { return it.messages; });
  while (bench([](auto& it) { return it.messages; }) == messages) std::this_thread::yield();
  EXPECT_THAT(bench([](auto& it) { return it.force_N; }), ElementsAre(0.0, 0.0, 0.0));
  bench([](auto& it) { it.answers_to_drop = 0; });
  while (!device->complaint().empty()) std::this_thread::yield();
}

// The service holds the last force; the thread that would send the next hangs.
TEST_F(Inverse3, IsAskedForNoForceWhileATickHangs) {
  const auto device = open();
  const int connections = bench([](auto& it) { return it.connections; });
  expect_zero_force_while_a_tick_hangs(*device, [this] { return has_force(); });
  EXPECT_EQ(bench([](auto& it) { return it.connections; }), connections);
}

// Somebody who waits for a service that takes the connection and says nothing, or not even that.
TEST_F(Inverse3, HearsAStopWhileTheServiceIsWaitedFor) {
  using std::chrono::hours;
  constexpr Inverse3Patience kEndless{
      .connection = hours(1), .inventory = hours(1), .update = hours(1)};
  DriverRegistry drivers;
  drivers.add(inverse3_driver(kEndless));
  bench([](auto& it) { it.lists_nothing = true; });
  const auto stopped_after = [&](int connections, const auto& act) {
    std::stop_source stop;
    DriverOptions told = options;
    told.stop = stop.get_token();
    std::jthread stopping([&, connections] {
      while (bench([](auto& it) { return it.connections; }) < connections) {
        std::this_thread::yield();
      }
      stop.request_stop();
    });
    act(told);
  };
  stopped_after(1, [&](const DriverOptions& told) {
    EXPECT_THROW(drivers.survey(drivers.drivers().front(), told), LookStopped);
  });
  stopped_after(2, [&](const DriverOptions& told) {
    EXPECT_THROW(drivers.open("inverse3", told), OpeningStopped);
  });
  // Opened it says where it is; the first message of the driver's is never answered.
  bench([](auto& it) {
    it.lists_nothing = false;
    it.answers_to_drop = 1'000'000;
  });
  stopped_after(4, [&](const DriverOptions& told) {
    EXPECT_THROW(drivers.open("inverse3", told), OpeningStopped);
  });
  // A port that takes connections, behind which nobody speaks WebSocket.
  const int port = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof place;
  ASSERT_EQ(::bind(port, reinterpret_cast<sockaddr*>(&place), length), 0);
  ASSERT_EQ(::listen(port, 1), 0);
  ASSERT_EQ(::getsockname(port, reinterpret_cast<sockaddr*>(&place), &length), 0);
  std::stop_source stop;
  std::jthread stopping([&] {
    const int line = ::accept(port, nullptr, nullptr);
    stop.request_stop();
    ::close(line);
  });
  EXPECT_THROW(WebSocket("127.0.0.1", ntohs(place.sin_port), hours(1), stop.get_token()),
               std::runtime_error);
  ::close(port);
}

TEST_F(Inverse3, IsLeftWithoutForceWhereItsOpeningIsStoppedInTheTrialOfOne) {
  bench([](auto& it) { it.answers_forces = false; });
  std::stop_source stop;
  DriverOptions told = options;
  told.stop = stop.get_token();
  bool had_force = false;
  {
    std::jthread stopping([&](const std::stop_token& opening_ended) {
      while (!had_force && !opening_ended.stop_requested()) had_force = has_force();
      stop.request_stop();
    });
    EXPECT_THROW(driver.open("", told), OpeningStopped);
  }
  EXPECT_TRUE(had_force);
  EXPECT_TRUE(ends_without_force()) << "that of the trial was the last word";
}

TEST_F(Inverse3, IsLeftWithoutForceWhereTheTrialOfOneFails) {
  constexpr Inverse3Patience kShort{
      .connection = kPatience, .inventory = std::chrono::milliseconds(300), .update = kPatience};
  bench([](auto& it) {
    it.answers_forces = false;
    it.delay_ms = 40;
  });
  EXPECT_THAT(refusal_of([&] { inverse3_driver(kShort).open("", options); }),
              HasSubstr("does not report the position"));
  // The end of a connection can take along what was sent last. Zero has arrived and is answered before; only the force of
  // the trial has no answer.
  EXPECT_FALSE(has_force()) << "that of the trial was the last word";
  EXPECT_EQ(bench([](auto& it) { return it.messages - it.answers; }), 1);
}

TEST(WebSocket, AsksNoLibraryToLookUpAHost) {
  // Longer than a label of a name can be: known to nobody, without a question on the network.
  const std::string host(70, 'x');
  EXPECT_THAT(refusal_of([&] { WebSocket(host, 10001, kPatience); }),
              AllOf(HasSubstr("The host \"" + host), HasSubstr("not known")));
}

TEST(WebSocket, FindsThisComputerByItsName) {
  const TestInverseService service;
  const std::string place = service.place();
  WebSocket socket("localhost", std::stoi(place.substr(place.find(':') + 1)), kPatience);
  EXPECT_TRUE(socket.receive(kPatience).has_value());
}

}  // namespace
}  // namespace asperity
