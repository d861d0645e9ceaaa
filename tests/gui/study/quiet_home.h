// A home folder and settings of their own around a test of windows.

#pragma once

#include <filesystem>

#include <QtCore/QByteArray>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

class QuietHome : public testing::Test {
 protected:
  QuietHome();
  ~QuietHome() override;

  /// Removed after the test.
  std::filesystem::path home() const { return folder_.path(); }

  /// The files of the demo study, but with stimuli of 64 × 64 pixels, which are quick.
  std::filesystem::path small_demo_study() const;
  /// The same with participants (`fill_with_participants`).
  std::filesystem::path lively_study() const;

 private:
  std::filesystem::path copied(const std::filesystem::path& pattern) const;

  TemporaryFolder folder_{};
  QByteArray former_home_{};
};

}  // namespace asperity
