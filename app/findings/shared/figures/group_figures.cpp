// Two groups of participants: their means, and the difference between them.

#include "app/findings/shared/figures/group_figures.h"

#include <algorithm>

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

}  // namespace

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
        phrase("Figures", "%1 (n = %2)").with(word_of_group(mean->key), std::to_string(mean->n)),
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
  less.x = {.name = phrase("Figures", "%1 − %2, with its %3 % CI")
                        .with(word_of_group(means[0]->key), word_of_group(means[1]->key), percent),
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
                      .with(word_of_group(means[0]->key), word_of_group(means[1]->key));
  }
  // A difference of 0 is in the centre, so that the sign is visible.
  less.x.high = std::max(less.x.high, -less.x.low);
  less.x.low = -less.x.high;
  add_room(less);
  less.references.push_back({.value = 0.0, .label = phrase("Figures", "no difference")});
  return {both, less};
}

}  // namespace asperity
