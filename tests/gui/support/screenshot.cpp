#include "tests/gui/support/screenshot.h"

#include <QtCore/QDir>
#include <QtTest/QTest>
#include <QtWidgets/QWidget>

namespace asperity {

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
