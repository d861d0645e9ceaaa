// Rated dissimilarities, from the rows of a study to its configuration, its reliability and its tests.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// An item in the plane.
struct PlantedItem {
  const char* name = "";
  double x = 0.0;
  double y = 0.0;
};
constexpr std::array kPlantedItems{PlantedItem{"brick", 0, 0}, PlantedItem{"cork", 3, 0},
                                   PlantedItem{"felt", 5, 2},  PlantedItem{"metal", 1, 4},
                                   PlantedItem{"oak", 4, 5},   PlantedItem{"slate", 2, 2},
                                   PlantedItem{"steel", 0, 5}, PlantedItem{"stone", 5, 0},
                                   PlantedItem{"wax", 3, 3},   PlantedItem{"wool", 1, 1}};

std::string protocol_that_rates(const std::string& quantity) {
  return R"({"kind": "similarity", "blocks": {"only": {"question": {"name": "different",
      "prompt": "How different?", "rates": ")" +
         quantity + R"(", "scale": {"minimum": 0, "maximum": 100}}}},
      "analysis": {"family": ["configuration", "identical", "properties"]}})";
}

MadeUpTrial rated(const PlantedItem& first, const PlantedItem& second, double rating) {
  MadeUpTrial trial{};
  for (const PlantedItem* const item : {&first, &second}) {
    trial.surfaces.push_back(surface_of(item->name, "height_map", item->name));
    trial.surfaces.back().achieved_texture_force_N = 0.1 + 0.02 * item->x;
  }
  trial.questions = {"different"};
  trial.answers = {std::to_string(static_cast<int>(std::lround(rating)))};
  return trial;
}

/// Ten times the distance, and a deviation that differs between participants and pairs.
double rating_of(const PlantedItem& first, const PlantedItem& second, int person, int deviation) {
  return 10.0 * std::hypot(first.x - second.x, first.y - second.y) +
         static_cast<double>((person * 7 + deviation) % 5);
}

struct RatedStudyOptions {
  int people = 4;
  std::size_t items = 6;
  std::string rates = "dissimilarity";
  bool both_orders = true;
  bool identical = true;
  bool only_first_pair = false;
  /// Two halves of the items: all pairs between them are rated higher than all within them.
  bool two_clusters = false;
  /// The first half of the items: their pairs are rated lower than all others, without a structure.
  bool one_cluster = false;
};

AnalysisOutcome make_ratings(const RatedStudyOptions& options) {
  const auto stored = [&options](double dissimilarity) {
    return options.rates == "similarity" ? 100.0 - dissimilarity : dissimilarity;
  };
  const auto trials_of_person = [&](int person) {
    std::vector<MadeUpTrial> trials{};
    int deviation = 0;
    for (std::size_t i = 0; i < options.items; ++i) {
      const PlantedItem& first = kPlantedItems[i];
      if (options.identical) trials.push_back(rated(first, first, stored(person % 2)));
      for (std::size_t j = i + 1; j < options.items; ++j) {
        if (options.only_first_pair && !(i == 0 && j == 1)) continue;
        const PlantedItem& second = kPlantedItems[j];
        if (options.two_clusters) {
          const std::size_t half = options.items / 2;
          ++deviation;
          const int draw = deviation * 37 + person * 13;
          const int rating = (i < half) == (j < half) ? 20 + draw % 23 : 75 + draw % 19;
          trials.push_back(rated(first, second, rating));
          continue;
        }
        if (options.one_cluster && j < options.items / 2) {
          trials.push_back(rated(first, second, 20 + (++deviation * 37 + person * 13) % 23));
          continue;
        }
        if (options.one_cluster) {
          // From the cluster, which has one position.
          const PlantedItem& from = i < options.items / 2 ? kPlantedItems[0] : first;
          const double far = 40.0 + rating_of(from, second, person, ++deviation);
          trials.push_back(rated(first, second, far));
          continue;
        }
        trials.push_back(
            rated(first, second, stored(rating_of(first, second, person, ++deviation))));
        if (options.both_orders)
          trials.push_back(
              rated(second, first, stored(rating_of(first, second, person, ++deviation))));
      }
    }
    return trials;
  };
  MadeUpStudy made;
  add_participants(made, made.add_protocol("map", "similarity", protocol_that_rates(options.rates)),
                   {.number = options.people, .first = 1}, trials_of_person);
  std::vector<AnalysisOutcome> outcomes = analyze_study(made.study());
  EXPECT_EQ(outcomes.size(), 1U) << "its scale is not analysed as ratings as well";
  return std::move(outcomes.front());
}

