// How large the smallest letters of the participant's window are on a screen.

#pragma once

#include <QtCore/QSizeF>

class QScreen;

namespace asperity {

/// What a screen says of itself. Pixels are those that widgets count in.
struct ScreenMeasures {
  QSizeF size_px{};
  QSizeF size_mm{};
  double logical_per_inch = 96.0;
};
ScreenMeasures measures_of(const QScreen& screen);

/// The pixels of 24 points, which is what is read at arm's length: 24/72 inch by the densest of
///   - 96 pixels per inch, that is 32 px: no screen is read from nearer than that;
///   - what the desktop says that an inch is (a person who wants larger letters says so there);
///   - what the glass measures, where that can be true: a diagonal of 20 cm or more, of the same
///     proportions as the pixels. Television sets and projectors tell a made-up size.
double smallest_text_px(const ScreenMeasures& screen);

}  // namespace asperity
