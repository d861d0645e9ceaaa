#include "tests/gui/support/screenshot.h"

#include <QtCore/QDir>
#include <QtTest/QTest>
#include <QtWidgets/QWidget>

namespace asperity {

void take_screenshot(QWidget& widget, const QString& name) {
  take_screenshot(widget, name + "_1366x768", {1366, 768});
  take_screenshot(widget, name + "_1920x1080", {1920, 1080});
}

void take_screenshot(QWidget& widget, const QString& name, QSize size) {
  const QString folder = qEnvironmentVariable("ASPERITY_SCREENSHOTS");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  widget.resize(size);
  widget.show();
  QTest::qWait(50);
  widget.grab().save(folder + "/" + name + ".png");
}

}  // namespace asperity
