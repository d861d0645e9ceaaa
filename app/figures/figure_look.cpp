// The colours on paper.

#include "app/figures/figure_look.h"

namespace asperity {

FigureColors print_colors() {
  return {.ground = QColor("#FFFFFF"),
          .text = QColor("#000000"),
          .muted = QColor("#4A4A4A"),
          .line = QColor("#D9D9D9"),
          .strong = QColor("#08306B")};
}

}  // namespace asperity