/// Computed once in this process for these options.
const AnalysisOutcome& outcome_of_ratings(const RatedStudyOptions& options) {
  return outcome_once(outcome_key("ratings", options.people, options.items, options.rates,
                                  options.both_orders, options.identical, options.only_first_pair,
                                  options.two_clusters, options.one_cluster),
                      [&options] { return make_ratings(options); });
}

std::string answer_about_configuration(const AnalysisOutcome& outcome) {
  return question_of(outcome, "configuration").answer.english();
}

TEST(RatedDissimilarities, AreTheMeansOfBothOrdersFromTheEndForIdenticalSurfaces) {
  for (const char* const rates : {"dissimilarity", "similarity"}) {
    const AnalysisOutcome& outcome = outcome_of_ratings({.rates = rates});
    const FoundNumbers found(outcome.findings);
    double sum = 0.0;
    for (int person = 0; person < 4; ++person) {
      // The ninth and the tenth deviation.
      sum += 0.5 * (std::round(rating_of(kPlantedItems[0], kPlantedItems[5], person, 9)) +
                    std::round(rating_of(kPlantedItems[0], kPlantedItems[5], person, 10)));
    }
    EXPECT_NEAR(found.value("dissimilarity", "brick|slate").value(), sum / 4.0, 1e-9) << rates;
    EXPECT_NEAR(found.value("identical.mean").value(), 0.5, 1e-9) << rates;
    EXPECT_EQ(table_of(outcome, "dissimilarities").table.rows.size(), 15U);
    const Table& identical = table_of(outcome, "identical_pairs").table;
    EXPECT_NEAR(*number_of(identical.rows.at(0).at(*column_of(identical, "mean"))), 0.5, 1e-9);
    const bool is_one = found.value("cv.chosen").value_or(2.0) < 2.0;
    EXPECT_EQ(answer_about_configuration(outcome).find("chose one dimension") != std::string::npos,
              is_one);
  }
}

TEST(RatedDissimilarities, HaveAConfigurationWithTheStructureOfThePlane) {
  const AnalysisOutcome& outcome = outcome_of_ratings({.items = 8});
  const FoundNumbers found(outcome.findings);
  EXPECT_EQ(found.value("stress.perm.p").value(), 1.0 / 200.0) << "below all permutations";
  EXPECT_LT(found.value("stress.ordinal", "2").value(), 0.02);
  const std::string answer = answer_about_configuration(outcome);
  EXPECT_THAT(answer, HasSubstr("Yes: the configuration in 2 dimensions has a stress-1 of "));
  EXPECT_THAT(answer, HasSubstr("Permutation test: "));
  const Table& configuration = table_of(outcome, "configuration").table;
  EXPECT_EQ(configuration.rows.size(), 8U);
  EXPECT_EQ(configuration.columns.size(), 1U + 2U + 3U);
  EXPECT_EQ(table_of(outcome, "tree").table.rows.size(), 7U);
}

TEST(RatedDissimilarities, WarnBelowFourItemsPerDimensionAndOne) {
  EXPECT_THAT(remarks_of(outcome_of_ratings({})),
              HasSubstr("2 dimensions require at least 9 items, and the number of items is 6"));
}

TEST(RatedDissimilarities, HaveAReliabilityForEveryParticipant) {
  const AnalysisOutcome& outcome = outcome_of_ratings({});
  const FoundNumbers found(outcome.findings);
  const Table& raters = table_of(outcome, "weights").table;
  ASSERT_EQ(raters.rows.size(), 4U);
  for (int person = 1; person <= 4; ++person) {
    const std::string label = "p" + std::to_string(person);
    EXPECT_GT(found.value("orders.r", label).value(), 0.95) << "deviations of up to 4 in 10 to 64";
    EXPECT_LT(found.value("orders.r", label).value(), 1.0);
    EXPECT_GT(found.value("retest.r", label).value(), 0.95);
  }
  const AnalysisOutcome& once = outcome_of_ratings({.both_orders = false});
  EXPECT_EQ(FoundNumbers(once.findings).find("retest.r", "p1"), nullptr) << "no pair was repeated";
}

