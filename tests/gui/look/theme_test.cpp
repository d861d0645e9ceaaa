// Contrast of the light and the dark theme, and the return to that of the system.

#include "app/gui/look/theme.h"

#include <algorithm>
#include <cmath>

#include <QtWidgets/QApplication>
#include <gtest/gtest.h>

namespace asperity {
namespace {

double luminance(const QColor& color) {
  const auto linear = [](double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& one, const QColor& other) {
  const double brighter = std::max(luminance(one), luminance(other));
  const double darker = std::min(luminance(one), luminance(other));
  return (brighter + 0.05) / (darker + 0.05);
}

TEST(Theme, HasReadableContrastLightAndDark) {
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    const Theme& look = theme();
    for (const QColor& ground : {look.ground, look.panel}) {
      for (const QColor& letters :
           {look.text, look.muted, look.press, look.fine, look.look, look.stop}) {
        EXPECT_GE(contrast(letters, ground), 4.5)
            << letters.name().toStdString() << " on " << ground.name().toStdString();
      }
    }
    EXPECT_GE(contrast(look.on_press, look.press), 4.5);
    EXPECT_GE(contrast(look.on_stop, look.stop), 4.5);
    EXPECT_GE(contrast(look.on_band, look.pilot), 4.5);
    EXPECT_GE(contrast(look.on_band, look.simulated), 4.5);
  }
  apply_theme(*qApp, ThemeChoice::light);
}

TEST(Theme, GoesBackToThatOfTheSystem) {
  apply_theme(*qApp, ThemeChoice::system);
  const bool system_is_dark = theme().dark;
  apply_theme(*qApp, system_is_dark ? ThemeChoice::light : ThemeChoice::dark);
  apply_theme(*qApp, ThemeChoice::system);
  EXPECT_EQ(theme().dark, system_is_dark);
  apply_theme(*qApp, ThemeChoice::light);
}

}  // namespace
}  // namespace asperity
