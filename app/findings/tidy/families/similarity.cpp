// Dissimilarities that raters gave to pairs: reliability, the configuration of the items and its precision, weights of raters, the
// dendrogram, and the agreement with physical properties.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dissimilarity/individual_differences.h"
#include "analysis/dissimilarity/multidimensional_scaling.h"
#include "analysis/dissimilarity/procrustes.h"
#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "analysis/tests/multiplicity.h"
#include "analysis/tests/t_test.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/rated_pairs.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// Of the stresses by number of dimensions.
constexpr Eigen::Index kMostDimensions = 5;
constexpr std::size_t kFewestItems = 4;

/// A property of the items; missing where it is unknown for an item.
struct Property {
  std::string name{};
  std::vector<std::optional<double>> values{};
};

std::vector<Property> properties_in(const TidyTable& table, const std::vector<std::string>& items) {
  const LabelColumn of = table.labels("item", items);
  const LabelColumn names = table.all_labels("property");
  const std::vector<std::optional<double>> values = table.numbers("value");
  std::vector<Property> properties{};
  for (const std::string& name : names.names)
    properties.push_back(
        {.name = name, .values = std::vector<std::optional<double>>(items.size())});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (of.codes[row] == LabelColumn::kMissing)
      table.refuse(row, "item", "the item is missing; enter it, or remove the row");
    if (!values[row]) continue;
    std::optional<double>& value = properties[names.codes[row]].values[of.codes[row]];
    if (value) {
      table.refuse(row, "property",
                   "this item already has a value of \"" + names.names[names.codes[row]] +
                       "\"; remove one of the rows: an item has one value of a property");
    }
    value = values[row];
  }
  return properties;
}

/// The number of an axis in a key.
std::string axis_name(Eigen::Index axis) { return std::to_string(axis + 1); }

/// Whether the dissimilarities of all judged pairs are equal but for rounding.
bool are_alike(const RatedPairs& pairs) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (Eigen::Index i = 0; i < pairs.values.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (pairs.weights(i, j) == 0.0) continue;
      least = std::min(least, pairs.values(i, j));
      greatest = std::max(greatest, pairs.values(i, j));
    }
  }
  return greatest - least <= 16.0 * std::numeric_limits<double>::epsilon() * greatest;
}

class SimilarityFindings {
 public:
  SimilarityFindings(const JudgedPairs& judged, const FamilyOptions& options)
      : judged_(judged),
        confidence_(options.confidence()),
        wanted_(options.number_if("dimensions")) {
    const std::vector<RatedPairs> all = judged.by_rater();
    for (std::size_t rater = 0; rater < all.size(); ++rater) {
      if (all[rater].weights.sum() == 0.0) continue;
      raters_.push_back(all[rater]);
      names_.push_back(judged.raters[rater]);
    }
  }

  /// Without those on which no test depends.
  enum class Parts { all, tests };

  std::vector<Finding> take(const std::vector<Property>& properties, Parts parts) {
    const std::size_t m = judged_.items.size();
    list_.count("n.items", "", m, {.n = raters_.size(), .method = "items that were judged"});
    list_.count("n.raters", "", raters_.size(),
                {.n = raters_.size(), .method = "participants who judged a pair of items"});
    if (parts == Parts::all) reliability();
    identical_pairs();
    if (m < kFewestItems) {
      list_.word("stress.ordinal", "", "too_few_items",
                 "a configuration requires at least four items: add items",
                 basis("non-metric multidimensional scaling"));
      return list_.take();
    }
    if (raters_.empty()) {
      list_.word("stress.ordinal", "", "too_few_participants",
                 "no participant judged a pair of different items: add participants",
                 basis("non-metric multidimensional scaling"));
      return list_.take();
    }
    mean_ = mean_of_raters(raters_);
    if (parts == Parts::all) dissimilarities();
    if (!connects_all_items(mean_.weights)) {
      list_.word("stress.ordinal", "", "not_connected",
                 "the pairs that were judged do not connect all items: judge further pairs",
                 basis("non-metric multidimensional scaling"));
      return list_.take();
    }
    if (!(mean_.values.maxCoeff() > 0.0)) {
      list_.word("stress.ordinal", "", "no_variance",
                 "all pairs were judged identical, so that there are no distances: check the "
                 "direction of the scale, or use items that differ",
                 basis("non-metric multidimensional scaling"));
      return list_.take();
    }
    if (are_alike(mean_)) {
      list_.word(
          "stress.ordinal", "", "no_differences",
          "all pairs were judged equally dissimilar, so that every configuration fits as well "
          "as any other: check the use of the scale, or use items that differ more",
          basis("non-metric multidimensional scaling"));
      return list_.take();
    }
    if (parts == Parts::all) dendrogram();
    stresses();
    choose_level_and_dimensions();
    if (parts == Parts::all) configuration();
    chance();
    if (parts == Parts::all) weights_of_raters();
    compare_with(properties);
    return list_.take();
  }

