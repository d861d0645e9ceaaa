// A home folder and settings of their own around a test of windows.

#pragma once

#include <filesystem>

#include <QtCore/QTemporaryDir>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"

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

}  // namespace asperity
