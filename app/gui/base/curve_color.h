// The colours of curves on the ground of the theme.

#pragma once

#include "app/gui/look/theme.h"

namespace asperity {

/// Those of the series; on dark ground the first and the fifth change places, because the first is
/// too near to it.
inline QColor curve_color(int index) {
  const int place = index % 6;
  if (!theme().dark || (place != 0 && place != 4)) return series_color(place);
  return series_color(4 - place);
}

/// "━ name" in that colour, for a heading in rich text.
inline QString curve_key(const QColor& color, const QString& name) {
  return QString("&nbsp; <span style='color:%1'>━</span>&nbsp;%2")
      .arg(color.name(), name.toHtmlEscaped());
}

}  // namespace asperity
