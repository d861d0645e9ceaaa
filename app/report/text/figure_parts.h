// Divides a figure with many rows into figures that fit on a page.

#pragma once

#include <vector>

#include "app/findings/outcome/figure.h"

namespace asperity {

/// Figures of consecutive rows, each with at most about 30 marks one above the other; the figure itself if it has no rows
/// or not more, or if its lines join several rows. All parts have the horizontal axis of the figure, and titles that end with "part 1 of 2".
std::vector<Figure> parts_of_rows(const Figure& figure);

}  // namespace asperity
