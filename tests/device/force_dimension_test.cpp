// The driver of Force Dimension's devices, unmodified, against a library with the same functions and answers.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/force_dimension/force_dimension_device.h"
#include "device/small_turn.h"
#include "device/units_in_use.h"
#include "device/vendor_library.h"
#include "tests/device/ticks.h"
#include "tests/device/vendors/test_dhd.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/patience.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ForceDimension : public testing::Test {
 protected:
  ForceDimension() : library_("the stand-in", {ASPERITY_TEST_DRD}) {
    TestDhdBench bench_of = nullptr;
    library_.find("test_dhd_bench", bench_of);
    TestDhdLock lock_of = nullptr;
    library_.find("test_dhd_lock", lock_of);
    *bench_of() = test_dhd::Bench{};
    bench = test_dhd::SharedBench(bench_of(), lock_of());
  }

  test_dhd::Unit& attach(int type, unsigned short serial) {
    bench->units.push_back({.type = type, .serial = serial});
    return bench->units.back();
  }
  std::unique_ptr<ForceDimensionDevice> open(const ForceDimensionDevice::MayMove& may_move = {}) {
    return std::make_unique<ForceDimensionDevice>(
        std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 0, may_move);
  }

  // As with somebody beside it who is told and says yes.
  const ForceDimensionDevice::MayMove agrees = [this](const std::string& sentence) {
    told = sentence;
    bench->calls.push_back("asked");
    return true;
  };

  const Driver driver = force_dimension_driver();
  const DriverOptions options{.library = ASPERITY_TEST_DRD};
  std::string told{};
  test_dhd::SharedBench bench{};

 private:
  VendorLibrary library_;
};

TEST_F(ForceDimension, TellsWhatItNeedsWhenThereIsNoLibrary) {
  const DriverSurvey survey = driver.find({.library = "/no/such/libdhd.so"});
  EXPECT_THAT(survey.blocker,
              AllOf(HasSubstr("Force Dimension's SDK is not installed"), HasSubstr("/no/such")));
  EXPECT_THAT(refusal_of([&] { driver.open("", {.library = "/no/such/libdhd.so"}); }),
              HasSubstr("not installed"));
}

TEST_F(ForceDimension, TellsWhichFunctionAnotherVersionLacks) {
  EXPECT_THAT(
      driver.find({.library = ASPERITY_TEST_OLD_DHD}).blocker,
      AllOf(HasSubstr("dhdSetForceAndTorqueAndGripperForce"), HasSubstr("not the version")));
}

TEST_F(ForceDimension, FindsTwoAlikeByTheirSerialNumbers) {
  attach(33, 101);
  attach(33, 202);
  const DriverSurvey survey = driver.find(options);
  EXPECT_THAT(survey.found, AllOf(HasSubstr("libdrd 3.17.5"), HasSubstr("drd")));
  ASSERT_EQ(survey.attached.size(), 2U);
  EXPECT_EQ(survey.attached[1].model, "omega.3");
  EXPECT_EQ(survey.attached[1].serial, "202");
  EXPECT_EQ(survey.attached[1].place, "dhd 1");
  EXPECT_THAT(survey.attached[1].remark, HasSubstr("confirmation is requested before it moves"));
  EXPECT_FALSE(bench->units[0].is_open);
  EXPECT_FALSE(bench->units[1].is_open);

  EXPECT_THAT(refusal_of([&] { driver.open("", options); }),
              AllOf(HasSubstr("serial 101"), HasSubstr("serial 202")));
  const auto device = driver.open("202", options);
  EXPECT_EQ(device->capability().serial, "202");
  EXPECT_EQ(device->capability().model, "omega.3");
  EXPECT_FALSE(bench->units[0].is_open);
  EXPECT_TRUE(bench->units[1].is_open);
}

TEST_F(ForceDimension, LeavesADeviceThatThisProgramUsesAlone) {
  attach(33, 101);
  attach(33, 202);
  const auto device = driver.open("202", options);
  bench->calls.clear();
  const DriverSurvey survey = driver.find(options);
  ASSERT_EQ(survey.attached.size(), 2U);
  EXPECT_EQ(survey.attached[0].serial, "202");
  EXPECT_THAT(survey.attached[0].blocker, HasSubstr("This program uses it"));
  EXPECT_EQ(survey.attached[1].place, "dhd 0");
  EXPECT_THAT(survey.attached[1].blocker, HasSubstr("in use"));
  EXPECT_THAT(refusal_of([&] { driver.open("202", options); }), HasSubstr("uses it now"));
  EXPECT_THAT(bench->calls, IsEmpty());
  EXPECT_TRUE(bench->units[1].is_open);
}

