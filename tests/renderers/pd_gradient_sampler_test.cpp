// The fast evaluation of a contact against the plain one, and what it promises besides.

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kWindow_m = ContactsByChance::kWindow_m;
constexpr double kDepth_m = 0.1e-3;

HardMaximum step_of(int samples, int cells) { return {.step_m = cells * kWindow_m / samples}; }

SamplerSettings settings_for(int samples, const MaximumLaw& law, InstructionSet instructions) {
  return {.grid = {.width_m = kWindow_m, .samples = samples},
          .law = law,
          .most_triangles = 100,
          .instructions = instructions};
}

// The sampler's answer to a contact; the packed bodies last as long as the call.
std::optional<Penetration> answer(PenetrationSampler& sampler, const ChanceContact& contact,
                                  const ContactFrame& frame = {}) {
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  return sampler.evaluate({.surface = a, .triangles = contact.triangles_a, .pose = contact.pose_a},
                          {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b},
                          frame);
}

void press_in(ChanceContact& contact, const SamplingGrid& grid) {
  const auto found =
      reference_penetration(contact.a(), contact.b(), {}, grid, HardMaximum{.step_m = 1e-4});
  contact.pose_a.position_m.z -= kDepth_m - found->depth_m;
}

// Sums of squares of differences and of what they are relative to.
struct RelativeError {
  double difference = 0.0;
  double whole = 0.0;
  void add(double found, double expected) {
    difference += (found - expected) * (found - expected);
    whole += expected * expected;
  }
  double rms() const { return std::sqrt(difference / whole); }
};

TEST(PenetrationSampler, AgreesWithThePlainEvaluation) {
  ContactsByChance chance(11);
  for (const int step_cells : {1, 2}) {
    PenetrationSampler sampler(
        settings_for(64, step_of(64, step_cells), instruction_sets_here().back()));
    RelativeError tilts;
    RelativeError turn;
    for (const ContactKind kind : kContactKinds) {
      if (kind == ContactKind::overlapping) continue;  // what covers the border is the next test's
      ChanceContact contact = chance.draw(kind);
      press_in(contact, sampler.grid());
      const auto expected = reference_penetration(contact.a(), contact.b(), {}, sampler.grid(),
                                                  step_of(64, step_cells));
      const auto found = answer(sampler, contact);
      ASSERT_TRUE(expected && found);
      EXPECT_NEAR(found->depth_m, expected->depth_m, 10e-9);
      EXPECT_NEAR(found->slope.x, expected->slope.x, 1e-4);
      EXPECT_NEAR(found->slope.y, expected->slope.y, 1e-4);
      EXPECT_NEAR(found->deepest_m.x, expected->deepest_m.x, 1e-9);
      EXPECT_NEAR(found->deepest_m.y, expected->deepest_m.y, 1e-9);
      EXPECT_NEAR(found->deepest_m.z, expected->deepest_m.z, 10e-9);
      EXPECT_EQ(found->at_border, expected->at_border);
      EXPECT_EQ(found->at_window, expected->at_window);
      EXPECT_EQ(found->covered, expected->covered);
      EXPECT_EQ(found->folded, 0);
      tilts.add(found->lever_m.x, expected->lever_m.x);
      tilts.add(found->lever_m.y, expected->lever_m.y);
      turn.add(found->lever_m.z, expected->lever_m.z);
    }
    RecordProperty("tilts_" + std::to_string(step_cells), std::to_string(tilts.rms()));
    RecordProperty("turn_" + std::to_string(step_cells), std::to_string(turn.rms()));
    EXPECT_LT(tilts.rms(), 0.03);
    EXPECT_LT(turn.rms(), 0.2);
  }
}

