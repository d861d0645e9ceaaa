// The counts are those of known intervals, the same however they are made, and every number that is looked for is there.

#include "tests/coverage/coverage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/found_numbers.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/coverage_counts.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAreArray;

CoveragePart part_named(const std::string& name) {
  for (const CoveragePart& part : coverage_parts()) {
    if (part.name == name) return part;
  }
  throw std::runtime_error("no part " + name);
}

std::vector<std::string> rows_of(const std::vector<CoverageCount>& counts) {
  std::vector<std::string> rows{};
  for (const CoverageCount& count : counts) rows.push_back(row_of(count));
  return rows;
}

const CoverageCount& count_of(const std::vector<CoverageCount>& counts,
                              const std::string& quantity) {
  const auto found = std::find_if(counts.begin(), counts.end(), [&](const CoverageCount& count) {
    return count.quantity == quantity;
  });
  if (found == counts.end()) throw std::runtime_error("no count of " + quantity);
  return *found;
}

/// Four standard errors of a proportion of `n` about `p`.
double four_errors(double p, double n) { return 4.0 * std::sqrt(p * (1.0 - p) / n); }

// The exact coverage of Wilson's interval for 60 trials at .5 and .87, and the exact size of the binomial test against
// 1/4, summed over the binomial distribution.
TEST(CoverageCounts, AreThoseOfKnownIntervalsAndTests) {
  constexpr std::size_t kTables = 500;
  const CoveragePart part = part_named("recognition");
  for (const auto& [p, exact] : {std::pair{0.5, 0.9481061}, std::pair{0.87, 0.9459820}}) {
    const auto counts = counts_in(part, {.participants = 20, .trials = 3, .effect = p},
                                  {.seed = 3, .tables = kTables});
    const CoverageCount& wilson = count_of(counts, "pc");
    EXPECT_EQ(wilson.given, kTables);
    const double covered =
        1.0 - static_cast<double>(wilson.below + wilson.above) / static_cast<double>(kTables);
    EXPECT_NEAR(covered, exact, four_errors(exact, kTables)) << p;
  }
  constexpr double kSize = 0.0298009;
  const auto counts = counts_in(part, {.participants = 20, .trials = 3, .effect = 0.25},
                                {.seed = 3, .tables = kTables});
  const double rejected =
      static_cast<double>(count_of(counts, "pc.p.greater").rejected) / static_cast<double>(kTables);
  EXPECT_NEAR(rejected, kSize, four_errors(kSize, kTables));
}

TEST(CoverageCounts, AreTheSameForAnyNumberOfJobs) {
  const CoveragePart part = part_named("selection");
  const CoverageSetting setting{.participants = 6, .trials = 4, .effect = 0.0, .spread = 1.0};
  const auto one = rows_of(counts_in(part, setting, {.seed = 7, .tables = 60, .jobs = 1}));
  EXPECT_THAT(rows_of(counts_in(part, setting, {.seed = 7, .tables = 60, .jobs = 3})),
              ElementsAreArray(one));
  EXPECT_NE(rows_of(counts_in(part, setting, {.seed = 8, .tables = 60})), one);
}

TEST(CoverageCounts, GoOnWhereTheyWereStopped) {
  const TemporaryFolder folder;
  CoveragePart part = part_named("groups");
  const std::vector<CoverageSetting> settings{
      {.participants = 6, .trials = 4, .effect = 0.5},
      {.participants = 6, .trials = 4, .effect = 0.7, .spread = 1.0}};
  const CoverageRun run{.seed = 1, .tables = 20};
  const auto append = [&](const std::string& file, std::size_t how_many) {
    part.settings = std::span(settings).first(how_many);
    std::size_t told = 0;
    append_counts(file, {part}, run, [&told](const std::string&) { ++told; });
    return told;
  };
  const std::string at_once = (folder / "once.tsv").string();
  const std::string in_parts = (folder / "parts.tsv").string();
  EXPECT_EQ(append(at_once, 2), 2U);
  EXPECT_EQ(append(in_parts, 1), 1U);
  EXPECT_EQ(append(in_parts, 2), 1U);
  EXPECT_EQ(append(in_parts, 2), 0U);
  EXPECT_EQ(read_file(in_parts), read_file(at_once));
  write_file(folder / "other.tsv", "a\tb\n", Overwrite::refuse);
  EXPECT_THROW(append((folder / "other.tsv").string(), 1), std::runtime_error);
}

// A quantity that a family no longer has would count as never given.
TEST(CoverageParts, FindEveryNumberThatTheyLookFor) {
  for (const CoveragePart& part : coverage_parts()) {
    std::map<std::string, std::uint64_t> given{};
    const bool has_twelve = std::any_of(part.settings.begin(), part.settings.end(),
                                        [](const auto& one) { return one.participants == 12; });
    for (const CoverageSetting& setting : part.settings) {
      if (has_twelve && setting.participants != 12) continue;
      for (const CoverageCount& count : counts_in(part, setting, {.seed = 1, .tables = 2})) {
        given[count.quantity + ' ' + count.key] += count.given;
      }
    }
    for (const auto& [quantity, times] : given) {
      EXPECT_GT(times, 0U) << part.name << ' ' << quantity;
    }
  }
}

