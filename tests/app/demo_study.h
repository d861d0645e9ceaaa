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
    new_demo_study(study_folder(), [](double) {});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::filesystem::path study_folder() { return folder_->path() / "study"; }

  const std::filesystem::path study = study_folder();

 private:
  static inline std::unique_ptr<TemporaryFolder> folder_{};
};

}  // namespace asperity
