// Rated dissimilarities of pairs: stress compared with that of permuted ratings, and properties of the items.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dissimilarity/procrustes.h"
#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/rated_pairs.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

constexpr std::array kNoEffect{0.0};
constexpr std::array kNoSpread{0.0};
/// A scale of 0 to 100, as in the library.
constexpr double kLongest = 100.0;

/// The places of an item in a plane.
using Place = std::array<double, 2>;

template <class Rating>
DrawnTable rated_pairs_of(const CoverageSetting& setting, Rating rating) {
  DrawnTable table("subject,first,second,dissimilarity");
  for (std::size_t rater = 0; rater < setting.trials; ++rater) {
    for (std::size_t i = 0; i < setting.participants; ++i) {
      for (std::size_t j = i + 1; j < setting.participants; ++j) {
        table.add({participant_label(rater), 'T' + std::to_string(i + 1),
                   'T' + std::to_string(j + 1), number_text(rating(i, j))});
      }
    }
  }
  return table;
}

// --- ratings without a relation to the pairs ---------------------------------------------------------

/// Every point of the scale is equally probable.
TidyInput draw_guessed_pairs(const CoverageSetting& setting, Random& random) {
  constexpr std::uint64_t kPoints = 101;
  return rated_pairs_of(setting,
                        [&random](std::size_t, std::size_t) {
                          return static_cast<double>(random.below(kPoints));
                        })
      .as_input();
}

/// The test of the family `similarity`, in two dimensions, without its other analyses.
std::vector<Finding> findings_of_stress(const TidyInput& input) {
  const StressByChance stress = stress_by_chance(judged_pairs_in(input.table(), {}).by_rater());
  FindingList list{};
  list.number("stress.perm.p", "", stress.can_be_significant() ? stress.p : kUndefined, {});
  return list.take();
}

std::vector<CheckedTest> stress_tests(const CoverageSetting&) {
  return {{.quantity = "stress.perm.p"}};
}

// --- properties without a relation to the items ------------------------------------------------------

constexpr std::array kProperties{"height", "friction"};
/// Of a rating, relative to the scale.
constexpr double kRatingNoise = 0.1;

/// The items have places in a plane, which the properties do not depend on. The second table has the properties.
TidyInput draw_unrelated_properties(const CoverageSetting& setting, Random& random) {
  std::vector<Place> places(setting.participants);
  for (Place& place : places) place = {random.uniform(), random.uniform()};
  TidyInput input = rated_pairs_of(setting, [&](std::size_t i, std::size_t j) {
                      const double distance =
                          std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
                      const double rated =
                          distance / std::sqrt(2.0) + kRatingNoise * random.normal();
                      return std::clamp(std::round(kLongest * rated), 0.0, kLongest);
                    }).as_input();
  DrawnTable properties("item,property,value");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    for (const char* const property : kProperties)
      properties.add({'T' + std::to_string(i + 1), property, number_text(random.normal())});
  }
  input.tables.push_back(std::move(std::move(properties).as_input().tables.front()));
  return input;
}

/// The tests of the family `similarity`, in two dimensions, without its other analyses.
std::vector<Finding> findings_of_properties(const TidyInput& input) {
  const JudgedPairs judged = judged_pairs_in(input.table(), {});
  const Eigen::MatrixXd points = scaled(mean_of_raters(judged.by_rater())).points;
  const TidyTable& table = input.table(1);
  const LabelColumn items = table.labels("item", judged.items);
  const LabelColumn names = table.all_labels("property");
  const std::vector<double> values = table.all_numbers("value");
  Eigen::MatrixXd together(points.rows(), static_cast<Eigen::Index>(names.names.size()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    together(static_cast<Eigen::Index>(items.codes[row]),
             static_cast<Eigen::Index>(names.codes[row])) = values[row];
  }
  const std::optional<PropertyFit> fit = property_fit(points, together.col(0));
  together.rowwise() -= together.colwise().mean().eval();
  together.colwise().normalize();
  const std::optional<Protest> all = protest(points, together);
  FindingList list{};
  list.number("property.perm.p", names.names.front(), fit ? fit->p : kUndefined, {});
  list.number("protest.p", "", all ? all->p : kUndefined, {});
  return list.take();
}

std::vector<CheckedTest> property_tests(const CoverageSetting&) {
  return {{.quantity = "property.perm.p", .key = kProperties.front()}, {.quantity = "protest.p"}};
}

/// The items are as many as the participants of a design, and the raters as many as its trials. Five items have ten pairs,
/// which a plane fits in many orders without stress and with items on one point.
std::vector<CoverageSetting> designs_with_items() {
  std::vector<CoverageSetting> settings = all_designs(kNoEffect, kNoSpread);
  std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 6; });
  return settings;
}

}  // namespace

std::span<const CoveragePart> similarity_parts() {
  static const auto kWithItems = designs_with_items();
  static const std::array kParts{
      CoveragePart{.name = "guessed_pairs",
                   .model = "dissimilarities of all pairs of as many items as the design has "
                            "participants, from as many raters as it has trials; all raters guess; "
                            "stress-1 in two dimensions compared with that of permuted ratings, by "
                            "the function that the family `similarity` calls",
                   .effect = "always 0",
                   .spread = "always 0",
                   .settings = kWithItems,
                   .draw = draw_guessed_pairs,
                   .findings = findings_of_stress,
                   .intervals = no_intervals,
                   .tests = stress_tests,
                   .tables = 2000},
      CoveragePart{.name = "unrelated_properties",
                   .model =
                       "items and raters as in `guessed_pairs`; the ratings are distances in a "
                       "plane with normal noise; the configuration in two dimensions is "
                       "compared with two normal properties that do not depend on the places "
                       "(PROTEST), and with one of them (property fitting)",
                   .effect = "always 0",
                   .spread = "always 0",
                   .settings = kWithItems,
                   .draw = draw_unrelated_properties,
                   .findings = findings_of_properties,
                   .intervals = no_intervals,
                   .tests = property_tests,
                   .tables = 10000}};
  return kParts;
}

}  // namespace asperity