TEST(RatedDissimilarities, AreTestedAgainstIdenticalPairsAndMeasuredProperties) {
  const AnalysisOutcome& outcome = outcome_of_ratings({});
  const FoundNumbers found(outcome.findings);
  EXPECT_LT(found.value("t.p.two", "identical").value(), 0.001);
  // The texture force is a linear function of the first coordinate.
  EXPECT_GT(found.value("property.r2", "texture_force_N").value(), 0.97);
  EXPECT_LT(found.value("property.perm.p", "texture_force_N").value(), 0.05);
  const Table& tests = table_of(outcome, "tests").table;
  EXPECT_EQ(tests.rows.size(), 3U) << "configuration, identical pairs, one property";
  const AnalysisOutcome& without = outcome_of_ratings({.identical = false});
  std::string reasons{};
  for (const auto& row : table_of(without, "tests").table.rows) {
    for (const Cell& cell : row) {
      if (const auto* const text = std::get_if<std::string>(&cell)) reasons += *text + ' ';
    }
  }
  EXPECT_THAT(reasons, HasSubstr("no_identical_pairs"));
}

TEST(RatedDissimilarities, WarnOfADegenerateConfiguration) {
  EXPECT_THAT(remarks_of(outcome_of_ratings({})), Not(HasSubstr("degenerate")));
  const AnalysisOutcome& clusters = outcome_of_ratings({.items = 10, .two_clusters = true});
  EXPECT_LT(FoundNumbers(clusters.findings).value("stress.ordinal", "2").value(), 0.001);
  EXPECT_THAT(remarks_of(clusters), HasSubstr("The non-metric configuration is degenerate"));
}

// In the non-metric configuration each of the two clusters is one point. The distances of the metric one also differ within them, as
// the dissimilarities do.
TEST(RatedDissimilarities, HaveTheMetricConfigurationWhereTheNonMetricOneIsDegenerate) {
  const AnalysisOutcome& clusters = outcome_of_ratings({.items = 10, .two_clusters = true});
  const FoundNumbers found(clusters.findings);
  EXPECT_EQ(found.find("configuration.level")->word, "ratio");
  double smallest = 1e9;
  double largest = 0.0;
  for (const Finding* const one : found.all("distance")) {
    smallest = std::min(smallest, one->value.value());
    largest = std::max(largest, one->value.value());
  }
  EXPECT_GT(smallest, 0.01 * largest) << "no two items lie on one point";
  const std::string dimensions =
      std::to_string(static_cast<int>(found.value("dimensions").value()));
  EXPECT_NEAR(found.value("stress.perm.observed").value(),
              found.value("stress.ratio", dimensions).value(), 0.02);
  EXPECT_THAT(answer_about_configuration(clusters), HasSubstr("Metric scaling, because"));
  EXPECT_THAT(table_of(clusters, "configuration").note.english(), HasSubstr("Metric (ratio)"));
  EXPECT_THAT(estimate_sentence(clusters).text, HasSubstr("Metric scaling, because"));
  EXPECT_EQ(FoundNumbers(outcome_of_ratings({}).findings).find("configuration.level")->word,
            "ordinal");
}

// Three items or more whose dissimilarities are below those to all others: non-metric scaling puts them on one point.
TEST(RatedDissimilarities, HaveTheMetricConfigurationWhereAPartOfTheItemsLiesOnOnePoint) {
  const AnalysisOutcome& cluster = outcome_of_ratings({.items = 10, .one_cluster = true});
  const FoundNumbers found(cluster.findings);
  EXPECT_GT(found.value("ordinal.disparities").value(), 3.0) << "these alone do not show it";
  EXPECT_EQ(found.find("configuration.level")->word, "ratio");
  EXPECT_THAT(remarks_of(cluster),
              HasSubstr("The non-metric configuration is degenerate: 5 items lie on one point "
                        "(brick, cork, felt, metal and oak), and their mean dissimilarities, on "
                        "which its stress does not depend, are 2"));
  EXPECT_THAT(answer_about_configuration(cluster), HasSubstr("Metric scaling, because"));
  const std::string paper = estimate_sentence(cluster).text;
  EXPECT_THAT(paper, HasSubstr("Metric scaling, because"));
  EXPECT_THAT(paper, testing::ContainsRegex("^The configuration in [2-5] dimensions had a "));
}

