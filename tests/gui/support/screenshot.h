// Pictures of widgets, for people to look at.

#pragma once

#include <QtCore/QSize>
#include <QtCore/QString>

class QWidget;

namespace asperity {

/// Writes NAME.png into the folder that the environment names in ASPERITY_SCREENSHOTS; does nothing
/// without one. The widget is shown at `size` for it.
void take_screenshot(QWidget& widget, const QString& name, QSize size = {1366, 768});

}  // namespace asperity
