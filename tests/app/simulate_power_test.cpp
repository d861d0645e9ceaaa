// Holds simulated studies of a test in closed form to its power, and their table to the same bytes however it came about.

#include "app/power/curve/simulate_power.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "analysis/power/power.h"
#include "analysis/tests/t_test.h"
#include "app/power/curve/planned_sample.h"
#include "app/power/curve/result_tables.h"
#include "app/power/curve/study_rows.h"
#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr double kD = 0.7;

PowerOrder order_of(std::int64_t runs) {
  return {.effects = {"rating.d=0", "rating.d=0.7"},
          .participants = {8, 16, 24},
          .seed = 3,
          .runs = runs,
          .protocol_sha256 = "aa",
          .assumptions_sha256 = "bb",
          .program = "asperity 0.0.0"};
}

/// A t test of normal differences with the mean 0 or kD, and the family that contains it alone.
std::vector<SimulatedOutcome> t_test_study(std::size_t effect, int participants, std::uint64_t seed,
                                           std::int64_t run) {
  Random random(seed + 1000 * static_cast<std::uint64_t>(run) + 100 * effect +
                static_cast<std::uint64_t>(participants));
  std::vector<double> differences{};
  for (int i = 0; i < participants; ++i) {
    differences.push_back(random.normal() + (effect == 0 ? 0.0 : kD));
  }
  const OneSampleT test = one_sample_t(differences);
  return {{.family = "ratings",
           .test = "difference",
           .p = test.test->p,
           .corrected_p = test.test->p,
           .estimate = test.mean,
           .lower = test.test->interval.low,
           .upper = test.test->interval.high},
          {.family = "ratings", .corrected_p = test.test->p}};
}

SimulatedPower simulated(const PowerOrder& order, const std::filesystem::path& folder, int jobs = 1,
                         const SimulateStudy& simulate = t_test_study,
                         const std::stop_token& stop = {}) {
  return simulate_power(order, simulate, jobs, PowerFiles{.folder = folder}, stop, {});
}

std::string studies_in(const std::filesystem::path& folder) {
  return read_file(folder / kStudiesFile, kTableFile);
}

// The noncentral t distribution; six proportions of 2000 studies each err by less than four standard errors.
TEST(SimulatePower, AgreesWithTheTTestInClosedForm) {
  constexpr std::int64_t kRuns = 2000;
  const SimulatedPower power = simulate_power(order_of(kRuns), t_test_study, 2, {}, {}, {});
  EXPECT_TRUE(power.is_complete);
  EXPECT_EQ(power.runs, kRuns);
  ASSERT_THAT(power.curves, SizeIs(4));  // two effects; the test and its family
  for (const PowerCurve& curve : power.curves) {
    ASSERT_THAT(curve.sizes, SizeIs(3));
    for (const TestAtSize& size : curve.sizes) {
      const double exact =
          paired_t_power({.pairs = static_cast<std::size_t>(size.power.participants),
                          .d = curve.effect == "rating.d=0" ? 0.0 : kD});
      EXPECT_NEAR(size.power.power, exact, 4.0 * std::sqrt(exact * (1.0 - exact) / kRuns))
          << curve.effect << ' ' << size.power.participants;
      EXPECT_EQ(size.without_p, 0U);
      // 2·t·s/√n with the median of s near 1; only the test has an interval.
      ASSERT_EQ(size.median_width.has_value(), !curve.test.empty());
      if (!size.median_width) continue;
      const double n = size.power.participants;
      EXPECT_NEAR(*size.median_width, 2.0 * (n < 10 ? 2.36 : 2.1) / std::sqrt(n),
                  0.1 * *size.median_width);
      EXPECT_GT(*size.p90_width, *size.median_width);
    }
  }
}

TEST(SimulatePower, BytesDoNotDependOnJobs) {
  const TemporaryFolder folder;
  simulated(order_of(40), folder.path() / "one", 1);
  simulated(order_of(40), folder.path() / "four", 4);
  EXPECT_EQ(studies_in(folder.path() / "one"), studies_in(folder.path() / "four"));
}

