// Responses to anchors by their place in a run.

#include "app/findings/shared/anchor_figures.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/single_participants.h"
#include "app/findings/shared/anchors.h"
#include "protocols/design/protocol.h"

namespace asperity {

namespace {

constexpr double kRoomAroundResponses = 0.06;  // as a fraction of their range

/// A place, with the column of its means.
struct PlaceOfAnchors {
  AnchorPlace place = AnchorPlace::start;
  const ResultColumn& means;
  Phrase name{};
};

const std::array<PlaceOfAnchors, 3>& all_places() {
  static const std::array<PlaceOfAnchors, 3> kPlacesOfAnchors{
      PlaceOfAnchors{AnchorPlace::start, kAnchorStart, phrase("Figures", "start")},
      PlaceOfAnchors{AnchorPlace::middle, kAnchorMiddle, phrase("Figures", "middle")},
      PlaceOfAnchors{AnchorPlace::end, kAnchorEnd, phrase("Figures", "end")}};
  return kPlacesOfAnchors;
}

/// The places that have a response, in order, from 0; by their words in the table of responses.
std::map<std::string, double> places_of(const RowReader& trend) {
  std::map<std::string, double> places{};
  for (const PlaceOfAnchors& each : all_places()) {
    if (trend.number(each.means)) {
      const auto next = static_cast<double>(places.size());
      places.emplace(text_of(each.place), next);
    }
  }
  return places;
}

/// A line for each run of a participant; none for a single line, or for too many.
FigureSeries lines_of_runs(const ResultTable& anchors, const RowReader& trend,
                           const std::map<std::string, double>& places) {
  using namespace columns;
  const bool are_proportions = trend.text(kMeasure) == kAnchorCorrect;
  const bool are_estimates = trend.text(kMeasure) == kAnchorEstimate;
  std::map<std::tuple<std::string, double, double>, std::vector<FigurePlace>> lines{};
  for (const ResultRow& cells : anchors.rows) {
    const RowReader row(anchors, cells);
    if (row.text(kBlock) != trend.text(kBlock) || row.text(kQuestion) != trend.text(kQuestion))
      continue;
    const std::optional<double> value = row.number(are_proportions ? kCorrect : kAnchorResponse);
    const auto place = places.find(row.text(kAnchorPlace));
    if (!value || place == places.end() || (are_estimates && *value <= 0.0)) continue;
    lines[{row.text(kParticipant), row.number(kSession).value_or(0.0),
           row.number(kBlockOrdinal).value_or(0.0)}]
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

Figure anchor_figure(const ResultTable& anchors, const RowReader& trend) {
  using namespace columns;
  const std::map<std::string, double> places = places_of(trend);
  const std::string measure = trend.text(kMeasure);
  const std::string block = trend.text(kBlock);
  const std::string question = trend.text(kQuestion);
  Figure figure{.name = figure_file_name("anchors_" + block + '_' + question),
                .title = phrase("Figures", "Responses to the anchors of the block %1, question %2")
                             .with(block, question)};
  figure.x.name = phrase("Figures", "place of the anchor in the block");
  figure.x.places.resize(places.size());
  FigureSeries means{};
  std::vector<FigurePlace>& line = means.lines.emplace_back();
  for (const PlaceOfAnchors& each : all_places()) {
    const std::optional<double> mean = trend.number(each.means);
    if (!mean) continue;
    const double place = places.at(text_of(each.place));
    figure.x.places[static_cast<std::size_t>(place)] = each.name;
    means.points.push_back({.x = place, .y = *mean});
    line.push_back({.x = place, .y = *mean});
  }
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

std::vector<Figure> anchor_figures(const ResultTable& trend, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const ResultTable* const anchors = table_named(outcome, kAnchors);
  if (anchors == nullptr) return figures;
  for (const ResultRow& row : trend.rows) {
    figures.push_back(anchor_figure(*anchors, RowReader(trend, row)));
  }
  return figures;
}

}  // namespace asperity
