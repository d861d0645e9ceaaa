// The Falcon's driver as it is, on an emulated Falcon: opening, frames, faults, coming back.

#include "device/falcon/falcon_device.h"

#include <atomic>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <stop_token>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <dlfcn.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/falcon/falcon_firmware.h"
#include "device/monotonic_clock.h"
#include "tests/device/emulated_falcon.h"
#include "tests/device/falcon_arm_angles.h"
#include "tests/device/falcon_run.h"
#include "tests/device/hanging_tick.h"
#include "tests/device/ticks.h"
#include "tests/device/watchdog_child.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/eventually.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

// libusb as it is where it has no files to wait for: this definition comes before the library's own.
struct libusb_context;
struct libusb_pollfd;
static bool libusb_has_no_files = false;
extern "C" const libusb_pollfd** libusb_get_pollfds(libusb_context* context) {
  using Function = const libusb_pollfd** (*)(libusb_context*);
  static const auto theirs = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "libusb_get_pollfds"));
  return libusb_has_no_files ? nullptr : theirs(context);
}

namespace asperity {
namespace {

using falcon::Frame;
using testing::HasSubstr;

constexpr std::array<std::int16_t, 3> kNoWords{};

class TemporaryFile final {
 public:
  TemporaryFile(const std::string& name, const std::string& content)
      : path_(std::filesystem::path(testing::TempDir()) / (std::to_string(getpid()) + '-' + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_{};
};

class Falcon : public testing::Test {
 protected:
  void SetUp() override {
    if (!EmulatedBus::is_possible()) GTEST_SKIP() << "not started under umockdev-wrapper";
    bus_.emplace();
  }

  EmulatedBus& bus() { return *bus_; }

  static std::vector<std::uint8_t> firmware() {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 1000; ++i) bytes.push_back(static_cast<std::uint8_t>(i * 7 + i / 256));
    return bytes;
  }

  // As a test machine runs it: no privileges, patience with its load.
  static FalconSettings settings(const std::string& place = "usb 1-2") {
    FalconSettings settings{};
    settings.line.place = place;
    settings.line.wants_fifo = false;
    return settings;
  }

  static std::unique_ptr<FalconDevice> open() { return FalconDevice::open(settings()); }

 private:
  std::optional<EmulatedBus> bus_{};
};

bool answers(FalconDevice& device) { return device.read(monotonic_now_ns()).has_value(); }

// Pushes until it is taken; a busy machine may lose the device for a moment.
void push_until(FalconDevice& device, const glm::dvec3& force_N,
                const std::function<bool()>& done) {
  EXPECT_TRUE(eventually([&] {
    device.read(monotonic_now_ns());
    device.push({.force_N = force_N}, kDt_s);
    return done();
  }));
}

std::string text_of(const Frame& frame) { return {frame.begin(), frame.end()}; }

TEST_F(Falcon, IsFoundWithPlaceAndSerialNumber) {
  const UsbSession before;
  EXPECT_TRUE(falcon::attached_falcons(before).empty());
  EmulatedFalcon first(bus(), {.port = 3, .serial = "NF042"});
  EmulatedFalcon second(bus(), {.port = 1});
  const std::vector<AttachedDevice> found = falcon::attached_falcons(UsbSession());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].place, "usb 1-1");
  EXPECT_EQ(found[0].serial, "");
  EXPECT_EQ(found[1].place, "usb 1-3");
  EXPECT_EQ(found[1].serial, "NF042");
  EXPECT_TRUE(found[0].is_usable() && found[1].is_usable());
}

TEST_F(Falcon, IsOpenedBySerialNumberOrPlaceWhereTwoAreAlike) {
  EmulatedFalcon one(bus(), {.port = 1});
  EmulatedFalcon other(bus(), {.port = 2, .serial = "NF042"});
  const DriverRegistry drivers = built_in_drivers();
  const DriverOptions options{.wants_fifo = false};
  EXPECT_THAT(refusal_of([&] { drivers.open("falcon", options); }),
              HasSubstr("name one by its serial number or place"));
  {
    const auto device = drivers.open("falcon:NF042", options);
    EXPECT_EQ(device->capability().serial, "NF042");
    EXPECT_TRUE(other.is_held());
    EXPECT_FALSE(one.is_held());
  }
  const auto device = drivers.open("falcon:usb 1-1", options);
  EXPECT_TRUE(one.is_held());
}

TEST_F(Falcon, IsAskedForItsPowerWhereThereIsNone) {
  EXPECT_THAT(refusal_of([] { built_in_drivers().open("falcon", {}); }),
              HasSubstr("no Novint Falcon is attached: plug it in"));
}

TEST_F(Falcon, SaysWhichRuleIsMissingWithoutPermission) {
  EmulatedFalcon emulated(bus(), {});
  emulated.forbid();
  std::string complaint;
  std::string blocker;
  // Root may open everything; a thread without its rights may not. glibc's call would take them from
  // the whole process.
  std::thread([&] {
    if (geteuid() == 0) {
      ASSERT_EQ(syscall(SYS_setresuid, -1, 65534, -1), 0);
    }
    complaint = refusal_of([] { open(); });
    const std::vector<AttachedDevice> found = falcon::attached_falcons(UsbSession());
    if (!found.empty()) blocker = found.front().blocker;
  }).join();
  EXPECT_THAT(complaint, HasSubstr("may not be opened by this user"));
  EXPECT_THAT(complaint, HasSubstr("70-asperity.rules"));
  EXPECT_EQ(blocker, complaint);
}

TEST(DeviceRules, LetPeopleOpenWhatThereAreDriversFor) {
  // The file that the sentence names.
  std::ifstream stream(ASPERITY_SOURCE_DIR "/device/udev/70-asperity.rules");
  const std::string rules{std::istreambuf_iterator<char>(stream), {}};
  for (const char* id : {"0403", "cb48", "1451", "2988", "256f", "046d"}) {
    EXPECT_THAT(rules, HasSubstr("\"" + std::string(id) + "\"")) << id;
  }
  // A Touch, however it tells its numbers and whatever the kernel takes it for.
  for (const char* line :
       {"\nATTR{idVendor}==\"0301\", ATTR{idProduct}==\"2988\", TAG+=\"uaccess\"\n",
        "\nSUBSYSTEM==\"tty\", ATTRS{idVendor}==\"2988\", TAG+=\"uaccess\"\n",
        "\nSUBSYSTEM==\"tty\", ATTRS{idVendor}==\"0301\", ATTRS{idProduct}==\"2988\", "
        "TAG+=\"uaccess\"\n",
        "\nSUBSYSTEM==\"hidraw\", ATTRS{idVendor}==\"2988\", TAG+=\"uaccess\"\n"}) {
    EXPECT_THAT(rules, HasSubstr(line));
  }
}

TEST_F(Falcon, SaysThatItIsInUse) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("is used by another program or session"));
  const DriverRegistry drivers = built_in_drivers();
  EXPECT_THAT(drivers.find("falcon")->find({}).attached.at(0).blocker, HasSubstr("is used by"));
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
}