TEST(SimulatePower, MoreRunsGiveTheBytesOfOneLongRun) {
  const TemporaryFolder folder;
  simulated(order_of(10), folder.path() / "grown");
  const SimulatedPower grown = simulated(order_of(40), folder.path() / "grown", 2);
  const SimulatedPower whole = simulated(order_of(40), folder.path() / "whole");
  EXPECT_EQ(studies_in(folder.path() / "grown"), studies_in(folder.path() / "whole"));
  EXPECT_EQ(grown.there, 60);
  EXPECT_EQ(json_of(power_table(grown.curves)), json_of(power_table(whole.curves)));
  // Fewer runs than there are use all.
  EXPECT_EQ(simulated(order_of(5), folder.path() / "grown").runs, 40);
  EXPECT_EQ(studies_in(folder.path() / "grown"), studies_in(folder.path() / "whole"));
}

// Stopped after a study in the middle of a run, and killed within a line.
TEST(SimulatePower, ResumesWhereItWasStopped) {
  const TemporaryFolder folder;
  simulated(order_of(12), folder.path() / "whole");
  std::stop_source stop{};
  std::atomic<int> studies{0};
  const SimulateStudy stopping = [&](std::size_t effect, int participants, std::uint64_t seed,
                                     std::int64_t run) {
    if (++studies == 15) stop.request_stop();
    return t_test_study(effect, participants, seed, run);
  };
  const SimulatedPower stopped =
      simulated(order_of(12), folder.path() / "stopped", 1, stopping, stop.get_token());
  EXPECT_FALSE(stopped.is_complete);
  EXPECT_EQ(stopped.runs, 2);  // 15 of 6 studies each
  const std::string begun = studies_in(folder.path() / "stopped");
  write_file(folder.path() / "stopped" / kStudiesFile, begun.substr(0, begun.size() - 7),
             Overwrite::allow);
  const SimulatedPower resumed = simulated(order_of(12), folder.path() / "stopped", 2);
  EXPECT_TRUE(resumed.is_complete);
  EXPECT_EQ(studies_in(folder.path() / "stopped"), studies_in(folder.path() / "whole"));
}

TEST(SimulatePower, RefusesOtherInputsAndNamesThem) {
  const TemporaryFolder folder;
  simulated(order_of(3), folder.path() / "out");
  PowerOrder other = order_of(3);
  other.seed = 4;
  other.protocol_sha256 = "cc";
  EXPECT_THAT(refusal_of([&] { simulated(other, folder.path() / "out"); }),
              HasSubstr("is from other inputs, which differ in the protocol and the seed; repeat "
                        "the command with the same inputs to add runs to it, choose another --out "
                        "to keep it, or use --force to replace it"));
  const SimulatedPower replaced = simulate_power(
      other, t_test_study, 1,
      PowerFiles{.folder = folder.path() / "out", .overwrite = Overwrite::allow}, {}, {});
  EXPECT_EQ(replaced.there, 0);
  simulated(other, folder.path() / "new");
  EXPECT_EQ(studies_in(folder.path() / "out"), studies_in(folder.path() / "new"));
}

// As after a stop between the two files, or when the user removed the studies.
TEST(SimulatePower, ReplacesTheDeclarationOfAnEmptyTable) {
  const TemporaryFolder folder;
  simulated(order_of(3), folder.path() / "out");
  std::filesystem::remove(folder.path() / "out" / kStudiesFile);
  PowerOrder other = order_of(3);
  other.seed = 4;
  EXPECT_EQ(simulated(other, folder.path() / "out").runs, 3);
  EXPECT_EQ(read_file(folder.path() / "out" / kDeclarationFile), declaration_of(other));
}