// Half of the window has only one surface; nothing may come of what lies beside it.
TEST(PenetrationSampler, FindsNothingDeeperWhereASurfaceEnds) {
  ContactsByChance chance(12);
  PenetrationSampler sampler(settings_for(64, step_of(64, 1), instruction_sets_here().back()));
  for (int i = 0; i < 4; ++i) {
    ChanceContact contact = chance.draw(ContactKind::overlapping);
    contact.pose_a.position_m += glm::dvec3{0.7 * kWindow_m, 0.0, 0.0};
    press_in(contact, sampler.grid());
    const auto expected =
        reference_penetration(contact.a(), contact.b(), {}, sampler.grid(), step_of(64, 1));
    const auto found = answer(sampler, contact);
    ASSERT_TRUE(expected && found);
    ASSERT_LT(expected->covered, 64 * 64);
    EXPECT_NEAR(found->covered, expected->covered, 4);
    EXPECT_NEAR(found->depth_m, expected->depth_m, 10e-9);
    EXPECT_NEAR(found->slope.x, expected->slope.x, 1e-3);
    EXPECT_NEAR(found->slope.y, expected->slope.y, 1e-3);
    // No lever is longer than the window's half diagonal.
    EXPECT_LT(glm::length(found->lever_m), kWindow_m);
  }
}

// B stands twice, the second time half a millimetre lower.
TEST(PenetrationSampler, TakesTheOutermostSheetAndCountsTheFold) {
  ContactsByChance chance(17);
  const ChanceContact once = chance.draw(ContactKind::flat);
  PenetrationSampler sampler(settings_for(32, step_of(32, 1), instruction_sets_here().back()));
  const auto single = answer(sampler, once);
  for (const bool lower_first : {true, false}) {
    ChanceContact twice = once;
    TexturedMesh& mesh = twice.mesh_b;
    const auto count = static_cast<std::uint32_t>(mesh.vertices_m.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      mesh.vertices_m.push_back(mesh.vertices_m[i] - glm::dvec3{0.0, 0.0, 0.5e-3});
      mesh.normals.push_back(glm::dvec3(mesh.normals[i]));
    }
    for (const auto& [a, b, c] : once.mesh_b.triangles) {
      mesh.triangles.push_back({a + count, b + count, c + count});
    }
    const std::vector<std::array<glm::dvec2, 3>> places = mesh.places;
    mesh.places.insert(mesh.places.end(), places.begin(), places.end());
    twice.triangles_b = all_triangles(mesh);
    if (lower_first) std::reverse(twice.triangles_b.begin(), twice.triangles_b.end());
    const auto found = answer(sampler, twice);
    ASSERT_TRUE(single && found);
    EXPECT_EQ(found->depth_m, single->depth_m);
    EXPECT_EQ(found->lever_m, single->lever_m);
    EXPECT_EQ(single->folded, 0);
    EXPECT_EQ(found->folded, 32 * 32);
    const auto plain =
        reference_penetration(twice.a(), twice.b(), {}, sampler.grid(), step_of(32, 1));
    EXPECT_EQ(plain->folded, 32 * 32);
  }
}

TEST(PenetrationSampler, AgreesWithThePlainSmoothMaximum) {
  ContactsByChance chance(18);
  RelativeError slopes;
  RelativeError tilts;
  RelativeError turn;
  const SmoothMaximum law{.tau_m = 20e-6};
  PenetrationSampler sampler(settings_for(128, law, instruction_sets_here().back()));
  for (const ContactKind kind : kContactKinds) {
    ChanceContact contact = chance.draw(kind);
    press_in(contact, sampler.grid());
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, sampler.grid(), law);
    const auto found = answer(sampler, contact);
    ASSERT_TRUE(expected && found);
    EXPECT_NEAR(found->depth_m, expected->depth_m, 20e-9);
    EXPECT_NEAR(found->deepest_m.x, expected->deepest_m.x, 1e-9);
    EXPECT_NEAR(found->covered, expected->covered, 4);
    slopes.add(found->slope.x, expected->slope.x);
    slopes.add(found->slope.y, expected->slope.y);
    tilts.add(found->lever_m.x, expected->lever_m.x);
    tilts.add(found->lever_m.y, expected->lever_m.y);
    turn.add(found->lever_m.z, expected->lever_m.z);
  }
  RecordProperty("smooth_slopes", std::to_string(slopes.rms()));
  RecordProperty("smooth_tilts", std::to_string(tilts.rms()));
  RecordProperty("smooth_turn", std::to_string(turn.rms()));
  // The plain law takes the slope between the two texels around a sample, of which there are eight to the shortest
  // wave, the fast one that through five samples over two texels: 3.5 % are left of that in the means.
  EXPECT_LT(slopes.rms(), 0.045);
  EXPECT_LT(tilts.rms(), 0.01);
  EXPECT_LT(turn.rms(), 0.05);
}