TEST_F(Falcon, SaysThatItNeedsFirmware) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false});
  EXPECT_THAT(refusal_of([] { open(); }), HasSubstr("has no firmware"));
  const DriverRegistry drivers = built_in_drivers();
  const Driver& driver = *drivers.find("falcon");
  EXPECT_THAT(driver.find({}).attached.at(0).blocker, HasSubstr("--firmware FILE"));
  EXPECT_THAT(driver.find({.firmware = "/no/such/file"}).attached.at(0).blocker,
              HasSubstr("/no/such/file cannot be read"));
  const TemporaryFile file("falcon.bin", std::string(8000, '\x81'));
  const DriverSurvey survey = driver.find({.firmware = file.path()});
  EXPECT_THAT(survey.found, HasSubstr("firmware of 8000 bytes"));
  EXPECT_TRUE(survey.attached.at(0).is_usable());
  EXPECT_THAT(survey.attached.at(0).remark, HasSubstr("loaded when it is opened"));
  EXPECT_THAT(refusal_of([&] { driver.open("", {.firmware = "/no/such/file"}); }),
              HasSubstr("/no/such/file cannot be read"));
}

TEST_F(Falcon, SaysThatAFileIsNoFirmwareBeforeOneIsAttached) {
  const DriverRegistry drivers = built_in_drivers();
  const auto blocker = [&](const std::filesystem::path& file) {
    return drivers.find("falcon")->find({.firmware = file}).blocker;
  };
  EXPECT_THAT(blocker("/no/such/file"), HasSubstr("cannot be read"));
  EXPECT_THAT(blocker(TemporaryFile("empty.bin", "").path()), HasSubstr("has 0 bytes"));
  EXPECT_THAT(blocker(TemporaryFile("text.bin", "nonsense\n").path()), HasSubstr("is a text"));
  EXPECT_EQ(blocker(TemporaryFile("falcon.bin", std::string(8000, '\x81')).path()), "");
}

TEST_F(Falcon, IsListedAsItIsOpenedWhereTheFirmwareIsNone) {
  EmulatedFalcon emulated(bus(), {});  // its own runs
  const DriverRegistry drivers = built_in_drivers();
  const Driver& driver = *drivers.find("falcon");
  EXPECT_TRUE(driver.find({}).attached.at(0).is_usable());
  const TemporaryFile file("text.bin", "nonsense\n");
  EXPECT_THAT(driver.find({.firmware = file.path()}).attached.at(0).blocker,
              HasSubstr("is a text"));
  EXPECT_THAT(refusal_of([&] { driver.open("", {.firmware = file.path()}); }),
              HasSubstr("is a text"));
}

TEST_F(Falcon, IsSetUpByteForByte) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  // Latency 1 ms, 1.5 Mbaud, nothing left in the buffers.
  const std::vector<std::pair<int, int>> expected{{9, 1}, {3, 0x0002}, {0, 1}, {0, 2}};
  EXPECT_EQ(emulated.settings_sent(), expected);
}

TEST_F(Falcon, GetsItsFirmwareThroughTheBootLoaderByteForByte) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false, .firmware = firmware()});
  FalconSettings wanted = settings();
  wanted.line.firmware = firmware();
  const auto device = FalconDevice::open(wanted);
  EXPECT_TRUE(emulated.runs_firmware());  // only after every byte was the right one
  EXPECT_EQ(emulated.loads(), 1);
  const std::vector<std::pair<int, int>> expected{
      {9, 1},      {3, 0x0002}, {0, 1},      {0, 2},                       // is one running?
      {0, 1},      {0, 2},      {9, 16},     {3, 0x4138}, {4, 8}, {2, 0},  // 9600 baud 8N1
      {1, 0x0200}, {1, 0x0100}, {1, 0x0101},                               // restart
      {1, 0x0100}, {3, 0x0015},                                            // load
      {9, 1},      {3, 0x0002}, {0, 1},      {0, 2}};
  EXPECT_EQ(emulated.settings_sent(), expected);
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
}

