// The analysis of ratings: each scale on its own; scales that accompany another question apart from the others.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/rating/profile_figure.h"
#include "app/findings/methods/rating/rating_analysis.h"
#include "app/findings/methods/rating/rating_components.h"
#include "app/findings/methods/rating/rating_constructs.h"
#include "app/findings/methods/rating/rating_models.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/accompanying_scales.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/intraclass_targets.h"
#include "app/findings/shared/rated_scales.h"
#include "app/findings/shared/repetition_reliability.h"

namespace asperity {

namespace {

constexpr const char* kRatings = "ratings";
constexpr const char* kAgreement = "agreement";

const ResultColumn kPoints{.id = "points", .heading = phrase("AnalysisWords", "points")};

/// The table of the families `rating` and `icc`, which call its columns by other names.
TidyInput table_of(const GatheredAnswers& gathered, const RatedScale& scale, const char* rater,
                   const char* rated) {
  ScoreRows scores(gathered);
  for (const auto& [of, mean] : scale.means) scores.add(of.first, of.second, mean);
  return std::move(scores).take(rater, rated, "the ratings on " + scale.name);
}

/// The scales as shown to participants.
ResultTable table_of_scales(const GatheredAnswers& gathered, const std::vector<RatedScale>& scales,
                            const AccompanyingScales& accompanying) {
  ResultTable shown{
      kScales,
      phrase("Analysis", "The scales"),
      {columns::kScale, columns::kMinimum, kLowLabel, columns::kMaximum, kHighLabel, kPoints},
      phrase("Analysis",
             "The ends of each scale as numbers and as labelled for participants; a "
             "scale without points is a continuous line.")};
  // Whole numbers are displayed without decimals.
  const auto whole_cell = [](const std::optional<double>& number) {
    return number && std::floor(*number) == *number
               ? ResultCell{static_cast<std::int64_t>(std::llround(*number))}
               : cell_of(number);
  };
  for (const Protocol::TrialQuestionTemplate& question : gathered.questions) {
    const bool is_rated = std::any_of(scales.begin(), scales.end(), [&question](const auto& scale) {
      return scale.name == question.name;
    });
    if (!is_rated && !accompanying.has(question.name)) continue;
    const ScaleForm& scale = scale_of(question);
    const auto label = [&scale](bool is_low) {
      if (scale.labels.empty()) return std::string{};
      return is_low ? scale.labels.front() : scale.labels.back();
    };
    shown.add({question.name, whole_cell(scale.minimum), word_cell(label(true)),
               whole_cell(scale.maximum), word_cell(label(false)),
               whole_cell(scale.points > 0 ? std::optional<double>(scale.points) : std::nullopt)});
  }
  return shown;
}

std::string rating_shown(double mean) {
  constexpr int kDecimals = 2;
  return display_signed(mean, kDecimals);
}

std::vector<RepeatedEstimate> repeated_ratings(const RatedScale& scale) {
  std::vector<RepeatedEstimate> ratings{};
  for (const RatedScale::Response& response : scale.responses) {
    ratings.push_back({.person = response.person,
                       .surface = response.item,
                       .repetition = response.repetition,
                       .value = response.score});
  }
  return ratings;
}

void add_means(const RatedScale& scale, const FoundNumbers& found, ResultTable& table) {
  for (const std::string& item : scale.items) {
    const FindingKey key{scale.name, item};
    const Finding* const mean = found.find("mean.score", key);
    if (mean == nullptr) continue;
    table.add({scale.name, item, count_cell(mean->n), cell_of(mean->value),
               found.interval("mean.score", key), found.cell("mean.rank", key)});
  }
}

void add_agreement(const RatedScale& scale, const FoundNumbers& found, ResultTable& table) {
  const Finding* const none = found.find("icc", scale.name);
  for (const char* const form : {"ICC2", "ICC3", "ICC2k", "ICC3k"}) {
    const FindingKey key{scale.name, form};
    const Finding* const icc = none == nullptr ? found.find("icc", key) : none;
    if (icc == nullptr) continue;
    table.add({scale.name, std::string(form), cell_of(icc->value), found.interval("icc", key),
               count_cell(icc->n), none == nullptr ? ResultCell{} : ResultCell{none->word}});
  }
}

void add_test_of_items(const RatedScale& scale, const FoundNumbers& found, StudyTests& tests) {
  tests.add("ratings", scale.name, found, "friedman.p", scale.name);
}

void add_tests(const RatedScale& scale, bool is_only_scale, const FoundNumbers& found,
               StudyTests& tests) {
  add_test_of_items(scale, found, tests);
  for (std::size_t a = 0; a < scale.items.size(); ++a) {
    for (std::size_t b = a + 1; b < scale.items.size(); ++b) {
      const FindingKey key{scale.name, scale.items[a], scale.items[b]};
      tests.add("rated_pairs",
                {scale.items[a], scale.items[b], is_only_scale ? std::string() : scale.name}, found,
                "wilcoxon.exact.p.two", key);
      const double tested = found.value("wilcoxon.n", key).value_or(0.0);
      const double complete = found.value("n.complete", scale.name).value_or(tested);
      const auto first = found.value("mean.score", {scale.name, scale.items[a]});
      const auto second = found.value("mean.score", {scale.name, scale.items[b]});
      if (first && second) tests.state_direction(*first - *second);
      tests.drop_ties(static_cast<std::size_t>(complete - tested));
    }
  }
}

/// `parts`: those of the family's findings that are needed.
std::vector<Finding> findings_of_items(const GatheredAnswers& gathered, const RatedScale& scale,
                                       const char* parts = "all") {
  TidyInput input = table_of(gathered, scale, "subject", "item");
  input.options.set("items", scale.items);
  input.options.set("parts", std::string(parts));
  return findings_of(kRatings, "rating", scale, std::move(input));
}

/// The mean over the items of the participants who rated all of them, and how their ratings differ between items.
void add_to_groups(const RatedScale& scale, bool is_only_scale, GroupComparisons& groups) {
  const std::string name = is_only_scale ? "" : scale.name;
  GroupMeasure mean{
      .name = name,
      .words = phrase("Analysis", "the mean rating on the scale “%1”").with(scale.name)};
  GroupProfile profile{
      .name = name,
      .words = phrase("Analysis", "how the ratings on the scale “%1” differ between the items")
                   .with(scale.name),
      .items = scale.items,
      .values = scale.means};
  std::map<std::uint32_t, std::pair<double, std::size_t>> sums{};
  for (const auto& [of, rating] : scale.means) {
    sums[of.first].first += rating;
    ++sums[of.first].second;
  }
  for (const auto& [person, sum] : sums) {
    mean.values[person] = sum.second == scale.items.size()
                              ? std::optional(sum.first / static_cast<double>(sum.second))
                              : std::nullopt;
  }
  groups.add(mean);
  groups.add(profile);
}

void add_untested_scale(const RatedScale& scale, StudyTests& tests) {
  tests.add_untested("ratings", scale.name, "one_item");
}

/// Which end is high: the name of a scale need not be that of its maximum.
Phrase text_of_ends(const RatedScale& scale) {
  if (scale.low_label.empty() || scale.high_label.empty()) return {};
  return phrase("Analysis", ", from %1 (“%2”) to %3 (“%4”),")
      .with(display_number(scale.minimum), scale.low_label, display_number(scale.maximum),
            scale.high_label);
}

void ask_about(const RatedScale& scale, const FoundNumbers& found, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  std::vector<std::pair<const Finding*, std::string>> means{};
  for (const std::string& item : scale.items) {
    const Finding* const mean = found.find("mean.score", {scale.name, item});
    if (mean != nullptr && mean->value) means.emplace_back(mean, item);
  }
  const StudyTests::Test* const test = tests.find("ratings", scale.name);
  const std::string name = "ratings_" + scale.name;
  const Phrase question =
      phrase("Analysis", "Do the ratings on the scale “%1” differ between the items?")
          .with(scale.name);
  const Phrase method = phrase("Analysis",
                               "Friedman test of the participants' mean ratings of the items; CIs "
                               "of the means are t-based.");
  if (means.empty() || test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis", "Not tested: too few participants rated every item."), method,
                 kRatings, nullptr);
    return;
  }
  const auto by_value = [](const auto& one, const auto& other) {
    return *one.first->value < *other.first->value;
  };
  const auto [low, high] = std::minmax_element(means.begin(), means.end(), by_value);
  const TestStatements statements = statements_of(
      *test,
      {.numbers =
           phrase(
               "Analysis",
               "the mean rating%6 is highest for %1, %2, and lowest for %3, %4. Friedman test: %5.")
               .with(words_of_condition(high->second), rating_text(*high->first),
                     words_of_condition(low->second), rating_text(*low->first), p_text(*test),
                     text_of_ends(scale)),
       .compares = true});
  add_question(outcome, name.c_str(), question, said_of(*test, statements), method, kRatings,
               high->first);
}

}  // namespace

