// The parts of a plan: what is joined, and what their durations add up to.

#include "protocols/plan/plan_parts.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;

Protocol read_library(std::string_view name) {
  return read_protocol(test::library_text(name), std::string(name), test::models_of_library());
}

TEST(PlanParts, AddUpToTheDurationAndTheTrialsOfTheSession) {
  for (const LibraryProtocol& each : library_protocols()) {
    const Protocol protocol = read_library(each.name);
    const Plan plan = example_plan(protocol, {1, 0});
    const PlanCost cost = cost_of(protocol, plan);
    double total_s = 0.0;
    int trials = 0;
    std::size_t next_step = 0;
    for (const PlanPart& part : parts_of(protocol, plan)) {
      total_s += part.duration_s;
      trials += part.trials;
      EXPECT_GE(part.first_step, next_step) << each.name;
      next_step = part.first_step + 1;
    }
    EXPECT_NEAR(total_s + cost.breaks_after_contact_s, cost.total_s, 1e-6) << each.name;
    EXPECT_EQ(trials, cost.trials) << each.name;
    int of_runs = 0;
    for (const PlannedRun& run : runs_in(protocol, parts_of(protocol, plan))) of_runs += run.trials;
    EXPECT_EQ(of_runs, cost.trials) << each.name;
  }
}

TEST(PlanParts, AreDividedByBreaksAndJoinedToRuns) {
  nlohmann::json file = test::without_practice(test::library_file("chapter_recognition"));
  file["blocks"]["main"]["repetitions"] = 4;
  file["flow"] = nlohmann::json::parse(R"([
    {"screen": "Welcome."}, {"check": "device"},
    {"run": "main", "break_every_trials": 3, "pause": {"minimum_s": 60, "text": "Rest."}}])");
  const Protocol protocol = test::valid(file);
  const Plan plan = example_plan(protocol, {1, 0});
  std::vector<PlanPart::What> kinds{};
  for (const PlanPart& part : parts_of(protocol, plan)) kinds.push_back(part.what);
  ASSERT_GE(kinds.size(), 4U);
  EXPECT_EQ(first_trial_step(plan), parts_of(protocol, plan)[1].first_step);
  kinds.resize(4);
  EXPECT_THAT(kinds, ElementsAre(PlanPart::What::reading, PlanPart::What::trials,
                                 PlanPart::What::pause, PlanPart::What::trials));
  const std::vector<PlannedRun> runs = runs_in(protocol, parts_of(protocol, plan));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs.front().trials, static_cast<int>(plan.trials.size()));
  EXPECT_FALSE(runs.front().most_trials);
}

}  // namespace
}  // namespace asperity
