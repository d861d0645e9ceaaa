// The demo study, made once for all tests that begin with it.

#pragma once

#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "app/tasks/new_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

/// Its tests leave the stimuli as they are.
class DemoStudy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    new_demo_study(folder_->path() / "study", [](double) {});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  const std::filesystem::path study = folder_->path() / "study";

 private:
  static inline std::unique_ptr<TemporaryFolder> folder_{};
};

}  // namespace asperity
