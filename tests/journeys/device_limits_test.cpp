// A protocol's limits for its device, all the way: refused where they are wrong, judged by, kept, compared.

#include <algorithm>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

class DeviceLimits : public testing::Test {
 protected:
  void limit(const nlohmann::ordered_json& limits) const {
    nlohmann::ordered_json protocol = small_selection(1);
    protocol["device"]["limits"] = limits;
    write_text(small.selection(), protocol.dump(2));
  }
  static Outcome asperity(const std::vector<std::string>& arguments) {
    Invocation invocation{};
    invocation.arguments = arguments;
    return run(invocation);
  }

  const SmallStudy small{1};
};

TEST_F(DeviceLimits, AreRefusedByCheckWithTheirPlaceAndWhatWouldBeRight) {
  limit({{"friction_N", -0.2}, {"fricton_N", 0.2}});
  const Outcome form = asperity({"check", small.selection()});
  EXPECT_EQ(form.status, 1);
  EXPECT_NE(form.err.find("error: -0.2 is too small: it must be at least 0"), std::string::npos)
      << form.err;
  EXPECT_NE(form.err.find("(/device/limits/friction_N)"), std::string::npos) << form.err;
  EXPECT_NE(form.err.find("did you mean \"friction_N\"?"), std::string::npos) << form.err;
  limit({{"rate_Hz", 1500}});
  const Outcome meaning = asperity({"check", small.selection()});
  EXPECT_EQ(meaning.status, 1);
  EXPECT_NE(meaning.err.find("at most /device/rate_Hz"), std::string::npos) << meaning.err;
}

TEST_F(DeviceLimits, JudgeTheDeviceAreKeptWithItAndComparedByCheck) {
  // The probe of the simulated device weighs 50 g and damps with 5 N s/m.
  limit({{"moving_mass_kg", 0.01}, {"damping_N_s_per_m", 2.0}, {"lateness_p99_s", 0.0}});
  const Outcome test = asperity(
      {"device-test", "simulated", "--protocol", small.selection(), "--study", small.study()});
  EXPECT_EQ(test.status, 1) << test.err;
  const auto line_of = [&test](const std::string& item) {
    const std::size_t at = test.out.find('\n' + item);
    return test.out.substr(at + 1, test.out.find('\n', at + 1) - at - 1);
  };
  EXPECT_NE(line_of("moving_mass_kg").find("fail"), std::string::npos) << test.out;
  EXPECT_NE(line_of("moving_mass_kg").find("<= 0.01"), std::string::npos) << test.out;
  EXPECT_NE(line_of("damping_N_s_per_m").find("pass"), std::string::npos) << test.out;
  EXPECT_NE(line_of("damping_N_s_per_m").find(">= 2"), std::string::npos) << test.out;
  EXPECT_EQ(line_of("lateness_p99_s").find("fail"), std::string::npos) << "told, not judged";
  EXPECT_NE(line_of("lateness_p50_s").find("no limit"), std::string::npos) << test.out;
  const Outcome compared =
      asperity({"check", small.selection(), "--study", small.study(), "--device", "simulated"});
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.err.find("warning: The protocol requires a device whose moving_mass_kg is at "
                              "most 0.0100; the measured value is 0.0"),
            std::string::npos)
      << compared.err;
  EXPECT_EQ(compared.err.find("lateness_p99_s"), std::string::npos) << compared.err;
}

