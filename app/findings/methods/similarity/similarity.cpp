// The analysis of rated dissimilarities.

#include "protocols/kinds/similarity.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/similarity/perceptual_map_figures.h"
#include "app/findings/methods/similarity/similarity_analysis.h"
#include "app/findings/methods/similarity/similarity_configuration.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/figures/similarity_figures.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/similarity_properties.h"
#include "protocols/answers/scale_form.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr const char* kDissimilarities = "dissimilarities";
constexpr const char* kIdenticalPairs = "identical_pairs";

/// The distance of a rating from the end of the scale for identical surfaces.
std::optional<double> dissimilarity_of(const GatheredAnswers& gathered,
                                       const GatheredAnswer& answer) {
  const std::optional<double>& number = gathered.reply_of(answer).number;
  if (!number) return std::nullopt;
  for (const Protocol::TrialQuestionTemplate& question : gathered.questions) {
    if (question.name != gathered.word(answer.question)) continue;
    const ScaleForm& scale = scale_of(question);
    return rated_quantity(question) == RatedQuantity::similarity ? scale.maximum - *number
                                                                 : *number - scale.minimum;
  }
  return std::nullopt;
}

/// The names of the items, by value where they are numbers.
std::vector<std::string> rated_items(const GatheredAnswers& gathered) {
  std::set<std::string> items{};
  for (const GatheredAnswer& answer : gathered.answers) {
    for (const FeltSurface& surface : gathered.surfaces_of(answer))
      items.insert(gathered.word(surface.item));
  }
  std::vector<std::string> names(items.begin(), items.end());
  std::sort(names.begin(), names.end(), precedes_by_value);
  return names;
}

TidyTable table_of_judgements(const GatheredAnswers& gathered) {
  LabelColumn people = labels_of_people(gathered);
  LabelRows first{};
  LabelRows second{};
  NumberColumn dissimilarities{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const auto surfaces = gathered.surfaces_of(answer);
    const std::optional<double> dissimilarity = dissimilarity_of(gathered, answer);
    if (surfaces.size() != 2 || !dissimilarity) continue;
    people.codes.push_back(answer.person);
    first.add(gathered.word(surfaces[0].item));
    second.add(gathered.word(surfaces[1].item));
    dissimilarities.push_back(*dissimilarity);
  }
  return {{{"subject", std::move(people)},
           {"first", std::move(first).take()},
           {"second", std::move(second).take()},
           {"dissimilarity", std::move(dissimilarities)}},
          "the ratings"};
}

const ResultColumn kDistance{.id = "distance", .heading = phrase("AnalysisWords", "distance")};
const ResultColumn kDisparity{.id = "disparity", .heading = phrase("AnalysisWords", "disparity")};
const ResultColumn kHalfAxisMajor{.id = "half_axis_major",
                                  .heading = phrase("AnalysisWords", "ellipse, major half axis")};
const ResultColumn kHalfAxisMinor{.id = "half_axis_minor",
                                  .heading = phrase("AnalysisWords", "ellipse, minor half axis")};
const ResultColumn kAngle{
    .id = "angle_deg", .heading = phrase("AnalysisWords", "angle"), .unit = "°"};
const ResultColumn kDimensions{.id = "dimensions",
                               .heading = phrase("AnalysisWords", "dimensions")};
const ResultColumn kStress{.id = "stress_1", .heading = phrase("AnalysisWords", "stress-1")};
const ResultColumn kMetricStress{.id = "metric_stress_1",
                                 .heading = phrase("AnalysisWords", "stress-1, metric")};
const ResultColumn kPredictionError{.id = "prediction_error",
                                    .heading = phrase("AnalysisWords", "prediction error")};
const ResultColumn kAboveSmallest{
    .id = "above_smallest", .heading = phrase("AnalysisWords", "squared error above the smallest")};
const ResultColumn kRepeatedR{.id = "repeated_r",
                              .heading = phrase("AnalysisWords", "r of repeated ratings")};
const ResultColumn kOrdersR{.id = "orders_r",
                            .heading = phrase("AnalysisWords", "r of both orders")};
const ResultColumn kAgreementR{.id = "agreement_r",
                               .heading = phrase("AnalysisWords", "r with the other participants")};