 private:
  Basis basis(const std::string& method) const { return {.n = raters_.size(), .method = method}; }
  FindingKey pair_key(Eigen::Index i, Eigen::Index j) const { return {item(i), item(j)}; }
  const std::string& item(Eigen::Index i) const {
    return judged_.items[static_cast<std::size_t>(i)];
  }
  Eigen::Index items() const { return static_cast<Eigen::Index>(judged_.items.size()); }

  /// Correlations are averaged as Fisher's z = artanh r, whose distribution is closer to a normal one.
  void mean_correlation(const std::string& quantity, const std::vector<double>& correlations,
                        const std::string& method) {
    if (correlations.empty()) return;
    std::vector<double> z{};
    constexpr double kLargest = 1.0 - 1e-12;  // r = 1 has no z
    for (const double r : correlations) z.push_back(std::atanh(std::clamp(r, -kLargest, kLargest)));
    const OneSampleT mean = one_sample_t(z, {.confidence = confidence_});
    Basis of_mean{.n = z.size(),
                  .method = method + ", mean over participants by Fisher's z; t interval"};
    if (mean.test) {
      of_mean.interval = ConfidenceInterval{.low = std::tanh(mean.test->interval.low),
                                            .high = std::tanh(mean.test->interval.high)};
      of_mean.confidence = confidence_;
    }
    list_.number(quantity, "", std::tanh(mean.mean), of_mean);
  }

  void reliability() {
    std::vector<double> all{};
    std::vector<double> all_orders{};
    const std::string method = "correlation of the first and the last judgement of a pair";
    const std::string of_orders = "correlation of the judgements in the two orders of a pair";
    for (std::size_t rater = 0; rater < judged_.raters.size(); ++rater) {
      const JudgedPairs::Repeated repeated = judged_.repeated_by(rater);
      if (const auto r = pearson_correlation(repeated.first, repeated.last)) {
        list_.number("retest.r", judged_.raters[rater], *r,
                     {.n = repeated.first.size(), .method = method});
        all.push_back(*r);
      }
      const JudgedPairs::Repeated orders = judged_.in_both_orders_by(rater);
      if (const auto r = pearson_correlation(orders.first, orders.last)) {
        list_.number("orders.r", judged_.raters[rater], *r,
                     {.n = orders.first.size(), .method = of_orders});
        all_orders.push_back(*r);
      }
    }
    mean_correlation("retest.mean", all, method);
    mean_correlation("orders.mean", all_orders, of_orders);
    const std::vector<std::optional<double>> agreement = agreement_with_others(raters_);
    std::vector<double> known{};
    const std::string with_others =
        "correlation with the mean judgements of the other participants";
    for (std::size_t s = 0; s < agreement.size(); ++s) {
      if (!agreement[s]) continue;
      list_.number("agreement.r", names_[s], *agreement[s], basis(with_others));
      known.push_back(*agreement[s]);
    }
    mean_correlation("agreement.mean", known, with_others);
  }

