// asperity replay --compare: the recorded hands of a study, and what other forces they would have met.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

class ReplayComparison : public testing::Test {
 protected:
  Outcome compare(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"replay", small_.study(), "--compare", "--out",
                                       small_.place() / name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  }
  std::string text(const std::string& name) const { return text_of(small_.place() / name); }

  SmallStudy small_ = simulated_study(2, 3, {"--recordings", "all"});
};

TEST_F(ReplayComparison, OfTheSameProgramIsZeroWhateverTheJobs) {
  const Outcome one = compare("one.tsv", {"--jobs", "1"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("presentations, largest difference 0 N"),
                             HasSubstr("315 to 500 Hz")));
  EXPECT_THAT(one.err, HasSubstr("replaying: "));
  const Outcome three = compare("three.tsv", {"--jobs", "3", "--json"});
  ASSERT_EQ(three.status, 0) << three.err;
  EXPECT_EQ(text("one.tsv"), text("three.tsv"));
  EXPECT_EQ(text("one.tsv.json"), text("three.tsv.json"));
  EXPECT_EQ(three.out, text("three.tsv.json"));

  const Tsv table = tsv(text("one.tsv"));
  EXPECT_THAT(table.column("rms_difference_N"), Each("0"));
  EXPECT_THAT(table.column("difference_energy_8_to_12.5_Hz_N2_s"), Each("0"));
  // Two participants with two selections of two surfaces and two recognitions of one.
  EXPECT_EQ(table.rows.size(), 12U);
  const auto json = nlohmann::json::parse(text("one.tsv.json"));
  EXPECT_EQ(json.at("format"), "asperity.replay/1");
  EXPECT_EQ(json.at("presentations"), 12);
  EXPECT_EQ(json.at("model"), nullptr);
  EXPECT_EQ(json.at("pooled").at("rms_difference_N"), 0.0);
  EXPECT_GT(json.at("pooled").at("recorded_rms_N"), 0.1);
  EXPECT_EQ(json.at("band_borders_Hz").size(), 10U);
  EXPECT_EQ(json.at("pooled").at("recorded_energy_N2_s").size(), 9U);
}

TEST_F(ReplayComparison, WithAnotherModelHasDifferencesAndAFigure) {
  std::vector<std::string> options{"--model", "sinusoid", "--param", "amplitude_m=0.0004"};
#ifdef ASPERITY_WITH_WINDOWS
  options.insert(options.end(), {"--plot", small_.place() / "forces.svg"});
#endif
  const Outcome outcome = compare("other.tsv", options);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Tsv table = tsv(text("other.tsv"));
  EXPECT_THAT(table.column("compared_model"), Each("sinusoid"));
  for (const std::string& cell : table.column("rms_difference_N")) {
    EXPECT_GT(number_in(cell).value(), 0.01);
  }
  const auto json = nlohmann::json::parse(text("other.tsv.json"));
  EXPECT_EQ(json.at("model"), "sinusoid");
  EXPECT_EQ(json.at("parameters").at("amplitude_m"), 0.0004);
#ifdef ASPERITY_WITH_WINDOWS
  EXPECT_THAT(text("forces.svg"), HasSubstr("<svg"));
#endif
  const Outcome again = compare("other.tsv", options);
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("other.tsv"));
  const Outcome of_bodies = compare("none.tsv", {"--model", "pd_gradient"});
  EXPECT_EQ(of_bodies.status, 1);
  EXPECT_THAT(of_bodies.err, HasSubstr("choose another model"));
  EXPECT_FALSE(fs::exists(small_.place() / "none.tsv"));
}

TEST_F(ReplayComparison, IsOfAWholeStudy) {
  const Outcome both = compare("x.tsv", {"--attempt", "1"});
  EXPECT_EQ(both.status, 2) << both.err;
  const Outcome neither = asperity({"replay", small_.study(), "--out", small_.place() / "x.tsv"});
  EXPECT_EQ(neither.status, 2);
  EXPECT_THAT(neither.err, HasSubstr("add --attempt WHICH or --compare"));
  const Outcome jobs = asperity({"replay", small_.study(), "--attempt", "1", "--jobs", "2", "--out",
                                 small_.place() / "x.tsv"});
  EXPECT_EQ(jobs.status, 2) << jobs.err;
  EXPECT_FALSE(fs::exists(small_.place() / "x.tsv"));
}

}  // namespace
}  // namespace asperity::test
