// A home folder and settings of their own around a test of windows.

#pragma once

#include <filesystem>
#include <functional>

#include <QtCore/QTemporaryDir>
#include <gtest/gtest.h>

class QWidget;

namespace asperity {

class QuietHome : public testing::Test {
 protected:
  QuietHome();
  ~QuietHome() override;

  /// Removed after the test.
  std::filesystem::path home() const { return folder_.path().toStdString(); }

  /// The files of the demo study, but with stimuli of 64 × 64 pixels, which are quick.
  std::filesystem::path small_demo_study() const;

 private:
  QTemporaryDir folder_{};
  QByteArray former_home_{};
};

/// Waits, with events going on, until it holds; false after 20 s.
bool eventually(const std::function<bool()>& condition);

/// The child of that object name; fails the test where there is none.
template <class Widget>
Widget& child(QWidget& parent, const char* name);

}  // namespace asperity

#include <QtWidgets/QWidget>

template <class Widget>
Widget& asperity::child(QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(name);
  if (found == nullptr) throw std::runtime_error(std::string("no widget ") + name);
  return *found;
}
