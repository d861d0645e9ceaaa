// The evaluation on a compute device against the plain one in double precision.

#include "renderers/pd_gradient/gpu/gpu_penetration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {
namespace {

using namespace std::chrono_literals;

constexpr double kGpuWindow_m = ContactsByChance::kWindow_m;
constexpr int kGpuSamples = 64;
constexpr std::chrono::nanoseconds kLong = 60s;

const SamplingGrid kGpuGrid{.width_m = kGpuWindow_m, .samples = kGpuSamples};

ComputeDevice any_device() {
  const std::vector<ComputeDevice> devices = ComputeDevice::all();
  if (devices.empty()) throw std::runtime_error("There is no OpenCL driver with double precision.");
  return devices.front();
}

GpuContact contact_of(const ChanceContact& chance, const MaximumLaw& law) {
  return {.grid = kGpuGrid,
          .law = law,
          .pose_a = chance.pose_a,
          .pose_b = chance.pose_b,
          .triangles_a = chance.triangles_a,
          .triangles_b = chance.triangles_b};
}

GpuPenetration gpu_for(const ChanceContact& chance) {
  return GpuPenetration(
      any_device(), chance.mesh_a, 1.0, chance.mesh_b, 1.0,
      {.contacts = 1, .samples = kGpuSamples, .triangles = 1000, .is_smooth = true});
}

std::optional<Penetration> answer(GpuPenetration& gpu, const ChanceContact& chance,
                                  const MaximumLaw& law) {
  const GpuContact contact = contact_of(chance, law);
  std::optional<Penetration> found;
  EXPECT_EQ(gpu.evaluate({&contact, 1}, {&found, 1}, kLong), GpuOutcome::answered);
  return found;
}

std::optional<Penetration> answer(const ChanceContact& chance, const MaximumLaw& law) {
  GpuPenetration gpu = gpu_for(chance);
  return answer(gpu, chance, law);
}

void press_in(ChanceContact& contact) {
  const auto found =
      reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, HardMaximum{.step_m = 1e-4});
  contact.pose_a.position_m.z -= 0.1e-3 - found->depth_m;
}

void expect_equal(const Penetration& found, const Penetration& expected, double depth_m = 1e-15) {
  EXPECT_NEAR(found.depth_m, expected.depth_m, depth_m);
  EXPECT_NEAR(found.slope.x, expected.slope.x, 1e-10);
  EXPECT_NEAR(found.slope.y, expected.slope.y, 1e-10);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found.lever_m[axis], expected.lever_m[axis], 1e-12);
    EXPECT_NEAR(found.deepest_m[axis], expected.deepest_m[axis], 1e-15);
  }
  EXPECT_EQ(found.covered, expected.covered);
  EXPECT_EQ(found.folded, expected.folded);
}

TEST(GpuPenetration, EqualsTheReferenceForTheHardMaximum) {
  ContactsByChance chance(21);
  const HardMaximum law{.step_m = kGpuWindow_m / kGpuSamples};
  for (const ContactKind kind : kContactKinds) {
    ChanceContact contact = chance.draw(kind);
    if (kind == ContactKind::overlapping) contact.pose_a.position_m.x += 0.7 * kGpuWindow_m;
    press_in(contact);
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
    const auto found = answer(contact, law);
    ASSERT_TRUE(expected && found);
    expect_equal(*found, *expected);
    EXPECT_EQ(found->at_border, expected->at_border);
    EXPECT_EQ(found->at_window, expected->at_window);
  }
}

TEST(GpuPenetration, EqualsTheReferenceForTheSmoothMaximum) {
  ContactsByChance chance(22);
  const SmoothMaximum law{.tau_m = 20e-6};
  for (const ContactKind kind : kContactKinds) {
    ChanceContact contact = chance.draw(kind);
    press_in(contact);
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
    const auto found = answer(contact, law);
    ASSERT_TRUE(expected && found);
    expect_equal(*found, *expected, 1e-14);
  }
}

