// Selects findings by analysis and passes them to the figures of their method, then names the question of each.

#include "app/findings/study/figures_of.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <utility>

#include "app/findings/methods/discrimination/sensitivity/roc_figures.h"
#include "app/findings/methods/discrimination/thresholds/psychometric_figures.h"
#include "app/findings/methods/discrimination/thresholds/threshold_figures.h"
#include "app/findings/methods/discrimination/thresholds/track_figure.h"
#include "app/findings/methods/magnitude/roughness_figure.h"
#include "app/findings/methods/magnitude/stimulus_estimates_figure.h"
#include "app/findings/methods/rating/biplot_figure.h"
#include "app/findings/methods/rating/profile_figure.h"
#include "app/findings/methods/similarity/perceptual_map_figures.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/exploration.h"
#include "app/findings/shared/figures/anchor_figures.h"
#include "app/findings/shared/figures/confusion_figure.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/figures/group_figures.h"
#include "app/findings/shared/figures/mean_figures.h"
#include "app/findings/shared/figures/power_figure.h"
#include "app/findings/shared/figures/response_time_figures.h"
#include "app/findings/shared/figures/scale_figure.h"
#include "app/findings/shared/figures/similarity_figures.h"
#include "app/findings/shared/learning.h"
#include "app/findings/shared/response_times.h"