TEST(SimulatePower, RefusesATableWithoutItsDeclaration) {
  const TemporaryFolder folder;
  simulated(order_of(3), folder.path() / "out");
  std::filesystem::remove(folder.path() / "out" / kDeclarationFile);
  EXPECT_THAT(refusal_of([&] { simulated(order_of(3), folder.path() / "out"); }),
              HasSubstr("has no studies.tsv.json"));
}

TEST(SimulatePower, NamesTheLineThatIsNotOfTheTable) {
  const TemporaryFolder folder;
  simulated(order_of(3), folder.path() / "out");
  std::string rows = studies_in(folder.path() / "out");
  const std::size_t second = rows.find('\n', rows.find('\n') + 1) + 1;
  // Without the rows of the first study, and with a row that is not one.
  write_file(folder.path() / "out" / kStudiesFile,
             rows.substr(0, rows.find('\n') + 1) + rows.substr(rows.find('\n', second) + 1),
             Overwrite::allow);
  EXPECT_THAT(refusal_of([&] { simulated(order_of(3), folder.path() / "out"); }),
              HasSubstr("line 2, is not the row that follows"));
  write_file(folder.path() / "out" / kStudiesFile, rows.insert(second, "0\tnothing\n"),
             Overwrite::allow);
  EXPECT_THAT(refusal_of([&] { simulated(order_of(3), folder.path() / "out"); }),
              HasSubstr("line 3, is not the row that follows"));
}

TEST(SimulatePower, HasOneWriterOfAFolder) {
  const TemporaryFolder folder;
  const SimulateStudy again = [&](std::size_t effect, int participants, std::uint64_t seed,
                                  std::int64_t run) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { simulated(order_of(1), folder.path() / "out"); }),
                HasSubstr("another program is writing the file"));
    return t_test_study(effect, participants, seed, run);
  };
  simulated(order_of(1), folder.path() / "out", 1, again);
}

TEST(SimulatePower, NamesTheStudyThatFailsAndKeepsThoseBefore) {
  const TemporaryFolder folder;
  const SimulateStudy failing = [](std::size_t effect, int participants, std::uint64_t seed,
                                   std::int64_t run) {
    if (run == 1 && participants == 16 && effect == 1) {
      throw std::runtime_error("the fit has no maximum");
    }
    return t_test_study(effect, participants, seed, run);
  };
  EXPECT_THAT(refusal_of([&] { simulated(order_of(3), folder.path() / "out", 1, failing); }),
              HasSubstr("run 1 with 16 participants and rating.d=0.7: the fit has no maximum"));
  const SimulatedPower resumed = simulated(order_of(3), folder.path() / "out");
  EXPECT_EQ(resumed.there, 10);
  simulated(order_of(3), folder.path() / "whole");
  EXPECT_EQ(studies_in(folder.path() / "out"), studies_in(folder.path() / "whole"));
}

// A status is not a significant test, and a test that an analysis leaves out counts in no study.
TEST(SimulatePower, CountsStudiesWithoutAPAsNotSignificant) {
  const SimulateStudy sometimes = [](std::size_t, int, std::uint64_t, std::int64_t run) {
    std::vector<SimulatedOutcome> outcomes{{.family = "f", .test = "kept", .corrected_p = 0.01}};
    if (run % 2 == 0) outcomes.push_back({.family = "f", .test = "fit", .status = "no_maximum"});
    if (run % 4 == 0) outcomes.push_back({.family = "f", .test = "rare", .p = 0.04});
    return outcomes;
  };
  const SimulatedPower power = simulate_power(
      {.effects = {"e=1"}, .participants = {10}, .runs = 100}, sometimes, 2, {}, {}, {});
  ASSERT_THAT(power.curves, SizeIs(3));
  EXPECT_EQ(power.curves[0].sizes[0].power.power, 1.0);
  EXPECT_EQ(power.curves[1].sizes[0].power.power, 0.0);
  EXPECT_EQ(power.curves[1].sizes[0].without_p, 100U);
  EXPECT_EQ(power.curves[2].sizes[0].power.power, 0.25);
  EXPECT_EQ(power.curves[2].sizes[0].without_p, 75U);
  EXPECT_THAT(power.curves[1].statuses, ElementsAre("no_maximum"));
  EXPECT_THAT(power.curves[2].statuses, IsEmpty());
}