// One and a half widths of a 95 % interval are six standard errors.
TEST(CoverageParts, HaveTrueValuesWhereManyParticipantsAre) {
  constexpr std::size_t kMany = 60;
  for (const std::string name : {"response_times",
                                 "learning_times",
                                 "learning_correct",
                                 "ratings",
                                 "repetitions",
                                 "repeated_estimates",
                                 "scores",
                                 "choice_effects",
                                 "equivalence",
                                 "matching_groups",
                                 "differences",
                                 "effects",
                                 "psychometric",
                                 "crossed_textures",
                                 "crossed_ten_textures",
                                 "sensitivity",
                                 "choices_of_three",
                                 "ratings_of_signal",
                                 "choices_by_place",
                                 "thresholds_of_three",
                                 "exponents",
                                 "ordered_categories",
                                 "continuous_scale",
                                 "explored_choices"}) {
    const CoveragePart part = part_named(name);
    for (CoverageSetting setting : part.settings) {
      if (setting.participants != 12) continue;
      setting.participants = kMany;
      Random random = Random(1).split(name_of(part, setting));
      const std::vector<Finding> findings = part.findings(part.draw(setting, random));
      const FoundNumbers found(findings);
      for (const CheckedInterval& checked : part.intervals(setting)) {
        const auto interval = interval_in(found, checked);
        if (!interval) continue;
        const double middle = 0.5 * (interval->low + interval->high);
        EXPECT_LE(std::abs(checked.truth - middle), 1.5 * (interval->high - interval->low) + 1e-9)
            << name_of(part, setting) << checked.quantity << ' ' << checked.key;
      }
    }
  }
}

/// P(p ≤ .05) of a permutation test of m items with B random orders, if their statistics differ: of m! orders the observed
/// one has every rank k with the same probability, and p = (1 + b)/(B + 1) with b ~ B(B, k/m!).
double attainable_size(std::size_t items) {
  constexpr double kDraws = 9999.0;
  constexpr double kMost = 499.0;  // p ≤ .05
  const double orders = std::tgamma(static_cast<double>(items) + 1.0);
  if (orders > kDraws) return (kMost + 1.0) / (kDraws + 1.0);
  double size = 0.0;
  for (double k = 1.0; k < orders; k += 1.0) {
    const double p = k / orders;
    for (double b = 0.0; b <= kMost; b += 1.0) {
      size += std::exp(std::lgamma(kDraws + 1.0) - std::lgamma(b + 1.0) -
                       std::lgamma(kDraws - b + 1.0) + b * std::log(p) +
                       (kDraws - b) * std::log1p(-p)) /
              orders;
    }
  }
  return size;
}

// The stress of 199 permutations has p ≤ .05 at ten of 200 ranks. The standard error of its 400 tables is 1.1 %.
TEST(CoverageCounts, HaveTheAttainableSizeOfPermutationTests) {
  const auto check = [](const std::string& part, const std::string& quantity, double most,
                        const auto& attainable_of) {
    const std::vector<DrawnCount> counts = coverage_counts(part, quantity);
    EXPECT_THAT(counts, testing::Not(testing::IsEmpty())) << part;
    for (const DrawnCount& count : counts) {
      if (count.given == 0.0) continue;  // six items: permuted ratings fit perfectly
      const double rejected = count.failed / count.given;
      const double attainable = attainable_of(count);
      EXPECT_LE(rejected, most) << part << ' ' << quantity << ' ' << count.participants;
      EXPECT_NEAR(rejected, attainable, four_errors(attainable, count.given))
          << part << ' ' << quantity << ' ' << count.participants;
    }
  };
  const auto of_items = [](const DrawnCount& count) {
    return attainable_size(static_cast<std::size_t>(count.participants));
  };
  check("guessed_pairs", "stress.perm.p", 0.07, [](const DrawnCount&) { return 0.05; });
  check("unrelated_properties", "property.perm.p", 0.06, of_items);
  check("unrelated_properties", "protest.p", 0.06, of_items);
}

TEST(CoverageParts, KnowTheMeanOfALogisticVariable) {
  EXPECT_NEAR(mean_of_logistic(0.0, 1.0), 0.5, 1e-12);
  EXPECT_NEAR(mean_of_logistic(1.0, 0.0), 1.0 / (1.0 + std::exp(-1.0)), 1e-15);
  for (const double p : {0.05, 0.5, 0.98}) {
    EXPECT_NEAR(mean_of_logistic(mu_of_mean(p, 1.0), 1.0), p, 1e-12);
  }
  EXPECT_THROW(mu_of_mean(1.0, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