  /// Pairs of different items against pairs of an item with itself, within participants.
  void identical_pairs() {
    std::vector<double> identical{};
    std::vector<double> differences{};
    for (std::size_t rater = 0; rater < judged_.raters.size(); ++rater) {
      const std::optional<double> same = judged_.mean_of_identical_by(rater);
      const std::optional<double> different = judged_.mean_of_different_by(rater);
      if (!same || !different) continue;
      identical.push_back(*same);
      differences.push_back(*different - *same);
    }
    if (differences.empty()) return;
    add_mean_of_group(
        "identical.mean", "", identical,
        {.confidence = confidence_, .of = "mean judgement of pairs of an item with itself"}, list_);
    add_mean_of_group("identical.difference", "", differences,
                      {.confidence = confidence_,
                       .of = "judgement of different items minus that of identical ones, mean"},
                      list_);
    const OneSampleT t = one_sample_t(differences, {.confidence = confidence_});
    const Basis paired{.n = differences.size(),
                       .method = "paired t test of different and identical pairs",
                       .undefined =
                           "the test needs two participants with different values: add "
                           "participants"};
    list_.number("t.p.two", "identical", t.test ? t.test->p : kUndefined, paired);
    list_.number("t", "identical", t.test ? t.test->t : kUndefined, paired);
    list_.number("df", "identical", t.test ? t.test->df : kUndefined, paired);
    list_.number("dz", "identical", t.test ? t.mean / *t.sd : kUndefined, paired);
  }

  void dissimilarities() {
    for (Eigen::Index i = 0; i < items(); ++i) {
      for (Eigen::Index j = i + 1; j < items(); ++j) {
        std::vector<double> own{};
        for (const RatedPairs& rater : raters_) {
          if (rater.weights(i, j) > 0.0) own.push_back(rater.values(i, j));
        }
        if (own.empty()) continue;
        add_mean_of_group("dissimilarity", pair_key(i, j), own,
                          {.confidence = confidence_, .of = "mean dissimilarity over participants"},
                          list_);
      }
    }
  }

  void dendrogram() {
    if ((mean_.weights.array() > 0.0).count() < items() * (items() - 1)) {
      list_.word("hclust.average.height", "1", "incomplete",
                 "a dendrogram requires a judgement of every pair: judge the missing pairs",
                 basis("average linkage"));
      return;
    }
    const Tree tree = agglomerate(mean_.values, Linkage::average);
    const Basis of_tree = basis("average linkage (UPGMA) of the mean dissimilarities");
    list_.number("hclust.average.cophcor", "", tree.cophenetic_correlation.value_or(kUndefined),
                 basis("correlation of cophenetic with mean dissimilarities"));
    for (std::size_t join = 0; join < tree.joins.size(); ++join) {
      const FindingKey key = std::to_string(join + 1);
      list_.word("hclust.average.first", key, judged_.items[tree.joins[join].first], "ok", of_tree);
      list_.word("hclust.average.second", key, judged_.items[tree.joins[join].second], "ok",
                 of_tree);
      list_.number("hclust.average.height", key, tree.joins[join].height, of_tree);
    }
    for (Eigen::Index i = 0; i < items(); ++i) {
      for (Eigen::Index j = i + 1; j < items(); ++j)
        list_.number("hclust.average.cophenetic", pair_key(i, j), tree.cophenetic(i, j), of_tree);
    }
  }

  void stresses() {
    const Eigen::Index most = std::min(kMostDimensions, items() - 2);
    for (Eigen::Index r = 1; r <= most; ++r) {
      maps_.push_back(scaled(mean_, {.dimensions = r}));
      list_.number("stress.ordinal", axis_name(r - 1), maps_.back().stress_1,
                   basis("Kruskal's stress-1 of non-metric scaling (SMACOF)"));
      metric_maps_.push_back(scaled(mean_, {.dimensions = r, .level = ScalingLevel::ratio}));
      list_.number("stress.ratio", axis_name(r - 1), metric_maps_.back().stress_1,
                   basis("Kruskal's stress-1 of metric (ratio) scaling (SMACOF)"));
    }
  }

  /// Whether the non-metric configuration that would be reported is degenerate. A perfect solution in the plane is one in every larger
  /// number of dimensions, so that the sizes of the dissimilarities do not determine that either.
  bool is_degenerate() {
    const std::size_t different =
        std::min(different_disparities(mean_, maps_[1]), different_disparities(mean_, map()));
    list_.count("ordinal.disparities", "", different,
                basis("different disparities of the non-metric configuration in the reported "
                      "number of dimensions, or in two if these are fewer"));
    const std::vector<Eigen::Index> collapsed = collapsed_items(mean_, map());
    for (const Eigen::Index i : collapsed) {
      list_.truth("ordinal.collapsed", item(i), true,
                  basis("items on one point of the non-metric configuration"));
    }
    return different <= kDisparitiesOfDegenerate || !collapsed.empty();
  }