// Also of studies that are read again; a study in which no test was made has none.
TEST(SimulatePower, KeepsTheStatisticalTestOfEachCurve) {
  const TemporaryFolder folder;
  const SimulateStudy varying = [](std::size_t, int, std::uint64_t, std::int64_t run) {
    return std::vector<SimulatedOutcome>{{.family = "f",
                                          .test = "order",
                                          .method = run == 0   ? ""
                                                    : run == 1 ? "wilcoxon"
                                                               : "paired_t",
                                          .p = 0.01},
                                         {.family = "f", .corrected_p = 0.01}};
  };
  for (const std::int64_t runs : {2, 3}) {
    const SimulatedPower power =
        simulate_power({.effects = {"e=1"}, .participants = {10}, .runs = runs}, varying, 1,
                       PowerFiles{.folder = folder.path() / "out"}, {}, {});
    ASSERT_THAT(power.curves, SizeIs(2));
    EXPECT_EQ(power.curves[0].methods, runs == 2
                                           ? std::vector<std::string>{"wilcoxon"}
                                           : (std::vector<std::string>{"paired_t", "wilcoxon"}));
    EXPECT_TRUE(power.curves[1].methods.empty());
  }
}

// A curve without a maximum has a limit that is not a number, or is infinite.
TEST(SimulatePower, CountsTheWidthsOfIntervalsOnly) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<double, double>> limits{
      {1.0, 3.0}, {kInfinite, kInfinite}, {std::nan(""), 1.0}, {2.0, 1.0}, {-kInfinite, kInfinite}};
  const SimulateStudy varying = [&limits](std::size_t, int, std::uint64_t, std::int64_t run) {
    const auto& [lower, upper] = limits[static_cast<std::size_t>(run)];
    return std::vector<SimulatedOutcome>{
        {.family = "f", .test = "t", .p = 0.1, .lower = lower, .upper = upper}};
  };
  const SimulatedPower power =
      simulate_power({.effects = {"e=1"}, .participants = {10}, .runs = 5}, varying, 1, {}, {}, {});
  const TestAtSize& size = power.curves[0].sizes[0];
  EXPECT_NEAR(size.median_width.value(), 2.0, 0.002);  // of two
  EXPECT_EQ(size.p90_width, kInfinite);
}

// Of 20 studies, the 18th width is that which 90 % do not exceed. Widths are stored with an error of 0.1 %.
TEST(SimulatePower, HasTheWidthThatNineOfTenStudiesDoNotExceed) {
  const SimulateStudy varying = [](std::size_t, int, std::uint64_t, std::int64_t run) {
    return std::vector<SimulatedOutcome>{{.family = "f",
                                          .test = "t",
                                          .p = 0.1,
                                          .lower = 0.0,
                                          .upper = static_cast<double>(run) + 1.0}};
  };
  const SimulatedPower power = simulate_power(
      {.effects = {"e=1"}, .participants = {10}, .runs = 20}, varying, 1, {}, {}, {});
  const TestAtSize& size = power.curves[0].sizes[0];
  EXPECT_NEAR(size.median_width.value(), 10.0, 0.02);
  EXPECT_NEAR(size.p90_width.value(), 18.0, 0.04);
}

