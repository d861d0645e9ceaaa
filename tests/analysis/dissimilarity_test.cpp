// Holds maps to the plane they came from, and trees to distances that a hand can follow.

#include "analysis/dissimilarity/dissimilarity.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

Dissimilarities four_items() {
  Dissimilarities d(4, 4);
  d << 0, 1, 4, 6,  //
      1, 0, 5, 7,   //
      4, 5, 0, 2,   //
      6, 7, 2, 0;
  return d;
}

TEST(ClassicalScaling, GivesBackTheDistancesOfAPlane) {
  Eigen::MatrixXd corners(4, 2);
  corners << 0, 0, 3, 0, 3, 1, 0, 1;
  Dissimilarities d(4, 4);
  for (Eigen::Index i = 0; i < 4; ++i) {
    d.col(i) = (corners.rowwise() - corners.row(i)).rowwise().norm();
  }
  const ClassicalScaling map = classical_scaling(d);
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      EXPECT_NEAR((map.points.row(i) - map.points.row(j)).norm(), d(i, j), 1e-12);
    }
  }
  EXPECT_NEAR(map.eigenvalues(0), 9.0, 1e-12);  // Σx² about the centre
  EXPECT_NEAR(*map.fit_of_absolute, 1.0, 1e-12);
  EXPECT_TRUE(map.plane_is_unique);
}

// All alike: a simplex, of which two dimensions show two thirds, and no two in particular.
TEST(ClassicalScaling, SaysThatEqualDistancesHaveNoPlane) {
  const Dissimilarities d = Dissimilarities::Ones(4, 4) - Dissimilarities::Identity(4, 4);
  const ClassicalScaling map = classical_scaling(d);
  EXPECT_NEAR(*map.fit_of_positive, 2.0 / 3.0, 1e-12);
  EXPECT_FALSE(map.plane_is_unique);
}

// {1,2} join at 1, {3,4} at 2; between them stand 4, 5, 6 and 7.
TEST(Tree, JoinsAtTheMeanTheGreatestOrTheLeastDistance) {
  const struct {
    Linkage linkage;
    double last;
  } kLasts[] = {{Linkage::average, 5.5}, {Linkage::complete, 7.0}, {Linkage::single, 4.0}};
  for (const auto& [linkage, last] : kLasts) {
    const Tree tree = agglomerate(four_items(), linkage);
    EXPECT_EQ(tree.joins[0].height, 1.0);
    EXPECT_EQ(tree.joins[1].height, 2.0);
    EXPECT_EQ(tree.joins[2].height, last);
    EXPECT_EQ(tree.cophenetic(0, 3), last);
    EXPECT_EQ(tree.cophenetic(2, 3), 2.0);
  }
}

TEST(Tree, JoinsTheLowestOfEquallyNearPairs) {
  const Dissimilarities d = Dissimilarities::Ones(3, 3) - Dissimilarities::Identity(3, 3);
  const Tree tree = agglomerate(d, Linkage::average);
  EXPECT_EQ(tree.joins[0].first, 0U);
  EXPECT_EQ(tree.joins[0].second, 1U);
  EXPECT_FALSE(tree.cophenetic_correlation) << "equal distances correlate with nothing";
}

TEST(Dissimilarities, RefuseWhatIsNoDistance) {
  Dissimilarities lopsided = four_items();
  lopsided(0, 1) = 2.0;
  EXPECT_THROW(classical_scaling(lopsided), std::invalid_argument);
  EXPECT_THROW(agglomerate(-four_items(), Linkage::single), std::invalid_argument);
}

// Confused more often than recognised: nearer than itself, which no distance is.
TEST(Dissimilarities, AreZeroForWhatIsConfusedMoreOftenThanRecognised) {
  ConfusionCounts counts(2, 2);
  counts << 1, 9, 8, 2;
  EXPECT_EQ(shepard_dissimilarities(counts)(0, 1), 0.0);
}

}  // namespace
}  // namespace asperity