const ResultColumn kFit{.id = "fit", .heading = phrase("AnalysisWords", "fit")};
const ResultColumn kProperty{
    .id = "property", .heading = phrase("AnalysisWords", "property"), .words = words_of_property};

ResultColumn dimension_column(std::size_t dimension) {
  const std::string number = std::to_string(dimension);
  return {.id = "dimension_" + number,
          .heading = phrase("AnalysisWords", "dimension %1").with(number)};
}

ResultColumn weight_column(std::size_t dimension) {
  const std::string number = std::to_string(dimension);
  return {.id = "weight_" + number, .heading = phrase("AnalysisWords", "weight %1").with(number)};
}

template <Figure (*make)(const FoundNumbers&)>
std::vector<Figure> figure_of_configuration(const ResultTable&, const AnalysisOutcome& outcome) {
  return {make(FoundNumbers(outcome.findings, kConfiguration))};
}

Figure map_of_items(const FoundNumbers& found) {
  return answering(kConfiguration, configuration_figure(found));
}

Figure tree_of_items(const FoundNumbers& found) { return dendrogram(found, rated_tree()); }

void add_pairs_table(const std::vector<std::string>& items, const FoundNumbers& found,
                     AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable pairs{
      kDissimilarities,
      phrase("Analysis", "Mean dissimilarities of the pairs"),
      {kItem, kOther, kPersons, kMean, interval_of(kMean), kDistance, kDisparity},
      phrase(
          "Analysis",
          "Dissimilarity: the distance of the rating from the end of the scale for identical "
          "surfaces, mean over participants with a t-based 95 % CI; both orders together. "
          "Distance: in the configuration. Disparity: the regression of the distances on the mean "
          "dissimilarities, isotonic for non-metric and proportional for metric scaling.")};
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1; j < items.size(); ++j) {
      const FindingKey key{items[i], items[j]};
      const Finding* const mean = found.find("dissimilarity", key);
      if (mean == nullptr) continue;
      pairs.add({items[i], items[j], count_cell(mean->n), cell_of(mean->value),
                 found.interval("dissimilarity", key), found.cell("distance", key),
                 found.cell("disparity", key)});
    }
  }
  pairs.figures = figure_of_configuration<shepard_figure>;
  if (!pairs.rows.empty()) outcome.tables.push_back(std::move(pairs));
}

void add_identical_table(const FoundNumbers& found, AnalysisOutcome& outcome) {
  const Finding* const mean = found.find("identical.mean");
  if (mean == nullptr || !mean->value) return;
  using namespace columns;
  ResultTable& table = outcome.tables.emplace_back(ResultTable{
      kIdenticalPairs,
      phrase("Analysis", "Dissimilarity of identical pairs"),
      {kPersons, kMean, interval_of(kMean), kDifference, interval_of(kDifference)},
      phrase("Analysis",
             "Mean dissimilarity of a surface and itself; 0 is the end of the scale for identical "
             "surfaces. Difference: mean dissimilarity of different surfaces minus that of "
             "identical ones. Means over participants with t-based 95 % CIs.")});
  table.add({count_cell(mean->n), cell_of(mean->value), found.interval("identical.mean"),
             found.cell("identical.difference"), found.interval("identical.difference")});
}

void add_configuration_table(const std::vector<std::string>& items, const FoundNumbers& found,
                             AnalysisOutcome& outcome) {
  const std::size_t dimensions = dimensions_in(found);
  if (dimensions == 0) return;
  ResultTable map{
      kConfiguration,
      phrase("Analysis", "Configuration of the items"),
      {columns::kItem},
      phrase("Analysis",
             "%1 Only distances can be interpreted. Half axes and angle: the 95 % ellipse of the "
             "position in the first two dimensions, from a bootstrap over participants.")
          .with(is_metric(found)
                    ? phrase("Analysis",
                             "Metric (ratio) multidimensional scaling, along the principal axes, "
                             "because the non-metric configuration is degenerate; distances have "
                             "the unit of the scale.")
                    : phrase("Analysis",
                             "Non-metric multidimensional scaling, along the principal axes; the "
                             "mean square distance of two items is 1."))};
  for (std::size_t d = 1; d <= dimensions; ++d) map.columns.push_back(dimension_column(d));
  map.columns.insert(map.columns.end(), {kHalfAxisMajor, kHalfAxisMinor, kAngle});
  for (const std::string& item : items) {
    ResultRow& row = map.rows.emplace_back();
    row.emplace_back(item);
    for (std::size_t d = 1; d <= dimensions; ++d)
      row.push_back(found.cell("position", {item, std::to_string(d)}));
    row.push_back(found.cell("region.major", item));
    row.push_back(found.cell("region.minor", item));
    const std::optional<double> angle_rad = found.value("region.angle", item);
    row.push_back(angle_rad ? ResultCell{*angle_rad * 180.0 / std::numbers::pi} : ResultCell{});
  }
  map.figures = figure_of_configuration<map_of_items>;
  outcome.tables.push_back(std::move(map));
}

