// Single participants as marks behind the means of a figure.

#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "analysis/finding.h"
#include "app/findings/figure.h"

namespace asperity {

/// More participants hide each other; a figure then shows the means alone.
inline constexpr std::size_t kMostSingle = 60;

/// How far each value stands aside, −1 to 1: values within `near` of each other, in the order of their size, spread
/// evenly about 0, so that all are seen. The same values have the same places.
std::vector<double> places_aside(std::span<const double> values, double near);

/// What single participants have at one place of the other axis.
struct SingleValues {
  double place = 0.0;
  std::vector<double> values{};
};

/// Values of single participants by what stands behind the participant in their key: "texture=wood" of
/// "P01|texture=wood", nothing of "P01".
using SinglesByCondition = std::map<std::string, std::vector<double>>;
SinglesByCondition singles_by_condition(std::span<const Finding* const> findings);

/// Marks in rows, the values along the horizontal axis `x`. None where there are too many for a row.
FigureSeries singles_in_rows(std::span<const SingleValues> rows, const FigureAxis& x, int style);

/// Marks in columns, the values along the vertical axis `y`, at places on a horizontal axis of numbers.
FigureSeries singles_in_columns(std::span<const SingleValues> columns, const FigureAxis& x,
                                const FigureAxis& y, int style);

/// Whether a series has marks or lines of single participants, which a caption then explains.
bool shows_singles(const Figure& figure);

/// A note with the sentence about the marks, where there are any.
Phrase with_note_on_singles(const Phrase& note, const Figure& figure);

}  // namespace asperity
