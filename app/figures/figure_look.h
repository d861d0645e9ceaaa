// The appearance of a figure: colours, font and language.

#pragma once

#include <QtCore/QString>
#include <QtGui/QColor>

#include "analysis/words/phrase.h"

namespace asperity {

struct FigureColors {
  QColor ground{};  ///< of cells with shade 0; the figure does not paint a ground
  QColor text{};
  QColor muted{};   ///< axes and their labels
  QColor line{};    ///< grid
  QColor strong{};  ///< cells with shade 1
};

/// Black on white, for print.
FigureColors print_colors();

struct FigureLook {
  FigureColors colors = print_colors();
  QString family{};  ///< of the font; empty: the sans-serif font of the system
  double letters =
      1.0;  ///< font size in the units of the painter; all other lengths follow from it
  Phrase::LookUp look_up{};  ///< the language; empty: English
};

}  // namespace asperity
