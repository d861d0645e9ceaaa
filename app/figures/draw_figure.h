// Draws a figure with Qt, on paper and in windows.

#pragma once

#include <QtCore/QRectF>

#include "app/figures/figure_look.h"
#include "app/findings/outcome/figure.h"

class QPainter;

namespace asperity {

/// The height of a figure of this width, in the units of the painter.
double figure_height(const Figure& figure, double width, const FigureLook& look);

/// Draws the figure inside the rectangle, without a ground. The state of the painter is restored. Any thread, if there
/// is a QGuiApplication.
void draw_figure(const Figure& figure, QPainter& painter, const QRectF& into,
                 const FigureLook& look);

}  // namespace asperity