// Without subjects an analysis states once that it cannot test them.
TEST(SimulatePower, HasNoCurveOfWhatStandsInPlaceOfSeveralTests) {
  const SimulateStudy sometimes = [](std::size_t, int, std::uint64_t, std::int64_t run) {
    if (run % 4 == 0) {
      return std::vector<SimulatedOutcome>{{.family = "f", .test = "peaks", .status = "untested"},
                                           {.family = "f", .test = "alone", .status = "untested"}};
    }
    return std::vector<SimulatedOutcome>{{.family = "f", .test = "peaks a|b", .p = 0.01},
                                         {.family = "f", .test = "peaks a|c", .p = 0.01}};
  };
  const SimulatedPower power = simulate_power(
      {.effects = {"e=1"}, .participants = {10}, .runs = 100}, sometimes, 1, {}, {}, {});
  ASSERT_THAT(power.curves, SizeIs(3));
  EXPECT_EQ(power.curves[0].test, "alone");
  EXPECT_EQ(power.curves[1].test, "peaks a|b");
  EXPECT_EQ(power.curves[1].sizes[0].power.power, 0.75);
  EXPECT_EQ(power.curves[1].sizes[0].without_p, 25U);
}

// A long study can end on a stop request without outcomes: it is not stored, nor is the next one, which ends beside it. It is no
// error.
TEST(SimulatePower, StoresNoStudyThatWasStopped) {
  const TemporaryFolder folder;
  std::stop_source stop{};
  std::atomic<bool> has_next_begun{false};
  const SimulateStudy stopped_in_third = [&](std::size_t effect, int participants,
                                             std::uint64_t seed, std::int64_t run) {
    if (run == 0 && effect == 0 && participants == 24) {
      has_next_begun.wait(false);
      stop.request_stop();
      return std::vector<SimulatedOutcome>{};
    }
    if (run == 0 && effect == 1 && participants == 8) {
      has_next_begun = true;
      has_next_begun.notify_all();
    }
    return t_test_study(effect, participants, seed, run);
  };
  const SimulatedPower power =
      simulated(order_of(2), folder.path() / "out", 2, stopped_in_third, stop.get_token());
  EXPECT_FALSE(power.is_complete);
  EXPECT_THAT(studies_in(folder.path() / "out"), Not(HasSubstr("0\trating.d=0\t24")));
  EXPECT_THAT(studies_in(folder.path() / "out"), Not(HasSubstr("rating.d=0.7")));
  simulated(order_of(2), folder.path() / "out");
  simulated(order_of(2), folder.path() / "whole");
  EXPECT_EQ(studies_in(folder.path() / "out"), studies_in(folder.path() / "whole"));
  const SimulateStudy empty = [](std::size_t, int, std::uint64_t, std::int64_t) {
    return std::vector<SimulatedOutcome>{};
  };
  EXPECT_THAT(refusal_of([&] { simulate_power(order_of(1), empty, 1, {}, {}, {}); }),
              HasSubstr("the analysis has no test"));
  PowerOrder without_effects = order_of(1);
  without_effects.effects = {""};
  EXPECT_THAT(refusal_of([&] { simulate_power(without_effects, empty, 1, {}, {}, {}); }),
              HasSubstr(" participants: the analysis"));
}

TEST(PowerOrder, NamesEachInputThatDiffers) {
  const std::string declaration = declaration_of(order_of(1));
  const auto differing = [&](const auto& change) {
    PowerOrder other = order_of(1);
    change(other);
    return differences(declaration, declaration_of(other));
  };
  EXPECT_EQ(differing([](PowerOrder& order) { order.program = "asperity 0.0.1"; }),
            "the version of the program");
  EXPECT_EQ(differing([](PowerOrder& order) { order.protocol_sha256 = "cc"; }), "the protocol");
  EXPECT_EQ(differing([](PowerOrder& order) { order.assumptions_sha256 = "cc"; }),
            "the assumptions");
  EXPECT_EQ(differing([](PowerOrder& order) { order.effects.pop_back(); }), "the effects");
  EXPECT_EQ(differing([](PowerOrder& order) { order.participants.pop_back(); }),
            "the numbers of participants");
  EXPECT_EQ(differing([](PowerOrder& order) { order.seed = 4; }), "the seed");
  EXPECT_EQ(differing([](PowerOrder& order) { order.runs = 2; }), "") << "runs can be added";
  nlohmann::json later = nlohmann::json::parse(declaration);
  later["format"] = "asperity.power_studies/2";
  EXPECT_EQ(differences(declaration, later.dump()), "the format");
}

