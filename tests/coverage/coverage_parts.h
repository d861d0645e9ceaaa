// What is drawn to see whether intervals cover and tests keep their size.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/random.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// One cell of the grid: how many participants give how many answers, and what is true of them.
struct CoverageSetting {
  std::size_t participants = 0;
  std::size_t trials = 0;  ///< of each participant
  double effect = 0.0;     ///< in the unit of the part's model
  double spread =
      0.0;  ///< standard deviation between participants, in the unit of the part's model
};

/// An interval that the family reports: of a finding, or between two findings where `lower` and `upper` name these.
struct CheckedInterval {
  std::string quantity{};
  std::string key{};
  double truth = 0.0;
  std::string lower{};
  std::string upper{};
};

/// A p-value whose null hypothesis is true in the setting.
struct CheckedTest {
  std::string quantity{};
  std::string key{};
};

/// A model that tables are drawn from, what analyses them, and what must hold of its findings.
///
/// To add one: its functions in one of the files *_parts.cpp, its row in that file's array.
struct CoveragePart {
  std::string_view name{};
  std::string_view model{};   ///< a sentence for the documentation
  std::string_view effect{};  ///< what CoverageSetting::effect is
  std::string_view spread{};  ///< what CoverageSetting::spread is
  std::span<const CoverageSetting> settings{};
  TidyInput (*draw)(const CoverageSetting&, Random&) = nullptr;
  /// A family's; or, of numbers that only a study's analysis gives, a function that hands it the table's rows.
  std::vector<Finding> (*findings)(const TidyInput&) = nullptr;
  std::vector<CheckedInterval> (*intervals)(const CoverageSetting&) = nullptr;
  std::vector<CheckedTest> (*tests)(const CoverageSetting&) = nullptr;
  std::size_t tables = 4000;  ///< of each setting: fewer where an analysis takes long
};

/// In the order of the documentation.
std::vector<CoveragePart> coverage_parts();

/// Of proportions and choices.
std::span<const CoveragePart> choice_parts();
/// Of assignments of pictures to surfaces.
std::span<const CoveragePart> matching_parts();
/// Of scales: worths of compared items, estimated magnitudes.
std::span<const CoveragePart> scale_parts();
/// Of response times, and of what changes over the trials.
std::span<const CoveragePart> time_parts();
/// Of reliability over repetitions, and of agreement between participants.
std::span<const CoveragePart> agreement_parts();
/// Of differences, their equivalence and their effect sizes.
std::span<const CoveragePart> difference_parts();
/// Of psychometric functions and mixed models of correct responses.
std::span<const CoveragePart> model_parts();
/// Of sensitivity and the ROC of ratings.
std::span<const CoveragePart> detection_parts();
/// Of choices among three surfaces, and of thresholds of split counts.
std::span<const CoveragePart> discrimination_parts();
/// Of a mean of thresholds of which some lie outside the levels.
std::span<const CoveragePart> left_out_parts();
/// Of ratings on ordered categories and continuous scales.
std::span<const CoveragePart> rating_parts();
/// Of choices that depend on the exploration.
std::span<const CoveragePart> exploration_parts();
/// Of rated dissimilarities.
std::span<const CoveragePart> similarity_parts();

/// All combinations: the designs are 20 × 3, 12 × 12, 6 × 20 and 2 to 5 participants × 12.
std::vector<CoverageSetting> all_designs(std::span<const double> effects,
                                         std::span<const double> spreads);

/// The mean of `of` over a standard normal variable.
double mean_over_normal(const std::function<double(double)>& of);
/// The mean of 1/(1 + exp(−(μ + spread·z))) over standard normal z.
double mean_of_logistic(double mu, double spread);
/// The μ with that mean. Throws std::invalid_argument where `mean` is not between 0 and 1.
double mu_of_mean(double mean, double spread);

/// Something of each of three items, of which the best is chosen.
using ThreeItems = std::array<double, 3>;
/// A participant's own weights in Luce's rule: exp of utilities that are normal about these means.
ThreeItems own_weights(const ThreeItems& mean_utilities, double spread, Random& random);
/// The probabilities that a participant drawn so chooses each of them.
ThreeItems mean_choices(const ThreeItems& mean_utilities, double spread);

/// For a part that checks tests alone, or intervals alone.
std::vector<CheckedInterval> no_intervals(const CoverageSetting& setting);
std::vector<CheckedTest> no_tests(const CoverageSetting& setting);

/// Text of a table: a line of column names, then rows.
class DrawnTable {
 public:
  explicit DrawnTable(std::string_view columns) : text_(std::string(columns) + '\n') {}
  void add(std::initializer_list<std::string_view> cells);
  TidyInput as_input() &&;

 private:
  std::string text_{};
};
/// "S01".
std::string participant_label(std::size_t participant);
/// The first of the `weights` with the probability of its share of their sum, and so on.
std::size_t drawn_by_weight(std::span<const double> weights, Random& random);

}  // namespace asperity
