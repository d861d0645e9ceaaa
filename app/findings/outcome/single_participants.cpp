// Moves marks that would overlap aside, symmetrically about their place; omitted for one participant and for many.

#include "app/findings/outcome/single_participants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity {

namespace {

constexpr double kNear = 0.015;             // of an axis: about the width of a mark
constexpr double kStepAside = 0.5;          // between neighbours, where space permits
constexpr double kFarthestInRow = 0.4;      // of the distance between rows
constexpr double kFarthestInColumn = 0.02;  // of the horizontal axis

double on_axis(const FigureAxis& axis, double value) {
  return axis.scale == AxisScale::log10 ? std::log10(value) : value;
}

double range_of(const FigureAxis& axis) {
  return on_axis(axis, axis.high) - on_axis(axis, axis.low);
}

std::vector<double> places_along(const SingleValues& singles, const FigureAxis& axis) {
  std::vector<double> along{};
  for (const double value : singles.values) along.push_back(on_axis(axis, value));
  return places_aside(along, kNear * range_of(axis));
}

/// False where the marks would be hidden: by the mean of a single participant, or by each other.
bool can_be_seen(std::span<const SingleValues> places) {
  std::size_t most = 0;
  for (const SingleValues& one : places) most = std::max(most, one.values.size());
  return most > 1 && most <= kMostSingle;
}

}  // namespace

std::vector<double> places_aside(std::span<const double> values, double near) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> places(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && values[order[last + 1]] - values[order[first]] <= near) {
      ++last;
    }
    const auto neighbours = static_cast<double>(last - first);
    const double step = neighbours > 0.0 ? std::min(kStepAside, 2.0 / neighbours) : 0.0;
    for (std::size_t i = first; i <= last; ++i) {
      places[order[i]] = step * (static_cast<double>(i - first) - 0.5 * neighbours);
    }
    first = last + 1;
  }
  return places;
}

SinglesByCondition singles_by_condition(std::span<const Finding* const> findings) {
  SinglesByCondition singles{};
  for (const Finding* one : findings) {
    if (!one->value) continue;
    singles[one->key.without_first()].push_back(*one->value);
  }
  return singles;
}

FigureSeries singles_in_rows(std::span<const SingleValues> rows, const FigureAxis& x, int style) {
  FigureSeries series{.style = style, .single = true};
  if (!can_be_seen(rows)) return series;
  for (const SingleValues& row : rows) {
    const std::vector<double> aside = places_along(row, x);
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      series.points.push_back({.x = row.values[i], .y = row.place + kFarthestInRow * aside[i]});
    }
  }
  return series;
}

FigureSeries singles_in_columns(std::span<const SingleValues> columns, const FigureAxis& x,
                                const FigureAxis& y, int style) {
  FigureSeries series{.style = style, .single = true};
  if (!can_be_seen(columns)) return series;
  const double farthest = kFarthestInColumn * range_of(x);
  for (const SingleValues& column : columns) {
    const std::vector<double> aside = places_along(column, y);
    for (std::size_t i = 0; i < column.values.size(); ++i) {
      const double shift = farthest * aside[i];
      series.points.push_back({.x = x.scale == AxisScale::log10
                                        ? column.place * std::pow(10.0, shift)
                                        : column.place + shift,
                               .y = column.values[i]});
    }
  }
  return series;
}

bool shows_singles(const Figure& figure) {
  return std::any_of(figure.series.begin(), figure.series.end(), [](const FigureSeries& one) {
    return one.single && (!one.points.empty() || !one.lines.empty());
  });
}

Phrase with_note_on_singles(const Phrase& note, const Figure& figure) {
  if (!shows_singles(figure)) return note;
  return phrase("Figures", "%1 Small pale marks: individual participants.").with(note);
}

}  // namespace asperity
