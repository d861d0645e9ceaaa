// Response times by condition and over trials, and proportions correct over trials.

#include "app/findings/shared/figures/response_time_figures.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/findings/outcome/single_participants.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr double kFarthestEnd = 2.0;  // of an interval beyond the marks, as a factor

/// A range that is extended to include numbers above 0.
struct LogRange {
  double low = 0.0;
  double high = 0.0;

  void hold(double value) {
    low = low > 0.0 ? std::min(low, value) : value;
    high = std::max(high, value);
  }
};

/// A logarithmic axis for marks and their intervals; intervals that extend far beyond all marks end
/// in arrows.
void fit_axis(const LogRange& marks, const LogRange& ends, FigureAxis& axis) {
  LogRange shown = marks;
  if (ends.high > 0.0) {
    shown.hold(std::max(ends.low, marks.low / kFarthestEnd));
    shown.hold(std::min(ends.high, marks.high * kFarthestEnd));
  }
  axis.scale = AxisScale::log10;
  axis.low = shown.low / kBeyondMarks;
  axis.high = shown.high * kBeyondMarks;
}

/// "wood" for "texture=wood".
Phrase name_of_condition(const std::string& key) {
  if (key.empty()) return phrase("Figures", "all trials");
  const std::size_t equals = key.find('=');
  if (equals == std::string::npos) return key;
  const std::string factor = key.substr(0, equals);
  const std::string level = key.substr(equals + 1);
  if (factor == "column") return phrase("Figures", "repetition %1").with(level);
  if (const auto spacing_m = number_in(level); factor == "spacing_m" && spacing_m) {
    return phrase("Figures", "spacing %1 mm").with(number_text(kMillimetresPerMetre * *spacing_m));
  }
  return level;
}

bool has_interval(const std::vector<const Finding*>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding* one) { return interval_of(*one).has_value(); });
}

Phrase note_on_geometric_means(const std::vector<const Finding*>& means) {
  return has_interval(means) ? phrase("Figures",
                                      "Points are geometric means over the participants; error "
                                      "bars show their t-based %1 % CIs on the logarithmic scale. "
                                      "Response times are measured from the cue to the response.")
                                   .with(percent_of(means))
                             : phrase("Figures",
                                      "Points are geometric means over the participants. Response "
                                      "times are measured from the cue to the response.");
}

/// The lines of single participants over the blocks; none for a single participant, or for too
/// many.
FigureSeries lines_of_singles(const FoundNumbers& found,
                              const std::map<std::string, double>& place_of_block) {
  std::map<std::string, std::vector<FigurePlace>> lines{};
  for (const Finding* one : found.all("subject.block")) {
    const auto place = place_of_block.find(one->key.last());
    if (!one->value || place == place_of_block.end()) continue;
    lines[one->key[0]].push_back({.x = place->second, .y = *one->value});
  }
  FigureSeries series{.single = true};
  if (lines.size() < 2 || lines.size() > kMostSingle) return series;
  for (auto& [name, line] : lines) series.lines.push_back(std::move(line));
  return series;
}

/// Means of ranges of trials as points on a line, with single participants behind them. The caller
/// sets the axis of the means.
Figure course_figure(const FoundNumbers& found) {
  Figure figure{};
  const std::vector<const Finding*> blocks = found.all("block");
  std::map<std::string, double> place_of_block{};
  FigureSeries means{};
  std::vector<FigurePlace>& line = means.lines.emplace_back();
  for (const Finding* block : blocks) {
    const auto place = static_cast<double>(figure.x.places.size());
    place_of_block[block->key.last()] = place;
    std::string range = block->key.last();
    if (const std::size_t dash = range.find('-'); dash != std::string::npos) {
      range.replace(dash, 1, "–");
    }
    figure.x.places.emplace_back(range);
    means.points.push_back({.x = place, .y = *block->value, .y_interval = interval_of(*block)});
    line.push_back({.x = place, .y = *block->value});
  }
  if (blocks.empty()) {
    figure.instead = phrase("Figures", "No trial has a result; collect responses first.");
    return figure;
  }
  figure.x.name = phrase("Figures", "trials of a participant, as numbered in the plan");
  figure.series.push_back(std::move(means));
  figure.series.push_back(lines_of_singles(found, place_of_block));
  return figure;
}

Phrase with_note_on_lines(const Phrase& note, const Figure& figure) {
  if (!shows_singles(figure)) return note;
  return phrase("Figures", "%1 Thin pale lines: individual participants.").with(note);
}

}  // namespace