TEST_F(Falcon, IsLoadedAgainWhenALoadFails) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false, .firmware = firmware()});
  emulated.spoil_loads(2);
  FalconSettings wanted = settings();
  wanted.line.firmware = firmware();
  const auto device = FalconDevice::open(wanted);
  EXPECT_EQ(emulated.loads(), 3);
}

TEST_F(Falcon, SaysWhatItDidWhenThreeLoadsFail) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false, .firmware = firmware()});
  emulated.spoil_loads(3);
  FalconSettings wanted = settings();
  wanted.line.firmware = firmware();
  const std::string complaint = refusal_of([&] { FalconDevice::open(wanted); });
  EXPECT_THAT(complaint, HasSubstr("could not be loaded in three tries"));
  EXPECT_THAT(complaint, HasSubstr("byte 99 of the firmware was read back with another value"));
  EXPECT_EQ(emulated.loads(), 3);
}

TEST_F(Falcon, SaysThatFirmwareOfSomethingElseDoesNotRun) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false, .firmware = firmware()});
  FalconSettings wanted = settings();
  wanted.line.firmware = firmware();
  wanted.line.firmware.pop_back();
  EXPECT_THAT(refusal_of([&] { FalconDevice::open(wanted); }), HasSubstr("does not respond"));
}

TEST_F(Falcon, IsHomedByAPersonWhoIsTold) {
  EmulatedFalcon emulated(bus(), {.is_homed = false});
  FalconSettings wanted = settings();
  std::string told;
  wanted.tell = [&](const std::string& sentence) {
    told = sentence;
    // Red, and it looks for its zero: 8 + 1 above 'A'.
    EXPECT_TRUE(eventually([&] { return text_of(emulated.last_frame()) == "<AAAAAAAAAAAAJA>"; }));
    emulated.home();
  };
  const auto device = FalconDevice::open(wanted);
  EXPECT_THAT(told, HasSubstr("pull the grip out all the way"));
  EXPECT_TRUE(eventually([&] { return text_of(emulated.last_frame()) == "<AAAAAAAAAAAACA>"; }));
}

TEST_F(Falcon, GivesUpWhenNobodyHomesIt) {
  EmulatedFalcon emulated(bus(), {.is_homed = false});
  FalconSettings wanted = settings();
  std::atomic<std::int64_t> now_ns{monotonic_now_ns()};
  wanted.line.clock = [&now_ns] { return now_ns.load(); };
  wanted.tell = [&](const std::string&) {
    now_ns += std::chrono::nanoseconds(wanted.homing_patience).count() + 1;
  };
  EXPECT_THAT(refusal_of([&] { FalconDevice::open(wanted); }), HasSubstr("was not homed in time"));
}

TEST_F(Falcon, IsLetGoOfWhereSomebodyStopsWhileItIsHomed) {
  EmulatedFalcon emulated(bus(), {.is_homed = false});
  std::stop_source stop;
  const DriverOptions options{.tell = [&](const std::string&) { stop.request_stop(); },
                              .stop = stop.get_token(),
                              .wants_fifo = false};
  EXPECT_THROW(built_in_drivers().open("falcon", options), OpeningStopped);
  EXPECT_FALSE(emulated.is_held());
  EXPECT_EQ(emulated.motor_words(), kNoWords);
}

TEST_F(Falcon, IsLetGoOfWhereSomebodyStopsBeforeItsFirmwareIsLoaded) {
  EmulatedFalcon emulated(bus(), {.runs_firmware = false, .firmware = firmware()});
  std::stop_source stop;
  FalconSettings wanted = settings();
  wanted.stop = stop.get_token();
  stop.request_stop();
  EXPECT_THROW(FalconDevice::open(wanted), OpeningStopped) << "and not: it has no firmware";
  wanted.line.firmware = firmware();
  EXPECT_THROW(FalconDevice::open(wanted), OpeningStopped);
  EXPECT_FALSE(emulated.is_held());
  EXPECT_EQ(emulated.loads(), 0);
}

// Half a second is waited for a frame before a Falcon counts as one without firmware.
TEST_F(Falcon, IsAskedForNoFrameWhereSomebodyStopsALook) {
  EmulatedFalcon emulated(bus(), {});
  std::stop_source stop;
  falcon_driver().find({.stop = stop.get_token()});
  EXPECT_GT(emulated.frames(), 0);
  const std::int64_t before = emulated.frames();
  stop.request_stop();
  falcon_driver().find({.stop = stop.get_token()});
  EXPECT_EQ(emulated.frames(), before);
}

