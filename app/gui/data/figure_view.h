// A figure in a window.

#pragma once

#include <QtWidgets/QFrame>

#include "app/findings/outcome/figure.h"

namespace asperity {

/// The figure as wide as there is room, in the colours of the theme, with its note and with buttons
/// to save and to copy it. Where there is nothing to draw, the sentence that says why.
class FigureView final : public QFrame {
  Q_OBJECT
 public:
  explicit FigureView(Figure figure, QWidget* parent = nullptr);

  const Figure& figure() const noexcept { return figure_; }

 signals:
  void saveWanted(double width_mm);
  void copyWanted();

 private:
  Figure figure_{};
};

}  // namespace asperity