Figure response_times_figure(const FoundNumbers& found) {
  const std::vector<const Finding*> means = found.all("geomean");
  Figure figure{.name = "response_times",
                .title = phrase("Figures", "Response times by condition"),
                .shape = FigureShape::rows};
  if (means.empty()) {
    figure.instead =
        phrase("Figures", "No trial has a stored response time; collect responses first.");
    return figure;
  }
  const auto singles = singles_by_condition(found.all("subject.geomean"));
  LogRange marks{};
  LogRange ends{};
  FigureSeries points{};
  std::vector<SingleValues> rows{};
  for (const Finding* mean : means) {
    const auto place = static_cast<double>(figure.y.places.size());
    const std::optional<FigureSpan> interval = interval_of(*mean);
    points.points.push_back({.x = *mean->value, .y = place, .x_interval = interval});
    figure.y.places.push_back(
        phrase("Figures", "%1 (n = %2)")
            .with(name_of_condition(mean->key.last()), std::to_string(mean->n)));
    marks.hold(*mean->value);
    if (const auto own = singles.find(mean->key); own != singles.end()) {
      rows.push_back({.place = place, .values = own->second});
      for (const double value : own->second) marks.hold(value);
    }
    if (!interval) continue;
    ends.hold(interval->low);
    ends.hold(interval->high);
  }
  fit_axis(marks, ends, figure.x);
  figure.x.name = has_interval(means)
                      ? phrase("Figures", "response time, with its %1 % CI").with(percent_of(means))
                      : phrase("Figures", "response time");
  figure.x.unit = "s";
  figure.series.push_back(std::move(points));
  figure.series.push_back(singles_in_rows(rows, figure.x, 0));
  figure.note = with_note_on_singles(note_on_geometric_means(means), figure);
  return figure;
}

Figure contact_times_figure(const FoundNumbers& found) {
  const std::string quantity = "contact_s";
  const auto of_contact = [&](QuantityName name) {
    std::vector<Finding> of{};
    for (const Finding* one : found.all(name)) {
      if (one->key[0] != quantity || !one->value) continue;
      of.push_back(*one);
      of.back().key = one->key.without_first();
    }
    return of;
  };
  Figure figure{.name = "contact_times",
                .title = phrase("Figures", "Contact times by condition"),
                .shape = FigureShape::rows};
  const std::vector<Finding> medians = of_contact("median");
  if (medians.empty()) {
    figure.instead =
        phrase("Figures", "No trial has a stored contact time; collect trials with contact first.");
    return figure;
  }
  const std::vector<Finding> own = of_contact("subject.value");
  std::vector<const Finding*> of_participants{};
  for (const Finding& one : own) of_participants.push_back(&one);
  const auto singles = singles_by_condition(of_participants);
  FigureSeries points{};
  std::vector<SingleValues> rows{};
  double highest = 0.0;
  for (const Finding& median : medians) {
    const auto place = static_cast<double>(figure.y.places.size());
    const FindingKey key{quantity, median.key};
    const std::optional<double> lower = found.value("quartile.lower", key);
    const std::optional<double> upper = found.value("quartile.upper", key);
    const bool has_quartiles = lower && upper && median.n > 1;
    points.points.push_back(
        {.x = *median.value,
         .y = place,
         .x_interval = has_quartiles ? std::optional(FigureSpan{*lower, *upper}) : std::nullopt});
    figure.y.places.push_back(
        phrase("Figures", "%1 (n = %2)")
            .with(name_of_condition(median.key.last()), std::to_string(median.n)));
    highest = std::max(highest, upper.value_or(*median.value));
    if (const auto values = singles.find(median.key); values != singles.end()) {
      rows.push_back({.place = place, .values = values->second});
      for (const double value : values->second) highest = std::max(highest, value);
    }
  }
  figure.x = {.name = phrase("Figures", "contact time per surface"), .unit = "s"};
  figure.x.low = 0.0;
  figure.x.high = highest > 0.0 ? highest * kBeyondMarks : 1.0;
  figure.series.push_back(std::move(points));
  figure.series.push_back(singles_in_rows(rows, figure.x, 0));
  figure.note =
      with_note_on_singles(phrase("Figures",
                                  "Points are medians over the participants of each participant’s "
                                  "median contact time; error bars show the quartiles."),
                           figure);
  return figure;
}

Figure times_over_trials_figure(const FoundNumbers& found) {
  Figure figure = course_figure(found);
  figure.name = "times_over_trials";
  figure.title = phrase("Figures", "Response times over the trials");
  if (!figure.is_drawn()) return figure;
  LogRange marks{};
  LogRange ends{};
  for (const FigureSeries& series : figure.series) {
    for (const std::vector<FigurePlace>& line : series.lines) {
      for (const FigurePlace& place : line) marks.hold(place.y);
    }
    for (const FigurePoint& point : series.points) {
      if (!point.y_interval) continue;
      ends.hold(point.y_interval->low);
      ends.hold(point.y_interval->high);
    }
  }
  fit_axis(marks, ends, figure.y);
  figure.y.name = phrase("Figures", "response time");
  figure.y.unit = "s";
  const std::vector<const Finding*> blocks = found.all("block");
  figure.note = with_note_on_lines(note_on_geometric_means(blocks), figure);
  return figure;
}

Figure correct_over_trials_figure(const FoundNumbers& found) {
  Figure figure = course_figure(found);
  figure.name = "correct_over_trials";
  figure.title = phrase("Figures", "Proportion correct over the trials (for matching: of items)");
  if (!figure.is_drawn()) return figure;
  figure.y = {.name = phrase("Figures", "proportion correct (for matching: of items)"),
              .low = 0.0,
              .high = 1.0};
  const std::vector<const Finding*> blocks = found.all("block");
  figure.note = with_note_on_lines(
      has_interval(blocks)
          ? phrase("Figures",
                   "Points are means of the participants' own proportions; error bars show their "
                   "t-based %1 % CIs on the logit scale.")
                .with(percent_of(blocks))
          : phrase("Figures", "Points are means of the participants' own proportions."),
      figure);
  return figure;
}

}  // namespace asperity
