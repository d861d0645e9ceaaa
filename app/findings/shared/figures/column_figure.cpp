// Reads units from the endings of columns; lines are interrupted where a number is missing.

#include "app/findings/shared/figures/column_figure.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "analysis/numbers/unit_of_name.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

constexpr double kRoomAroundLines = 0.05;  // as a fraction of the range

std::size_t place_of(const std::vector<std::string>& columns, const std::string& name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw std::invalid_argument("there is no column \"" + name + "\"; write one of " +
                                comma_separated(columns));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<double> number_of_cell(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  if (const auto* text = std::get_if<std::string>(&cell)) return number_in(*text);
  return {};
}

void widen_to(FigureAxis& axis, double value, bool is_first) {
  axis.low = is_first ? value : std::min(axis.low, value);
  axis.high = is_first ? value : std::max(axis.high, value);
}

void add_room_around(FigureAxis& axis) {
  const double range = axis.high - axis.low;
  const double room = range > 0.0 ? kRoomAroundLines * range : 0.5;
  axis.low -= room;
  axis.high += room;
}

}  // namespace

void require_columns(const std::vector<std::string>& columns, const ColumnChoice& choice) {
  place_of(columns, choice.x);
  if (choice.y.empty()) throw std::invalid_argument("no column is drawn; name at least one");
  const std::string_view unit = named_quantity(choice.y.front()).unit;
  for (const std::string& column : choice.y) {
    place_of(columns, column);
    if (std::count(choice.y.begin(), choice.y.end(), column) > 1) {
      throw std::invalid_argument("the column " + column + " is named twice; name it once");
    }
    if (named_quantity(column).unit == unit) continue;
    throw std::invalid_argument("the columns " + choice.y.front() + " and " + column +
                                " have different units; draw them in separate figures");
  }
}

Figure column_figure(const Table& table, const ColumnChoice& choice) {
  require_columns(table.columns, choice);
  const NamedQuantity across = named_quantity(choice.x);
  Figure figure{
      .name = "columns",
      .title = Phrase(comma_separated(choice.y) + " over " + choice.x),
      .x = {.name = Phrase(std::string(across.quantity)), .unit = std::string(across.unit)},
      .y = {.unit = std::string(named_quantity(choice.y.front()).unit)}};
  const std::size_t x = place_of(table.columns, choice.x);
  std::string names{};
  bool is_first = true;
  for (std::size_t i = 0; i < choice.y.size(); ++i) {
    const std::size_t y = place_of(table.columns, choice.y[i]);
    const std::string name(named_quantity(choice.y[i]).quantity);
    names += (names.empty() ? "" : ", ") + name;
    FigureSeries series{.name = Phrase(name), .style = static_cast<int>(i)};
    std::vector<FigurePlace> line{};
    const auto end_line = [&] {
      if (!line.empty()) series.lines.push_back(std::move(line));
      line.clear();
    };
    for (const std::vector<Cell>& row : table.rows) {
      const std::optional<double> at = number_of_cell(row[x]);
      const std::optional<double> value = number_of_cell(row[y]);
      if (!at || !value) {
        end_line();
        continue;
      }
      line.push_back({.x = *at, .y = *value});
      widen_to(figure.x, *at, is_first);
      widen_to(figure.y, *value, is_first);
      is_first = false;
    }
    end_line();
    figure.series.push_back(std::move(series));
  }
  figure.y.name = Phrase(names);
  add_room_around(figure.x);
  add_room_around(figure.y);
  return figure;
}

}  // namespace asperity
