// An application off screen around the tests of the windows.

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtWidgets/QApplication>
#include <gtest/gtest.h>
#include <locale.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/theme.h"
#include "results_schema/study.h"

namespace {

/// Tests of a suite share a process: each begins with empty settings, the light theme and English.
class FreshApplication final : public testing::EmptyTestEventListener {
 public:
  explicit FreshApplication(QApplication& application) : application_(application) {}

  void OnTestStart(const testing::TestInfo&) override {
    // Some tests put their settings elsewhere.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    QSettings{}.clear();
    // It styles every window anew, those that tests share too.
    if (asperity::theme().dark || application_.styleSheet().isEmpty()) {
      asperity::apply_theme(application_, asperity::ThemeChoice::light);
    }
    asperity::apply_language("en");
  }

 private:
  QApplication& application_;
  // Settings of the person who runs the tests are neither read nor written, nor are those of a test
  // that runs at the same time.
  const QTemporaryDir settings_{};
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  setlocale(LC_NUMERIC, "C");
  QApplication::setOrganizationName("asperity");
  QApplication::setApplicationName("asperity-tests");
  asperity::Study::read_beside_writers();  // as the program with its windows does
  testing::UnitTest::GetInstance()->listeners().Append(new FreshApplication(application));
  return RUN_ALL_TESTS();
}
