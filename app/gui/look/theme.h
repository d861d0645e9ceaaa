// Colours, distances and letters of every window.

#pragma once

#include <QtGui/QColor>
#include <QtGui/QFont>

class QApplication;
class QCustomPlot;

namespace asperity {

/// Distances in pixels: everything lies on a grid of 8.
inline constexpr int kGrid = 8;
inline constexpr int kMargin = 16;
inline constexpr int kGroupGap = 24;
inline constexpr int kControlHeight = 32;

enum class ThemeChoice { system, light, dark };

/// One meaning per colour, never colour alone: blue can be pressed, green is fine, amber wants a
/// look, red is stopped. All text colours have a contrast of 4.5 : 1 or more on `ground` and
/// `panel`.
struct Theme {
  bool dark = false;
  QColor ground;  ///< of pages
  QColor panel;   ///< of cards, tables, fields
  QColor raised;  ///< of buttons, headers
  QColor line;
  QColor text;
  QColor muted;  ///< secondary text
  QColor press;  ///< blue
  QColor on_press;
  QColor fine;  ///< green
  QColor look;  ///< amber
  QColor stop;  ///< red
  QColor on_stop;
  QColor pilot;      ///< the amber band, with `on_band` on it
  QColor simulated;  ///< the violet band
  QColor on_band;
};

/// Of the running application, as last applied; light before that.
const Theme& theme();
/// Palette, style sheet and font of the whole application.
void apply_theme(QApplication& application, ThemeChoice choice);

/// Okabe–Ito, in the order in which series take them.
QColor series_color(int index);

enum class TextSize { small = 11, body = 13, heading = 16, title = 20 };  // points
QFont text_font(TextSize size, bool bold = false);
/// Digits of equal width, so that live numbers do not dance.
QFont number_font(TextSize size);

/// Axes and grid as every plot has them: no frame, few ticks, letters of the theme.
void style_plot(QCustomPlot& plot);

}  // namespace asperity
