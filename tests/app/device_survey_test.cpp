// What else than devices a look finds wanting.

#include "app/device_bench/device_survey.h"

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(UdevRule, IsMissedWhereNoFolderOfUdevsHasIt) {
  const TemporaryFolder folder{};
  const std::filesystem::path empty = folder.path() / "empty";
  const std::filesystem::path rules = folder.path() / "rules.d";
  std::filesystem::create_directories(empty);
  std::filesystem::create_directories(rules);
  const std::string missed = missing_udev_rule({empty, folder.path() / "none", rules}).english();
  for (const char* said :
       {"The udev rules file 70-asperity.rules is not installed", "only root can open USB devices",
        "Copy " ASPERITY_SOURCE_DIR
        "/device/udev/70-asperity.rules into /etc/udev/rules.d, then"}) {
    EXPECT_NE(missed.find(said), std::string::npos) << missed;
  }
  write_file(rules / "70-asperity.rules", "", Overwrite::allow);
  EXPECT_TRUE(missing_udev_rule({empty, folder.path() / "none", rules}).empty());
}

}  // namespace
}  // namespace asperity
