// asperity clean-stiffness: the same bytes for any jobs, Ctrl-C, refusals.

#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::Each;
using testing::HasSubstr;

Outcome searched(const fs::path& out, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"clean-stiffness", "--out", out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return asperity(arguments);
}

const std::vector<std::string> kFewCombinations{
    "--model",       "sinusoid", "--model", "height_map", "--amplitudes", "0.0001",
    "--wavelengths", "0.004",    "--rates", "500,1000",   "--strokes",    "1",
    "--tolerance",   "0.2"};

TEST(CleanStiffnessCommand, HasTheSameBytesWhateverTheJobs) {
  const TemporaryFolder place{};
  std::vector<std::string> one = kFewCombinations;
  one.insert(one.end(), {"--jobs", "1"});
  std::vector<std::string> three = kFewCombinations;
  three.insert(three.end(), {"--jobs", "3"});
  const Outcome first = searched(place / "one.tsv", one);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.err, HasSubstr("searching: 100 %"));
  ASSERT_EQ(searched(place / "three.tsv", three).status, 0);
  EXPECT_EQ(text_of(place / "one.tsv"), text_of(place / "three.tsv"));
  EXPECT_EQ(text_of(place / "one.tsv.json"), text_of(place / "three.tsv.json"));
  EXPECT_THAT(text_of(place / "one.tsv.json"), HasSubstr("\"asperity.clean_stiffness/1\""));
  // The arm by default is that of the page, with little damping across the surface.
  EXPECT_EQ(nlohmann::json::parse(text_of(place / "one.tsv.json")).at("device"),
            "simulated:falcon,mass_kg=0.1,damping_N_s_per_m=1,normal_damping_N_s_per_m=1");

  const Tsv table = tsv(text_of(place / "one.tsv"));
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"model", "amplitude_m", "wavelength_m", "rate_Hz",
                                      "clean_stiffness_N_per_m", "unclean_stiffness_N_per_m",
                                      "buzz_of_clean", "buzz_of_unclean", "buzz_force_of_clean_N",
                                      "buzz_force_of_unclean_N", "status"}));
  EXPECT_EQ(table.column("model"),
            (std::vector<std::string>{"sinusoid", "sinusoid", "height_map", "height_map"}));
  EXPECT_EQ(table.column("rate_Hz"), (std::vector<std::string>{"500", "1000", "500", "1000"}));
  EXPECT_THAT(table.column("status"), Each("ok"));
  const std::vector<std::string> clean = table.column("clean_stiffness_N_per_m");
  EXPECT_GT(number_in(clean[1]).value(), number_in(clean[0]).value());  // with the rate
  EXPECT_EQ(searched(place / "one.tsv", one).status, 1);                // it is there
}

TEST(CleanStiffnessCommand, WritesNothingWhenItIsInterrupted) {
  const TemporaryFolder place{};
  Program program(
      {.arguments = {"clean-stiffness", "--out", place / "table.tsv", "--model", "sinusoid",
                     "--rates", "500,10000,9000,8000", "--strokes", "1000", "--jobs", "1"}});
  // No combination is complete by then.
  std::this_thread::sleep_for(std::chrono::seconds(1));
  program.send(SIGINT);
  const Outcome stopped = program.finish();
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("no table was written; repeat the command"));
  EXPECT_FALSE(fs::exists(place / "table.tsv"));
  EXPECT_FALSE(fs::exists(place / "table.tsv.json"));
}

TEST(CleanStiffnessCommand, RefusesWhatMakesNoSense) {
  const TemporaryFolder place{};
  const auto refused = [&](const std::vector<std::string>& more, int status) {
    const Outcome outcome = searched(place / "no.tsv", more);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_FALSE(fs::exists(place / "no.tsv"));
    return outcome.err;
  };
  EXPECT_THAT(refused({"--model", "pd_gradient"}, 1), HasSubstr("choose a model of a point"));
  EXPECT_THAT(refused({"--model", "sinusoid", "--rates", "250"}, 1),
              HasSubstr("sinusoid at an amplitude of 1e-04 m, a wavelength of 0.002 m and 250 Hz"));
  EXPECT_THAT(refused({"--model", "sinusoid", "--device", "falcon"}, 2),
              HasSubstr("write simulated or simulated:MODEL"));
  EXPECT_THAT(refused({"--model", "sinusoid", "--amplitudes", "1"}, 2),
              HasSubstr("a length is at most 0.1 m"));
  EXPECT_THAT(refused({"--model", "sinusoid", "--stiffness-range", "100"}, 2),
              HasSubstr("write LEAST:MOST"));
  EXPECT_THAT(
      refused({"--model", "sinusoid", "--model", "height_map", "--param", "law=corrected"}, 2),
      HasSubstr("run the command once for each"));
}

}  // namespace
}  // namespace asperity::test
