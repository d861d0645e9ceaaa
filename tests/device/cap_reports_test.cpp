// The reports of a SpaceMouse, byte for byte.

#include "device/spacemouse/cap_reports.h"

#include <initializer_list>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/support/allocation_guard.h"

namespace asperity::spacemouse {
namespace {

using Told = CapReader::Told;

Told give(CapReader& reader, std::initializer_list<int> bytes) {
  std::vector<std::uint8_t> report;
  for (const int byte : bytes) report.push_back(static_cast<std::uint8_t>(byte));
  return reader.take(report);
}

// 350 is 0x015e, −350 0xfea2, 175 0x00af, −70 0xffba, 35 0x0023, −7 0xfff9.

TEST(CapReports, TellThePushInTheHandsFrame) {
  CapReader reader;
  // Half to the right, fully towards the hand, a fifth up: the device counts towards the hand and down.
  EXPECT_EQ(give(reader, {1, 0xaf, 0x00, 0x5e, 0x01, 0xba, 0xff}), Told::motion);
  EXPECT_EQ(reader.cap().push, glm::dvec3(0.5, -1.0, 0.2));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(0.0));
}

TEST(CapReports, TellTheTurnAboutTheSameAxes) {
  CapReader reader;
  EXPECT_EQ(give(reader, {2, 0xa2, 0xfe, 0xf9, 0xff, 0x23, 0x00}), Told::motion);
  EXPECT_EQ(reader.cap().turn, glm::dvec3(-1.0, 0.02, -0.1));
  EXPECT_EQ(reader.cap().push, glm::dvec3(0.0));
}

// A turn is about the axis that a push goes along, by the right-hand rule, in the device's frame and in ours: what turns
// the device's axes into ours has to be a rotation. Its columns are our axes of three unit pushes.
TEST(CapReports, TurnTheDevicesAxesAndMirrorNothing) {
  CapReader reader;
  const auto push = [&](std::initializer_list<int> bytes) {
    give(reader, bytes);
    return reader.cap().push;
  };
  const glm::dvec3 x = push({1, 0x5e, 0x01, 0, 0, 0, 0});
  const glm::dvec3 y = push({1, 0, 0, 0x5e, 0x01, 0, 0});
  const glm::dvec3 z = push({1, 0, 0, 0, 0, 0x5e, 0x01});
  EXPECT_EQ(glm::cross(x, y), z);
  give(reader, {2, 0, 0, 0x5e, 0x01, 0, 0});
  EXPECT_EQ(reader.cap().turn, y);
}

TEST(CapReports, TellBothAtOnceInNewerModels) {
  CapReader reader;
  EXPECT_EQ(give(reader, {1, 0x5e, 0x01, 0xaf, 0x00, 0, 0, 0xba, 0xff, 0xa2, 0xfe, 0x23, 0x00}),
            Told::motion);
  EXPECT_EQ(reader.cap().push, glm::dvec3(1.0, -0.5, 0.0));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(-0.2, 1.0, -0.1));
}

TEST(CapReports, KeepWhatTheyDoNotTell) {
  CapReader reader;
  give(reader, {1, 0x5e, 0x01, 0, 0, 0, 0});
  give(reader, {2, 0, 0, 0, 0, 0xa2, 0xfe});
  give(reader, {3, 1, 0});
  EXPECT_EQ(reader.cap().push, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(0.0, 0.0, 1.0));
  EXPECT_EQ(reader.cap().buttons, 1U);
  give(reader, {1, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(reader.cap().push, glm::dvec3(0.0));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(0.0, 0.0, 1.0));
}

TEST(CapReports, CountMoreThanFullAsFull) {
  CapReader reader;
  // 500, −32768, 32767.
  give(reader, {1, 0xf4, 0x01, 0x00, 0x80, 0xff, 0x7f});
  EXPECT_EQ(reader.cap().push, glm::dvec3(1.0, 1.0, -1.0));
}

TEST(CapReports, TellButtonsOfTwoOrOfThirtyTwo) {
  CapReader reader;
  EXPECT_EQ(give(reader, {3, 0x03, 0x00}), Told::buttons);
  EXPECT_EQ(reader.cap().buttons, 0b11U);
  EXPECT_EQ(give(reader, {3, 0x00, 0x10, 0xc0, 0x03, 0xff, 0xff}), Told::buttons);
  EXPECT_EQ(reader.cap().buttons, 0x03c01000U);
  EXPECT_EQ(give(reader, {3, 0x00, 0x00}), Told::buttons);
  EXPECT_EQ(reader.cap().buttons, 0U);
}

TEST(CapReports, ChangeNothingWhenTheyAreCutShort) {
  CapReader reader;
  give(reader, {1, 0x5e, 0x01, 0, 0, 0, 0});
  give(reader, {3, 1, 0});
  const std::vector<std::uint8_t> both{1, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7};
  std::uint64_t refused = 0;
  for (std::size_t size = 1; size <= both.size(); ++size) {
    if (size == 7 || size == 13) continue;
    EXPECT_EQ(reader.take({both.data(), size}), Told::nothing) << size;
    EXPECT_EQ(reader.malformed(), ++refused) << size;
  }
  EXPECT_EQ(give(reader, {2, 7, 7, 7, 7, 7}), Told::nothing);
  EXPECT_EQ(give(reader, {3}), Told::nothing);
  EXPECT_EQ(reader.malformed(), refused + 2);
  EXPECT_EQ(reader.cap().push, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(0.0));
  EXPECT_EQ(reader.cap().buttons, 1U);
}

// Its first half alone would leave the turn of before.
TEST(CapReports, AreNoHalvesOnceBothCameInOne) {
  CapReader reader;
  give(reader, {1, 0x5e, 0x01, 0, 0, 0, 0, 0x5e, 0x01, 0, 0, 0, 0});
  EXPECT_EQ(give(reader, {1, 0, 0, 0, 0, 0, 0}), Told::nothing);
  EXPECT_EQ(give(reader, {2, 0, 0, 0, 0, 0, 0}), Told::nothing);
  EXPECT_EQ(reader.malformed(), 2U);
  EXPECT_EQ(reader.cap().push.x, 1.0);
  reader.reset();
  EXPECT_EQ(reader.cap().push, glm::dvec3(0.0));
  EXPECT_EQ(reader.cap().turn, glm::dvec3(0.0));
  EXPECT_EQ(give(reader, {1, 0x5e, 0x01, 0, 0, 0, 0}), Told::motion);
}

TEST(CapReports, ArePassedOverWhereTheyTellOfSomethingElse) {
  CapReader reader;
  EXPECT_EQ(give(reader, {0x17, 0x64, 0x01}), Told::nothing);  // the battery
  EXPECT_EQ(give(reader, {}), Told::nothing);
  EXPECT_EQ(reader.malformed(), 0U);
}

TEST(CapReports, AreReadWithoutTouchingTheHeap) {
  CapReader reader;
  const std::vector<std::uint8_t> both(13, 1);
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) reader.take(both);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity::spacemouse
