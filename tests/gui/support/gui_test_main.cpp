// An application off screen around the tests of the windows.

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtWidgets/QApplication>
#include <gtest/gtest.h>
#include <locale.h>

#include "app/gui/look/theme.h"
#include "app/gui/study/settings.h"
#include "results_schema/study.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // Settings of the person who runs the tests are neither read nor written, nor are those of a test
  // that runs at the same time.
  QStandardPaths::setTestModeEnabled(true);
  const QTemporaryDir settings{};
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QApplication application(argc, argv);
  setlocale(LC_NUMERIC, "C");
  QApplication::setOrganizationName("asperity");
  QApplication::setApplicationName("asperity-tests");
  asperity::Study::read_beside_writers();  // as the program with its windows does
  asperity::apply_theme(application, asperity::ThemeChoice::light);
  asperity::apply_language("en");
  return RUN_ALL_TESTS();
}
