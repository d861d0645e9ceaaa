// Joins response and confidence into one signed rating, and calls the family `roc` for all and for single participants.

#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "analysis/choices/rating_roc.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/sensitivity/roc_figures.h"
#include "app/findings/methods/discrimination/sensitivity/sensitivity_bounds.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

/// By participant and rating: the response and its confidence as one number.
using RatingsOfLevel = std::map<std::uint32_t, std::map<double, RatingCount>>;
/// By condition and value of the parameter.
using RatedLevels = std::map<std::pair<std::size_t, double>, RatingsOfLevel>;

struct RatedTrial {
  const DiscriminationTrial* trial = nullptr;
  bool is_signal = true;
  double rating = 0.0;
};

/// The trials with a rating. "yes" is positive and "no" negative, and farther from 0 with more confidence.
std::vector<RatedTrial> rated_trials(const DiscriminationStudy& study) {
  std::optional<double> least{};
  for (const DiscriminationTrial& trial : study.trials) {
    if (trial.confidence) least = std::min(least.value_or(*trial.confidence), *trial.confidence);
  }
  if (!least) return {};
  const bool has_noise = study.task.design->has_noise();
  std::vector<RatedTrial> rated{};
  for (const DiscriminationTrial& trial : study.trials) {
    if (!trial.confidence) continue;
    // With two alternatives "yes" is the choice of surface A.
    const bool is_yes =
        has_noise ? trial.chose_comparison : trial.chose_comparison == trial.comparison_first;
    const double confidence = *trial.confidence - *least + 1.0;
    rated.push_back({.trial = &trial,
                     .is_signal = has_noise ? trial.is_signal : trial.comparison_first,
                     .rating = is_yes ? confidence : -confidence});
  }
  return rated;
}

void count_rating(const RatedTrial& rated, RatingsOfLevel& level) {
  RatingCount& count = level[rated.trial->person][rated.rating];
  ++(rated.is_signal ? count.signal : count.noise);
}

RatedLevels rated_levels(const DiscriminationStudy& study) {
  const std::vector<RatedTrial> trials = rated_trials(study);
  const bool shares_noise = study.task.design->has_noise();
  RatedLevels levels{};
  for (const RatedTrial& rated : trials) {
    if (shares_noise && !rated.is_signal) continue;
    count_rating(rated, levels[{rated.trial->condition, rated.trial->value}]);
  }
  if (!shares_noise) return levels;
  for (auto& [place, level] : levels) {
    for (const RatedTrial& rated : trials) {
      if (!rated.is_signal && rated.trial->condition == place.first) count_rating(rated, level);
    }
  }
  return levels;
}

std::vector<Finding> roc_of(const GatheredAnswers& gathered, const DiscriminationResults& results,
                            const RatedLevels& levels) {
  struct Columns {
    TidyInput input{};
    LabelRows conditions{};
    LabelRows subjects{};
    NumberColumn ratings{};
    NumberColumn noise{};
    NumberColumn signal{};
  };
  Columns together{};
  Columns single{};
  for (const auto& [place, level] : levels) {
    const FindingKey id = id_of_level(results, place);
    for (const auto& [person, ratings] : level) {
      const std::string& participant = gathered.people[person].label;
      for (const auto& [rating, count] : ratings) {
        for (Columns* const columns : {&together, &single}) {
          columns->conditions.add(
              columns->input.label_of(columns == &together ? id : FindingKey{id, participant}));
          columns->ratings.emplace_back(rating);
          columns->noise.emplace_back(static_cast<double>(count.noise));
          columns->signal.emplace_back(static_cast<double>(count.signal));
        }
        together.subjects.add(participant);
      }
    }
  }
  std::vector<Finding> findings{};
  for (Columns* const columns : {&together, &single}) {
    std::vector<TidyTable::Column> made{{"condition", std::move(columns->conditions).take()},
                                        {"rating", std::move(columns->ratings)},
                                        {"noise", std::move(columns->noise)},
                                        {"signal", std::move(columns->signal)}};
    if (columns == &together) made.push_back({"subject", std::move(columns->subjects).take()});
    TidyInput& input = columns->input;
    input.tables.emplace_back(std::move(made), "the ratings of confidence");
    for (Finding& finding : analysis_of(kConfidenceRoc, "roc", std::move(input))) {
      findings.push_back(std::move(finding));
    }
  }
  return findings;
}

const ResultColumn kRocArea{.id = "roc_area",
                            .heading = phrase("AnalysisWords", "area under the ROC")};
