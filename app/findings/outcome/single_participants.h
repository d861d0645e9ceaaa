// Draws single participants as marks behind the means of a figure.

#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// With more participants, marks hide each other; a figure then shows only the means.
inline constexpr std::size_t kMostSingle = 60;

/// The sideways offset of each value, −1 to 1: values within `near` of each other, in ascending
/// order, are spread evenly about 0, so that all are visible. The same values have the same
/// offsets.
std::vector<double> places_aside(std::span<const double> values, double near);

/// The values of single participants at one place of the other axis.
struct SingleValues {
  double place = 0.0;
  std::vector<double> values{};
};

/// Values of single participants by the names of their key after the participant.
using SinglesByCondition = std::map<FindingKey, std::vector<double>>;
SinglesByCondition singles_by_condition(std::span<const Finding* const> findings);

/// Marks in rows, with the values along the horizontal axis `x`. None where there are too many for
/// a row.
FigureSeries singles_in_rows(std::span<const SingleValues> rows, const FigureAxis& x, int style);

/// Marks in columns, with the values along the vertical axis `y`, at places on a horizontal axis of
/// numbers.
FigureSeries singles_in_columns(std::span<const SingleValues> columns, const FigureAxis& x,
                                const FigureAxis& y, int style);

/// Whether a series has marks or lines of single participants, which the caption then explains.
bool shows_singles(const Figure& figure);

/// Adds a sentence about these marks to a note, where there are any.
Phrase with_note_on_singles(const Phrase& note, const Figure& figure);

}  // namespace asperity