TEST_F(ForceDimension, LeavesADeviceThatAnotherProgramUsesAlone) {
  attach(33, 101);
  bench->in_use_elsewhere = 1;
  const DriverSurvey survey = driver.find(options);
  ASSERT_EQ(survey.attached.size(), 1U);
  EXPECT_THAT(survey.attached[0].blocker, HasSubstr("in use"));
  EXPECT_THAT(bench->calls, IsEmpty());
}

TEST_F(ForceDimension, RefusesAKindThatItDoesNotKnow) {
  attach(77, 5);
  EXPECT_THAT(driver.find(options).attached.at(0).blocker, HasSubstr("system type 77"));
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("system type 77"));
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, KnowsWhatEachModelCanDo) {
  const auto capability = [](int type) { return dhd_model_of(type).value().capability; };
  EXPECT_EQ(capability(63).model, "delta.3");
  EXPECT_EQ(capability(63).peak_force_N, 20.0);
  EXPECT_EQ(capability(63).sensed_degrees_of_freedom, 3);
  EXPECT_EQ(capability(34).model, "omega.6");
  EXPECT_EQ(capability(34).sensed_degrees_of_freedom, 6);
  EXPECT_EQ(capability(34).actuated_degrees_of_freedom, 3);
  EXPECT_EQ(capability(104).model, "sigma.7");
  EXPECT_EQ(capability(104).actuated_degrees_of_freedom, 6);
  EXPECT_EQ(capability(108).model, "lambda.7");
  EXPECT_THAT(capability(108).remarks, HasSubstr("lambda.7"));  // its figures are borrowed
  EXPECT_FALSE(dhd_model_of(-1).has_value());
}

TEST_F(ForceDimension, MovesToFindItsZeroOnlyWhenItHasLostItAndSomebodyAgrees) {
  attach(33, 101);
  open(agrees);
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
  EXPECT_EQ(told, "");
  bench->units[0].knows_its_zero = false;
  bench->calls.clear();
  open(agrees);
  EXPECT_THAT(told, AllOf(HasSubstr("omega.3 101 will move by itself"),
                          HasSubstr("make sure that it is not held")));
  EXPECT_THAT(bench->calls,
              ElementsAre("dhdOpenID 0", "asked", "drdOpenID 0", "drdAutoInit 3",
                          "drdStop with force 3", "dhdStop 3", "drdClose 3", "dhdClose 3"));
}

TEST_F(ForceDimension, IsNotMovedWhereNobodyWasAskedOrSomebodySaidNo) {
  attach(33, 101).knows_its_zero = false;
  EXPECT_THAT(refusal_of([&] { driver.open("", options); }),
              AllOf(HasSubstr("omega.3 101 has lost its zero"),
                    HasSubstr("asperity device-test force_dimension:101"), HasSubstr("manual")));
  EXPECT_THAT(refusal_of([&] { open([](const std::string&) { return false; }); }),
              AllOf(HasSubstr("was not moved"), HasSubstr("was not confirmed")));
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
  EXPECT_FALSE(bench->units[0].is_open);
}

// Somebody may take minutes to answer. A look that opened the device to ask its name would close it under the question.
TEST_F(ForceDimension, KeepsNobodyFromLookingWhileItAsksAndIsNotTouchedByTheLook) {
  attach(33, 101).knows_its_zero = false;
  attach(33, 202);
  DriverRegistry drivers;
  drivers.add(driver);
  std::vector<AttachedDevice> found;
  std::string refusal;
  bool has_looked = false;
  std::thread other;
  DriverOptions asks = options;
  asks.may_move = [&](const std::string&) {
    bench->calls.push_back("asked");
    std::packaged_task<void()> look([&] {
      found = drivers.survey(driver, options).attached;
      refusal = refusal_of([&] { drivers.open("force_dimension:101", options); });
    });
    std::future<void> looked = look.get_future();
    std::thread(std::move(look)).swap(other);
    has_looked = looked.wait_for(kPatience) == std::future_status::ready;
    bench->calls.push_back("answered");
    return true;
  };
  const auto device = drivers.open("force_dimension:101", asks);
  other.join();
  EXPECT_TRUE(has_looked);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].blocker, HasSubstr("uses it now"));
  EXPECT_THAT(found[1].blocker, HasSubstr("is in use"));
  EXPECT_THAT(refusal, HasSubstr("uses it now"));
  const std::vector<std::string> calls = bench->calls;
  const auto asked = std::find(calls.begin(), calls.end(), "asked");
  ASSERT_NE(asked, calls.end());
  EXPECT_EQ(*(asked + 1), "answered") << "nothing was asked of the SDK in between";
  EXPECT_TRUE(bench->units[0].knows_its_zero);
}