const ResultColumn kAreaOfModel{.id = "a_z", .heading = phrase("AnalysisWords", "A_z")};
const ResultColumn kDistanceOfModel{.id = "d_a", .heading = phrase("AnalysisWords", "d_a")};
const ResultColumn kSdRatio{.id = "sd_ratio",
                            .heading = phrase("AnalysisWords", "SD of signal/noise")};
const ResultColumn kChiSquared{
    .id = "chi_squared", .heading = phrase("AnalysisWords", "χ²(1)"), .digits = Digits::statistic};

void add_row(const DiscriminationResults& results, const std::pair<std::size_t, double>& place,
             const std::string& participant, const FindingKey& key, const FoundNumbers& found,
             ResultTable& table) {
  const DiscriminationTask& task = results.study.task;
  const std::string& unit = task.varied.unit;
  table.add({participant, results.conditions[place.first], task.varied.parameter,
             quantity_cell(place.second, unit), quantity_cell(place.second - task.standard(), unit),
             found.count("n.noise", key), found.count("n.signal", key), found.cell("auc", key),
             found.interval("auc", key), found.cell("uv.az", key), found.cell("uv.da", key),
             found.cell("uv.sigma", key), found.cell("lr.equal.variance", key),
             found.cell("lr.equal.variance.p", key), word_cell(unit)});
}

Phrase with_interval(const Phrase& text, const Finding& finding) {
  if (!finding.low || !finding.high) return text;
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(text, display_number(*finding.low), display_number(*finding.high));
}