// Somebody takes a minute for it, and others have devices to look for.
TEST_F(Falcon, KeepsNobodyFromLookingWhileItIsHomed) {
  EmulatedFalcon emulated(bus(), {.is_homed = false});
  const DriverRegistry drivers = built_in_drivers();
  std::atomic<bool> has_looked{false};
  std::vector<AttachedDevice> found;
  std::jthread looking;
  const DriverOptions options{.tell =
                                  [&](const std::string&) {
                                    looking = std::jthread([&] {
                                      found = drivers.survey(*drivers.find("falcon"), {}).attached;
                                      has_looked = true;
                                    });
                                    EXPECT_TRUE(eventually([&] { return has_looked.load(); }));
                                    emulated.home();
                                  },
                              .wants_fifo = false};
  const auto device = drivers.open("falcon", options);
  looking.join();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.front().blocker, HasSubstr("is used by another program or session"));
  EXPECT_TRUE(eventually([&] { return device->read(monotonic_now_ns()).has_value(); }));
}

TEST_F(Falcon, TellsWhereTheGripIsInTheHandsFrame) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  emulated.press(0b0101);  // first: the answer with the place has it then
  // 20 mm right, 10 mm up, 5 mm towards the hand.
  emulated.put_grip({0.020, 0.010, 0.120});
  ProbeState state{};
  EXPECT_TRUE(eventually([&] {
    const auto read = device->read(42);
    if (read) state = *read;
    return glm::distance(state.position_m, glm::dvec3(0.020, -0.005, 0.010)) < 100e-6;
  })) << state.position_m.x
      << ' ' << state.position_m.y << ' ' << state.position_m.z;
  EXPECT_EQ(state.time_ns, 42);
  EXPECT_EQ(state.buttons, 0b0101U);
}

TEST_F(Falcon, PutsAForceIntoTheWordsOfThreeMotors) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  // 2 N upwards are 2 N along the machine's y; the arms are where their counts say.
  const glm::dvec3 grip_m(0.010, -0.020, 0.110);
  emulated.put_grip(grip_m);
  const auto angles = falcon::angles_at(falcon::counts_at(grip_m));
  const auto words =
      falcon::words_for(
          falcon::torques_N_m(angles, falcon::position_m(angles).value(), {0.0, 2.0, 0.0}).value())
          .words;
  push_until(*device, {0.0, 0.0, 2.0}, [&] { return emulated.motor_words() == words; });
  EXPECT_EQ(text_of(emulated.last_frame()),
            text_of(falcon::frame_of({.motor_words = words, .lamp = falcon::Lamp::green})));
}

// Bit 11 of one encoder flips on the wire: the place is 54 mm off and more, and the torques for a force there would push the
// hand in another direction.
TEST_F(Falcon, PushesFromTheLastPlausiblePoseAfterAWildAnswer) {
  EmulatedFalcon emulated(bus(), {});
  const glm::dvec3 grip_m(0.010, -0.020, 0.110);
  const glm::dvec3 in_hands_frame_m(0.010, 0.005, -0.020);
  emulated.put_grip(grip_m);
  FalconSettings wanted = settings();
  // It stands still: no pose becomes old, however busy the machine is.
  wanted.line.clock = [began_ns = monotonic_now_ns()] { return began_ns; };
  const auto device = FalconDevice::open(wanted);
  const glm::dvec3 force_N(0.5, 0.0, 1.0);
  const auto words_at = [](const std::array<std::int16_t, 3>& counts) {
    const auto angles = falcon::angles_at(counts);
    const auto torques_N_m =
        falcon::torques_N_m(angles, falcon::position_m(angles).value(), {0.5, 1.0, 0.0});
    return falcon::words_for(torques_N_m.value()).words;
  };
  const auto counts = falcon::counts_at(grip_m);
  const auto words = words_at(counts);
  push_until(*device, force_N, [&] { return emulated.motor_words() == words; });
  const auto is_read_off = [&](double least_m, double most_m) {
    const auto read = device->read(monotonic_now_ns());
    const double off_m = read ? glm::distance(read->position_m, in_hands_frame_m) : -1.0;
    return off_m >= least_m && off_m <= most_m;
  };
  for (std::size_t encoder = 0; encoder < 3; ++encoder) {
    std::array<std::int16_t, 3> bits{};
    bits[encoder] = 1 << 11;
    auto wild = counts;
    wild[encoder] = static_cast<std::int16_t>(wild[encoder] ^ bits[encoder]);
    ASSERT_NE(words_at(wild), words);
    emulated.flip(bits);
    EXPECT_TRUE(eventually([&] { return is_read_off(0.05, 0.1); })) << encoder;
    EXPECT_TRUE(device->push({.force_N = force_N}, kDt_s).has_value());
    // The second frame from now on was made of these words.
    const std::int64_t before = emulated.frames();
    EXPECT_TRUE(eventually([&] { return emulated.frames() > before + 1; }));
    EXPECT_EQ(emulated.motor_words(), words) << encoder;
    emulated.flip({});
    EXPECT_TRUE(eventually([&] { return is_read_off(0.0, 0.001); })) << encoder;
  }
}

