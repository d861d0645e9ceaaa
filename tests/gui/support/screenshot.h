// Pictures of widgets, for people to look at.

#pragma once

#include <QtCore/QSize>
#include <QtCore/QString>

class QWidget;

namespace asperity {

/// Writes NAME_1280x720.png and NAME_1920x1080.png into the folder that the environment names in
/// ASPERITY_SCREENSHOTS; does nothing without one. The widget is shown at these sizes for it.
void take_screenshot(QWidget& widget, const QString& name);
/// The same at one size, as NAME.png.
void take_screenshot(QWidget& widget, const QString& name, QSize size);

}  // namespace asperity
