// A deletion of a participant's data that is interrupted at every write, sync and truncation of the database.

#include <gtest/gtest.h>

#include "tests/results_schema/interrupted_deletion.h"

namespace asperity {
namespace {

class EveryStepOfADeletion : public InterruptedDeletion {};

TEST_F(EveryStepOfADeletion, CanBeFollowedByADeath) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::killed, 1, 1), 100);
}

TEST_F(EveryStepOfADeletion, CanMeetABrokenDisk) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::broken_disk, 1, 1), 100);
}

TEST_F(EveryStepOfADeletion, CanMeetAFullDisk) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::disk_full, 1, 1), 100);
}

}  // namespace
}  // namespace asperity
