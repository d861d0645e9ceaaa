// The figures of precision: those of a power analysis with the same studies, their Monte-Carlo errors, and what has to be stated.

#include "app/power/curve/precision.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/power/curve/simulate_power.h"
#include "protocols/file/protocol_reader.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using What = PrecisionFigure::What;

Protocol protocol_of_library(const std::string& name) {
  return read_protocol(test::library_text(name), name, test::models_of_library());
}

PowerModel jnd_model() {
  const Protocol protocol = protocol_of_library("amplitude_jnd");
  const std::string question = "comparisons.rougher.";
  return {protocol,
          with_stated(assumptions_of(protocol),
                      {{question + "order", 0.4}, {question + "order_sd", 0.3}}, "the test")};
}

PrecisionStudies simulated(const PowerModel& model, std::int64_t studies, std::uint64_t seed = 1) {
  PrecisionStudies made(model, 6, seed);
  made.simulate(studies, {});
  return made;
}

const PrecisionOf& result_named(const std::vector<PrecisionOf>& results, const std::string& name) {
  const auto found = std::ranges::find(results, name, &PrecisionOf::name);
  if (found == results.end()) throw std::runtime_error("no result " + name);
  return *found;
}

PrecisionFigure figure_of(const PrecisionOf& result, What what) {
  const auto found = std::ranges::find(result.figures, what, &PrecisionFigure::what);
  return found == result.figures.end() ? PrecisionFigure{.what = what} : *found;
}

void expect_equal_results(const std::vector<PrecisionOf>& one,
                          const std::vector<PrecisionOf>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    SCOPED_TRACE(one[i].name);
    EXPECT_EQ(one[i].name, other[i].name);
    ASSERT_EQ(one[i].figures.size(), other[i].figures.size());
    for (std::size_t j = 0; j < one[i].figures.size(); ++j) {
      EXPECT_EQ(one[i].figures[j].value, other[i].figures[j].value);
    }
  }
}

TEST(Precision, NamesWhatHasToBeStated) {
  const std::vector<Assumption> usual = assumptions_of(protocol_of_library("amplitude_jnd"));
  EXPECT_EQ(names_without_value(usual), (std::vector<std::string>{"comparisons.rougher.order",
                                                                  "comparisons.rougher.order_sd"}));
  const std::vector<Assumption> stated =
      with_stated(usual, {{"comparisons.rougher.order", 0.2}, {"unknown", 1.0}}, "the test");
  EXPECT_EQ(names_without_value(stated), std::vector<std::string>{"comparisons.rougher.order_sd"});
  EXPECT_EQ(stated.size(), usual.size());
}

TEST(Precision, DependsOnSeedAndNumberOfStudiesAlone) {
  const PowerModel model = jnd_model();
  const PrecisionStudies at_once = simulated(model, 12);
  PrecisionStudies in_parts(model, 6, 1);
  in_parts.simulate(5, {});
  const PrecisionStudies copy = in_parts;
  in_parts.simulate(12, [&in_parts] { return in_parts.studies() >= 12; });
  EXPECT_EQ(in_parts.studies(), 12);
  EXPECT_EQ(copy.studies(), 5);
  expect_equal_results(in_parts.results(), at_once.results());
  const auto width = [](const PrecisionStudies& studies) {
    return figure_of(result_named(studies.results(), "order"), What::median_width).value;
  };
  ASSERT_TRUE(width(at_once).has_value());
  EXPECT_NE(width(at_once), width(simulated(model, 12, 2)));
}

TEST(Precision, HasTheNumbersOfThePowerAnalysisOfTheSameStudies) {
  const PowerModel model = jnd_model();
  constexpr std::int64_t kRuns = 12;
  const SimulatedPower power =
      simulate_power({.effects = {"order"}, .participants = {6}, .seed = 1, .runs = kRuns},
                     [&model](std::size_t, int participants, std::uint64_t seed, std::int64_t run) {
                       return simulate_and_analyse(model, participants, seed, run);
                     },
                     1, {}, {}, {});
  const std::vector<PrecisionOf> results = simulated(model, kRuns).results();
  const PrecisionOf& order = result_named(results, "order");
  ASSERT_EQ(power.curves.size(), 2U) << "the test, and its family";
  const TestAtSize& counts = power.curves.front().sizes.front();
  EXPECT_EQ(order.family, power.curves.front().family);
  EXPECT_EQ(order.without_p, counts.without_p);
  const PrecisionFigure found = figure_of(order, What::power);
  EXPECT_EQ(found.value, counts.power.power);
  EXPECT_EQ(found.interval->low, counts.power.interval.low);
  EXPECT_EQ(found.interval->high, counts.power.interval.high);
  const PrecisionFigure width = figure_of(order, What::median_width);
  EXPECT_EQ(width.value, counts.median_width);
  EXPECT_LE(width.interval->low, *width.value);
  EXPECT_GE(width.interval->high, *width.value);
  EXPECT_FALSE(figure_of(order, What::p90_width).value.has_value())
      << "the interval of this quantile needs more studies";
  EXPECT_EQ(order.measure, "difference of proportions");
  EXPECT_EQ(std::ranges::count(results, std::string(), &PrecisionOf::name), 0)
      << "the family of a single test is that test";
}

