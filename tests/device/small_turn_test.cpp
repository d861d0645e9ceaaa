// The turn from one orientation to the next, against rotations whose axis and angle are known.

#include "device/small_turn.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SmallTurn, IsTheVectorThatTurnsOneIntoTheOther) {
  const glm::dquat from = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1.0, 2.0, -1.0)));
  for (const double angle_rad : {1e-13, 1e-6, 0.3, 3.0}) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, -1.0, 0.5));
    const glm::dquat to = glm::angleAxis(angle_rad, axis) * from;
    EXPECT_NEAR(glm::distance(small_turn_rad(from, to), angle_rad * axis), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(small_turn_rad(from, -to), angle_rad * axis), 0.0, 1e-12);
  }
  EXPECT_EQ(small_turn_rad(from, from), glm::dvec3(0.0));
}

}  // namespace
}  // namespace asperity