TEST_F(Falcon, SaysWhatTheMotorsCouldGive) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  const double peak_N = device->capability().peak_force_N;
  device->set_limits({.force_N = peak_N, .slew_N = 1e6});
  // At a corner of its workspace the motors have less along x than anywhere in the middle.
  const double half_m = device->capability().workspace_maximum_m.x;
  const glm::dvec3 corner_m(half_m, half_m, 0.115 + half_m);
  emulated.put_grip(corner_m);
  const auto angles = falcon::angles_at(falcon::counts_at(corner_m));
  const double part =
      falcon::words_for(
          falcon::torques_N_m(angles, falcon::position_m(angles).value(), {peak_N, 0.0, 0.0})
              .value())
          .part;
  ASSERT_LT(part, 0.95);
  std::optional<LimitedWrench> sent;
  EXPECT_TRUE(eventually([&] {
    device->read(monotonic_now_ns());
    sent = device->push({.force_N = {peak_N, 0.0, 0.0}}, kDt_s);
    return sent.has_value() && sent->wrench.force_N.x < 0.95 * peak_N;
  }));
  EXPECT_TRUE(sent->has(LimitReason::force));
  EXPECT_NEAR(sent->wrench.force_N.x, part * peak_N, 1e-9);
  EXPECT_EQ(sent->wrench.force_N.y, 0.0);
  push_until(*device, {peak_N, 0.0, 0.0},
             [&] { return emulated.take_strongest_word() == falcon::kLargestWord; });
}

TEST_F(Falcon, HasItsMotorsAtZeroWhenNobodyPushesAnyMoreAndAtTheEnd) {
  EmulatedFalcon emulated(bus(), {});
  auto device = open();
  const auto pushed = [&] { return emulated.motor_words() != kNoWords; };
  push_until(*device, {0.0, 0.0, 1.0}, pushed);
  // The program hangs: the thread of the wire does not.
  EXPECT_TRUE(eventually([&] { return emulated.motor_words() == kNoWords; }));
  push_until(*device, {0.0, 0.0, 1.0}, pushed);
  device.reset();
  EXPECT_EQ(emulated.motor_words(), kNoWords);
  EXPECT_FALSE(emulated.is_held());
}

// Long before the line takes an old force away by itself: for the line, time passes a hundred times as slowly.
TEST_F(Falcon, HasItsMotorsAtZeroWhileATickHangs) {
  EmulatedFalcon emulated(bus(), {});
  FalconSettings slow = settings();
  slow.line.clock = [] { return monotonic_now_ns() / 100; };
  const auto device = FalconDevice::open(slow);
  expect_zero_force_while_a_tick_hangs(*device, [&] { return emulated.motor_words() != kNoWords; });
}

pid_t start_victim() {
  const pid_t victim = fork();
  if (victim == 0) {
    execl(ASPERITY_FALCON_VICTIM, ASPERITY_FALCON_VICTIM, nullptr);
    _exit(1);
  }
  return victim;
}

// On a busy machine, a process that is dead still holds what it has claimed.
TEST_F(Falcon, HasItsMotorsAtZeroHoweverLongTheDeadHoldIt) {
  constexpr int kOfMoreThanASecond = 250;  // one every 5 ms at most
  EmulatedFalcon emulated(bus(), {});
  const pid_t victim = start_victim();
  EXPECT_TRUE(eventually([&] { return emulated.take_strongest_word() > 0; }));
  kill(victim, SIGKILL);
  waitpid(victim, nullptr, 0);
  const int before = emulated.refused_claims();
  EXPECT_TRUE(eventually([&] { return emulated.refused_claims() >= before + kOfMoreThanASecond; }));
  emulated.let_go();
  EXPECT_TRUE(eventually([&] { return emulated.motor_words() == kNoWords; }));
}

TEST_F(Falcon, HasItsMotorsAtZeroHoweverTheProgramThatDroveItDies) {
  for (const int signal : {SIGKILL, SIGSEGV, SIGABRT, SIGINT}) {
    EmulatedFalcon emulated(bus(), {});
    const auto dies_pushing = [&] {
      const pid_t victim = start_victim();
      EXPECT_TRUE(eventually([&] { return emulated.take_strongest_word() > 0; }));
      kill(victim, signal);
      waitpid(victim, nullptr, 0);
      return emulated.motor_words() != kNoWords;  // as long as nobody else may say anything
    };
    // On a busy machine it may have stood still, at zero, before it was killed.
    bool is_pushed = dies_pushing();
    for (int more = 0; more < 5 && !is_pushed; ++more) {
      emulated.let_go();
      is_pushed = dies_pushing();
    }
    ASSERT_TRUE(is_pushed);
    emulated.let_go();
    EXPECT_TRUE(eventually([&] { return emulated.motor_words() == kNoWords; })) << signal;
    // And anybody may drive it again.
    EXPECT_TRUE(eventually([&] { return refusal_of([] { open(); }).empty(); }));
  }
}

TEST_F(Falcon, GetsNoForceOnceTheProcessThatWouldTakeItAwayIsGone) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  const auto is_pushed = [&] { return emulated.motor_words() != kNoWords; };
  push_until(*device, {0.0, 0.0, 1.0}, is_pushed);
  pid_t watchdog = -1;
  ASSERT_TRUE(eventually([&] { return (watchdog = watchdog_child()) > 0; }));
  ASSERT_EQ(kill(watchdog, SIGKILL), 0);
  push_until(*device, {0.0, 0.0, 1.0}, [&] {
    return device->complaint().find("if this program crashes has ended") != std::string::npos;
  });
  EXPECT_TRUE(eventually([&] { return !is_pushed(); }));
  emulated.take_strongest_word();
  const std::int64_t before = emulated.frames();
  EXPECT_TRUE(eventually([&] {
    EXPECT_FALSE(answers(*device));
    EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, kDt_s).has_value());
    return emulated.frames() > before + 50;
  }));
  EXPECT_EQ(emulated.take_strongest_word(), 0);
  emulated.unplug();
  EXPECT_TRUE(eventually([&] {
    EXPECT_FALSE(answers(*device));
    return device->complaint().find("is unplugged") != std::string::npos;
  }));
  emulated.plug_in();
  push_until(*device, {0.0, 0.0, 1.0}, is_pushed);
  EXPECT_TRUE(eventually([&] { return answers(*device) && device->complaint().empty(); }));
}