// Two plates without texture, A upside down: everywhere equally deep.
ChanceContact flat_plates(double width_of_a_m, const glm::dvec3& place_m) {
  ChanceContact contact;
  const auto flat = [](double, double) { return 0.0; };
  contact.mesh_a = formed_plate({.size_m = {width_of_a_m, 1.5 * kGpuWindow_m}}, flat);
  contact.mesh_b = formed_plate({.size_m = glm::dvec2(1.5 * kGpuWindow_m)}, flat);
  contact.triangles_a = all_triangles(contact.mesh_a);
  contact.triangles_b = all_triangles(contact.mesh_b);
  contact.pose_a = upside_down(place_m);
  return contact;
}

TEST(GpuPenetration, TakesTheFirstOfEquallyDeepSamples) {
  const ChanceContact contact = flat_plates(1.5 * kGpuWindow_m, {0.0, 0.0, -0.1e-3});
  const HardMaximum law{.step_m = kGpuWindow_m / kGpuSamples};
  const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
  const auto found = answer(contact, law);
  ASSERT_TRUE(expected && found);
  expect_equal(*found, *expected);
}

// A covers the last column of samples only: moved forth it is outside the window.
TEST(GpuPenetration, TakesAOneSidedDifferenceWhereAConfigurationHasNoOverlap) {
  const double cell_m = kGpuWindow_m / kGpuSamples;
  const ChanceContact contact =
      flat_plates(0.5 * cell_m, {kGpuGrid.place_m(kGpuSamples - 1), 0.0, -0.1e-3});
  const HardMaximum law{.step_m = cell_m};
  const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
  const auto found = answer(contact, law);
  ASSERT_TRUE(expected && found);
  EXPECT_EQ(expected->covered, kGpuSamples);
  expect_equal(*found, *expected);
}

// The top of a roof is at the border of two tiles of the window: moved, it is in the other one, at its edge.
TEST(GpuPenetration, FindsTheTopOfARoofInEveryTile) {
  const double cell_m = kGpuWindow_m / kGpuSamples;
  const HardMaximum law{.step_m = 2.0 * cell_m};
  ChanceContact contact = flat_plates(kGpuWindow_m, {});
  contact.mesh_a = formed_plate(
      {.size_m = glm::dvec2(1.5 * kGpuWindow_m), .cells = {2, 2}},
      [](double x_m, double y_m) { return -0.5 * std::abs(x_m) - 0.4 * std::abs(y_m); });
  contact.triangles_a = all_triangles(contact.mesh_a);
  GpuPenetration gpu = gpu_for(contact);
  for (int along = -6; along <= 6; ++along) {
    contact.pose_a = upside_down({(0.3 + 0.5 * along) * cell_m, 0.4 * along * cell_m, -0.1e-3});
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
    const auto found = answer(gpu, contact, law);
    ASSERT_TRUE(expected && found);
    expect_equal(*found, *expected);
  }
}

// B stands twice, the second time half a millimetre lower.
TEST(GpuPenetration, TakesTheOutermostSheetAndCountsTheFold) {
  const HardMaximum law{.step_m = kGpuWindow_m / kGpuSamples};
  for (const bool lower_first : {true, false}) {
    ChanceContact contact = ContactsByChance(26).draw(ContactKind::flat);
    TexturedMesh& mesh = contact.mesh_b;
    const auto count = static_cast<std::uint32_t>(mesh.vertices_m.size());
    const auto triangles = mesh.triangles;
    const auto places = mesh.places;
    for (std::uint32_t i = 0; i < count; ++i) {
      mesh.vertices_m.push_back(mesh.vertices_m[i] - glm::dvec3{0.0, 0.0, 0.5e-3});
      mesh.normals.push_back(glm::dvec3(mesh.normals[i]));
    }
    for (const auto& [a, b, c] : triangles) {
      mesh.triangles.push_back({a + count, b + count, c + count});
    }
    mesh.places.insert(mesh.places.end(), places.begin(), places.end());
    contact.triangles_b = all_triangles(mesh);
    if (lower_first) std::reverse(contact.triangles_b.begin(), contact.triangles_b.end());
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, kGpuGrid, law);
    const auto found = answer(contact, law);
    ASSERT_TRUE(expected && found);
    EXPECT_GT(expected->folded, 0);
    expect_equal(*found, *expected);
  }
}