  /// As many as the options state, or as cross-validation chooses; at least two, so that there is a plane to show.
  Eigen::Index shown_by(const std::optional<DimensionChoice>& choice) const {
    if (wanted_) return static_cast<Eigen::Index>(*wanted_);
    return std::max<Eigen::Index>(2, choice ? choice->chosen : 2);
  }

  void choose_level_and_dimensions() {
    const auto most = static_cast<double>(maps_.size());
    if (wanted_ && !(*wanted_ >= 2.0 && *wanted_ <= most && *wanted_ == std::floor(*wanted_))) {
      throw std::runtime_error("the option \"dimensions\" must be a whole number from 2 to " +
                               std::to_string(maps_.size()) + " for " +
                               std::to_string(judged_.items.size()) + " items; correct it");
    }
    std::optional<DimensionChoice> choice = dimensions_by_cross_validation(raters_, maps_, level_);
    dimensions_ = shown_by(choice);
    if (is_degenerate()) {
      level_ = ScalingLevel::ratio;
      maps_ = metric_maps_;
      choice = dimensions_by_cross_validation(raters_, maps_, level_);
      dimensions_ = shown_by(choice);
    }
    list_.word("configuration.level", "", level_ == ScalingLevel::ratio ? "ratio" : "ordinal", "ok",
               basis("metric (ratio) scaling where the non-metric configuration is degenerate"));
    const Basis cross = basis(
        "leave-one-participant-out cross-validation: root mean square error of the prediction");
    if (choice) {
      for (const DimensionError& error : choice->errors) {
        const FindingKey key = axis_name(error.dimensions - 1);
        list_.number("cv.error", key, error.error, cross);
        list_.number("cv.above", key, error.above_best,
                     basis("mean square error minus that of the best number of dimensions"));
        list_.number("cv.above.se", key, error.above_best_se,
                     basis("standard error of that difference over participants"));
      }
      list_.count("cv.chosen", "", static_cast<std::uint64_t>(choice->chosen),
                  basis("fewest dimensions within one standard error of the smallest error"));
    } else {
      list_.word("cv.chosen", "", "too_few_participants",
                 "cross-validation requires three participants whose pairs connect all items: add "
                 "participants",
                 cross);
    }
    list_.count(
        "dimensions", "", static_cast<std::uint64_t>(dimensions_),
        basis(wanted_ ? "dimensions of the configuration, as stated"
                      : "dimensions of the configuration: by cross-validation, at least 2"));
    list_.truth("dimensions.too.many", "", items() < items_for(dimensions_),
                basis("fewer than 4·R + 1 items for R dimensions"));
    list_.count("dimensions.items", "", static_cast<std::uint64_t>(items_for(dimensions_)),
                basis("4·R + 1, the items that R dimensions require"));
  }

  void configuration() {
    const Configuration& map = this->map();
    const Basis of_map =
        basis(level_ == ScalingLevel::ratio
                  ? "metric (ratio) scaling (SMACOF), principal axes, unit of the dissimilarities"
                  : "non-metric scaling (SMACOF), principal axes, mean square distance 1");
    for (Eigen::Index i = 0; i < items(); ++i) {
      for (Eigen::Index axis = 0; axis < dimensions_; ++axis)
        list_.number("position", {item(i), axis_name(axis)}, map.points(i, axis), of_map);
    }
    for (const ShepardPoint& pair : shepard_diagram(mean_, map.points, level_)) {
      const FindingKey key = pair_key(pair.first, pair.second);
      list_.number("distance", key, pair.distance, of_map);
      list_.number(
          "disparity", key, pair.disparity,
          basis(level_ == ScalingLevel::ratio
                    ? "proportional regression of the distances on the mean dissimilarities"
                    : "isotonic regression of the distances on the mean dissimilarities"));
    }
    const auto regions = bootstrap_regions(raters_, map, level_, {.confidence = confidence_});
    const Basis of_region =
        basis("bootstrap over participants, configurations aligned by Procrustes rotation");
    if (!regions) {
      list_.word("region.major", "", "too_few_participants",
                 "ellipses require three participants whose pairs connect all items: add "
                 "participants",
                 of_region);
      return;
    }
    for (Eigen::Index i = 0; i < items(); ++i) {
      const PositionRegion& region = (*regions)[static_cast<std::size_t>(i)];
      list_.number("region.major", item(i), region.major, of_region);
      list_.number("region.minor", item(i), region.minor, of_region);
      list_.number("region.angle", item(i), region.angle_rad,
                   {.n = raters_.size(), .method = of_region.method, .unit = "rad"});
    }
  }

