// The heights of a relief along a line across it, and their spectrum.

#pragma once

#include "app/gui/workbench/signal_plots.h"
#include "stimuli/heights/height_field.h"

namespace asperity {

/// In the units of the screen: millimetres and micrometres; waves per mm and µm² mm.
struct LineProfile {
  PlotSeries heights{};
  PlotSeries spectrum{};  ///< by Welch's method, from half of the line at a time
};

/// Along the row of samples nearest to y.
LineProfile profile_along(const HeightField& field, double y_m);

}  // namespace asperity
