#include "tests/gui/study/quiet_home.h"

#include <QtCore/QSettings>
#include <QtTest/QTest>

#include "app/tasks/new_study.h"

namespace asperity {

QuietHome::QuietHome() : former_home_(qgetenv("HOME")) {
  qputenv("HOME", folder_.path().toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path() + "/settings");
  QSettings{}.clear();
}

QuietHome::~QuietHome() { qputenv("HOME", former_home_); }

std::filesystem::path QuietHome::demo_study() const {
  static QTemporaryDir once{};
  const std::filesystem::path made = std::filesystem::path(once.path().toStdString()) / "demo";
  if (!std::filesystem::exists(made)) new_demo_study(made, [](double) {});
  const std::filesystem::path copy = home() / "studies" / "demo";
  std::filesystem::create_directories(copy.parent_path());
  std::filesystem::copy(made, copy, std::filesystem::copy_options::recursive);
  return copy;
}

bool eventually(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 20000);
}

}  // namespace asperity
