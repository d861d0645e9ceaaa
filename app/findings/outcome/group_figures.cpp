// Two groups of participants: their means, and the difference between them. Of several pairs each figure has a name.

#include "app/findings/outcome/group_figures.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/findings/outcome/single_participants.h"

namespace asperity {

namespace {

Phrase word_of_group(const std::string& name) {
  if (name == "F") return phrase("Figures", "women");
  if (name == "M") return phrase("Figures", "men");
  return name;
}

/// Adds a row with its interval; the axis is extended to include it.
void add_row_of(const Finding& finding, const Phrase& label, Figure& figure) {
  const std::optional<FigureSpan> interval = interval_of(finding);
  figure.series.front().points.push_back({.x = *finding.value,
                                          .y = static_cast<double>(figure.y.places.size()),
                                          .x_interval = interval});
  figure.y.places.push_back(label);
  const FigureSpan span = interval.value_or(FigureSpan{*finding.value, *finding.value});
  figure.x.low = std::min(figure.x.low, span.low);
  figure.x.high = std::max(figure.x.high, span.high);
}

void add_room(Figure& figure) {
  constexpr double kRounding = 1e-12;  // of means that are otherwise equal
  const double span = figure.x.high - figure.x.low;
  const double room = span > kRounding ? 0.06 * span : 0.5;
  figure.x.low -= room;
  figure.x.high += room;
}

/// The participants' own proportions behind the rows of their groups.
void add_singles(const std::vector<const Finding*>& means, const FoundNumbers& found,
                 Figure& figure) {
  const SinglesByCondition singles = singles_by_condition(found.all("subject.share"));
  std::vector<SingleValues> rows{};
  for (std::size_t i = 0; i < means.size(); ++i) {
    const auto own = singles.find(means[i]->key);
    if (own != singles.end()) rows.push_back({static_cast<double>(i), own->second});
  }
  figure.series.push_back(singles_in_rows(rows, figure.x, figure.series.front().style));
  figure.note = with_note_on_singles(figure.note, figure);
}

std::vector<Figure> figures_of_sexes(const AnalysisOutcome& outcome) {
  if (const FoundNumbers compared(outcome.findings, kSexesTest); !compared.empty()) {
    return group_figures(shares_of_groups(), compared);
  }
  // Matchings of different sizes have no proportions.
  const FoundNumbers matched(outcome.findings, "matching");
  if (matched.all("group.mean").empty()) return {};
  return group_figures(
      {.means = "group.mean",
       .difference = "group.diff",
       .axis = phrase("Figures", "correctly matched items per trial, mean with its %1 % CI")},
      matched);
}

GroupChoice choice_of_groups(const FoundNumbers& found, const std::string& kind) {
  GroupChoice choice = shares_of_groups();
  if (const auto means = found.all("values.mean"); !means.empty()) {
    // A ratio is in the answer and the tests: its axis would not be that of a difference.
    const bool is_ratio = found.find("values.ratio") != nullptr;
    choice = {.means = "values.mean",
              .difference = is_ratio ? QuantityName() : "values.shift",
              .axis = is_ratio
                          ? phrase("Figures", "geometric mean of the participants with its %1 % CI")
                          : phrase("Figures", "mean of the participants with its %1 % CI"),
              .unit = means.front()->unit == "1" ? "" : means.front()->unit};
  } else if (kind == "selection") {
    choice.axis = phrase("Figures", "proportion of choices of the target, mean with its %1 % CI");
  }
  return choice;
}

}  // namespace

GroupChoice shares_of_groups() {
  return {.means = "subj.mean",
          .difference = "subj.diff",
          .pooled_difference = "diff",
          .axis = phrase("Figures",
                         "proportion correct (for matching: of items), mean with its %1 % CI"),
          .are_shares = true};
}

std::vector<Figure> figures_of_comparisons(const ResultTable&, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  for (Figure& figure : figures_of_sexes(outcome)) {
    figures.push_back(answering(kSexesTest, std::move(figure)));
  }
  const std::string test = kGroupsTest;
  for (const AnsweredQuestion& asked : outcome.questions) {
    if (asked.name != test && !asked.name.starts_with(test + ':')) continue;
    const FoundNumbers found(outcome.findings, asked.name);
    const GroupChoice choice = choice_of_groups(found, outcome.kind);
    for (Figure& figure : group_figures(choice, found)) {
      if (figure.name == "group_difference" && choice.difference.empty()) continue;
      // "groups_means", "groups_haptic_visual_means": a file has this name.
      constexpr std::string_view kPrefix = "group";
      figure.name = figure_file_name(asked.name + figure.name.substr(kPrefix.size()));
      figures.push_back(answering(asked.name, std::move(figure)));
    }
  }
  return figures;
}

std::vector<Figure> group_figures(const GroupChoice& choice, const FoundNumbers& found) {
  const std::vector<const Finding*> means = found.all(choice.means);
  const bool has_both = means.size() == 2 && means[0]->value && means[1]->value;
  const std::string percent = percent_of(means);
  Figure both{.name = "group_means",
              .title = phrase("Figures", "Both groups: means of the participants"),
              .note = phrase("Figures",
                             "Points are means of the participants' own results; error bars show "
                             "their t-based %1 % CIs, for proportions on the logit scale. "
                             "Overlapping CIs are not a test of a difference.")
                          .with(percent),
              .shape = FigureShape::rows,
              .series = {{}}};
  Figure less{
      .name = "group_difference",
      .title = phrase("Figures", "The difference between the groups"),
      .note =
          (found.all(choice.pooled_difference).empty()
               ? phrase(
                     "Figures",
                     "The error bar shows Welch's %1 % CI of the difference of the participants' "
                     "means. The permutation test of group labels makes fewer assumptions.")
               : phrase(
                     "Figures",
                     "Error bars show %1 % CIs: Welch's for the difference of the participants' "
                     "means, Newcombe's for all responses pooled, as if they were independent. The "
                     "permutation test of group labels makes fewer assumptions than either."))
              .with(percent),
      .shape = FigureShape::rows,
      .series = {{.style = 1}}};
  if (!has_both) {
    for (Figure* figure : {&both, &less}) {
      figure->series.clear();
      figure->instead = phrase("Figures",
                               "Fewer than two groups have responses, so that no comparison is "
                               "possible; collect responses of both groups.");
    }
    return {both, less};
  }
  both.x = {.name = choice.axis.filled({percent}),
            .unit = choice.unit,
            .low = choice.are_shares ? 0.0 : *means[0]->value,
            .high = choice.are_shares ? 1.0 : *means[0]->value};
  for (const Finding* mean : means) {
    add_row_of(
        *mean,
        phrase("Figures", "%1 (n = %2)").with(word_of_group(mean->key[0]), std::to_string(mean->n)),
        both);
  }
  if (!choice.are_shares) add_room(both);
  const auto has_interval = [](const Figure& figure) {
    const auto& points = figure.series.front().points;
    return std::any_of(points.begin(), points.end(),
                       [](const auto& point) { return point.x_interval.has_value(); });
  };
  if (!has_interval(both)) {
    both.note =
        phrase("Figures", "Points are means of the participants' own results; there are no CIs.");
  }
  if (choice.are_shares) add_singles(means, found, both);
  less.x = {
      .name = phrase("Figures", "%1 − %2, with its %3 % CI")
                  .with(word_of_group(means[0]->key[0]), word_of_group(means[1]->key[0]), percent),
      .low = 0.0,
      .high = 0.0};
  if (const auto of_means = found.all(choice.difference); !of_means.empty()) {
    if (of_means.front()->value) {
      add_row_of(*of_means.front(), phrase("Figures", "means of the participants"), less);
    }
  }
  if (const auto of_all = found.all(choice.pooled_difference); !of_all.empty()) {
    if (of_all.front()->value) {
      add_row_of(*of_all.front(), phrase("Figures", "all responses together"), less);
    }
  }
  if (less.y.places.empty()) {
    less.series.clear();
    less.instead =
        phrase("Figures",
               "The difference of means could not be computed; add participants to both groups.");
    return {both, less};
  }
  if (!has_interval(less)) {
    less.note =
        phrase("Figures", "The point is the difference of the participants' means; it has no CI.");
    less.x.name = phrase("Figures", "%1 − %2")
                      .with(word_of_group(means[0]->key[0]), word_of_group(means[1]->key[0]));
  }
  // A difference of 0 is in the centre, so that the sign is visible.
  less.x.high = std::max(less.x.high, -less.x.low);
  less.x.low = -less.x.high;
  add_room(less);
  less.references.push_back({.value = 0.0, .label = phrase("Figures", "no difference")});
  return {both, less};
}

}  // namespace asperity