namespace asperity {

namespace {

ScaleChoice bradley_terry() {
  return {.quantity = "bt.ability.sumzero.cluster",
          .otherwise = "bt.firth.ability",
          .status = "bt.status",
          .title = phrase("Figures", "Scale of the items (Bradley–Terry)")};
}

ScaleChoice plackett_luce() {
  return {.quantity = "pl.logworth.sumzero.cluster",
          .status = "pl.status",
          .title = phrase("Figures", "Scale of the items (Plackett–Luce)")};
}

/// The findings of one of several analyses.
std::vector<Finding> part_of(const std::vector<Finding>& findings, const std::string& analysis) {
  std::vector<Finding> part{};
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(part),
               [&analysis](const Finding& finding) { return finding.analysis == analysis; });
  return part;
}

GroupChoice shares_of_groups() {
  return {.means = "subj.mean",
          .difference = "subj.diff",
          .pooled_difference = "diff",
          .axis = phrase("Figures",
                         "proportion correct (for matching: of items), mean with its %1 % CI"),
          .are_shares = true};
}

/// Women and men, where they were compared.
void add_sexes(const AnalysisOutcome& outcome, std::vector<Figure>& figures) {
  const std::vector<Finding> compared = part_of(outcome.findings, "sexes");
  const std::vector<Finding> matched = part_of(outcome.findings, "matching");
  std::vector<Figure> of_sexes{};
  if (!compared.empty()) {
    of_sexes = group_figures(shares_of_groups(), FoundNumbers(compared));
  } else if (!FoundNumbers(matched).all("group.mean").empty()) {
    of_sexes = group_figures(
        {.means = "group.mean",
         .difference = "group.diff",
         .axis = phrase("Figures", "correctly matched items per trial, mean with its %1 % CI")},
        FoundNumbers(matched));
  }
  for (Figure& figure : of_sexes) {
    figure.table = StudyTests::kTable;
    figures.push_back(std::move(figure));
  }
}

/// The groups to which the protocol assigns participants, pair by pair.
void add_groups(const AnalysisOutcome& outcome, std::vector<Figure>& figures) {
  const std::string test = kGroupsTest;
  for (const AnsweredQuestion& asked : outcome.questions) {
    if (asked.name != test && !asked.name.starts_with(test + ':')) continue;
    const std::vector<Finding> compared = part_of(outcome.findings, asked.name);
    const FoundNumbers found(compared);
    GroupChoice choice = shares_of_groups();
    if (const auto means = found.all("values.mean"); !means.empty()) {
      // A ratio is in the answer and the tests: its axis would not be that of a difference.
      const bool is_ratio = found.find("values.ratio") != nullptr;
      choice = {.means = "values.mean",
                .difference = is_ratio ? QuantityName() : "values.shift",
                .axis = is_ratio ? phrase("Figures",
                                          "geometric mean of the participants with its %1 % CI")
                                 : phrase("Figures", "mean of the participants with its %1 % CI"),
                .unit = means.front()->unit == "1" ? "" : means.front()->unit};
    } else if (outcome.kind == "selection") {
      choice.axis = phrase("Figures", "proportion of choices of the target, mean with its %1 % CI");
    }
    for (Figure& figure : group_figures(choice, found)) {
      if (figure.name == "group_difference" && choice.difference.empty()) continue;
      // "groups_means", "groups_haptic_visual_means": a file has this name.
      figure.name = asked.name + figure.name.substr(std::string("group").size());
      std::replace_if(
          figure.name.begin(), figure.name.end(),
          [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
      figure.table = StudyTests::kTable;
      figure.question = asked.name;
      figures.push_back(std::move(figure));
    }
  }
}

/// Response times, learning and contact times.
void add_times(const AnalysisOutcome& outcome, std::vector<Figure>& figures) {
  struct Kind {
    const char* analysis = "";
    const char* table = "";
    Figure (*figure)(const FoundNumbers&) = nullptr;
  };
  for (const Kind& kind : {Kind{kResponseTimes, kResponseTimes, response_times_figure},
                           Kind{kLearningOfTimes, kTrialCourse, times_over_trials_figure},
                           Kind{kLearningCorrect, kTrialCourse, correct_over_trials_figure}}) {
    const std::vector<Finding> part = part_of(outcome.findings, kind.analysis);
    const FoundNumbers found(part);
    if (found.all("geomean").empty() && found.all("block").empty()) continue;
    figures.push_back(kind.figure(found));
    figures.back().table = kind.table;
  }
  const std::vector<Finding> explored = part_of(outcome.findings, kExploration);
  if (explored.empty()) return;
  figures.push_back(contact_times_figure(FoundNumbers(explored)));
  figures.back().table = kExploration;
}

/// Of one scale a row per item; of several a profile, which follows the answer for the last of them,
/// and their components.
void add_ratings(const AnalysisOutcome& outcome, std::vector<Figure>& figures) {
  const char* const analysis = "ratings";
  const ResultTable* const ratings = table_named(outcome, analysis);
  if (ratings == nullptr || ratings->rows.empty()) return;
  std::string question{};
  for (const AnsweredQuestion& asked : outcome.questions) {
    if (asked.table == ratings->name) question = asked.name;
  }
  std::set<std::string> scales{};
  for (const ResultRow& row : ratings->rows) {
    scales.insert(RowReader(*ratings, row).text(columns::kScale));
  }
  if (scales.size() > 1) {
    figures.push_back(profile_figure(*ratings, table_named(outcome, "scales")));
  } else {
    std::vector<Finding> means = part_of(outcome.findings, analysis);
    for (Finding& mean : means) mean.key.erase(0, mean.key.find('|') + 1);  // the scale
    figures.push_back(rating_figure(FoundNumbers(means)));
    figures.back().table = ratings->name;
  }
  figures.back().question = question;
  const ResultTable* const loadings = table_named(outcome, "loadings");
  if (loadings == nullptr) return;
  const std::vector<Finding> components = part_of(outcome.findings, "components");
  const bool has_second =
      std::any_of(components.begin(), components.end(), [](const Finding& finding) {
        return is(finding, "loading") && finding.key.ends_with("|C2");
      });
  if (!has_second) return;  // too few items for the loadings of two components
  figures.push_back(biplot_figure(FoundNumbers(components)));
  figures.back().table = loadings->name;
}

/// Sets the question of the study that each figure answers.
void name_questions(const AnalysisOutcome& outcome, std::vector<Figure>& figures) {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> kAnswers{
      {"preference", {"persons_forest"}},
      {"pairs", {kWorthScale}},
      {"position", {"positions_forest"}},
      {"textures", {"shares_by_texture_forest"}},
      {"items", {"shares_by_texture_forest"}},
      {"whole", {"whole_permutations_forest"}},
      {"right", {"shares_by_texture_forest"}},
      {"confusions", {"confusions"}},
      {"spacing", {"roughness"}},
      {"exponent", {"stimulus_estimates"}},
      {"stimuli", {"stimulus_estimates"}},
      {"threshold", {"thresholds"}},
      {"point_of_subjective_equality", {"points_of_subjective_equality"}},
      {"sexes", {"group_means", "group_difference"}}};
  for (const auto& [question, names] : kAnswers) {
    const bool is_asked =
        std::any_of(outcome.questions.begin(), outcome.questions.end(),
                    [&name = question](const AnsweredQuestion& one) { return one.name == name; });
    if (!is_asked) continue;
    for (Figure& figure : figures) {
      if (std::find(names.begin(), names.end(), figure.name) != names.end()) {
        figure.question = question;
      }
    }
  }
}

std::vector<Figure> confused(Figure forest, const FoundNumbers& found) {
  std::vector<Figure> figures{};
  figures.push_back(std::move(forest));
  figures.push_back(confusion_figure(found));
  return figures;
}

std::vector<Figure> recognised(const FoundNumbers& found) {
  std::vector<Figure> figures = confused(recognition_forest(found), found);
  figures.push_back(dendrogram(found));
  figures.push_back(similarity_map(found));
  return figures;
}

}  // namespace

std::vector<Figure> figures_of(const AnalysisOutcome& outcome) {
  std::vector<Figure> figures = table_forests(outcome);
  for (const ResultTable& table : outcome.tables) {
    if (table.figure != nullptr) figures.push_back(table.figure(table));
  }
  const std::vector<Finding> scale = part_of(outcome.findings, kWorthScale);
  if (!scale.empty()) {
    const FoundNumbers found(scale);
    const bool of_pairs = !found.all("bt.ability").empty() || found.find("bt.status") != nullptr;
    figures.push_back(
        scale_figure(kWorthScale, of_pairs ? bradley_terry() : plackett_luce(), found));
    figures.back().table = kWorthScale;
  }
  const std::vector<Finding> roughness = part_of(outcome.findings, kRoughness);
  if (!roughness.empty()) {
    figures.push_back(roughness_figure(FoundNumbers(roughness), "m", CurveNames::alone));
    figures.back().table = kRoughness;
  }
  const std::vector<Finding> by_stimulus = part_of(outcome.findings, kStimulusEstimates);
  if (!by_stimulus.empty()) {
    figures.push_back(stimulus_estimates_figure(
        FoundNumbers(by_stimulus), outcome.name_of_predictor, outcome.unit_of_predictor));
    figures.back().table = kStimulusEstimates;
  }
  const std::vector<Finding> similarity = part_of(outcome.findings, "similarity");
  if (!similarity.empty()) {
    const FoundNumbers found(similarity);
    figures.push_back(dendrogram(found));
    figures.back().table = "tree";
    figures.push_back(similarity_map(found));
    figures.back().table = "map";
  }
  const std::vector<Finding> rated = part_of(outcome.findings, "configuration");
  if (!rated.empty()) {
    for (Figure& figure : perceptual_map_figures(FoundNumbers(rated)))
      figures.push_back(std::move(figure));
  }
  add_ratings(outcome, figures);
  for (Figure& figure : threshold_figures(outcome)) figures.push_back(std::move(figure));
  for (Figure& figure : roc_figures(outcome)) figures.push_back(std::move(figure));
  add_sexes(outcome, figures);
  add_groups(outcome, figures);
  add_times(outcome, figures);
  for (Figure& figure : anchor_figures(outcome)) figures.push_back(std::move(figure));
  name_questions(outcome, figures);
  return figures;
}

std::vector<Figure> figures_of(const std::string& family, const TidyInput& input,
                               std::span<const Finding> findings, const std::string& level_unit) {
  const FoundNumbers found(findings);
  if (family == "proportion") return {proportion_forest(input, found)};
  if (family == "selection") return {selection_forest(found)};
  if (family == "matching") return confused(matching_forest(found), found);
  if (family == "recognition") return recognised(found);
  if (family == "paired") return {scale_figure("preference", bradley_terry(), found)};
  if (family == "ranking") return {scale_figure("preference", plackett_luce(), found)};
  if (family == "rating") return {rating_figure(found)};
  if (family == "similarity") return perceptual_map_figures(found);
  if (family == "components") return {biplot_figure(found)};
  if (family == "group") return group_figures(shares_of_groups(), found);
  if (family == "response_times") return {response_times_figure(found)};
  if (family == "learning") {
    return {input.table().has("time_s") ? times_over_trials_figure(found)
                                        : correct_over_trials_figure(found)};
  }
  if (family == "rmanova") return {interaction_figure(input, found, level_unit)};
  if (family == "power") return {power_figure(input, found)};
  if (family == "magnitude") return {roughness_figure(found, level_unit, CurveNames::of_probes)};
  if (family == "roc") {
    std::vector<RocCurve> curves{};
    for (const std::string& name : input.table().all_labels("condition").names) {
      curves.push_back({.key = name, .name = words_of_condition(name)});
    }
    return {roc_figure(found, curves)};
  }
  if (family == "psyfit") return {psychometric_figure(input, found, level_unit)};
  if (family == "staircase") return {tracks_figure(track_trials(input, found), level_unit)};
  if (family == "seedpaper") return seedpaper_forests(found);
  return {};
}

}  // namespace asperity