void add_stress_table(const FoundNumbers& found, AnalysisOutcome& outcome) {
  ResultTable stress{
      "stress",
      phrase("Analysis", "Stress by the number of dimensions"),
      {kDimensions, kStress, kMetricStress, kPredictionError, kAboveSmallest,
       standard_error_of(kAboveSmallest, phrase("AnalysisWords", "its standard error"))},
      phrase("Analysis",
             "Kruskal’s stress-1 of non-metric and of metric (ratio) scaling; 0 is a perfect fit. "
             "Prediction error: root mean square error of the prediction of each participant’s "
             "ratings from those of the others (cross-validation), in the unit of the scale; next "
             "to it, its square minus that of the best number of dimensions, with the standard "
             "error over participants.")};
  for (const Finding* const one : found.all("stress.ordinal")) {
    if (!one->value) return;
    const FindingKey& key = one->key;
    stress.add({count_cell(stress.rows.size() + 1), cell_of(one->value),
                found.cell("stress.ratio", key), found.cell("cv.error", key),
                found.cell("cv.above", key), found.cell("cv.above.se", key)});
  }
  stress.figures = figure_of_configuration<stress_figure>;
  if (!stress.rows.empty()) outcome.tables.push_back(std::move(stress));
}

void add_raters_table(const GatheredAnswers& gathered, const FoundNumbers& found,
                      AnalysisOutcome& outcome) {
  const std::size_t dimensions = dimensions_in(found);
  ResultTable raters{
      "weights",
      phrase("Analysis", "Participants: reliability, agreement, and weights of the dimensions"),
      {columns::kParticipant, kRepeatedR, kOrdersR, kAgreementR, kFit},
      phrase("Analysis",
             "Correlations of the first and the last rating of a pair, of the ratings in its two "
             "orders, and of the participant’s mean ratings with those of the others. Fit: the "
             "proportion of the participant’s scalar products that the INDSCAL model explains; "
             "the weights are those of its dimensions, which differ from the axes of the "
             "configuration.")};
  for (std::size_t d = 1; d <= dimensions; ++d) raters.columns.push_back(weight_column(d));
  for (const AnsweringPerson& person : gathered.people) {
    if (found.find("agreement.r", person.label) == nullptr &&
        found.find("retest.r", person.label) == nullptr)
      continue;
    ResultRow& row = raters.rows.emplace_back();
    row.emplace_back(person.label);
    for (const QuantityName quantity :
         std::initializer_list<QuantityName>{"retest.r", "orders.r", "agreement.r", "indscal.fit"})
      row.push_back(found.cell(quantity, person.label));
    for (std::size_t d = 1; d <= dimensions; ++d)
      row.push_back(found.cell("indscal.weight", {person.label, std::to_string(d)}));
  }
  raters.figures = figure_of_configuration<weights_figure>;
  if (!raters.rows.empty()) outcome.tables.push_back(std::move(raters));
}

void add_tree_table(const FoundNumbers& found, AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable tree{"tree",
                   phrase("Analysis", "Dendrogram of the items"),
                   {kJoin, kFirst, kSecond, kHeight},
                   phrase("Analysis",
                          "Average linkage of the mean dissimilarities. Each row joins the cluster "
                          "of the first item with that of the second.")};
  for (std::size_t join = 1;; ++join) {
    const FindingKey key = std::to_string(join);
    const Finding* const first = found.find("hclust.average.first", key);
    const Finding* const second = found.find("hclust.average.second", key);
    if (first == nullptr || second == nullptr) break;
    tree.add(
        {count_cell(join), first->word, second->word, found.cell("hclust.average.height", key)});
  }
  tree.figures = figure_of_configuration<tree_of_items>;
  if (!tree.rows.empty()) outcome.tables.push_back(std::move(tree));
}

