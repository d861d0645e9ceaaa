// A deletion of a participant's data that is interrupted here and there; deletion_at_every_step_test.cpp has every place.

#include "tests/results_schema/interrupted_deletion.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr int kStep = 17;  // of some hundreds of operations

class SomeStepsOfADeletion : public InterruptedDeletion {};

TEST_F(SomeStepsOfADeletion, CanBeFollowedByADeath) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::killed, 5, kStep), 5);
}

TEST_F(SomeStepsOfADeletion, CanMeetABrokenDisk) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::broken_disk, 9, kStep), 5);
}

TEST_F(SomeStepsOfADeletion, CanMeetAFullDisk) {
  EXPECT_GT(interrupt_database(FailingVfs::Fault::disk_full, 13, kStep), 5);
}

TEST_F(SomeStepsOfADeletion, CanFindFilesThatCannotBeRemoved) {
  EXPECT_GE(interrupt_removal(RemovalFault::Kind::error), 5);
}

TEST_F(SomeStepsOfADeletion, CanBeKilledBeforeItRemovesAFile) {
  EXPECT_GE(interrupt_removal(RemovalFault::Kind::killed), 5);
}

}  // namespace
}  // namespace asperity