TEST_F(DeviceLimits, OfTheCommandLineAreOnesThatAProtocolCouldHave) {
  for (const char* const none : {"force_zero_N=1", "friction_N=nan", "friction_N=inf",
                                 "friction_N=-1", "friction=0.1", "resonance_Hz=99999"}) {
    const Outcome outcome = asperity({"device-test", "simulated", "--limit", none});
    EXPECT_EQ(outcome.status, 2) << none;
    EXPECT_NE(outcome.err.find(none), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << none;
  }
}

// A stand-in is no delta.3, and says so.
TEST_F(DeviceLimits, OfAStandInAreHeldToNothingThatIsNotKnown) {
  const Outcome test = asperity(
      {"device-test", "simulated:delta.3", "--limit", "friction_N=1", "--limit", "latency_s=1"});
  EXPECT_EQ(test.status, 0) << test.err;
  EXPECT_EQ(test.out.find("Simulated model of delta.3; known: workspace, peak force, rate, "
                          "latency; unknown: continuous force, position resolution,"),
            0U)
      << test.out;
  const auto line_of = [&test](const std::string& item) {
    const std::size_t at = test.out.find('\n' + item);
    return test.out.substr(at + 1, test.out.find('\n', at + 1) - at - 1);
  };
  EXPECT_NE(line_of("friction_N").find("not measured"), std::string::npos) << test.out;
  EXPECT_NE(line_of("friction_N").find("Unknown for delta.3"), std::string::npos) << test.out;
  EXPECT_NE(line_of("latency_s").find("pass"), std::string::npos) << test.out;
  EXPECT_NE(
      test.out.find("\nThe device met every limit that was measured. Not measured, although "
                    "a limit applies: friction_N, workspace_reached. Measure the device again.\n"),
      std::string::npos)
      << test.out;
}

class CheckedDevice : public DeviceLimits {
 protected:
  void ask_for(const std::string& key, const nlohmann::ordered_json& value) const {
    nlohmann::ordered_json protocol = small_selection(1);
    protocol["device"][key] = value;
    write_text(small.selection(), protocol.dump(2));
  }
  Outcome checked(const std::string& device) const {
    return asperity({"check", small.selection(), "--study", small.study(), "--device", device});
  }
};

TEST_F(CheckedDevice, IsRefusedAsARunRefusesItWithACommandThatHelps) {
  ask_for("profile_maximum_age_days", 30);
  const Outcome before = checked("simulated:falcon");
  EXPECT_EQ(before.status, 1);
  const std::string command =
      "asperity device-test simulated:falcon --study " + small.study().string();
  EXPECT_NE(before.err.find("error: the protocol requires a device measured"), std::string::npos)
      << before.err;
  EXPECT_NE(before.err.find(command), std::string::npos) << before.err;
  EXPECT_EQ(asperity({"device-test", "simulated:falcon", "--study", small.study()}).status, 0);
  const Outcome after = checked("simulated:falcon");
  EXPECT_EQ(after.status, 0) << after.err;
  EXPECT_NE(after.out.find("compared with the profile of \"simulated:falcon\", measured on"),
            std::string::npos)
      << after.out;
  // Who waits at a terminal sees how far it is, and no pipe gets a bar.
  EXPECT_EQ(after.err.find("comparing small_selection"), std::string::npos) << after.err;
  Invocation at_terminal{};
  at_terminal.arguments = {"check",       small.selection(), "--study",
                           small.study(), "--device",        "simulated:falcon"};
  at_terminal.on_terminal = true;
  at_terminal.in_child = [] { ::dup2(STDOUT_FILENO, STDERR_FILENO); };
  const Outcome watched = run(at_terminal);
  EXPECT_EQ(watched.status, 0) << watched.out;
  EXPECT_NE(watched.out.find("comparing small_selection with the device"), std::string::npos)
      << watched.out;
}

TEST_F(CheckedDevice, IsSaidNotToBeKnownWhereAProgramReadsItToo) {
  const Outcome read = asperity({"check", small.selection(), "--study", small.study(), "--device",
                                 "simulated:delta.3", "--json"});
  EXPECT_EQ(read.status, 0) << read.err;
  const auto json = nlohmann::json::parse(read.out);
  const auto& not_known = json["protocols"][0]["device"]["not_known"];
  EXPECT_NE(std::find(not_known.begin(), not_known.end(), "friction"), not_known.end()) << read.out;
  EXPECT_NE(read.err.find("these properties of delta.3, which \"simulated:delta.3\" models, are "
                          "unknown: friction, "),
            std::string::npos)
      << read.err;
  EXPECT_NE(read.err.find("(/device)"), std::string::npos);
  EXPECT_EQ(read.err.find(":1:1: warning"), std::string::npos) << "it has a place: " << read.err;
}

TEST_F(CheckedDevice, IsSaidNotToBeComparedAndTakesTheOptionsOfItsDriver) {
  ask_for("rate_Hz", 1000);
  const Outcome unmeasured = checked("falcon");
  EXPECT_EQ(unmeasured.status, 0) << unmeasured.err;
  // Here may be one.
  EXPECT_TRUE(unmeasured.err.find("no profile of \"falcon\"") != std::string::npos ||
              unmeasured.err.find("no profile of the attached device ") != std::string::npos)
      << unmeasured.err;
  EXPECT_EQ(checked("replay:nofile").status, 1);
  const Outcome named = asperity({"check", small.selection(), "--device", "force_dimension",
                                  "--library", "/no/such/libdhd.so", "--study", small.study()});
  EXPECT_EQ(named.status, 0) << named.err;
  EXPECT_NE(named.err.find("/no/such/libdhd.so"), std::string::npos) << named.err;
}

}  // namespace
}  // namespace asperity::test