TEST_F(ForceDimension, IsNotMovedOnceAStopCameAfterTheYes) {
  attach(33, 101).knows_its_zero = false;
  std::stop_source stop;
  const auto says_yes_and_stops = [&stop](const std::string&) {
    stop.request_stop();
    return true;
  };
  EXPECT_THROW(ForceDimensionDevice(std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 0,
                                    says_yes_and_stops, stop.get_token()),
               OpeningStopped);
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
  EXPECT_FALSE(bench->units[0].is_open);
}

// As libdrd, whose search hears of no stop: what ends it is its force that is off and its regulation that is.
class MovingForceDimension : public ForceDimension {
 protected:
  MovingForceDimension() {
    test_dhd::Unit& unit = attach(33, 101);
    unit.knows_its_zero = false;
    unit.searches_on = true;
  }
  /// Opens it and stops once it moves.
  std::unique_ptr<ForceDimensionDevice> open_and_stop(const ForceDimensionDevice::Tell& tell = {}) {
    std::stop_source stop;
    std::jthread stopping([&](const std::stop_token& opening_ended) {
      while (!moves() && !opening_ended.stop_requested()) std::this_thread::yield();
      stop.request_stop();
    });
    return std::make_unique<ForceDimensionDevice>(sdk, 0, agrees, stop.get_token(), tell);
  }

  const std::shared_ptr<DhdFunctions> sdk = std::make_shared<DhdFunctions>(ASPERITY_TEST_DRD);

 private:
  bool moves() {
    const auto held = bench.operator->();
    return !held->units.empty() && held->units[0].regulation_is_on;
  }
};

TEST_F(MovingForceDimension, IsStoppedWhereItMovesAndHasNoForceThen) {
  bench->axes_to_search = 2;  // and its force is on again for each
  EXPECT_THAT(refusal_of<OpeningStopped>([&] { open_and_stop(); }),
              AllOf(HasSubstr("omega.3 101 was stopped on request while it moved"),
                    HasSubstr("its force is off")));
  EXPECT_EQ(bench->stops_heard, 3);
  EXPECT_FALSE(bench->units[0].force_is_on);
  EXPECT_FALSE(bench->units[0].regulation_is_on);
  EXPECT_FALSE(bench->units[0].is_open);
  const std::vector<std::string> calls = bench->calls;
  const auto at_rest = std::find(calls.begin(), calls.end(), "at rest 3");
  ASSERT_NE(at_rest, calls.end());
  EXPECT_EQ(std::find(calls.begin(), at_rest, "drdStop with force 3"), at_rest);
  EXPECT_EQ(std::find(calls.begin(), calls.end(), "drdStop with force 3"), calls.end())
      << "which would leave its force on";
  EXPECT_EQ(std::find(calls.begin(), at_rest, "drdClose 3"), at_rest) << "while it still moved";
}

TEST_F(MovingForceDimension, TellsWhatToDoWhereTheSdkContinuesAlthoughItWasStopped) {
  constexpr int kOnAndOn = 1'000'000'000;
  bench->axes_to_search = kOnAndOn;
  std::vector<std::string> sentences;
  EXPECT_THROW(open_and_stop([&](const std::string& sentence) {
                 sentences.push_back(sentence);
                 bench->axes_to_search = 1;
               }),
               OpeningStopped);
  EXPECT_THAT(sentences, ElementsAre(AllOf(HasSubstr("still moves omega.3 101"),
                                           HasSubstr("switch the device off"))));
}

