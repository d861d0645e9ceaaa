// Computes the size from the physical measures of a screen where these are plausible.

#include "app/gui/participant/type_size.h"

#include <algorithm>
#include <cmath>

#include <QtGui/QScreen>

namespace asperity {

namespace {

constexpr double kSmallest_inch = 24.0 / 72.0;
constexpr double kUsual_per_inch = 96.0;
constexpr double kSmallestDiagonal_mm = 200.0;
constexpr double kSameProportions = 0.1;  // pixels are square within a tenth
constexpr double kInch_mm = 25.4;

double diagonal(const QSizeF& size) { return std::hypot(size.width(), size.height()); }

}  // namespace

ScreenMeasures measures_of(const QScreen& screen) {
  return {.size_px = screen.size(),
          .size_mm = screen.physicalSize(),
          .logical_per_inch = screen.logicalDotsPerInch()};
}

double smallest_text_px(const ScreenMeasures& screen) {
  double per_inch = std::max(kUsual_per_inch, screen.logical_per_inch);
  const double glass_mm = diagonal(screen.size_mm);
  if (glass_mm >= kSmallestDiagonal_mm && screen.size_mm.height() > 0.0) {
    const double of_px = screen.size_px.width() / screen.size_px.height();
    const double of_mm = screen.size_mm.width() / screen.size_mm.height();
    if (std::abs(of_mm / of_px - 1.0) <= kSameProportions) {
      per_inch = std::max(per_inch, diagonal(screen.size_px) / glass_mm * kInch_mm);
    }
  }
  return per_inch * kSmallest_inch;
}

}  // namespace asperity