// Sooner than the driver, on a busy machine, has asked it anything.
TEST_F(Falcon, IsOpenedAnewHoweverShortlyItWasUnplugged) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  push_until(*device, {0.0, 0.0, 1.0}, [&] { return emulated.motor_words() != kNoWords; });
  emulated.unplug();
  emulated.plug_in();
  EXPECT_TRUE(eventually([&] { return emulated.is_held() && answers(*device); }));
  EXPECT_EQ(emulated.take_strongest_word(), 0);
  push_until(*device, {0.0, 0.0, 1.0}, [&] { return emulated.motor_words() != kNoWords; });
}

TEST_F(Falcon, IsRefusedWhereNobodyCouldTakeItsForceAway) {
  EmulatedFalcon emulated(bus(), {});
  libusb_has_no_files = true;
  const std::string complaint = refusal_of([] { open(); });
  libusb_has_no_files = false;
  EXPECT_THAT(complaint, HasSubstr("the Novint Falcon at usb 1-2 receives no force"));
  EXPECT_FALSE(emulated.is_held());
  EXPECT_EQ(emulated.take_strongest_word(), 0);
  open();
}

TEST_F(Falcon, IsLeftToItsWatchdogWhenItTakesNoPartingFrame) {
  for (const bool in_time : {true, false}) {
    EmulatedFalcon emulated(bus(), {});
    auto device = open();
    const auto is_pushed = [&] { return emulated.motor_words() != kNoWords; };
    const auto refuse = [&](bool refuses) {
      if (in_time) {
        emulated.fail_transfers(refuses ? 1'000'000 : 0);
      } else {
        emulated.take_no_frames(refuses);
      }
    };
    // On a busy machine the force may have ended before it takes nothing any more: once again then.
    do {
      refuse(false);
      push_until(*device, {0.0, 0.0, 1.0}, is_pushed);
      refuse(true);
    } while (!is_pushed());
    device.reset();
    EXPECT_EQ(emulated.motor_words(), kNoWords);
    EXPECT_FALSE(emulated.is_held());
  }
}

TEST_F(Falcon, TakesZeroOverTheFileThatItsDriverHasOpenedAndNoOther) {
  EmulatedFalcon emulated(bus(), {});
  const UsbSession usb;
  falcon::FalconPort port(usb, "usb 1-2");
  ASSERT_EQ(port.begin_frames(), falcon::Transfer::done);
  ASSERT_EQ(port.write(falcon::frame_of({.motor_words = {300, -20, 1}}), std::chrono::seconds(9)),
            falcon::Transfer::done);
  ASSERT_EQ(emulated.motor_words(), (std::array<std::int16_t, 3>{300, -20, 1}));
  const falcon::LastWords words = port.last_words();
  const int another = ::open(words.node.data(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(another, 0) << words.node.data();
  EXPECT_FALSE(falcon::send_zero(another, words.zero));
  EXPECT_NE(emulated.motor_words(), kNoWords);
  // What the watchdog does while the program is stopped and cannot.
  say_last_words(WatchdogProcess::Cause::stopped, &words);
  EXPECT_EQ(emulated.motor_words(), kNoWords);
  ::close(another);
}

// umockdev stands between the program and its system calls, and has locks: a fork in which one is held does nothing.
TEST_F(Falcon, HasAWatchdogThatActsWhateverLockALibraryHoldsAtItsStart) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const std::jthread locks([](const std::stop_token& end) {
    // Held for about a third of the time.
    while (!end.stop_requested()) {
      const auto begun = std::chrono::steady_clock::now();
      access("/dev/null", R_OK);
      const auto held = std::chrono::steady_clock::now() - begun;
      while (std::chrono::steady_clock::now() - begun < 3 * held) {
      }
    }
  });
  constexpr int kWatchdogs = 10;
  for (int number = 0; number < kWatchdogs; ++number) {
    WatchdogProcess watchdog(
        [](WatchdogProcess::Cause, const void* to) noexcept {
          [[maybe_unused]] const ssize_t written = write(*static_cast<const int*>(to), "", 1);
        },
        &ends[1], ends[1]);
    watchdog.leave_to_act();
  }
  close(ends[1]);
  std::array<char, kWatchdogs + 1> acted{};
  EXPECT_EQ(read(ends[0], acted.data(), acted.size()), kWatchdogs);
  close(ends[0]);
}

TEST_F(Falcon, IsInStepAgainAfterAnAnswerThatCameLate) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  // Later than a frame is waited for: it is read as the answer to a later one, unless somebody minds.
  emulated.answer_late(std::chrono::milliseconds(60));
  EXPECT_TRUE(eventually([&] { return emulated.take_most_unread() > 0; }));
  EXPECT_TRUE(eventually([&] {
    emulated.take_most_unread();
    const std::int64_t before = emulated.frames();
    EXPECT_TRUE(eventually([&] { return emulated.frames() > before + 50; }));
    return emulated.take_most_unread() == 0;
  }));
}