// Whatever of the SDK hangs is what somebody has to be told of; and a force that comes on again is taken away meanwhile.
TEST_F(MovingForceDimension, TellsWhatToDoWhereACallThatStopsItDoesNotReturn) {
  for (const std::string function : {"dhdStop", "drdStop"}) {
    bench->blocks = function;
    bench->calls.clear();
    const auto calls_of_other = [&] {
      const std::string other = function == "dhdStop" ? "drdStop 3" : "dhdStop 3";
      const std::vector<std::string> calls = bench->calls;
      return std::count(calls.begin(), calls.end(), other);
    };
    bool was_blocked = false;
    long others = 0;
    std::jthread gives_in([&](const std::stop_token& ended) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any never;
      never.wait_for(lock, ended, kPatience, [] { return false; });
      bench->blocks.clear();
    });
    EXPECT_THROW(open_and_stop([&](const std::string& sentence) {
                   was_blocked = bench->blocks == function;
                   EXPECT_THAT(sentence, HasSubstr("switch the device off"));
                   while (bench->blocks == function && calls_of_other() < 2) {
                     std::this_thread::yield();
                   }
                   others = calls_of_other();
                   bench->blocks.clear();
                 }),
                 OpeningStopped);
    EXPECT_TRUE(was_blocked) << function << " returned before anybody was told";
    EXPECT_GE(others, 2) << "the other one waited for " << function;
  }
}

// That it is stopped must not hide that it may still move.
TEST_F(MovingForceDimension, SaysThatTheSdkDoesNotLetGoThoughItWasStopped) {
  bench->stop_answer = -1;
  bench->goes_on = true;
  EXPECT_THAT(refusal_of([&] { open_and_stop(); }),
              AllOf(HasSubstr("does not release omega.3 101"), HasSubstr("switch the device off")));
}

// An SDK may refuse to stop what is stopped already.
TEST_F(MovingForceDimension, IsLetGoOfWhereItsRegulationIsOffThoughTheLastStopWasRefused) {
  bench->stop_answer = -1;
  EXPECT_THROW(open_and_stop(), OpeningStopped);
}

TEST_F(MovingForceDimension, SaysWhatTheSdkDidNotConfirmWhereItCannotBeAsked) {
  bench->stop_answer = -1;
  sdk->drdIsRunning = nullptr;
  EXPECT_THAT(refusal_of([&] { open_and_stop(); }),
              AllOf(HasSubstr("did not confirm that it stopped"), Not(HasSubstr("may still move")),
                    HasSubstr("switch the device off")));
}

/// Another thread that looks for devices, from when it is made until it is told that it is enough.
class LongLook final {
 public:
  /// `begun` is called once it looks.
  explicit LongLook(std::function<void()> begun, std::chrono::milliseconds longest) {
    std::promise<void> holds;
    std::future<void> is_held = holds.get_future();
    thread_ = std::thread([this, longest, begun = std::move(begun), holds = std::move(holds),
                           enough = enough_.get_future()]() mutable {
      const std::lock_guard alone(UnitInUse::looking());
      holds.set_value();
      if (begun) begun();
      was_told_ = enough.wait_for(longest) == std::future_status::ready;
    });
    is_held.wait();
  }
  /// Whether it was told before the longest time was over.
  bool end() {
    enough_.set_value();
    thread_.join();
    return was_told_;
  }

 private:
  std::promise<void> enough_{};
  std::thread thread_{};
  bool was_told_ = false;
};

TEST_F(ForceDimension, HearsAStopWhileAnotherThreadLooksAfterTheYes) {
  attach(33, 101).knows_its_zero = false;
  DriverRegistry drivers;
  drivers.add(driver);
  std::stop_source stop;
  std::unique_ptr<LongLook> look{};
  DriverOptions asks = options;
  asks.stop = stop.get_token();
  asks.may_move = [&](const std::string&) {
    const auto stop_later = [&stop] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      stop.request_stop();
    };
    look = std::make_unique<LongLook>(stop_later, kPatience);
    return true;
  };
  EXPECT_THROW(drivers.open("force_dimension", asks), OpeningStopped);
  ASSERT_NE(look, nullptr);
  EXPECT_TRUE(look->end()) << "it waited for the look and not for the stop";
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, IsNotMovedLongAfterTheYes) {
  attach(33, 101).knows_its_zero = false;
  DriverRegistry drivers;
  drivers.add(driver);
  std::unique_ptr<LongLook> look{};
  DriverOptions asks = options;
  asks.may_move = [&](const std::string&) {
    look = std::make_unique<LongLook>(nullptr, std::chrono::milliseconds(1500));
    return true;
  };
  EXPECT_THAT(refusal_of([&] { drivers.open("force_dimension", asks); }),
              AllOf(HasSubstr("was not moved"), HasSubstr("confirm again")));
  ASSERT_NE(look, nullptr);
  EXPECT_FALSE(look->end());
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, RefusesADeviceThatTheSdkDoesNotLetGoOf) {
  attach(33, 101).knows_its_zero = false;
  bench->stop_answer = -1;
  bench->goes_on = true;
  EXPECT_THAT(refusal_of([&] { open(agrees); }),
              AllOf(HasSubstr("does not release omega.3 101"), HasSubstr("the regulation goes on"),
                    HasSubstr("switch the device off")));
  EXPECT_FALSE(bench->units[0].is_open);
}