// With threshold_sd = 0.4 the mean logarithm of 6 participants' thresholds has at least the SD 0.4/√6 = 0.16 of the threshold.
TEST(Precision, HasTheStandardErrorOfTheThreshold) {
  const PowerModel model = jnd_model();
  const std::string name = "comparisons.rougher.threshold";
  const std::vector<PrecisionOf> results = simulated(model, 60).results();
  const PrecisionOf& threshold = result_named(results, name);
  EXPECT_TRUE(threshold.family.empty());
  ASSERT_EQ(threshold.figures.size(), 1U);
  const PrecisionFigure error = figure_of(threshold, What::standard_error);
  const auto assumed = std::ranges::find(model.assumptions(), name, &Assumption::name);
  ASSERT_TRUE(error.value.has_value());
  EXPECT_GT(*error.value, 0.1 * *assumed->value);
  EXPECT_LT(*error.value, 0.6 * *assumed->value);
  EXPECT_LT(error.interval->low, *error.value);
  EXPECT_GT(error.interval->high, *error.value);
  EXPECT_EQ(std::ranges::count(results, name + "_sd", &PrecisionOf::name), 0);
}

TEST(Precision, StatesNoFigureOfAFewStudies) {
  const std::vector<PrecisionOf> results = simulated(jnd_model(), 2).results();
  const PrecisionOf& order = result_named(results, "order");
  EXPECT_TRUE(figure_of(order, What::power).value.has_value()) << "its interval is exact";
  for (const What what : {What::median_width, What::p90_width, What::standard_error}) {
    EXPECT_FALSE(figure_of(order, what).value.has_value());
    EXPECT_FALSE(figure_of(order, what).interval.has_value());
  }
}

TEST(Precision, NamesTheEffectSize) {
  const Protocol protocol = protocol_of_library("roughness_of_photographs");
  std::map<std::string, double> stated{};
  for (const std::string& name : names_without_value(assumptions_of(protocol))) stated[name] = 8.0;
  const PowerModel model(protocol, with_stated(assumptions_of(protocol), stated, "the test"));
  EXPECT_EQ(simulated(model, 1).results().front().measure, "W") << "of Friedman's test";
}

TEST(EstimateSpread, HasTheMomentsOfItsNumbers) {
  const std::vector<double> numbers{1.0, 4.0, 2.5, -3.0, 8.0, 0.5, 2.0};
  EstimateSpread spread{};
  double sum = 0.0;
  for (const double number : numbers) {
    spread.add(number);
    sum += number;
  }
  const auto n = static_cast<double>(numbers.size());
  double second = 0.0;
  double fourth = 0.0;
  for (const double number : numbers) {
    second += std::pow(number - sum / n, 2);
    fourth += std::pow(number - sum / n, 4);
  }
  const double variance = second / (n - 1.0);
  const double of_variance = (fourth / n - variance * variance * (n - 3.0) / (n - 1.0)) / n;
  EXPECT_NEAR(spread.mean(), sum / n, 1e-12);
  EXPECT_NEAR(spread.standard_error(), std::sqrt(variance), 1e-12);
  EXPECT_NEAR(spread.error_of_standard_error(),
              std::sqrt(of_variance) / (2.0 * std::sqrt(variance)), 1e-12);
}

TEST(IntervalOfQuantile, HasTheRanksOfABinomialNumber) {
  PositiveQuantiles numbers{};
  for (int i = 1; i <= 100; ++i) numbers.add(i);
  const auto interval = interval_of_quantile(numbers, 0.5);  // 50 ± 9.8
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 40.0, 0.05);
  EXPECT_NEAR(interval->high, 61.0, 0.07);
  EXPECT_FALSE(interval_of_quantile(numbers, 0.99).has_value());
}

}  // namespace
}  // namespace asperity