// The sides of a ridge sink; the reference has no such faces, the sampler of the processor has.
TEST(GpuPenetration, LowersLeaningFacesAsTheSamplerDoes) {
  ContactsByChance chance(27);
  ChanceContact contact = chance.draw(ContactKind::ridge);
  press_in(contact);
  const HardMaximum law{.step_m = kGpuWindow_m / kGpuSamples};
  GpuPenetration gpu(any_device(), contact.mesh_a, 1.0, contact.mesh_b, 1.0,
                     {.contacts = 1, .samples = kGpuSamples, .triangles = 1000});
  GpuContact asked = contact_of(contact, law);
  asked.leaning_a = 0.999;
  asked.leaning_b = 0.9999;
  std::optional<Penetration> found;
  ASSERT_EQ(gpu.evaluate({&asked, 1}, {&found, 1}, kLong), GpuOutcome::answered);
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  PenetrationSampler sampler({.grid = kGpuGrid,
                              .law = law,
                              .most_triangles = 1000,
                              .instructions = instruction_sets_here().back()});
  const auto expected = sampler.evaluate({.surface = a,
                                          .triangles = contact.triangles_a,
                                          .pose = contact.pose_a,
                                          .leaning_cosine = asked.leaning_a},
                                         {.surface = b,
                                          .triangles = contact.triangles_b,
                                          .pose = contact.pose_b,
                                          .leaning_cosine = asked.leaning_b},
                                         {});
  const auto upright = answer(contact, law);
  ASSERT_TRUE(found && expected && upright);
  EXPECT_LT(found->depth_m, upright->depth_m - 1e-6);
  EXPECT_NEAR(found->depth_m, expected->depth_m, 10e-9);
}

TEST(GpuPenetration, RefusesMoreThanThereIsRoomForAndKeepsTheAnswers) {
  const ChanceContact chance = ContactsByChance(23).draw(ContactKind::flat);
  const HardMaximum law{.step_m = kGpuWindow_m / kGpuSamples};
  GpuPenetration gpu(any_device(), chance.mesh_a, 1.0, chance.mesh_b, 1.0,
                     {.contacts = 1, .samples = kGpuSamples, .triangles = 200});
  const GpuContact fits = contact_of(chance, law);
  std::vector<GpuContact> two(2, fits);
  std::vector<std::optional<Penetration>> answers(2, Penetration{.depth_m = 7.0});
  EXPECT_EQ(gpu.evaluate(two, answers, kLong), GpuOutcome::too_much);
  GpuContact wide = fits;
  wide.grid = {.width_m = 2.0 * kGpuWindow_m, .samples = 2 * kGpuSamples};
  EXPECT_EQ(gpu.evaluate({&wide, 1}, answers, kLong), GpuOutcome::too_much);
  GpuContact smooth = fits;
  smooth.law = SmoothMaximum{.tau_m = 20e-6};
  EXPECT_EQ(gpu.evaluate({&smooth, 1}, answers, kLong), GpuOutcome::too_much);
  EXPECT_EQ(answers[0]->depth_m, 7.0);
  EXPECT_EQ(gpu.evaluate({&fits, 1}, answers, kLong), GpuOutcome::answered);
  EXPECT_NE(answers[0]->depth_m, 7.0);
}

TEST(GpuPenetration, FindsNothingWhereSurfacesDoNotOverlap) {
  ChanceContact chance = ContactsByChance(24).draw(ContactKind::flat);
  chance.pose_a.position_m.x += 3.0 * kGpuWindow_m;
  EXPECT_FALSE(answer(chance, HardMaximum{.step_m = kGpuWindow_m / kGpuSamples}));
}

TEST(GpuPenetration, RefusesRoomThatIsNotWholeTiles) {
  const ChanceContact chance = ContactsByChance(25).draw(ContactKind::flat);
  EXPECT_THROW(GpuPenetration(any_device(), chance.mesh_a, 1.0, chance.mesh_b, 1.0,
                              {.contacts = 1, .samples = 40, .triangles = 200}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