TEST(PowerOrder, NamesWhatThePhysicsDiffersIn) {
  const PowerOrder tables = order_of(1);
  PowerOrder physics = tables;
  physics.physics_sha256 = "cc";
  PowerOrder other = physics;
  other.physics_sha256 = "dd";
  constexpr const char* kName = "the stimuli or force models of the full physics";
  EXPECT_EQ(differences(declaration_of(physics), declaration_of(physics)), "");
  EXPECT_EQ(differences(declaration_of(physics), declaration_of(other)), kName);
  EXPECT_EQ(differences(declaration_of(tables), declaration_of(physics)), kName);
  EXPECT_EQ(differences(declaration_of(physics), declaration_of(tables)), kName);
}

// The correction decides; at .05 itself no test of the program is significant.
TEST(SimulatePower, SignificanceIsThatOfTheCorrectedP) {
  EXPECT_FALSE(is_significant({.p = 0.01, .corrected_p = 0.06}));
  EXPECT_TRUE(is_significant({.p = 0.01, .corrected_p = 0.049}));
  EXPECT_FALSE(is_significant({.p = 0.05}));
  EXPECT_TRUE(is_significant({.corrected_p = 0.01}));
  EXPECT_FALSE(is_significant({.status = "no_data"}));
}

TEST(SimulatePower, RefusesOrdersWithoutStudies) {
  PowerOrder order = order_of(1);
  order.participants = {8, 8};
  EXPECT_THROW(simulate_power(order, t_test_study, 1, {}, {}, {}), std::invalid_argument);
  order = order_of(0);
  EXPECT_THROW(simulate_power(order, t_test_study, 1, {}, {}, {}), std::invalid_argument);
  order = order_of(1);
  order.effects = {"a", "a"};
  EXPECT_THROW(simulate_power(order, t_test_study, 1, {}, {}, {}), std::invalid_argument);
}

TEST(StudyRows, AreReadAsTheyWereWritten) {
  const PowerOrder order = order_of(1);
  const StudyPlace place{.run = 7, .effect = 1, .size = 2};
  const SimulatedOutcome outcome{.family = "pairs and preference",
                                 .test = "order rough: a|b",
                                 .method = "wilcoxon",
                                 .p = 0.1 + 0.2,
                                 .lower = -1e-300,
                                 .status = "one_difference"};
  const std::string text = rows_of(order, place, std::vector{outcome});
  EXPECT_EQ(text,
            "7\trating.d=0.7\t24\tpairs and preference\torder rough: a|b\twilcoxon"
            "\t0.30000000000000004\tn/a\tn/a\t-1e-300\tn/a\tone_difference\n");
  const auto row = study_row_in(text.substr(0, text.size() - 1));
  ASSERT_TRUE(row);
  EXPECT_TRUE(row->is_of(order, place));
  EXPECT_FALSE(row->is_of(order, {.run = 7, .effect = 1, .size = 1}));
  EXPECT_EQ(row->outcome.method, outcome.method);
  EXPECT_EQ(row->outcome.p, outcome.p);
  EXPECT_EQ(row->outcome.lower, outcome.lower);
  EXPECT_FALSE(row->outcome.upper);
  EXPECT_EQ(row->outcome.status, outcome.status);
  EXPECT_FALSE(study_row_in("7\trating.d=0.7"));
  // Damaged numbers that no run and no sample has.
  for (const char* const run : {"7.5", "1e300", "99999999999999999999", "-", ""}) {
    EXPECT_FALSE(study_row_in(run + text.substr(1, text.size() - 2))) << run;
  }
}

}  // namespace
}  // namespace asperity
