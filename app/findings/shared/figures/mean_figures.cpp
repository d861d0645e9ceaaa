// Means by condition: scores of items, and cells of an analysis of variance.

#include "app/findings/shared/figures/mean_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/findings/outcome/finding_parts.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

constexpr double kRoomAround = 0.06;  // beyond the outermost marks, as a fraction of their range
constexpr double kAside = 0.08;       // the offset between series at one place
constexpr double kFarthestAside = 0.3;

void hold(const FigureSpan& span, bool& is_first, FigureAxis& axis) {
  axis.low = is_first ? span.low : std::min(axis.low, span.low);
  axis.high = is_first ? span.high : std::max(axis.high, span.high);
  is_first = false;
}

void widen(FigureAxis& axis) {
  const double room = axis.high > axis.low ? kRoomAround * (axis.high - axis.low) : 0.5;
  axis.low -= room;
  axis.high += room;
}

using Factors = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// The factor along the axis: the one with the most levels.
std::size_t along_of(const Factors& within) {
  std::size_t along = 0;
  for (std::size_t i = 1; i < within.size(); ++i) {
    if (within[i].second.size() > within[along].second.size()) along = i;
  }
  return along;
}

/// The name of a line: "probe 1.5 · men".
Phrase name_of_line(const std::vector<std::string>& parts, const Factors& within, std::size_t along,
                    bool has_groups) {
  Phrase name = has_groups ? Phrase(parts.front()) : Phrase();
  for (std::size_t i = 0; i < within.size(); ++i) {
    if (i == along) continue;
    const Phrase one = within[i].first + ' ' + parts[i + 1];
    name = name.empty() ? one : phrase("Figures", "%1 · %2").with(name, one);
  }
  return name;
}

/// Explains only the marks that are drawn.
Phrase note_on_cell_means(bool is_within, bool has_intervals, const std::string& percent) {
  const Phrase points =
      phrase("Figures", "Points are means over the participants, shifted where several coincide.");
  if (!has_intervals) return phrase("Figures", "%1 Lines guide the eye.").with(points);
  return (is_within
              ? phrase("Figures",
                       "%1 Error bars: within-participant %2 % CIs (Cousineau and Morey), which do "
                       "not include the differences between participants. Lines guide the eye.")
              : phrase("Figures", "%1 Error bars: t-based %2 % CIs. Lines guide the eye."))
      .with(points, percent);
}

}  // namespace

Figure rating_figure(const FoundNumbers& found) {
  const std::vector<const Finding*> means = found.all("mean.score");
  Figure figure{
      .name = "ratings", .title = phrase("Figures", "Ratings by item"), .shape = FigureShape::rows};
  bool is_first = true;
  FigureSeries points{};
  for (const Finding* mean : means) {
    if (!mean->value) continue;
    const std::optional<FigureSpan> interval = interval_of(*mean);
    points.points.push_back({.x = *mean->value,
                             .y = static_cast<double>(figure.y.places.size()),
                             .x_interval = interval});
    figure.y.places.push_back(
        phrase("Figures", "%1 (n = %2)").with(mean->key.text(), std::to_string(mean->n)));
    hold(interval.value_or(FigureSpan{*mean->value, *mean->value}), is_first, figure.x);
  }
  if (points.points.empty()) {
    figure.instead = phrase(
        "Figures",
        "No participant rated every item, so that there are no means; add the missing ratings.");
    return figure;
  }
  widen(figure.x);
  figure.series.push_back(std::move(points));
  if (draws_intervals(figure.series)) {
    figure.x.name = phrase("Figures", "rating, mean with its %1 % CI").with(percent_of(means));
    figure.note =
        phrase("Figures",
               "Points are means over the participants who rated every item; error bars show their "
               "t-based %1 % CIs. The accompanying tests use only the ranks of the ratings.")
            .with(percent_of(means));
  } else {
    figure.x.name = phrase("Figures", "rating, mean");
    figure.note =
        phrase("Figures",
               "Points are means over the participants who rated every item; there are no CIs. The "
               "accompanying tests use only the ranks of the ratings.");
  }
  return figure;
}

Figure interaction_figure(const TidyInput& input, const FoundNumbers& found,
                          const std::string& unit) {
  const std::vector<const Finding*> means = found.all("cell.mean");
  const bool has_within_intervals =
      !means.empty() && found.value("cell.ci.half.morey", means.front()->key).has_value();
  Figure figure{.name = "means", .title = phrase("Figures", "Means by condition")};
  if (means.empty()) {
    const Finding* status = found.find("status");
    figure.instead = status != nullptr
                         ? phrase("Figures", "There are no means: %1.").with(status->status)
                         : phrase("Figures",
                                  "There are no means, because there are no measurements; collect "
                                  "measurements first.");
    return figure;
  }
  const Factors within = input.options.levels("within");
  const bool has_groups = !input.options.levels("between").empty();
  const std::size_t along = along_of(within);
  const std::vector<std::string>& levels = within[along].second;
  bool is_first = true;
  for (const Finding* mean : means) {
    const std::vector<std::string>& parts = mean->key.names();
    if (!mean->value || parts.size() != within.size() + 1) continue;
    const Phrase name = name_of_line(parts, within, along, has_groups);
    auto series = std::find_if(figure.series.begin(), figure.series.end(),
                               [&name](const FigureSeries& one) { return one.name == name; });
    if (series == figure.series.end()) {
      figure.series.push_back({.name = name, .style = static_cast<int>(figure.series.size())});
      series = figure.series.end() - 1;
    }
    const auto level = std::find(levels.begin(), levels.end(), parts[along + 1]) - levels.begin();
    FigurePoint point{.x = static_cast<double>(level), .y = *mean->value};
    const auto half = found.value("cell.ci.half.morey", mean->key);
    point.y_interval = half ? FigureSpan{.low = *mean->value - *half, .high = *mean->value + *half}
                            : interval_of(*mean);
    hold(point.y_interval.value_or(FigureSpan{*mean->value, *mean->value}), is_first, figure.y);
    series->points.push_back(point);
  }
  figure.note =
      note_on_cell_means(has_within_intervals, draws_intervals(figure.series), percent_of(means));
  const auto lines = static_cast<double>(figure.series.size());
  const double aside = std::min(kAside, 2.0 * kFarthestAside / std::max(1.0, lines - 1.0));
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    FigureSeries& series = figure.series[i];
    std::vector<FigurePlace>& line = series.lines.emplace_back();
    for (FigurePoint& point : series.points) {
      point.x += aside * (static_cast<double>(i) - 0.5 * (lines - 1.0));
      line.push_back({.x = point.x, .y = point.y});
    }
  }
  if (figure.series.size() == 1) figure.series.front().name = {};
  widen(figure.y);
  const bool are_numbers = std::all_of(levels.begin(), levels.end(), [](const std::string& level) {
    return number_in(level).has_value();
  });
  figure.x.name = within[along].first;
  if (are_numbers) figure.x.unit = unit;
  figure.x.places.assign(levels.begin(), levels.end());
  figure.y.name = phrase("Figures", "mean, in the unit of the table");
  return figure;
}

}  // namespace asperity