void add_properties_table(const FoundNumbers& found, AnalysisOutcome& outcome) {
  const std::size_t dimensions = dimensions_in(found);
  ResultTable properties{
      "properties",
      phrase("Analysis", "Measured properties of the items in the configuration"),
      {kProperty, columns::kRSquared},
      phrase("Analysis",
             "R² of the regression of the property on the positions, and the direction in which it "
             "increases (of length 1). Forces and speeds are means over the participants’ contacts "
             "with the item: they depend on how it was explored. Texture force: the RMS along the "
             "participants’ paths.")};
  for (std::size_t d = 1; d <= dimensions; ++d) properties.columns.push_back(dimension_column(d));
  for (const Finding* const one : found.all("property.r2")) {
    if (!one->value) continue;
    ResultRow& row = properties.rows.emplace_back();
    row.emplace_back(one->key.text());
    row.push_back(cell_of(one->value));
    for (std::size_t d = 1; d <= dimensions; ++d)
      row.push_back(found.cell("property.direction", {one->key, std::to_string(d)}));
  }
  if (properties.rows.empty()) return;
  if (const std::optional<double> together = found.value("protest.r2")) {
    properties.note = phrase("Analysis",
                             "%1 All properties together, as a configuration of their standardised "
                             "values: Procrustes r² = %2, permutation test (PROTEST) %3.")
                          .with(properties.note, display_bounded(*together),
                                display_p(found.value("protest.p").value_or(1.0)));
  }
  outcome.tables.push_back(std::move(properties));
}

void ask_about_configuration(std::size_t items, const FoundNumbers& found, const StudyTests& tests,
                             AnalysisOutcome& outcome) {
  const Phrase question =
      phrase("Analysis", "Do the ratings have a structure, and in how many dimensions?");
  const Phrase method =
      phrase("Analysis",
             "Non-metric multidimensional scaling of the mean dissimilarities, or metric (ratio) "
             "scaling if the non-metric configuration is degenerate. Permutation test of "
             "its stress-1: ratings are permuted over the pairs within participants. The number of "
             "dimensions is chosen by cross-validation over participants.");
  const StudyTests::Test* const test = tests.find(kConfiguration);
  const Finding* const stress =
      found.find(stress_quantity(found), std::to_string(dimensions_in(found)));
  if (test == nullptr || !test->p || stress == nullptr || !stress->value) {
    const std::string reason = test == nullptr ? "no_responses" : test->status;
    const Phrase answer =
        reason == "permuted_fit_perfectly"
            ? phrase("Analysis",
                     "Not tested: with %1 surfaces, a configuration in %2 dimensions fits many "
                     "permuted ratings perfectly, so that no ratings can fit significantly better; "
                     "see the mean dissimilarities of the pairs.")
                  .with(std::to_string(items), std::to_string(dimensions_in(found)))
            : phrase("Analysis", "Not tested: %1.").with(words_of_status(reason));
    add_question(outcome, kConfiguration, question, answer, method, kDissimilarities, nullptr);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    const Phrase said =
        words.with(std::to_string(dimensions_in(found)), stress_text(*stress->value),
                   stress_text(found.value("stress.perm.mean").value_or(0.0)), p_text(*test));
    const Phrase qualified = qualification_of_stress(found);
    return qualified.empty() ? said : phrase("Analysis", "%1 %2").with(said, qualified);
  };
  TestStatements statements = statements_of(
      *test, {.numbers = with_numbers(phrase(
                  "Analysis",
                  "the configuration in %1 dimensions has a stress-1 of %2, and that of permuted "
                  "ratings is %3 on average. Permutation test: %4."))});
  statements.claim = with_numbers(
      phrase("Analysis",
             "Yes: the configuration in %1 dimensions has a stress-1 of %2, lower than that of "
             "permuted ratings (mean %3). Permutation test: %4."));
  add_question(outcome, kConfiguration, question, said_of(*test, statements), method,
               kConfiguration, stress);
}

