// A device that has to move by itself before it can be used: nobody's arm moves unasked.

#include <csignal>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

// A stand-in for Force Dimension's SDK with one device, which was switched off.
class MovingDevice : public testing::Test {
 protected:
  Invocation invocation(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--library", ASPERITY_TEST_DRD});
    Invocation invocation{};
    invocation.arguments = std::move(arguments);
    invocation.environment = {{"ASPERITY_TEST_DHD_SWITCHED_OFF", "101"},
                              {"ASPERITY_TEST_DHD_CALLS", calls_.string()},
                              // A device with this number may be driven in another test.
                              {"XDG_RUNTIME_DIR", folder_.path().string()}};
    return invocation;
  }
  /// To its maker's library.
  std::string said() const { return text_of(calls_); }
  void forget() const { fs::remove(calls_); }
  /// So far: a program that has only begun has said nothing.
  bool has_moved() const {
    return fs::exists(calls_) && text_of(calls_).find("drdAutoInit") != std::string::npos;
  }

 private:
  const TemporaryFolder folder_{};
  const fs::path calls_ = folder_ / "calls.txt";
};

TEST_F(MovingDevice, IsNotMovedByALookAtWhatIsAttached) {
  const Outcome outcome = run(invocation({"devices"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("omega.3, serial 101"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("confirmation is requested before it moves"), std::string::npos)
      << outcome.out;
  EXPECT_FALSE(has_moved());
}

// To be asked for its serial number it is opened, for which it need not be found twice.
TEST_F(MovingDevice, IsLookedForOnceHoweverManyProtocolsAreCheckedAgainstIt) {
  const SmallStudy small(1);
  const fs::path libraries = small.place() / "libraries";
  fs::create_directory(libraries);
  fs::create_symlink(ASPERITY_TEST_DRD, libraries / "libdrd.so");
  Invocation check = invocation({});
  check.arguments = {"check",       small.selection(), small.recognition(), "--study",
                     small.study(), "--device",        "force_dimension"};
  check.environment["LD_LIBRARY_PATH"] = libraries;
  const Outcome outcome = run(check);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string missing = "no profile of the attached device force_dimension 101";
  const std::size_t first = outcome.err.find(missing);
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(missing, first + 1), std::string::npos) << "one for each protocol";
  EXPECT_EQ(said(), "dhdOpenID 0\ndhdClose 3\n");
}

TEST_F(MovingDevice, IsNotMovedByATestWithoutATerminal) {
  const Outcome outcome = run(invocation({"device-test", "force_dimension"}));
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("omega.3 101 will move by itself"), std::string::npos) << outcome.err;
  EXPECT_FALSE(has_moved());
}

TEST_F(MovingDevice, IsNotMovedByATestThatIsToldNo) {
  Invocation asked = invocation({"device-test", "force_dimension"});
  asked.on_terminal = true;
  Program program(asked);
  EXPECT_TRUE(program.read_until_told("Type yes")) << program.err();
  EXPECT_FALSE(has_moved());
  program.type("no\n");
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("was not confirmed"), std::string::npos) << outcome.err;
  EXPECT_FALSE(has_moved());
}

TEST_F(MovingDevice, IsLetGoOfWhereSomebodyStopsInsteadOfAnswering) {
  Invocation asked = invocation({"device-test", "force_dimension"});
  asked.on_terminal = true;
  Program program(asked);
  EXPECT_TRUE(program.read_until_told("Type yes")) << program.err();
  program.send(SIGINT);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("stopping the device. If the handle keeps moving by itself"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("the force is set to zero"), std::string::npos) << outcome.err;
  EXPECT_NE(said().find("dhdClose"), std::string::npos) << said();
  EXPECT_FALSE(has_moved());
}

TEST_F(MovingDevice, IsMovedByATestThatIsToldYes) {
  Invocation asked = invocation({"device-test", "force_dimension"});
  asked.on_terminal = true;
  Program program(asked);
  const auto questions = [&](std::size_t wanted) {
    return program.read_until([wanted](const std::string&, const std::string& err) {
      std::size_t seen = 0;
      for (std::size_t at = 0; (at = err.find("Type yes", at)) != std::string::npos; ++at) ++seen;
      return seen >= wanted;
    });
  };
  EXPECT_TRUE(questions(1)) << program.err();
  program.type("yes\n");
  EXPECT_TRUE(questions(2)) << program.err();  // before it is measured
  EXPECT_TRUE(has_moved());
  program.type("no\n");
  EXPECT_EQ(program.finish().status, 1);
}

// For ten seconds.
TEST_F(MovingDevice, IsNotWaitedForWhereItsDriverDoesNotReturnFromClosingIt) {
  Invocation asked = invocation({"device-test", "force_dimension"});
  asked.environment["ASPERITY_TEST_DHD_ATTACHED"] = "102";
  asked.environment.erase("ASPERITY_TEST_DHD_SWITCHED_OFF");
  asked.environment["ASPERITY_TEST_DHD_BLOCKS"] = "dhdStop";
  asked.on_terminal = true;
  Program program(asked);
  EXPECT_TRUE(program.read_until_told("Type yes")) << program.err();
  program.type("no\n");
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("the device force_dimension does not respond: its driver has not "
                             "returned from closing the device for 10 s. Switch the device off"),
            std::string::npos)
      << outcome.err;
}

TEST_F(MovingDevice, IsSaidToLoseItsForceWhereSomebodyStopsOnceItIsOpen) {
  Invocation agreed = invocation({"device-test", "force_dimension", "--yes"});
  agreed.on_terminal = true;
  Program program(agreed);
  EXPECT_TRUE(program.read_until_told(" %: ")) << program.err();
  program.send(SIGINT);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("stopping; the force is set to zero"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("stopping the device. If the handle keeps moving by itself"),
            std::string::npos)
      << outcome.err;
}

// Somebody who sees an arm coming presses as often as they can.
TEST_F(MovingDevice, HasStoppedBeforeTheProgramEndsHoweverOftenSomebodyPresses) {
  for (const int presses : {1, 2, 4}) {
    Invocation agreed = invocation({"device-test", "force_dimension", "--yes"});
    agreed.environment["ASPERITY_TEST_DHD_SEARCHES_ON"] = "1";
    Program program(agreed);
    EXPECT_TRUE(program.read_until([&](const std::string&, const std::string&) {
      return has_moved();
    })) << program.err();
    for (int press = 0; press < presses; ++press) program.send(SIGINT);
    const Outcome outcome = program.finish();
    EXPECT_EQ(outcome.signal, std::nullopt) << presses;
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("omega.3 101 was stopped on request while it moved"),
              std::string::npos)
        << outcome.err;
    const std::string calls = said();
    const std::size_t at_rest = calls.find("at rest 3");
    ASSERT_NE(at_rest, std::string::npos) << calls;
    EXPECT_LT(calls.find("dhdStop 3"), at_rest) << calls;
    EXPECT_GT(calls.find("drdClose 3"), at_rest) << calls;
    forget();
  }
}

TEST_F(MovingDevice, IsNotMovedByASession) {
  const SmallStudy small(1);
  Invocation session = invocation({"run", small.selection(), "--study", small.study(),
                                   "--participant", "anna", "--device", "force_dimension"});
  session.on_terminal = true;
  const Outcome outcome = run(session);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("omega.3 101 has lost its zero"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("asperity device-test force_dimension:101 --library " ASPERITY_TEST_DRD
                             "\""),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(has_moved());
}

}  // namespace
}  // namespace asperity::test
