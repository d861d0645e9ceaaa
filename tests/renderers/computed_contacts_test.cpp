// The contacts of two bodies, evaluated on a compute device.

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

constexpr double kTickOfTest_s = 0.001;
constexpr double kRadiusOfTwoBalls_m = 1e-3;
const WindowSampling kSamplingOf64{
    .law = HardMaximum{.step_m = 0.1e-3}, .cell_m = 0.1e-3, .most_samples = 64};
const Grating kWave{.amplitude_m = 0.05e-3, .wavelength_m = 2e-3};

// A grated plate, and two balls on it that belong to one tool: two contacts.
class BallsOnAPlate : public testing::Test {
 protected:
  static TexturedMesh two_balls() {
    TexturedMesh pair =
        shifted(bare(ball(kRadiusOfTwoBalls_m, 24, 12)), {-3e-3, 0.0, kRadiusOfTwoBalls_m});
    const TexturedMesh other =
        shifted(bare(ball(kRadiusOfTwoBalls_m, 24, 12)), {3e-3, 0.0, kRadiusOfTwoBalls_m});
    const auto count = static_cast<std::uint32_t>(pair.vertices_m.size());
    pair.vertices_m.insert(pair.vertices_m.end(), other.vertices_m.begin(), other.vertices_m.end());
    pair.normals.insert(pair.normals.end(), other.normals.begin(), other.normals.end());
    pair.places.insert(pair.places.end(), other.places.begin(), other.places.end());
    for (const auto& [a, b, c] : other.triangles) {
      pair.triangles.push_back({a + count, b + count, c + count});
    }
    return pair;
  }

  std::unique_ptr<TexturedContacts> contacts(std::chrono::nanoseconds deadline) const {
    const GpuRoom room{.contacts = TexturedContacts::kMostComputed, .samples = 64};
    return std::make_unique<TexturedContacts>(
        TexturedBody(balls_, 1.0), TexturedBody(plate_, 1.0), kSamplingOf64,
        instruction_sets_here().back(),
        std::make_unique<ComputedContacts>(*first_compute(deadline), balls_, 1.0, plate_, 1.0,
                                           room));
  }

  std::unique_ptr<TexturedContacts> contacts_here() const {
    return std::make_unique<TexturedContacts>(TexturedBody(balls_, 1.0), TexturedBody(plate_, 1.0),
                                              kSamplingOf64, instruction_sets_here().back());
  }

  static Pose at(int tick) { return pose_at({0.2e-3 + tick * 0.05e-3, 0.1e-3, -0.1e-3}); }

  const TexturedMesh balls_ = two_balls();
  const TexturedMesh plate_ = grated_plate(kWave);
};

TEST_F(BallsOnAPlate, HaveTheDepthsAndGradientsOfTheReference) {
  const auto computed = contacts(std::chrono::minutes(10));
  for (int tick = 0; tick < 3; ++tick) {
    const auto found = computed->find(at(tick), {}, kTickOfTest_s);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(computed->left_out().is_computed_here);
    for (const TexturedContact& contact : found) {
      const std::vector<std::uint32_t> all_a = all_triangles(balls_);
      const std::vector<std::uint32_t> all_b = all_triangles(plate_);
      const auto expected = reference_penetration(
          {.mesh = balls_, .triangles = all_a, .pose = at(tick)},
          {.mesh = plate_, .triangles = all_b}, contact.frame, contact.grid, kSamplingOf64.law);
      ASSERT_TRUE(expected);
      EXPECT_NEAR(contact.sampled_depth_m, expected->depth_m, 1e-12);
      EXPECT_NEAR(contact.penetration.slope.x, expected->slope.x, 1e-8);
      EXPECT_NEAR(contact.penetration.slope.y, expected->slope.y, 1e-8);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(contact.penetration.lever_m[axis], expected->lever_m[axis], 1e-10);
      }
    }
  }
}

TEST_F(BallsOnAPlate, AreTheSameInEveryBitFromRunToRun) {
  const auto run = [this] {
    std::vector<double> values;
    const auto computed = contacts(std::chrono::minutes(10));
    for (int tick = 0; tick < 2; ++tick) {
      for (const TexturedContact& contact : computed->find(at(tick), {}, kTickOfTest_s)) {
        const Penetration& p = contact.penetration;
        values.insert(values.end(),
                      {p.depth_m, p.slope.x, p.slope.y, p.lever_m.x, p.lever_m.y, p.lever_m.z});
      }
    }
    return values;
  };
  const std::vector<double> first = run();
  ASSERT_EQ(first.size(), 24U);
  EXPECT_EQ(first, run());
}

TEST_F(BallsOnAPlate, AreEvaluatedByTheProcessorWithoutAnAnswerInTime) {
  const auto late = contacts(std::chrono::nanoseconds(0));
  const auto here = contacts_here();
  int computed_here = 0;
  // On a busy machine an answer may be there before it is waited for.
  for (int tick = 0; tick < 100 && computed_here < 3; ++tick) {
    const auto found = late->find(at(tick % 3), {}, kTickOfTest_s);
    const auto expected = here->find(at(tick % 3), {}, kTickOfTest_s);
    if (!late->left_out().is_computed_here) continue;
    ++computed_here;
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].penetration.depth_m, expected[i].penetration.depth_m);
      EXPECT_EQ(found[i].penetration.slope, expected[i].penetration.slope);
      EXPECT_EQ(found[i].penetration.lever_m, expected[i].penetration.lever_m);
    }
  }
  EXPECT_EQ(computed_here, 3);
}

}  // namespace
}  // namespace asperity
