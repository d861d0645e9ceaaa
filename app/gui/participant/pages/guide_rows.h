// The rows of a guide, which shows how the hand meets its bands, and the numbers under its bars.

#pragma once

#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// What a guide shows, from above, in rows of one height.
struct GuideRows {
  int track = 0;  ///< rows of the stroke that a target moves along
  bool force = false;
  bool speed = false;
  int bars() const noexcept { return (force ? 1 : 0) + (speed ? 1 : 0); }
  int count() const noexcept { return track + bars(); }
};
GuideRows guide_rows(const Exploration& asked);
/// How much higher a bar's row is with the numbers of its scale under it, in letters of that size.
double height_of_guide_numbers(double letters_px);
/// What stands at a scale from 0 to `end`: at most five round numbers and 0.
std::vector<double> guide_ticks(double end);

}  // namespace asperity