/// "55 µm: mean A_z of 8 of 8 participants = 0.81 (95 % CI [0.75, 0.87]); mean area by trapezoids of 8 of 8 participants =
/// 0.80 (95 % CI [0.74, 0.86]); of the pooled responses A_z = 0.79, d_a = 1.2, SD ratio 1.1, test of equal variances
/// χ²(1) = 1.3, p = .25"
Phrase roc_text(const DiscriminationResults& results, const RatedLevels& levels,
                const FoundNumbers& found) {
  Phrase all{};
  for (const auto& [place, level] : levels) {
    const FindingKey id = id_of_level(results, place);
    const Finding* const area = found.find("uv.az", id);
    const auto effect = found.value("uv.da", id);
    const auto ratio = found.value("uv.sigma", id);
    const auto statistic = found.value("lr.equal.variance", id);
    const auto p = found.value("lr.equal.variance.p", id);
    if (area == nullptr || !area->value || !effect || !ratio) continue;
    Phrase one(stated_quantity(place.second, results.study.task.varied.unit));
    if (const Finding* const mean = found.find("uv.az.mean", id); mean != nullptr && mean->value) {
      one = phrase("Analysis", "%1: mean A_z of %2 of %3 participants = %4")
                .with(one, std::to_string(mean->n), std::to_string(level.size()),
                      display_number(*mean->value));
      one = with_interval(one, *mean);
    }
    if (const Finding* const mean = found.find("auc.mean", id); mean != nullptr && mean->value) {
      one = phrase("Analysis", "%1; mean area by trapezoids of %2 of %3 participants = %4")
                .with(one, std::to_string(mean->n), std::to_string(level.size()),
                      display_number(*mean->value));
      one = with_interval(one, *mean);
    }
    one = phrase("Analysis", "%1; of the pooled responses A_z = %2")
              .with(one, display_number(*area->value));
    one = phrase("Analysis", "%1, d_a = %2, SD ratio %3")
              .with(one, display_number(*effect), display_number(*ratio));
    if (statistic && p) {
      one = phrase("Analysis", "%1, test of equal variances χ²(1) = %2, %3")
                .with(one, display_number(*statistic), display_p(*p));
    }
    if (results.conditions.size() > 1) {
      one = phrase("Analysis", "%1, %2")
                .with(words_of_condition(results.conditions[place.first]), one);
    }
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// The mean of the participants at the first level, or else the pooled area.
const Finding* first_area(const DiscriminationResults& results, const RatedLevels& levels,
                          const FoundNumbers& found) {
  const FindingKey id = id_of_level(results, levels.begin()->first);
  const Finding* const mean = found.find("uv.az.mean", id);
  return mean != nullptr && mean->value ? mean : found.find("uv.az", id);
}

void ask_roc(const DiscriminationResults& results, const RatedLevels& levels,
             const FoundNumbers& found, AnalysisOutcome& outcome) {
  const Phrase text = roc_text(results, levels, found);
  const std::string name =
      results.name.empty() ? kConfidenceRoc : std::string(kConfidenceRoc) + ':' + results.name;
  add_question(
      outcome, name.c_str(),
      phrase("Analysis", "How large is the area under the ROC of the confidence ratings?"),
      text.empty()
          ? phrase("Analysis",
                   "It could not be estimated: signal and noise trials share too few "
                   "categories of response and confidence.")
          : phrase("Analysis",
                   "ROC by the %1 of the comparison: %2. The area of pooled responses is too small "
                   "where participants have different criteria: a common A_z of .856 becomes .81 "
                   "and .77 if criteria differ with SDs of 0.7 and 1.0. The tests of equal "
                   "variances are exploratory and uncorrected, and treat the responses of all "
                   "participants as independent.")
                .with(words_of_parameter(results.study.task.varied.parameter), text),
      phrase(
          "Analysis",
          "Normal model with unequal variances of the categories of response and confidence, by "
          "maximum likelihood for each participant and over the responses of all participants; "
          "likelihood-ratio test of equal variances [Dorfman 1969]. Means of participants with "
          "t-based CIs, without one where a participant has no estimate: in simulations the "
          "coverage for A_z was 92 to 97 % and for the area by trapezoids 91 to 97 %. There is no "
          "CI of the "
          "pooled responses: in simulations in which participants had different criteria, that of "
          "a bootstrap over participants contained the common A_z in 12 to 87 % of the studies."),
      kConfidenceRoc, first_area(results, levels, found));
}

Phrase note_on_roc(const std::vector<DiscriminationResults>& all) {
  Phrase note = phrase(
      "Analysis",
      "Response and confidence together are ordered categories. Area: by trapezoids, 95 % CI "
      "[DeLong 1988], truncated to 0 to 1; in simulations of one participant with 24 to 144 "
      "trials of either kind, its coverage was 88 to 95 %. A_z, d_a and the SD of the signal "
      "divided by that of "
      "the noise: normal model with unequal variances. χ²(1) and p: likelihood-ratio test of equal "
      "variances, exploratory and uncorrected; all responses are treated as independent. The rows "
      "of all participants assume equal criteria of the participants; an area over participants "
      "with different criteria is too small and has no CI: in simulations that of a bootstrap over "
      "participants contained the common A_z in 12 to 87 % of the studies, and DeLong’s the common "
      "area "
      "by trapezoids in 14 to 80 %. There is "
      "no CI of an area by trapezoids of "
      "0 or 1, whose standard error is 0, so that the CI would be the area itself (coverage 0 %), "
      "and none where all trials with a signal, or all without one, have the same rating, because "
      "DeLong’s standard error is then too small.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  const auto has = [&all](const DiscriminationDesign& design) {
    return std::any_of(all.begin(), all.end(), [&design](const DiscriminationResults& results) {
      return results.study.task.design == &design && !rated_levels(results.study).empty();
    });
  };
  if (has(two_alternatives())) {
    add(phrase("Analysis",
               "With two alternatives the comparison as surface A is the signal, and d′ = "
               "d_a/√2."));
  }
  if (has(same_different_task())) {
    add(phrase("Analysis",
               "Same–different: d_a is not the d′ of the differencing rule but describes the "
               "distributions of the judged difference between the surfaces. Unequal variances are "
               "expected, because equal pairs and different pairs in both orders are judged by "
               "the absolute difference of two impressions."));
  }
  return note;
}

}  // namespace

void add_confidence_roc(const GatheredAnswers& gathered,
                        const std::vector<DiscriminationResults>& all, AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable roc{kConfidenceRoc,
                  phrase("Analysis", "ROC of the confidence ratings"),
                  {kParticipant, kCondition, kParameterColumn, kLevelColumn, kDifference,
                   kNoiseTrials, kSignalTrials, kRocArea, interval_of(kRocArea), kAreaOfModel,
                   kDistanceOfModel, kSdRatio, kChiSquared, kP, kUnitOfLevels},
                  note_on_roc(all)};
  roc.figures = roc_figures;
  for (const DiscriminationResults& results : all) {
    const DiscriminationTask& task = results.study.task;
    if (!task.is_performance || task.design->is_choice_of_three() ||
        results.study.has_levels_of_procedure) {
      continue;
    }
    const RatedLevels levels = rated_levels(results.study);
    if (levels.empty()) continue;
    const std::vector<Finding> findings = roc_of(gathered, results, levels);
    keep_findings(findings, outcome);
    const FoundNumbers found(findings);
    for (const auto& [place, level] : levels) {
      const FindingKey id = id_of_level(results, place);
      add_row(results, place, kAllParticipants, id, found, roc);
      if (gathered.people.size() < 2) continue;
      for (const auto& [person, ratings] : level) {
        const std::string& participant = gathered.people[person].label;
        add_row(results, place, participant, {id, participant}, found, roc);
      }
    }
    ask_roc(results, levels, found, outcome);
  }
  if (roc.rows.empty()) return;
  roc.drop_empty_columns(2);
  outcome.tables.push_back(std::move(roc));
}

}  // namespace asperity
