// Divides the rows evenly, and repeats the axis in every part.

#include "app/report/text/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace asperity {

std::vector<Figure> parts_of_rows(const Figure& figure) {
  constexpr std::size_t kMostMarks = 30;  // of rows on a page
  const std::size_t marks = std::max<std::size_t>(1, figure.marks_per_row);
  const std::size_t most = std::max<std::size_t>(1, kMostMarks / marks);
  const std::size_t rows = figure.y.places.size();
  if (!figure.is_drawn() || figure.shape != FigureShape::rows || rows <= most) return {figure};
  const std::size_t count = (rows + most - 1) / most;
  // Profiles and trees join rows across a division; they are not divided.
  const bool joins_rows =
      std::any_of(figure.series.begin(), figure.series.end(), [](const FigureSeries& series) {
        return std::any_of(series.lines.begin(), series.lines.end(), [](const auto& line) {
          return std::any_of(line.begin(), line.end(), [&line](const FigurePlace& place) {
            return std::abs(place.y - line.front().y) >= 1.0;
          });
        });
      });
  if (joins_rows) return {figure};
  std::vector<Figure> parts{};
  for (std::size_t part = 0; part < count; ++part) {
    const std::size_t from = part * rows / count;
    const std::size_t to = (part + 1) * rows / count;
    // Several marks at one place lie within half a row of it.
    const auto is_outside = [from, to](double y) {
      return y < static_cast<double>(from) - 0.5 || y >= static_cast<double>(to) - 0.5;
    };
    const auto offset = static_cast<double>(from);
    const auto select = [from, to](std::vector<Phrase>& places) {
      if (places.empty()) return;
      places = {places.begin() + static_cast<std::ptrdiff_t>(from),
                places.begin() + static_cast<std::ptrdiff_t>(to)};
    };
    Figure of_part = figure;
    of_part.title = Phrase("%1, part %2 of %3")
                        .with(figure.title, std::to_string(part + 1), std::to_string(count));
    select(of_part.y.places);
    select(of_part.y.far_places);
    for (FigureSeries& series : of_part.series) {
      std::erase_if(series.points, [&](const FigurePoint& point) { return is_outside(point.y); });
      for (FigurePoint& point : series.points) point.y -= offset;
      std::erase_if(series.lines, [&](const std::vector<FigurePlace>& line) {
        return std::any_of(line.begin(), line.end(),
                           [&](const FigurePlace& place) { return is_outside(place.y); });
      });
      for (std::vector<FigurePlace>& line : series.lines) {
        for (FigurePlace& place : line) place.y -= offset;
      }
    }
    parts.push_back(std::move(of_part));
  }
  return parts;
}

}  // namespace asperity