int threads_at_fifo() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    const int policy = sched_getscheduler(std::stoi(task.path().filename().string()));
    if (policy == SCHED_FIFO) ++count;
  }
  return count;
}

TEST_F(Falcon, HurriesWhileItExchangesFramesAndNotWhileItIsSearchedFor) {
  EmulatedFalcon emulated(bus(), {});
  FalconSettings wanted = settings();
  wanted.line.wants_fifo = true;
  const sched_param priority{1};
  if (sched_setscheduler(0, SCHED_FIFO, &priority) != 0) GTEST_SKIP() << "SCHED_FIFO is refused";
  const sched_param normal{0};
  ASSERT_EQ(sched_setscheduler(0, SCHED_OTHER, &normal), 0);
  const auto device = FalconDevice::open(wanted);
  EXPECT_TRUE(eventually([] { return threads_at_fifo() == 1; }));
  emulated.unplug();
  EXPECT_TRUE(eventually([] { return threads_at_fifo() == 0; }));
  emulated.plug_in();
  EXPECT_TRUE(eventually([] { return threads_at_fifo() == 1; }));
}

TEST_F(Falcon, IsLostAfterFiftyMillisecondsOfSilenceAndFoundAgain) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  push_until(*device, {0.0, 0.0, 1.0}, [&] { return emulated.motor_words() != kNoWords; });
  const std::size_t before = emulated.settings_sent().size();
  const std::int64_t fell_silent_ns = monotonic_now_ns();
  emulated.fall_silent(true);
  EXPECT_TRUE(eventually([&] { return !answers(*device); }));
  EXPECT_THAT(device->complaint(), HasSubstr("has not responded for 50 ms"));
  // Long before it is opened anew, unless this machine has looked away for as long.
  const std::size_t after = emulated.settings_sent().size();
  if (monotonic_now_ns() - fell_silent_ns < 900'000'000) {
    EXPECT_EQ(after, before);
  }
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, kDt_s).has_value());
  emulated.take_strongest_word();
  emulated.fall_silent(false);
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
  EXPECT_EQ(emulated.take_strongest_word(), 0);
}

TEST_F(Falcon, IsSilentAndNotFrozenWhileItTellsNothingNew) {
  EmulatedFalcon emulated(bus(), {});
  emulated.circle(0.03);  // at 0.19 m/s
  const auto device = open();
  EXPECT_TRUE(eventually([&] {
    const auto read = device->read(monotonic_now_ns());
    return read && glm::length(read->velocity_m_per_s) > 0.1;
  }));
  emulated.fall_silent(true);
  // A second by the clock of the tick, within the 50 ms for which the last reading stands.
  std::int64_t now_ns = monotonic_now_ns();
  for (int tick = 0; tick < 1000; ++tick) device->read(now_ns += 1'000'000);
  EXPECT_EQ(device->complaint().find("repeatedly"), std::string::npos) << device->complaint();
  EXPECT_TRUE(eventually([&] { return !answers(*device); }));
  EXPECT_THAT(device->complaint(), HasSubstr("has not responded for 50 ms"));
  EXPECT_EQ(device->complaint().find("repeatedly"), std::string::npos) << device->complaint();
}

TEST_F(Falcon, ComesBackAfterItWasUnpluggedWithoutForce) {
  EmulatedFalcon emulated(bus(), {.serial = "NF042"});
  const auto device = open();
  push_until(*device, {0.0, 0.0, 1.0}, [&] { return emulated.motor_words() != kNoWords; });
  EXPECT_TRUE(eventually([&] { return answers(*device) && device->complaint().empty(); }));
  emulated.unplug();
  EXPECT_TRUE(eventually([&] {
    return !answers(*device) && device->complaint().find("is unplugged") != std::string::npos;
  }));
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, kDt_s).has_value());
  emulated.plug_in();
  EXPECT_TRUE(eventually([&] { return answers(*device) && device->complaint().empty(); }));
  EXPECT_EQ(emulated.take_strongest_word(), 0);
  push_until(*device, {0.0, 0.0, 1.0}, [&] { return emulated.motor_words() != kNoWords; });
}

TEST_F(Falcon, LeavesItsNeighbourAloneWhenItWasUnplugged) {
  EmulatedFalcon ours(bus(), {.port = 2});
  EmulatedFalcon neighbour(bus(), {.port = 1});
  const auto device = open();
  ASSERT_TRUE(ours.is_held());
  ours.unplug();
  ASSERT_TRUE(eventually([&] { return !answers(*device); }));
  // Three searches for it; nobody knows that the neighbour, in another hand, would not be pushed.
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(700);
  while (std::chrono::steady_clock::now() < until) {
    EXPECT_FALSE(answers(*device));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ours.plug_in();
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
  // Not a word: a search may hold it for a moment, to see whether somebody does.
  EXPECT_EQ(neighbour.frames(), 0);
}

TEST_F(Falcon, IsLoadedAndHomedAgainWhenItWasWithoutPower) {
  EmulatedFalcon emulated(bus(), {.firmware = firmware()});
  FalconSettings wanted = settings();
  wanted.line.firmware = firmware();
  const auto device = FalconDevice::open(wanted);
  emulated.unplug();
  emulated.lose_power();
  emulated.plug_in();
  EXPECT_TRUE(eventually([&] { return text_of(emulated.last_frame()) == "<AAAAAAAAAAAAJA>"; }));
  EXPECT_FALSE(answers(*device));
  emulated.home();
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
}

TEST_F(Falcon, OutlivesErrorsOfTheBusInBursts) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  for (const int burst : {1, 2, 7, 60}) {
    emulated.fail_transfers(burst);
    const std::int64_t before = emulated.frames();
    EXPECT_TRUE(eventually([&] { return emulated.frames() > before + 3 && answers(*device); }));
  }
  EXPECT_TRUE(emulated.is_held());  // it was never opened anew
}