/// `parts`: those of the family's findings that are needed.
std::vector<Finding> findings_of_judgements(const GatheredAnswers& gathered,
                                            const std::vector<std::string>& items,
                                            const char* parts) {
  TidyInput input{};
  input.tables.push_back(table_of_judgements(gathered));
  TidyTable properties = properties_of_items(gathered, items);
  if (properties.rows() > 0) input.tables.push_back(std::move(properties));
  input.options.set("items", items);
  input.options.set("parts", std::string(parts));
  return analysis_of(kConfiguration, "similarity", std::move(input));
}

/// The mean dissimilarity of each pair of different items, in both orders, of each participant.
void add_to_groups(const GatheredAnswers& gathered, GroupComparisons& groups) {
  GroupProfile profile{
      .words = phrase("Analysis", "which pairs of surfaces are rated as more dissimilar")};
  std::map<std::pair<std::uint32_t, std::string>, std::size_t> counts{};
  std::set<std::string> pairs{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const auto surfaces = gathered.surfaces_of(answer);
    const std::optional<double> dissimilarity = dissimilarity_of(gathered, answer);
    if (surfaces.size() != 2 || !dissimilarity) continue;
    auto [first, second] =
        std::pair(gathered.word(surfaces[0].item), gathered.word(surfaces[1].item));
    if (first == second) continue;
    if (precedes_by_value(second, first)) std::swap(first, second);
    const std::string pair = first + " / " + second;
    pairs.insert(pair);
    double& mean = profile.values[{answer.person, pair}];
    mean += (*dissimilarity - mean) / static_cast<double>(++counts[{answer.person, pair}]);
  }
  profile.items.assign(pairs.begin(), pairs.end());
  groups.add(profile);
}

void add_similarity_tests(const FoundNumbers& found, StudyTests& tests) {
  const Finding* const unscaled = found.find("stress.ordinal");
  const Finding* const permuted = found.find("stress.perm.p");
  if (unscaled != nullptr && !unscaled->word.empty()) {
    tests.add_untested(kConfiguration, "", unscaled->word);
  } else if (permuted != nullptr && !permuted->word.empty()) {
    tests.add_untested(kConfiguration, "", permuted->word);
  } else {
    tests.add(kConfiguration, "", found, "stress.perm.p");
  }
  if (found.find("t.p.two", "identical") != nullptr)
    tests.add("identical", "", found, "t.p.two", "identical");
  for (const Finding* const property : found.all("property.r2")) {
    if (property->value)
      tests.add("properties", property->key.text(), found, "property.perm.p", property->key);
  }
}

}  // namespace

std::vector<StudyTest> test_similarity(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  const std::vector<Finding> findings =
      findings_of_judgements(gathered, rated_items(gathered), "tests");
  add_similarity_tests(FoundNumbers(findings), tests);
  if (tests.is_in_family(kGroupProfilesTest)) {
    GroupComparisons groups(gathered);
    add_to_groups(gathered, groups);
    AnalysisOutcome unused{};
    groups.add_tests(tests, unused);
  }
  return std::move(tests).take_family();
}

void analyze_similarity(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<std::string> items = rated_items(gathered);
  const std::vector<Finding> findings = findings_of_judgements(gathered, items, "all");
  const FoundNumbers found(findings);
  keep_findings(findings, outcome);
  add_pairs_table(items, found, outcome);
  add_identical_table(found, outcome);
  add_configuration_table(items, found, outcome);
  add_stress_table(found, outcome);
  add_tree_table(found, outcome);
  add_raters_table(gathered, found, outcome);
  add_properties_table(found, outcome);
  StudyTests tests(gathered);
  add_similarity_tests(found, tests);
  GroupComparisons groups(gathered);
  add_to_groups(gathered, groups);
  groups.add_tests(tests, outcome);
  tests.finish(outcome);
  for (Phrase& remark : remarks_on_configuration(found)) {
    outcome.remarks.push_back(std::move(remark));
  }
  ask_about_configuration(items.size(), found, tests, outcome);
  groups.report(tests, outcome);
}

}  // namespace asperity
