// Makes confusions out of known similarities and biases, and takes them apart again.

#include "analysis/choices/similarity_choice.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SimilarityChoice, RecoversWhatMadeTheConfusions) {
  Eigen::Matrix3d similarity;
  similarity << 1, 0.5, 0.2,  //
      0.5, 1, 0.1,            //
      0.2, 0.1, 1;
  const Eigen::Vector3d bias(0.5, 0.3, 0.2);
  ConfusionCounts counts = similarity * bias.asDiagonal();
  counts.array().colwise() *= Eigen::Array3d(60, 90, 30) / counts.rowwise().sum().array();
  const SimilarityChoice model = similarity_choice(counts);
  ASSERT_TRUE(model.parameters);
  EXPECT_NEAR((model.parameters->similarity - similarity).norm(), 0.0, 1e-9);
  EXPECT_NEAR((model.parameters->bias - bias).norm(), 0.0, 1e-9);
  EXPECT_NEAR(model.G2, 0.0, 1e-9);
  EXPECT_EQ(model.df, 1.0);
  EXPECT_EQ(model.added, 0.0);
}

TEST(SimilarityChoice, AddsHalfWhereAPairWasNeverConfused) {
  ConfusionCounts counts(3, 3);
  counts << 9, 1, 0, 2, 9, 1, 0, 1, 9;
  EXPECT_EQ(similarity_choice(counts).added, 0.5);
}

// Nothing but one answer moves in a circle of three; here it cannot move either way, so the
// likeliest table has the empty cells of the observed one.
TEST(SimilarityChoice, HasNoParametersAtTheEdgeOfTheModel) {
  ConfusionCounts counts(3, 3);
  counts << 9, 0, 0, 3, 9, 2, 3, 0, 9;
  const SimilarityChoice model = similarity_choice(counts);
  EXPECT_EQ(model.added, 0.0);
  EXPECT_FALSE(model.parameters);
}

}  // namespace
}  // namespace asperity