/// One participant and eight items in four clusters of two. All dissimilarities within clusters are below all between them, and neither
/// have an order that a configuration could show.
std::string four_clusters() {
  std::string table = "subject,first,second,dissimilarity\n";
  int pair = 0;
  for (int i = 0; i < 8; ++i) {
    for (int j = i + 1; j < 8; ++j) {
      const int draw = ++pair * 37 % 41;
      const int dissimilarity = i / 2 == j / 2 ? 5 + draw % 20 : 50 + draw;
      table += "s,i" + std::to_string(i) + ",i" + std::to_string(j) + ',' +
               std::to_string(dissimilarity) + '\n';
    }
  }
  return table;
}

// Four points with one distance from each other exist in three dimensions and not in the plane.
TEST(RatedDissimilarities, AreJudgedDegenerateInTheDimensionsThatAreReported) {
  const auto level_in = [](const char* options) {
    TidyInput input{.options = FamilyOptions::of_json(options, "options")};
    input.tables.emplace_back(four_clusters(), "t.csv");
    const std::vector<Finding> findings = tidy_family("similarity").findings(input);
    return FoundNumbers(findings).find("configuration.level")->word;
  };
  EXPECT_EQ(level_in(R"({"dimensions": 2})"), "ordinal");
  EXPECT_EQ(level_in(R"({"dimensions": 3})"), "ratio");
}

// The items are permuted, not responses.
TEST(RatedDissimilarities, AreNotPooledInTheTestOfAProperty) {
  const AnalysisOutcome& outcome = outcome_of_ratings({});
  const std::string sentence = sentence_about(outcome, "properties");
  EXPECT_THAT(sentence, HasSubstr("n = 6 items"));
  EXPECT_THAT(sentence, Not(HasSubstr("pooled")));
}

// The order of the dissimilarities of four items has a perfect fit in the plane, whatever the ratings are.
TEST(RatedDissimilarities, AreNotTestedWherePermutedRatingsFitPerfectly) {
  const AnalysisOutcome& four = outcome_of_ratings({.people = 12, .items = 4});
  const FoundNumbers found(four.findings);
  EXPECT_EQ(found.find("configuration.level")->word, "ordinal");
  EXPECT_LT(found.value("stress.perm.mean").value(), 0.001);
  EXPECT_EQ(found.find("stress.perm.p")->word, "permuted_fit_perfectly");
  EXPECT_TRUE(std::none_of(four.findings.begin(), four.findings.end(), [](const Finding& one) {
    return one.quantity == "stress.perm.reduction";
  }));
  EXPECT_EQ(answer_about_configuration(four),
            "Not tested: with 4 surfaces, a configuration in 2 dimensions fits many permuted "
            "ratings perfectly, so that no ratings can fit significantly better; see the mean "
            "dissimilarities of the pairs.");
  EXPECT_EQ(question_of(four, "configuration").table, "dissimilarities");
  EXPECT_THAT(sentence_about(four, "configuration"), HasSubstr("too few surfaces"));
  // Of the permuted ratings of six items, a part fits perfectly, which is enough.
  const FoundNumbers six(outcome_of_ratings({}).findings);
  EXPECT_GT(six.value("stress.perm.mean").value(), 0.01);
  EXPECT_LT(six.value("stress.perm.p05").value(), 1e-9);
  EXPECT_FALSE(six.value("stress.perm.p").has_value());
}

TEST(RatedDissimilarities, StateWhyThereIsNoConfiguration) {
  const AnalysisOutcome& few = outcome_of_ratings({.items = 3});
  EXPECT_EQ(answer_about_configuration(few), "Not tested: too few items.");
  const AnalysisOutcome& unrelated = outcome_of_ratings({.only_first_pair = true});
  EXPECT_EQ(answer_about_configuration(unrelated),
            "Not tested: the rated pairs do not connect all items.");
}

}  // namespace
}  // namespace asperity