  void chance() {
    const StressByChance stress =
        stress_by_chance(raters_, {.dimensions = dimensions_, .level = level_});
    const Basis permuted = basis(
        "permutation test of the stress, judgements permuted over the pairs within "
        "participants, " +
        way_of_counting(stress.drawn));
    list_.number("stress.perm.observed", "", stress.observed, permuted);
    list_.number("stress.perm.mean", "", stress.mean, permuted);
    list_.number("stress.perm.p05", "", stress.p05, permuted);
    if (!stress.can_be_significant()) {
      list_.word("stress.perm.p", "", "permuted_fit_perfectly",
                 "so many of the permuted judgements fit perfectly that no judgements can fit "
                 "significantly better: add items, or compare the dissimilarities of the pairs",
                 permuted);
      list_.count("stress.perm.draws", "", stress.drawn, permuted);
      return;
    }
    list_.number("stress.perm.p", "", stress.p, permuted);
    list_.count("stress.perm.draws", "", stress.drawn, permuted);
    list_.number("stress.perm.smallest", "", stress.smallest_p(), permuted);
    list_.number("stress.perm.reduction", "", 1.0 - stress.observed / stress.mean,
                 basis("1 − stress / mean stress of permuted judgements"));
  }

  void weights_of_raters() {
    std::vector<Dissimilarities> complete{};
    std::vector<std::string> names{};
    for (std::size_t s = 0; s < raters_.size(); ++s) {
      if ((raters_[s].weights.array() > 0.0).count() < items() * (items() - 1)) continue;
      if (!(raters_[s].values.maxCoeff() > 0.0)) continue;
      complete.push_back(raters_[s].values);
      names.push_back(names_[s]);
    }
    const Basis model{.n = complete.size(),
                      .method = "INDSCAL of the participants who judged every pair"};
    if (complete.size() < 2) {
      list_.word("indscal.fit.mean", "", "too_few_participants",
                 "weights of participants require two participants who judged every pair: add "
                 "participants",
                 model);
      return;
    }
    const std::optional<IndividualDifferences> found =
        individual_differences(complete, dimensions_);
    if (!found) {
      list_.word("indscal.fit.mean", "", "no_variance",
                 "the dissimilarities of a participant do not vary: leave this participant out",
                 model);
      return;
    }
    list_.number("indscal.fit.mean", "", found->total_fit, model);
    for (std::size_t s = 0; s < names.size(); ++s) {
      const auto row = static_cast<Eigen::Index>(s);
      list_.number(
          "indscal.fit", names[s], found->fit(row),
          {.n = complete.size(),
           .method = "INDSCAL: proportion of the participant's scalar products that is fitted"});
      for (Eigen::Index axis = 0; axis < dimensions_; ++axis)
        list_.number("indscal.weight", {names[s], axis_name(axis)}, found->weights(row, axis),
                     {.n = complete.size(), .method = "INDSCAL: weight of the dimension"});
    }
    for (Eigen::Index i = 0; i < items(); ++i) {
      for (Eigen::Index axis = 0; axis < dimensions_; ++axis)
        list_.number(
            "indscal.position", {item(i), axis_name(axis)}, found->points(i, axis),
            {.n = complete.size(), .method = "INDSCAL: common configuration, sum of squares 1"});
    }
  }