// The SDK opens by place and speaks to what is open by ID: mixed up, the neighbour would move.
TEST_F(ForceDimension, FindsTheZeroOfTheOneThatWasAskedFor) {
  attach(33, 101);
  attach(33, 202).knows_its_zero = false;
  attach(33, 303);
  DriverOptions with_somebody = options;
  with_somebody.may_move = agrees;
  EXPECT_EQ(driver.open("202", with_somebody)->capability().serial, "202");
  EXPECT_TRUE(bench->units[1].knows_its_zero);
  EXPECT_THAT(bench->calls, Contains("drdAutoInit 5"));
  for (const test_dhd::Unit& unit : bench->units) EXPECT_FALSE(unit.is_open);
}

TEST_F(ForceDimension, RefusesADeviceThatDoesNotFindItsZero) {
  test_dhd::Unit& unit = attach(33, 101);
  unit.knows_its_zero = false;
  unit.finds_its_zero = false;
  EXPECT_THAT(refusal_of([&] { open(agrees); }),
              AllOf(HasSubstr("omega.3 101"), HasSubstr("the handle was held"),
                    HasSubstr("open the device again")));
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, AsksForLibdrdWhereOnlyThatCanFindTheZero) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DHD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  *bench_of() = test_dhd::Bench{};
  bench_of()->units.push_back({.type = 33, .serial = 7, .knows_its_zero = false});
  EXPECT_THAT(refusal_of([&] { driver.open("", {.library = ASPERITY_TEST_DHD}); }),
              HasSubstr("install libdrd"));
  bench_of()->units[0].knows_its_zero = true;
  EXPECT_EQ(driver.open("", {.library = ASPERITY_TEST_DHD})->capability().serial, "7");
}

