// A program that is killed while it drives a device that only a library of its manufacturer reaches, and the process that then
// closes the device; and a library that does not return.

#include <csignal>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// Stand-ins for both libraries, of which a test sees the calls and the wire.
class DeviceOfALibrary : public testing::Test {
 protected:
  Invocation invocation(std::vector<std::string> arguments,
                        const char* library = ASPERITY_TEST_DRD) const {
    arguments.insert(arguments.end(), {"--library", library});
    Invocation invocation{};
    invocation.arguments = std::move(arguments);
    invocation.environment = {{"ASPERITY_TEST_DHD_ATTACHED", "101"},
                              {"ASPERITY_TEST_DHD_CALLS", calls_.string()},
                              {"ASPERITY_TEST_DHD_WIRE", wire_.string()},
                              {"ASPERITY_TEST_HD_CALLS", calls_.string()},
                              // A device with this number may be driven in another test.
                              {"XDG_RUNTIME_DIR", folder_.path().string()}};
    return invocation;
  }
  Invocation closing() const {
    return invocation(
        {"close-device", "force_dimension:101", "--claim", "force_dimension", "--within", "1"});
  }
  std::string calls() const { return fs::exists(calls_) ? text_of(calls_) : ""; }
  std::string wire() const { return fs::exists(wire_) ? text_of(wire_) : ""; }

 private:
  const TemporaryFolder folder_{};
  const fs::path calls_ = folder_ / "calls.txt";
  const fs::path wire_ = folder_ / "wire.txt";
};

class KilledProgram : public DeviceOfALibrary {};
class CloseDevice : public DeviceOfALibrary {};
class HangingDriver : public DeviceOfALibrary {};

TEST_F(KilledProgram, HasItsDeviceClosedAtZeroForceByAnotherProcess) {
  const SmallStudy small(1);
  Invocation session =
      invocation({"run", small.recognition(), "--study", small.study(), "--participant", "anna",
                  "--mode", "pilot", "--device", "force_dimension"});
  session.on_terminal = true;
  Program program(session);
  ASSERT_TRUE(program.read_until([](const std::string& out, const std::string&) {
    return out.ends_with("Your answer: ");
  })) << program.err();
  EXPECT_EQ(calls().find("dhdStop"), std::string::npos) << "the program has it open";
  EXPECT_EQ(wire(), "zero\n");
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().signal, SIGKILL);
  // With its brakes on; its handle does not fall.
  EXPECT_TRUE(eventually([&] {
    return calls().find("dhdStop 3\ndhdClose 3\n") != std::string::npos;
  })) << calls();
  EXPECT_EQ(wire(), "zero\nzero\n") << "one for each process";
}

TEST_F(KilledProgram, LeavesNoForceOnADeviceOfForceDimension) {
  Program program(invocation({"device-test", "force_dimension", "--yes"}));
  ASSERT_TRUE(program.read_until([this](const std::string&, const std::string&) {
    return wire().ends_with("force\n");
  })) << program.err();
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().signal, SIGKILL);
  EXPECT_TRUE(eventually([this] { return calls().ends_with("dhdStop 3\ndhdClose 3\n"); }))
      << calls();
  EXPECT_THAT(wire(), EndsWith("force\nzero\n"));
}

TEST_F(KilledProgram, LeavesNoForceOnADeviceOfOpenHapticsWithAConfiguredName) {
  Program program(
      invocation({"device-test", "openhaptics:Left Device", "--yes"}, ASPERITY_TEST_HD));
  ASSERT_TRUE(program.read_until([this](const std::string&, const std::string&) {
    return calls().ends_with("force\n");
  })) << program.err();
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().signal, SIGKILL);
  constexpr const char* kClosed =
      "force\nhdInitDevice Left Device\nhdDisable 16384\nhdDisableDevice\n";
  EXPECT_TRUE(eventually([&] { return calls().ends_with(kClosed); })) << calls();
}

TEST_F(CloseDevice, GivesUpWhereTheDriverDoesNotReturn) {
  Invocation hanging = closing();
  hanging.environment["ASPERITY_TEST_DHD_BLOCKS"] = "dhdStop";
  const Outcome outcome = run(hanging);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the device force_dimension:101 does not respond: its driver "
                                     "has not returned from closing the device for 1 s. Switch"));
  EXPECT_THAT(wire(), EndsWith("zero\n"));
}

TEST_F(CloseDevice, StatesWhyADeviceCannotBeOpened) {
  Invocation unplugged = closing();
  unplugged.environment["ASPERITY_TEST_DHD_ATTACHED"] = "102";
  const Outcome outcome = run(unplugged);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("has the serial number or place \"101\""));
}

// As one that was started again at once after it was killed.
TEST_F(CloseDevice, LeavesADeviceThatAnotherProgramDrives) {
  Invocation at_prompt = invocation({"device-test", "force_dimension"});
  at_prompt.on_terminal = true;
  Program program(at_prompt);
  ASSERT_TRUE(program.read_until_told("Type yes")) << program.err();
  const std::string before = calls();
  const Outcome left = run(closing());
  EXPECT_EQ(left.status, 0);
  EXPECT_THAT(left.err, HasSubstr("was left unchanged: another program drives it now"));
  EXPECT_EQ(calls(), before);
  program.type("no\n");
  EXPECT_EQ(program.finish().status, 1);

  const Outcome closed = run(closing());
  EXPECT_EQ(closed.status, 0) << closed.err;
  EXPECT_EQ(closed.err, "");
  EXPECT_NE(calls(), before);
}

// The end of the library waits for its threads, and the program does not.
TEST_F(HangingDriver, EndsADeviceTestAndHasItsDeviceClosedByAnotherProcess) {
  Invocation hanging = invocation({"device-test", "force_dimension", "--yes"});
  hanging.environment["ASPERITY_TEST_DHD_BLOCKS"] = "dhdGetPosition";
  const Outcome outcome = run(hanging);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the device omega.3 101 does not respond: its driver has not "
                                     "returned from reading the position for more than a second. "
                                     "Switch the device off"));
  EXPECT_TRUE(eventually([this] { return calls().ends_with("dhdStop 3\ndhdClose 3\n"); }))
      << calls();
}

}  // namespace
}  // namespace asperity::test