std::vector<StudyTest> test_ratings(const GatheredAnswers& gathered) {
  const std::vector<RatedScale> scales = rated_scales(gathered);
  StudyTests tests(gathered);
  GroupComparisons groups(gathered);
  for (const RatedScale& scale : scales) {
    if (tests.is_in_family(kGroupsTest) || tests.is_in_family(kGroupProfilesTest)) {
      add_to_groups(scale, scales.size() == 1, groups);
    }
    if (scale.items.size() < 2) {
      add_untested_scale(scale, tests);
      continue;
    }
    if (tests.is_in_family("rated_pairs")) {
      const std::vector<Finding> findings = findings_of_items(gathered, scale);
      add_tests(scale, scales.size() == 1, FoundNumbers(findings), tests);
    } else if (tests.is_in_family("ratings")) {
      const std::vector<Finding> findings = findings_of_items(gathered, scale, "items");
      add_test_of_items(scale, FoundNumbers(findings), tests);
    }
    if (tests.is_in_family("rating_model")) add_rating_model_test(gathered, scale, tests);
  }
  if (tests.is_in_family("accompanying_scales")) AccompanyingScales(gathered).add_tests(tests);
  AnalysisOutcome unused{};
  groups.add_tests(tests, unused);
  return std::move(tests).take_family();
}