// Plates without texture, one of them ending inside the window, with depths over several τ.
TEST(PenetrationSampler, WeighsPlatesAsThePlainSmoothMaximumDoes) {
  const SmoothMaximum law{.tau_m = 1e-3};
  PenetrationSampler sampler(settings_for(32, law, instruction_sets_here().back()));
  const auto flat = [](double, double) { return 0.0; };
  ChanceContact contact;
  contact.mesh_a = formed_plate({.size_m = {0.012, 0.012}}, flat);
  contact.mesh_b = formed_plate({.size_m = {0.020, 0.020}}, flat);
  contact.triangles_a = all_triangles(contact.mesh_a);
  contact.triangles_b = all_triangles(contact.mesh_b);
  for (const double tilt_rad : {0.0, 0.4}) {
    contact.pose_a = upside_down({0.0051, 0.0032, -0.1e-3});
    contact.pose_a.rotation = turn_about({1, 2, 0}, tilt_rad) * contact.pose_a.rotation;
    const auto expected = reference_penetration(contact.a(), contact.b(), {}, sampler.grid(), law);
    const auto found = answer(sampler, contact);
    ASSERT_TRUE(expected && found);
    ASSERT_LT(expected->covered, 32 * 32);
    EXPECT_EQ(found->covered, expected->covered);
    EXPECT_NEAR(found->depth_m, expected->depth_m, 20e-9);
    EXPECT_NEAR(found->slope.x, expected->slope.x, 1e-5);
    EXPECT_NEAR(found->slope.y, expected->slope.y, 1e-5);
    EXPECT_NEAR(found->lever_m.x, expected->lever_m.x, 1e-7);
    EXPECT_NEAR(found->lever_m.y, expected->lever_m.y, 1e-7);
    EXPECT_NEAR(found->lever_m.z, expected->lever_m.z, 1e-7);
  }
}

TEST(PenetrationSampler, GivesTheSameBitsWithEveryInstructionSet) {
  ContactsByChance chance(13);
  for (const MaximumLaw& law :
       {MaximumLaw(step_of(64, 2)), MaximumLaw(SmoothMaximum{.tau_m = 20e-6})}) {
    std::vector<PenetrationSampler> samplers;
    for (const InstructionSet set : instruction_sets_here()) {
      samplers.emplace_back(settings_for(64, law, set));
    }
    for (const ContactKind kind : kContactKinds) {
      const ChanceContact contact = chance.draw(kind);
      const auto first = answer(samplers.front(), contact);
      ASSERT_TRUE(first);
      for (PenetrationSampler& sampler : samplers) {
        const auto found = answer(sampler, contact);
        ASSERT_TRUE(found);
        const auto bits = [](const Penetration& p) {
          return std::array{p.depth_m,
                            p.slope.x,
                            p.slope.y,
                            p.lever_m.x,
                            p.lever_m.y,
                            p.lever_m.z,
                            p.deepest_m.x,
                            p.deepest_m.y,
                            p.deepest_m.z,
                            static_cast<double>(p.covered),
                            static_cast<double>(p.folded),
                            static_cast<double>(p.at_border)};
        };
        EXPECT_EQ(bits(*found), bits(*first));
      }
    }
  }
}