TEST_F(Falcon, FindsItsAnswersInNoise) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  emulated.babble({'<', 'A', 'A', 0x00, 0xff, '>'});
  emulated.put_grip({0.0, 0.010, 0.115});
  EXPECT_TRUE(eventually([&] {
    const auto read = device->read(monotonic_now_ns());
    return read && std::abs(read->position_m.z - 0.010) < 100e-6;
  }));
}

TEST_F(Falcon, IsNotLostWhileAHandHoldsItStill) {
  EmulatedFalcon emulated(bus(), {});
  const auto device = open();
  // 1.9 N for longer than a motor may push in vain.
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(1300);
  int lost_in_a_row = 0;
  while (std::chrono::steady_clock::now() < until) {
    lost_in_a_row = answers(*device) ? 0 : lost_in_a_row + 1;
    device->push({.force_N = {0.0, 0.0, 1.9}}, kDt_s);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(lost_in_a_row == 0 || eventually([&] { return answers(*device); }));
}

TEST_F(Falcon, IsLostWhenASecondOfForceMovesNothingUntilItMoves) {
  EmulatedFalcon emulated(bus(), {});
  FalconSettings wanted = settings();
  std::atomic<std::int64_t> now_ns{monotonic_now_ns()};
  wanted.line.clock = [&now_ns] { return now_ns.load(); };
  const auto device = FalconDevice::open(wanted);
  const auto is_there = [&] { return device->read(now_ns).has_value(); };
  const std::int64_t began_ns = now_ns;
  EXPECT_TRUE(eventually([&] {
    pass_step(now_ns, emulated);
    const bool is_lost = !is_there();
    device->push({.force_N = {0.0, 0.0, 3.0}}, 1e-9 * kStep_ns);
    return is_lost;
  }));
  EXPECT_GT(now_ns - began_ns, 1'000'000'000);
  EXPECT_THAT(device->complaint(), HasSubstr("repeatedly"));
  // Nothing pushes any more, frames come, and still it is lost: its encoders are not believed.
  const std::int64_t before = emulated.frames();
  EXPECT_TRUE(eventually([&] {
    EXPECT_FALSE(is_there());
    device->zero_force();
    return emulated.frames() > before + 100;
  }));
  emulated.put_grip({0.0, 0.001, 0.115});
  EXPECT_TRUE(eventually([&] {
    pass_step(now_ns, emulated);
    return is_there();
  }));
}

TEST_F(Falcon, DeclaresTheRateThatItReallyAnswersAt) {
  EmulatedFalcon emulated(bus(), {.rate_Hz = 100.0});
  const auto device = open();
  EXPECT_LE(device->capability().maximum_rate_Hz, 110.0);
  EXPECT_GT(device->capability().maximum_rate_Hz, 1.0);
}

TEST_F(Falcon, EndsAtOnceWhateverItsDeviceDoes) {
  EmulatedFalcon emulated(bus(), {.firmware = firmware()});
  auto device = open();
  emulated.fall_silent(true);
  EXPECT_TRUE(ends_soon(std::move(device)));
  emulated.fall_silent(false);
  device = open();
  emulated.unplug();
  EXPECT_TRUE(ends_soon(std::move(device)));
  emulated.plug_in();
  device = open();
  emulated.fail_transfers(1'000'000);
  EXPECT_TRUE(ends_soon(std::move(device)));
}

TEST_F(Falcon, LosesNothingInAMinuteWithThreeUnplugs) {
  run_stepped(bus(), std::chrono::minutes(1), 3);
}

TEST_F(Falcon, ReadsAndPushesWithoutTouchingTheHeap) {
  EmulatedFalcon emulated(bus(), {});
  emulated.circle(0.01);
  const auto device = open();
  EXPECT_TRUE(eventually([&] { return answers(*device); }));
  AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    device->read(monotonic_now_ns());
    device->push({.force_N = {9.0, 9.0, 9.0}}, kDt_s);
  }
  device->zero_force();
  EXPECT_EQ(guard.count(), 0);
}

TEST(FalconFirmware, IsNotReadFromAPipe) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "firmware").c_str(), 0600), 0);
  EXPECT_THAT(refusal_of<std::runtime_error>([&] { falcon::read_firmware(folder / "firmware"); }),
              testing::AllOf(testing::HasSubstr((folder / "firmware").string()),
                             testing::HasSubstr("cannot be read")));
}

}  // namespace
}  // namespace asperity