void analyze_rating(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<RatedScale> scales = rated_scales(gathered);
  const AccompanyingScales accompanying(gathered);
  using namespace columns;
  ResultTable ratings{
      kRatings,
      phrase("Analysis", "Mean ratings of the items on each scale"),
      {kScale, kItem, kPersons, kMean, interval_of(kMean), kMeanRank},
      phrase("Analysis",
             "Means of the participants' mean ratings, over the participants who rated every item, "
             "with t-based 95 % CIs; mean rank: 1 for a participant's lowest rating.")};
  ratings.figures = rating_figures;
  ResultTable agreement{
      kAgreement,
      phrase("Analysis", "Agreement of the participants on each scale"),
      {kScale, kMeasure, kValue, interval_of(kValue), kItems, kStatus},
      phrase("Analysis",
             "Intraclass correlations with the items as targets and the participants as raters: "
             "ICC2 measures agreement, ICC3 consistency; k: of the mean of all participants.")};
  RatingModels models{};
  StudyTests tests(gathered);
  GroupComparisons groups(gathered);
  std::vector<std::pair<const RatedScale*, std::vector<Finding>>> all{};
  for (const RatedScale& scale : scales) {
    add_to_groups(scale, scales.size() == 1, groups);
    if (scale.items.size() < 2) {
      add_untested_scale(scale, tests);
      continue;
    }
    std::vector<Finding> findings = findings_of_items(gathered, scale);
    const FoundNumbers found(findings);
    add_means(scale, found, ratings);
    add_tests(scale, scales.size() == 1, found, tests);
    keep_findings(findings, outcome);
    models.add(gathered, scale, tests, outcome);
    std::vector<Finding> correlations =
        findings_of(kAgreement, "icc", scale, table_of(gathered, scale, "rater", "target"));
    withhold_few_targets(correlations,
                         {.counted = "items that all participants rated", .key = scale.name});
    add_agreement(scale, FoundNumbers(correlations), agreement);
    // The family's α is ICC3k with the raters as test items; that of a construct is of its scales (add_constructs).
    keep_findings(correlations, outcome,
                  [](const Finding& one) { return !is(one, "cronbach.alpha"); });
    all.emplace_back(&scale, std::move(findings));
  }
  const bool has_ratings = !ratings.rows.empty();
  if (has_ratings) outcome.tables.push_back(std::move(ratings));
  if (has_ratings || !accompanying.empty()) {
    outcome.tables.push_back(table_of_scales(gathered, scales, accompanying));
  }
  agreement.drop_empty_columns(2);
  if (!agreement.rows.empty()) outcome.tables.push_back(std::move(agreement));
  std::move(models).report(outcome);
  add_rating_components(gathered, scales, outcome);
  accompanying.add_tests(tests);
  groups.add_tests(tests, outcome);
  tests.finish(outcome);
  for (const auto& [scale, findings] : all) {
    state_means_of_items(outcome, {.analysis = kRatings,
                                   .quantity = "mean.score",
                                   .scale = scale->name,
                                   .items = scale->items,
                                   .tests = {"ratings", "rating_model"},
                                   .tests_of_pairs = {"rated_pairs"},
                                   .shown = rating_shown});
    ask_about(*scale, FoundNumbers(findings), tests, outcome);
    ask_reliability_of_ratings(gathered, scale->name, repeated_ratings(*scale), outcome);
  }
  groups.report(tests, outcome);
  add_constructs(gathered, scales, outcome);
  accompanying.report(tests, outcome);
  if (!accompanying.empty()) {
    outcome.transformation =
        (scales.empty() ? std::string()
                        : "Each participant's ratings of an item were averaged before they were "
                          "analysed. ") +
        "Ratings that accompanied another response were averaged for each participant over " +
        accompanying.groups_text() + " before they were analysed.";
  }
}

}  // namespace asperity