TEST(PenetrationSampler, TurnsWithTheFrameUpToSinglePrecision) {
  ContactsByChance chance(14);
  ChanceContact contact = chance.draw(ContactKind::convex_on_flat);
  PenetrationSampler sampler(settings_for(32, step_of(32, 1), instruction_sets_here().back()));
  const auto before = answer(sampler, contact);
  const glm::dmat3 turn = turn_about({0.3, -0.8, 0.5}, 2.1);
  const glm::dvec3 shift_m{0.1, -0.2, 0.05};
  for (Pose* pose : {&contact.pose_a, &contact.pose_b}) {
    *pose = {.rotation = turn * pose->rotation, .position_m = turn * pose->position_m + shift_m};
  }
  const auto after =
      answer(sampler, contact, {.origin_m = shift_m, .u = turn[0], .v = turn[1], .n = turn[2]});
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->depth_m, before->depth_m, 10e-9);
  EXPECT_NEAR(after->slope.x, before->slope.x, 1e-4);
  EXPECT_NEAR(after->lever_m.z, before->lever_m.z, 1e-6);
}

TEST(PenetrationSampler, FindsNothingWhereNothingIs) {
  ContactsByChance chance(15);
  PenetrationSampler sampler(settings_for(32, step_of(32, 1), instruction_sets_here().back()));
  const ChanceContact whole = chance.draw(ContactKind::flat);
  ASSERT_TRUE(answer(sampler, whole));
  const auto finds_nothing = [&](auto change) {
    ChanceContact contact = whole;
    change(contact);
    EXPECT_FALSE(answer(sampler, contact));
  };
  finds_nothing([](auto& contact) { contact.triangles_a.clear(); });
  finds_nothing([](auto& contact) { contact.pose_a.position_m.x = 1.0; });
  finds_nothing([](auto& contact) { contact.pose_a.position_m.x = 1e30; });
  finds_nothing([](auto& contact) { contact.pose_a.rotation = glm::dmat3(1.0); });  // turned away
  finds_nothing([](auto& contact) {
    contact.pose_b.position_m.y = std::numeric_limits<double>::quiet_NaN();
  });
  finds_nothing([](auto& contact) {
    contact.pose_a.position_m.z = std::numeric_limits<double>::quiet_NaN();
  });
}

TEST(PenetrationSampler, DoesNotTouchTheHeap) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  ContactsByChance chance(16);
  const ChanceContact contact = chance.draw(ContactKind::convex_on_convex);
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  PenetrationSampler sampler(settings_for(32, step_of(32, 1), instruction_sets_here().back()));
  const AllocationGuard guard;
  const auto found = sampler.evaluate(
      {.surface = a, .triangles = contact.triangles_a, .pose = contact.pose_a},
      {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b}, {});
  EXPECT_EQ(guard.count(), 0);
  EXPECT_TRUE(found);
}

TEST(PenetrationSampler, RefusesAGridThatItsStepDoesNotFit) {
  const auto refuses = [](auto change) {
    SamplerSettings settings = settings_for(64, step_of(64, 1), InstructionSet::sse2);
    change(settings);
    EXPECT_THROW(PenetrationSampler{settings}, std::invalid_argument);
  };
  refuses([](SamplerSettings& settings) {
    settings.grid.samples = 48;
    settings.law = step_of(48, 1);
  });
  refuses([](SamplerSettings& settings) { settings.law = step_of(64, 3); });
  refuses([](SamplerSettings& settings) { settings.law = step_of(64, 0); });
  refuses([](SamplerSettings& settings) { settings.law = HardMaximum{.step_m = 0.1e-3}; });
  refuses([](SamplerSettings& settings) { settings.grid.width_m = 0.0; });
  refuses([](SamplerSettings& settings) {
    settings.grid.samples = 32 * 9;
    settings.law = step_of(32 * 9, 9);
  });
  refuses([](SamplerSettings& settings) { settings.law = SmoothMaximum{.tau_m = 0.0}; });
  refuses([](SamplerSettings& settings) {
    settings.grid.samples = 24;
    settings.law = SmoothMaximum{.tau_m = 1e-5};
  });
}

TEST(InstructionSets, NameWhatRunsHereTheWidestLast) {
  const std::vector<InstructionSet> sets = instruction_sets_here();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(std::string(name_of(sets.front())), "sse2");
  EXPECT_TRUE(std::is_sorted(sets.begin(), sets.end()));
}

}  // namespace
}  // namespace asperity