TEST_F(ForceDimension, TellsThePoseInOurFrame) {
  test_dhd::Unit& unit = attach(34, 1);
  // 10 mm towards the participant, 20 mm to their right, 30 mm up; turned by +90° about the axis that
  // points towards them: what pointed right points up.
  const double position_m[3] = {0.010, 0.020, 0.030};
  const double frame[3][3] = {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
  std::copy_n(position_m, 3, unit.position_m);
  for (int i = 0; i < 3; ++i) std::copy_n(frame[i], 3, unit.frame[i]);
  unit.buttons = 1;
  const auto device = open();
  const ProbeState state = device->read(0).value();
  EXPECT_EQ(state.position_m, glm::dvec3(0.020, -0.010, 0.030));
  EXPECT_EQ(state.buttons, 1U);
  // Towards the participant is −y of ours: the turn is by −90° about y.
  const glm::dvec3 turn_rad = small_turn_rad(glm::dquat(1.0, 0.0, 0.0, 0.0), state.orientation);
  EXPECT_NEAR(glm::distance(turn_rad, glm::dvec3(0.0, -std::acos(0.0), 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(
      glm::distance(state.orientation * glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)), 0.0,
      1e-12);
}

TEST_F(ForceDimension, TakesItsGrippersSqueezeForTheSecondButtonAndGivesItNoForce) {
  attach(35, 7).buttons = 3;  // what the SDK may say in the gripper's place does not count
  const auto device = open();
  EXPECT_EQ(device->capability().buttons, 2);
  std::int64_t now_ns = 0;
  const auto buttons_at = [&](double angle_rad) {
    bench->units[0].gripper_rad = angle_rad;
    now_ns += kMillisecond_ns;
    return device->read(now_ns).value().buttons;
  };
  EXPECT_EQ(buttons_at(0.50), 1U) << "open";
  EXPECT_EQ(buttons_at(0.20), 1U) << "11.5 degrees: not yet";
  EXPECT_EQ(buttons_at(0.17), 3U) << "9.7 degrees";
  EXPECT_EQ(buttons_at(0.25), 3U) << "14.3 degrees: still";
  EXPECT_EQ(buttons_at(0.27), 1U) << "15.5 degrees";
  EXPECT_EQ(buttons_at(-0.17), 3U) << "for the left hand";
  EXPECT_EQ(buttons_at(std::nan("")), 3U) << "as it was";
  device->push({.force_N = {1.0, 0.0, 0.0}}, 1e-3);
  EXPECT_EQ(bench->units[0].sent[6], 0.0);
  EXPECT_FALSE(dhd_model_of(34).value().has_gripper);
}

TEST_F(ForceDimension, HasNoGripperWhereTheLibraryTellsOfNone) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DHD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  *bench_of() = test_dhd::Bench{};
  bench_of()->units.push_back({.type = 35, .serial = 7, .buttons = 1});
  const auto device = driver.open("", {.library = ASPERITY_TEST_DHD});
  EXPECT_EQ(device->capability().buttons, 1);
  EXPECT_EQ(device->read(0).value().buttons, 1U);
}

TEST_F(ForceDimension, EstimatesVelocitiesItself) {
  attach(34, 1);
  const auto device = open();
  ProbeState state;
  for (int i = 0; i < 20; ++i) {  // 0.1 m/s to the right, 2 rad/s about the upward axis
    test_dhd::Unit& unit = bench->units[0];
    unit.position_m[1] = 0.0001 * i;
    const double angle_rad = 0.002 * i;
    unit.frame[0][0] = unit.frame[1][1] = std::cos(angle_rad);
    unit.frame[1][0] = std::sin(angle_rad);
    unit.frame[0][1] = -unit.frame[1][0];
    state = device->read(i * kMillisecond_ns).value();
  }
  EXPECT_NEAR(glm::distance(state.velocity_m_per_s, glm::dvec3(0.1, 0.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(state.angular_velocity_rad_per_s, glm::dvec3(0.0, 0.0, 2.0)), 0.0,
              1e-9);
}

TEST_F(ForceDimension, DoesNotTakeAGuardedReadingForANewOne) {
  attach(33, 1);
  const auto device = open();
  ProbeState state;
  for (int i = 0; i < 20; ++i) {
    const bool guarded = i % 2 == 1;
    if (!guarded) bench->units[0].position_m[1] = 0.0001 * i;
    bench->read_answer = guarded ? 1 : 0;
    state = device->read(i * kMillisecond_ns).value();
    EXPECT_EQ(state.time_ns, i * kMillisecond_ns);
  }
  EXPECT_NEAR(state.velocity_m_per_s.x, 0.1, 1e-12);  // as if the guarded ones had not been
}

TEST_F(ForceDimension, IsLostWhenNothingNewCameForFiftyMilliseconds) {
  attach(33, 1);
  const auto device = open();
  EXPECT_TRUE(device->read(0).has_value());
  bench->read_answer = 1;
  EXPECT_TRUE(device->read(50 * kMillisecond_ns).has_value());
  EXPECT_EQ(device->trouble(), "");
  EXPECT_FALSE(device->read(51 * kMillisecond_ns).has_value());
  EXPECT_THAT(device->trouble(), HasSubstr("nothing new for 50 ms"));
  bench->read_answer = 0;
  EXPECT_TRUE(device->read(52 * kMillisecond_ns).has_value());
  EXPECT_EQ(device->trouble(), "");
}

TEST_F(ForceDimension, IsBelievedWhileItsReadingsRepeatThoughTheLastOneMoved) {
  attach(33, 1);
  const auto device = open();
  std::int64_t tick = 0;
  for (; tick < 20; ++tick) {  // 1 m/s to the right
    bench->units[0].position_m[1] = 0.001 * static_cast<double>(tick);
    EXPECT_TRUE(device->read(tick * kMillisecond_ns).has_value());
  }
  bench->read_answer = 1;
  for (; tick < 65; ++tick) EXPECT_TRUE(device->read(tick * kMillisecond_ns).has_value()) << tick;
  EXPECT_EQ(device->complaint(), "");
}

TEST_F(ForceDimension, SendsForceAndTorqueInTheDevicesFrame) {
  attach(104, 1);
  const auto device = open();
  device->set_limits({.slew_N = 1e6, .slew_N_m = 1e6});
  ASSERT_TRUE(device->push({.force_N = {1.0, 2.0, 3.0}, .torque_N_m = {0.01, 0.02, 0.03}}, 1e-3));
  EXPECT_THAT(bench->units[0].sent, ElementsAre(-2.0, 1.0, 3.0, -0.02, 0.01, 0.03, 0.0));
}

TEST_F(ForceDimension, NeverSendsMoreThanTheModelGives) {
  attach(33, 1);
  const auto device = open();
  device->set_limits({.force_N = 100.0, .torque_N_m = 0.1, .slew_N = 1e6});
  device->push({.force_N = {0.0, 0.0, 80.0}}, 1e-3);
  EXPECT_NEAR(bench->units[0].sent[2], 12.0, 1e-12);
}

TEST_F(ForceDimension, TellsOfSaturatedMotorsInTheRecordAndInWordsWhileTheyAre) {
  attach(33, 1);
  const auto device = open();
  const auto push = [&] { return device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).value(); };
  EXPECT_FALSE(push().has(LimitReason::force));
  for (const int times : {2, 3}) {
    bench->send_answer = 2;
    for (int i = 0; i < times; ++i) {
      const LimitedWrench sent = push();
      EXPECT_TRUE(sent.has(LimitReason::force));
      EXPECT_EQ(sent.wrench.force_N.z, 1.0);  // how much less, nobody knows
    }
    EXPECT_THAT(device->trouble(),
                HasSubstr("less force than requested on " + std::to_string(times) + " occasions"));
    bench->send_answer = 0;
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(push().has(LimitReason::force));
    EXPECT_NE(device->trouble(), "");
    for (int i = 0; i < 1100; ++i) push();
    EXPECT_EQ(device->trouble(), "");
  }
}

TEST_F(ForceDimension, SaysWhyADeviceThatVanishedDoesNotAnswer) {
  attach(33, 101);
  const auto device = open();
  EXPECT_TRUE(device->read(0).has_value());
  bench->is_there = false;
  EXPECT_FALSE(device->read(kMillisecond_ns).has_value());
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
  EXPECT_THAT(device->trouble(),
              AllOf(HasSubstr("omega.3 101 does not respond"), HasSubstr("dhdGetPosition"),
                    HasSubstr("device disconnected")));
  bench->is_there = true;
  EXPECT_TRUE(device->read(2 * kMillisecond_ns).has_value());
  EXPECT_EQ(device->trouble(), "");
}

// One of two alike that was unplugged and plugged in again under a servo.
class UnpluggedForceDimension : public ForceDimension {
 protected:
  UnpluggedForceDimension() {
    attach(33, 100);
    attach(33, 101);
    device = std::make_unique<ForceDimensionDevice>(
        std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 1);
    device->set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
    EXPECT_TRUE(answers());
    EXPECT_TRUE(pushes());
  }
  bool answers() { return device->read(now_ns += kMillisecond_ns).has_value(); }
  bool pushes() { return device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value(); }
  void unplug() {
    bench->is_there = false;
    for (int i = 0; i < 250; ++i) EXPECT_FALSE(answers());
    EXPECT_FALSE(pushes());
  }
  void plug_in() {
    bench->calls.clear();
    bench->is_there = true;
    while (!answers()) std::this_thread::yield();
  }

  std::unique_ptr<ForceDimensionDevice> device{};
  std::int64_t now_ns = 0;
};

TEST_F(UnpluggedForceDimension, IsGoneOnWithWithoutATouchToItsNeighbour) {
  unplug();
  bench->units[1].force_is_on = false;
  bench->units[1].force_off_cause = 5;  // its USB connection broke
  plug_in();
  EXPECT_EQ(device->trouble(), "");
  EXPECT_TRUE(pushes());
  EXPECT_EQ(bench->units[1].sent[2], 1.0);  // the same one, not its neighbour
  EXPECT_FALSE(bench->units[1].was_enabled_with_force);
  EXPECT_THAT(bench->calls,
              AllOf(Contains("dhdOpenSerial 1"), Not(Contains(HasSubstr("dhdOpenID")))));
}

TEST_F(UnpluggedForceDimension, IsLookedForByOpeningOthersOnlyWhereNobodyUsesOne) {
  bench->opens_by_serial = false;
  unplug();
  bench->in_use_elsewhere = 1;
  bench->calls.clear();
  bench->is_there = true;
  // Long enough for some looks of the driver's; too short a time would pass, and tell nothing.
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  EXPECT_FALSE(answers());
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("dhdOpenID"))));
  bench->in_use_elsewhere = 0;
  while (!answers()) std::this_thread::yield();
  EXPECT_TRUE(pushes());
  EXPECT_EQ(bench->units[1].sent[2], 1.0);
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(UnpluggedForceDimension, StaysWithoutForceWhereAPersonOrTheGuardHadSwitchedItOff) {
  for (const int cause : {1, 2, 6}) {
    bench->units[1].force_is_on = false;
    bench->units[1].force_off_cause = cause;
    EXPECT_TRUE(answers());
    EXPECT_FALSE(pushes());
    unplug();
    bench->units[1].force_off_cause = 5;  // which the unit now holds for the reason
    bench->units[1].sent[2] = 1.0;        // what it was asked for before
    plug_in();
    EXPECT_EQ(bench->units[1].sent[2], 0.0);
    EXPECT_FALSE(pushes());
    EXPECT_FALSE(bench->units[1].force_is_on);
    bench->units[1].force_is_on = true;  // the person's button
    EXPECT_TRUE(answers());
    EXPECT_TRUE(pushes());
  }
  unplug();
  bench->units[1].force_is_on = false;
  bench->units[1].force_off_cause = 1;  // pressed while it was away
  plug_in();
  EXPECT_FALSE(pushes());
  EXPECT_THAT(device->trouble(), HasSubstr("force button was pressed"));
}

TEST_F(ForceDimension, DoesNotMoveADeviceThatIsBackWithoutItsZero) {
  attach(33, 101);
  auto device = open();
  std::int64_t now_ns = 0;
  EXPECT_TRUE(device->read(now_ns).has_value());
  bench->is_there = false;
  for (int i = 0; i < 250; ++i) device->read(now_ns += kMillisecond_ns);
  bench->units[0].knows_its_zero = false;  // it was without power
  bench->is_there = true;
  while (device->trouble().find("lost its zero") == std::string::npos) std::this_thread::yield();
  EXPECT_FALSE(device->read(now_ns += kMillisecond_ns).has_value());
  bench->is_there = false;  // and gone again: nothing is known of its zero any more
  while (device->trouble().find("lost its zero") != std::string::npos) std::this_thread::yield();
  EXPECT_THAT(device->trouble(), HasSubstr("does not respond"));
  device.reset();
  EXPECT_THAT(bench->calls, Not(Contains(HasSubstr("drdAutoInit"))));
}

TEST_F(ForceDimension, RefusesToPushWhileTheForceIsOffAndSaysWhatSwitchedItOff) {
  attach(33, 101);
  const auto device = open();
  device->read(0);
  EXPECT_TRUE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
  bench->units[0].force_is_on = false;
  bench->units[0].force_off_cause = 2;
  device->read(kMillisecond_ns);  // in the very next tick
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
  EXPECT_EQ(bench->units[0].sent[2], 0.0);  // nothing to give when it is switched on
  EXPECT_THAT(device->trouble(),
              AllOf(HasSubstr("force of omega.3 101 is off"), HasSubstr("velocity guard")));
  bench->units[0].force_is_on = true;
  device->read(2 * kMillisecond_ns);
  EXPECT_TRUE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
  EXPECT_EQ(device->trouble(), "");
}

TEST_F(ForceDimension, SeesAForceThatIsOffForOneTickWhileReadingsRepeat) {
  attach(33, 101);
  const auto device = open();
  device->read(0);
  bench->read_answer = 1;
  bench->units[0].force_is_on = false;
  device->read(kMillisecond_ns);
  EXPECT_FALSE(device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
}

TEST_F(ForceDimension, SwitchesItsForceOnAtZeroOrRefuses) {
  attach(33, 101);
  {
    const auto device = open();
    EXPECT_TRUE(bench->units[0].force_is_on);
    EXPECT_FALSE(bench->units[0].was_enabled_with_force);
  }
  bench->enable_answer = -1;
  EXPECT_THAT(refusal_of([&] { open(); }),
              AllOf(HasSubstr("the force of omega.3 101 cannot be switched on"),
                    HasSubstr("it has no power")));
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, BeginsAndEndsAtZeroForceAndLetsGo) {
  attach(33, 1);
  {
    const auto device = open();
    EXPECT_THAT(bench->units[0].sent, ElementsAre(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    device->push({.force_N = {1.0, 0.0, 0.0}}, 1e-3);
    EXPECT_NE(bench->units[0].sent[1], 0.0);
  }
  EXPECT_THAT(bench->units[0].sent, ElementsAre(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
  EXPECT_TRUE(bench->units[0].is_stopped);
  EXPECT_FALSE(bench->units[0].is_open);
}

TEST_F(ForceDimension, DoesNotTouchTheHeapInATick) {
  attach(104, 1);
  const auto device = open();
  AllocationGuard guard;
  for (int i = 0; i < 300; ++i) {
    bench->read_answer = i % 3 == 2 ? 1 : 0;
    bench->is_there = i != 250;
    device->read(i * kMillisecond_ns);
    device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3);
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