  /// Each property alone, and all of them together as a configuration of standardised values.
  void compare_with(const std::vector<Property>& properties) {
    std::vector<std::string> tested{};
    std::vector<double> p{};
    Eigen::MatrixXd together(items(), 0);
    for (const Property& property : properties) {
      if (std::any_of(property.values.begin(), property.values.end(),
                      [](const std::optional<double>& value) { return !value; })) {
        list_.word("property.r2", property.name, "incomplete",
                   "not every item has a value of this property: add the missing values",
                   basis("regression of the property on the positions"));
        continue;
      }
      Eigen::VectorXd values(items());
      for (Eigen::Index i = 0; i < items(); ++i)
        values(i) = *property.values[static_cast<std::size_t>(i)];
      const std::optional<PropertyFit> fit = property_fit(map().points, values);
      if (!fit) {
        list_.word("property.r2", property.name, "no_variance",
                   "the property does not vary over the items, or there are too few items: leave "
                   "it out, or add items",
                   basis("regression of the property on the positions"));
        continue;
      }
      const Basis regression{.n = judged_.items.size(),
                             .method =
                                 "regression of the property on the positions; items "
                                 "permuted, " +
                                 way_of_counting(fit->drawn)};
      list_.number("property.r2", property.name, fit->r_squared, regression);
      list_.number("property.perm.p", property.name, fit->p, regression);
      list_.count("property.draws", property.name, fit->drawn, regression);
      for (Eigen::Index axis = 0; axis < dimensions_; ++axis)
        list_.number("property.direction", {property.name, axis_name(axis)}, fit->direction(axis),
                     regression);
      tested.push_back(property.name);
      p.push_back(fit->p);
      const Eigen::VectorXd centred = values.array() - values.mean();
      together.conservativeResize(Eigen::NoChange, together.cols() + 1);
      together.rightCols(1) = centred / centred.norm();
    }
    const std::vector<double> adjusted = holm_adjusted(p);
    for (std::size_t i = 0; i < tested.size(); ++i)
      list_.number("property.p.holm", tested[i], adjusted[i],
                   {.n = judged_.items.size(), .method = "Holm-corrected over the properties"});
    if (together.cols() < 2) return;
    const std::optional<Protest> all = protest(map().points, together);
    if (!all) return;
    const Basis rotation{.n = judged_.items.size(),
                         .method =
                             "Procrustes rotation of the standardised properties; items "
                             "permuted (PROTEST), " +
                             way_of_counting(all->drawn)};
    list_.number("protest.r2", "", all->r_squared, rotation);
    list_.number("protest.p", "", all->p, rotation);
    list_.count("protest.draws", "", all->drawn, rotation);
  }

  const Configuration& map() const { return maps_[static_cast<std::size_t>(dimensions_ - 1)]; }

  const JudgedPairs& judged_;
  double confidence_ = 0.95;
  std::optional<double> wanted_{};
  std::vector<RatedPairs> raters_{};
  std::vector<std::string> names_{};  ///< of `raters_`
  WeightedDissimilarities mean_{};
  std::vector<Configuration> maps_{};  ///< in 1, 2, … dimensions, of the level
  std::vector<Configuration> metric_maps_{};
  ScalingLevel level_ = ScalingLevel::ordinal;
  Eigen::Index dimensions_ = 2;
  FindingList list_{};
};

}  // namespace

std::vector<Finding> similarity_findings(const TidyInput& input) {
  const JudgedPairs judged =
      judged_pairs_in(input.table(), input.options.has("items") ? input.options.texts("items")
                                                                : std::vector<std::string>{});
  const std::vector<Property> properties = input.tables.size() > 1
                                               ? properties_in(input.table(1), judged.items)
                                               : std::vector<Property>{};
  using Parts = SimilarityFindings::Parts;
  const std::string parts = input.options.text_or("parts", "all");
  if (parts != "all" && parts != "tests") {
    throw std::runtime_error("the option \"parts\" is \"" + parts +
                             "\"; it must be all or tests (that on which tests depend alone)");
  }
  return SimilarityFindings(judged, input.options)
      .take(properties, parts == "all" ? Parts::all : Parts::tests);
}

}  // namespace asperity
