// A small study with one protocol, which a test changes and checks.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/tasks/check_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

/// The study and the protocol are made by the constructor of the test.
class ProtocolInStudy : public testing::Test {
 protected:
  explicit ProtocolInStudy(const std::string& file_name)
      : protocol_(study_ / "protocols" / file_name) {}

  void replace_in_protocol(const std::string& from, const std::string& to) {
    std::string text = read_file(protocol_);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_file(protocol_, text.replace(at, from.size(), to), Overwrite::allow);
  }
  std::vector<Diagnostic> problems() const {
    return check_protocol(protocol_, models_, study_, {}).diagnostics;
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_.path() / "study";
  std::filesystem::path protocol_{};
  ModelRegistry models_ = built_in_models();
};

}  // namespace asperity
