// Waits until the picture no longer changes, and saves it if a folder is named.

#include "tests/gui/support/screenshot.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QWidget>

namespace asperity {

void take_screenshot(QWidget& widget, const QString& name) {
  take_screenshot(widget, name + "_1280x720", {1280, 720});
  take_screenshot(widget, name + "_1920x1080", {1920, 1080});
}

void take_screenshot(QWidget& widget, const QString& name, QSize size) {
  const QString folder = qEnvironmentVariable("ASPERITY_SCREENSHOTS");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  widget.resize(size);
  widget.show();
  // Words in scrolled cards find their height in several rounds of layout: the picture is taken when two are alike.
  constexpr int kBetween_ms = 50;
  constexpr int kMostRounds = 40;
  QTest::qWait(kBetween_ms);
  QImage before{};
  for (int round = 0; round < kMostRounds; ++round) {
    QCoreApplication::sendPostedEvents();
    QTest::qWait(kBetween_ms);
    const QImage now = widget.grab().toImage();
    if (now == before) break;
    before = now;
  }
  widget.grab().save(folder + "/" + name + ".png");
}

}  // namespace asperity
