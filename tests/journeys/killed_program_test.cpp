// A program that is killed while it drives a device that only a library of its manufacturer reaches.

#include <csignal>
#include <string>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/eventually.h"

namespace asperity::test {
namespace {

TEST(KilledProgram, HasItsDeviceClosedAtZeroForceByAnotherProcess) {
  const SmallStudy small(1);
  const fs::path calls = small.place() / "calls.txt";
  const fs::path wire = small.place() / "wire.txt";
  Program program({.arguments = {"run", small.recognition(), "--study", small.study(),
                                 "--participant", "anna", "--mode", "pilot", "--device",
                                 "force_dimension", "--library", ASPERITY_TEST_DRD},
                   .environment = {{"ASPERITY_TEST_DHD_ATTACHED", "101"},
                                   {"ASPERITY_TEST_DHD_CALLS", calls.string()},
                                   {"ASPERITY_TEST_DHD_WIRE", wire.string()}},
                   .on_terminal = true});
  ASSERT_TRUE(program.read_until([](const std::string& out, const std::string&) {
    return out.ends_with("Your answer: ");
  })) << program.err();
  EXPECT_EQ(text_of(calls).find("dhdStop"), std::string::npos) << "the program has it open";
  EXPECT_EQ(text_of(wire), "zero\n");
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().signal, SIGKILL);
  // With its brakes on; its handle does not fall.
  EXPECT_TRUE(eventually([&] {
    return text_of(calls).find("dhdStop 3\ndhdClose 3\n") != std::string::npos;
  })) << text_of(calls);
  EXPECT_EQ(text_of(wire), "zero\nzero\n") << "one for each process";
}

}  // namespace
}  // namespace asperity::test
