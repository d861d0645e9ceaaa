// Responses to anchors by their place in a run.

#include "app/findings/shared/figures/anchor_figures.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/single_participants.h"
#include "app/findings/shared/anchors.h"

namespace asperity {

namespace {

constexpr double kRoomAroundResponses = 0.06;  // as a fraction of their range
constexpr std::array kColumnsOfPlaces{"start", "middle", "end"};

/// The places that have a response, in order, from 0.
std::map<std::string, double> places_of(const RowOfTable& trend) {
  std::map<std::string, double> places{};
  for (const char* const column : kColumnsOfPlaces) {
    if (trend.number(column)) {
      const auto next = static_cast<double>(places.size());
      places.emplace(column, next);
    }
  }
  return places;
}

/// A line for each run of a participant; none for a single line, or for too many.
FigureSeries lines_of_runs(const Table& anchors, const RowOfTable& trend,
                           const std::map<std::string, double>& places) {
  const bool are_proportions = trend.text("measure") == kAnchorCorrect;
  const bool are_estimates = trend.text("measure") == kAnchorEstimate;
  std::map<std::tuple<std::string, double, double>, std::vector<FigurePlace>> lines{};
  for (const std::vector<Cell>& cells : anchors.rows) {
    const RowOfTable row(anchors, cells);
    if (row.text("block") != trend.text("block") || row.text("question") != trend.text("question"))
      continue;
    const std::optional<double> value = row.number(are_proportions ? "correct" : "response");
    const auto place = places.find(row.text("place"));
    if (!value || place == places.end() || (are_estimates && *value <= 0.0)) continue;
    lines[{row.text("participant"), row.number("session").value_or(0.0),
           row.number("block_ordinal").value_or(0.0)}]
        .push_back({.x = place->second, .y = *value});
  }
  FigureSeries series{.single = true};
  // Lines from 0 to 1 hide each other.
  if (are_proportions || lines.size() < 2 || lines.size() > kMostSingle) return series;
  for (auto& [run, line] : lines) series.lines.push_back(std::move(line));
  return series;
}

void fit_values(const std::vector<FigureSeries>& series, FigureAxis& axis) {
  std::vector<double> values{};
  for (const FigureSeries& each : series) {
    for (const FigurePoint& point : each.points) values.push_back(point.y);
    for (const std::vector<FigurePlace>& line : each.lines) {
      for (const FigurePlace& place : line) values.push_back(place.y);
    }
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (axis.scale == AxisScale::log10) {
    axis.low = *low / kBeyondMarks;
    axis.high = *high * kBeyondMarks;
    return;
  }
  const double room = *high > *low ? kRoomAroundResponses * (*high - *low) : 0.5;
  axis.low = *low - room;
  axis.high = *high + room;
}

Phrase name_of_values(const std::string& measure) {
  if (measure == kAnchorEstimate) return phrase("Figures", "estimate, geometric mean");
  return measure == kAnchorRating ? phrase("Figures", "rating, mean")
                                  : phrase("Figures", "proportion correct, mean");
}

Figure anchor_figure(const Table& anchors, const RowOfTable& trend) {
  const std::map<std::string, double> places = places_of(trend);
  const std::string measure = trend.text("measure");
  Figure figure{
      .name = figure_file_name("anchors_" + trend.text("block") + '_' + trend.text("question")),
      .table = kAnchorTrend,
      .title = phrase("Figures", "Responses to the anchors of the block %1, question %2")
                   .with(trend.text("block"), trend.text("question"))};
  figure.x.name = phrase("Figures", "place of the anchor in the block");
  figure.x.places.resize(places.size());
  FigureSeries means{};
  std::vector<FigurePlace>& line = means.lines.emplace_back();
  for (const auto& [name, place] : places) {
    figure.x.places[static_cast<std::size_t>(place)] = name == "start" ? phrase("Figures", "start")
                                                       : name == "middle"
                                                           ? phrase("Figures", "middle")
                                                           : phrase("Figures", "end");
    const double mean = *trend.number(name);
    means.points.push_back({.x = place, .y = mean});
    line.push_back({.x = place, .y = mean});
  }
  const auto by_place = [](const auto& a, const auto& b) { return a.x < b.x; };
  std::sort(means.points.begin(), means.points.end(), by_place);
  std::sort(line.begin(), line.end(), by_place);
  figure.series.push_back(std::move(means));
  figure.series.push_back(lines_of_runs(anchors, trend, places));
  figure.y.name = name_of_values(measure);
  if (measure == kAnchorCorrect) {
    figure.y.high = 1.0;
  } else {
    figure.y.scale = measure == kAnchorEstimate ? AxisScale::log10 : AxisScale::linear;
    fit_values(figure.series, figure.y);
  }
  figure.note = phrase("Figures", "Points are means over the participants.");
  if (shows_singles(figure)) {
    figure.note = phrase("Figures",
                         "%1 Thin pale lines: the responses of individual participants in each run "
                         "of the block.")
                      .with(figure.note);
  }
  return figure;
}

}  // namespace

std::vector<Figure> anchor_figures(const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const NamedTable* const anchors = table_named(outcome, kAnchors);
  const NamedTable* const trend = table_named(outcome, kAnchorTrend);
  if (anchors == nullptr || trend == nullptr) return figures;
  for (const std::vector<Cell>& row : trend->table.rows) {
    figures.push_back(anchor_figure(anchors->table, RowOfTable(trend->table, row)));
  }
  return figures;
}

}  // namespace asperity
