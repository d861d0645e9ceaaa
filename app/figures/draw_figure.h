// Draws a figure with Qt, on paper and in a window alike.

#pragma once

#include <QtCore/QRectF>
#include <QtCore/QString>
#include <QtGui/QColor>

#include "app/findings/figure.h"

class QPainter;

namespace asperity {

struct FigureColors {
  QColor ground{};  ///< where cells have shade 0; the figure itself paints no ground
  QColor text{};
  QColor muted{};   ///< axes and what stands at them
  QColor line{};    ///< grid
  QColor strong{};  ///< cells of shade 1
};

/// Black on white, for print.
FigureColors print_colors();

struct FigureLook {
  FigureColors colors = print_colors();
  QString family{};          ///< of the letters; empty: the system's sans
  double letters = 1.0;      ///< their size, in the units of the painter; all else goes by it
  Phrase::LookUp look_up{};  ///< the language; empty: English
};

/// How high the figure is, in the units of the painter, when it is so wide.
double figure_height(const Figure& figure, double width, const FigureLook& look);

/// Draws the figure into the rectangle: nothing outside of it, no ground. The painter is left as it
/// was. Any thread, where there is a QGuiApplication.
void draw_figure(const Figure& figure, QPainter& painter, const QRectF& into,
                 const FigureLook& look);

}  // namespace asperity
