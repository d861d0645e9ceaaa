// Answers from kept heights against those from heights sampled anew, and what they promise besides.

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/sampling/cached_penetration.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kWindow_m = ContactsByChance::kWindow_m;
constexpr double kContactDepth_m = 0.1e-3;

CachedSettings settings_for(int samples, const MaximumLaw& law,
                            InstructionSet instructions = instruction_sets_here().back()) {
  return {.sampler = {.grid = {.width_m = kWindow_m, .samples = samples},
                      .law = law,
                      .most_triangles = 200,
                      .instructions = instructions}};
}

HardMaximum step_of(int samples, int cells) { return {.step_m = cells * kWindow_m / samples}; }

std::array<double, 13> numbers_of(const Penetration& p) {
  return {p.depth_m,
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
          static_cast<double>(p.at_border),
          static_cast<double>(p.at_window)};
}

// A contact by chance whose bodies can be moved.
struct Bodies {
  Bodies(ContactsByChance& chance, ContactKind kind) : Bodies(chance.draw(kind)) {}
  explicit Bodies(const ChanceContact& drawn)
      : contact(pressed(drawn)), a(contact.mesh_a), b(contact.mesh_b) {}

  static ChanceContact pressed(ChanceContact contact) {
    const auto found =
        reference_penetration(contact.a(), contact.b(), {}, {.width_m = kWindow_m, .samples = 64},
                              HardMaximum{.step_m = 1e-4});
    contact.pose_a.position_m.z -= kContactDepth_m - found->depth_m;
    return contact;
  }
  PackedPatch patch_a(const Pose& pose) const { return {a, contact.triangles_a, pose}; }
  PackedPatch patch_b() const { return {b, contact.triangles_b, contact.pose_b}; }

  ChanceContact contact;
  PackedSurface a;
  PackedSurface b;
};

// Somewhere within what the kept heights allow for.
Pose drifted(const Pose& from, ContactsByChance& chance, double share) {
  const auto up_to = [&](double most) { return share * chance.between(-most, most); };
  Pose pose = from;
  pose.position_m += glm::dvec3{up_to(1.2e-3), up_to(1.2e-3), up_to(0.05e-3)};
  pose.rotation = turn_about({1, 0, 0}, up_to(0.025)) * turn_about({0, 1, 0}, up_to(0.025)) *
                  turn_about({0, 0, 1}, up_to(0.06)) * pose.rotation;
  return pose;
}

// Asks until heights are kept for the pose.
void settle(CachedPenetration& cached, const Bodies& bodies, const Pose& pose) {
  const std::uint64_t before = cached.kept_answers();
  for (int i = 0; i < 200 && cached.kept_answers() == before; ++i) {
    cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
  }
  ASSERT_GT(cached.kept_answers(), before);
}

struct RelativeError {
  double difference = 0.0;
  double whole = 0.0;
  void add(double found, double expected) {
    difference += (found - expected) * (found - expected);
    whole += expected * expected;
  }
  double rms() const { return std::sqrt(difference / whole); }
};

TEST(CachedPenetration, FindsTheSameBitsWithAndWithoutPruning) {
  ContactsByChance chance(31);
  int kept = 0;
  for (const MaximumLaw& law :
       {MaximumLaw(step_of(64, 1)), MaximumLaw(step_of(64, 2)),
        MaximumLaw(SmoothMaximum{.tau_m = 2e-6}), MaximumLaw(SmoothMaximum{.tau_m = 20e-6})}) {
    for (const ContactKind kind : kContactKinds) {
      const Bodies bodies(chance, kind);
      CachedSettings settings = settings_for(64, law);
      settings.most_places = 2;
      CachedPenetration pruned(settings);
      settings.pruning = Pruning::off;
      CachedPenetration whole(settings);
      const Pose start = bodies.contact.pose_a;
      settle(pruned, bodies, start);
      settle(whole, bodies, start);
      for (int i = 0; i < 150; ++i) {
        const Pose pose = drifted(start, chance, i % 2 == 0 ? 0.4 : 1.0);
        const auto found = pruned.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
        const auto expected = whole.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) continue;
        ASSERT_EQ(numbers_of(*found), numbers_of(*expected)) << i;
      }
      kept += static_cast<int>(pruned.kept_answers());
    }
  }
  EXPECT_GT(kept, 2500);  // of 3600: the rest lay too far away
}

// Thorns on flat plates: what is deepest is a single sample, and the next one is far lower.
TEST(CachedPenetration, LosesNoThornWhenPruning) {
  ContactsByChance chance(41);
  ChanceContact drawn = chance.draw(ContactKind::flat);
  for (TexturedMesh* mesh : {&drawn.mesh_a, &drawn.mesh_b}) {
    for (std::int16_t& value : mesh->atlas.values) {
      value = chance.between(0.0, 1.0) < 0.002
                  ? static_cast<std::int16_t>(chance.between(0.0, 32767.0))
                  : std::int16_t{0};
    }
  }
  const Bodies bodies(drawn);
  const HardMaximum law = step_of(128, 4);
  CachedSettings settings = settings_for(128, law);
  CachedPenetration pruned(settings);
  settings.pruning = Pruning::off;
  CachedPenetration whole(settings);
  for (CachedPenetration* cached : {&pruned, &whole}) {
    settle(*cached, bodies, bodies.contact.pose_a);
  }
  for (int i = 0; i < 300; ++i) {
    const Pose pose = drifted(bodies.contact.pose_a, chance, 0.45);
    const auto found = pruned.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
    const auto expected = whole.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
    ASSERT_TRUE(found && expected);
    ASSERT_EQ(numbers_of(*found), numbers_of(*expected)) << i;
  }
  EXPECT_GE(pruned.kept_answers(), 300U);
}

TEST(CachedPenetration, GivesTheSameBitsWithEveryInstructionSet) {
  ContactsByChance chance(32);
  for (const MaximumLaw& law :
       {MaximumLaw(step_of(64, 2)), MaximumLaw(SmoothMaximum{.tau_m = 20e-6})}) {
    const Bodies bodies(chance, ContactKind::convex_on_flat);
    std::vector<CachedPenetration> all;
    for (const InstructionSet set : instruction_sets_here()) {
      all.emplace_back(settings_for(64, law, set));
    }
    for (int i = 0; i < 100; ++i) {
      const Pose pose = drifted(bodies.contact.pose_a, chance, 0.8);
      const auto first = all.front().evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
      ASSERT_TRUE(first);
      for (CachedPenetration& cached : all) {
        if (&cached == &all.front()) continue;
        const auto found = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
        ASSERT_TRUE(found);
        ASSERT_EQ(numbers_of(*found), numbers_of(*first)) << i;
      }
    }
    EXPECT_GT(all.front().kept_answers(), 50U);
  }
}

// Bodies that have moved about as far as they may, at 16 samples a wavelength.
TEST(CachedPenetration, AgreesWithThePlainEvaluationWhereBodiesHaveDrifted) {
  ContactsByChance chance(33);
  const HardMaximum law = step_of(128, 2);
  RelativeError slopes;
  RelativeError tilts;
  RelativeError turn;
  for (const ContactKind kind : kContactKinds) {
    if (kind == ContactKind::overlapping) continue;  // ends under the window's border
    const Bodies bodies(chance, kind);
    CachedPenetration cached(settings_for(128, law));
    settle(cached, bodies, bodies.contact.pose_a);
    for (int i = 0; i < 2; ++i) {
      const Pose pose = drifted(bodies.contact.pose_a, chance, 0.45);
      const std::uint64_t kept = cached.kept_answers();
      const auto found = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
      const auto expected = PenetrationSampler(settings_for(128, law).sampler)
                                .evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
      ASSERT_TRUE(found && expected);
      ASSERT_GT(cached.kept_answers(), kept);
      EXPECT_NEAR(found->depth_m, expected->depth_m, 8e-6);
      slopes.add(found->slope.x, expected->slope.x);
      slopes.add(found->slope.y, expected->slope.y);
      tilts.add(found->lever_m.x, expected->lever_m.x);
      tilts.add(found->lever_m.y, expected->lever_m.y);
      turn.add(found->lever_m.z, expected->lever_m.z);
    }
  }
  RecordProperty("slopes", std::to_string(slopes.rms()));
  RecordProperty("tilts", std::to_string(tilts.rms()));
  RecordProperty("turn", std::to_string(turn.rms()));
  EXPECT_LT(slopes.rms(), 0.08);
  EXPECT_LT(tilts.rms(), 0.04);
  EXPECT_LT(turn.rms(), 0.12);
}

// The surfaces stay as they are and only what is asked for turns and moves: the wrench stays, whatever
// frame it is told in.
TEST(CachedPenetration, AnswersForTheAskedFrame) {
  ContactsByChance chance(34);
  const Bodies bodies(chance, ContactKind::convex_on_flat);
  const Pose& pose = bodies.contact.pose_a;
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  settle(cached, bodies, pose);
  const auto kept = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
  const glm::dmat3 turn = turn_about({0.4, -0.8, 0.0}, 0.025) * turn_about({0, 0, 1}, 0.7);
  const ContactFrame asked{
      .origin_m = {0.1e-3, -0.05e-3, 0.02e-3}, .u = turn[0], .v = turn[1], .n = turn[2]};
  const auto found = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), asked);
  ASSERT_TRUE(kept && found);
  ASSERT_GE(cached.kept_answers(), 3U);
  const Wrench expected = contact_wrench(*kept, {}, 1000.0);
  const Wrench told = contact_wrench(*found, asked, 1000.0);
  const double per_fall = found->depth_m / kept->depth_m;  // δ along a shorter way
  EXPECT_NEAR(per_fall, 1.0, 0.03);
  const glm::dvec3 force_N = per_fall * per_fall * expected.force_N;
  EXPECT_LT(glm::length(told.force_N - force_N), 1e-9);
  // Torques are about the asked origin.
  const glm::dvec3 torque_N_m =
      per_fall * per_fall * expected.torque_N_m - glm::cross(asked.origin_m, force_N);
  EXPECT_LT(glm::length(told.torque_N_m - torque_N_m), 1e-12);
  const glm::dvec3 deepest_m = asked.origin_m + asked.to_world(found->deepest_m);
  EXPECT_LT(glm::length(deepest_m - kept->deepest_m), 1e-9);
}

// The edge of A on a ramp of B that is 88° from n: δ rises by 28 for every metre along, and where n is
// asked for 0.05 rad aside it would not fall at all.
TEST(CachedPenetration, AnswersForAFrameAlongWhichASteepDepthHardlyFalls) {
  ChanceContact contact;
  contact.mesh_a = formed_plate({.size_m = {2e-3, 2e-3}}, [](double, double) { return 0.0; });
  contact.mesh_b = formed_plate({.size_m = {12e-3, 12e-3}, .cells = {60, 1}},
                                [](double x_m, double) { return 28.0 * std::max(0.0, x_m); });
  contact.triangles_a = all_triangles(contact.mesh_a);
  contact.triangles_b = all_triangles(contact.mesh_b);
  contact.pose_a = upside_down({0.0, 0.0, 0.0});
  contact.pose_b = {};
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  const PackedPatch patch_a{.surface = a, .triangles = contact.triangles_a, .pose = contact.pose_a};
  const PackedPatch patch_b{.surface = b, .triangles = contact.triangles_b};
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  for (int i = 0; i < 200 && cached.kept_answers() == 0; ++i) cached.evaluate(patch_a, patch_b, {});
  const auto kept = cached.evaluate(patch_a, patch_b, {});
  ASSERT_TRUE(kept);
  ASSERT_GT(kept->slope.x, 25.0);
  for (const double aside_rad : {0.05, 0.0356, -0.05}) {
    const glm::dmat3 turn = turn_about({0, 1, 0}, aside_rad);
    const std::uint64_t before = cached.kept_answers();
    const ContactFrame asked{.u = turn[0], .v = turn[1], .n = turn[2]};
    const auto found = cached.evaluate(patch_a, patch_b, asked);
    ASSERT_EQ(cached.kept_answers(), before + 1U);
    EXPECT_GT(found->depth_m, 0.0) << aside_rad;
    EXPECT_LE(found->depth_m, 1.25 * kept->depth_m + 1e-12) << aside_rad;
    EXPECT_GT(found->slope.x, 0.0) << aside_rad;
    EXPECT_LT(found->slope.x, 1.3 * kept->slope.x) << aside_rad;
  }
}

// A floor, and a sheet 1 mm above it that a low box does not reach. Kept heights of the low box do not
// serve a high one, nor the other way round; a little more or less they do.
TEST(CachedPenetration, SamplesAnewWhereTrianglesAreOfAnotherBox) {
  const auto flat = [](double, double) { return 0.0; };
  const TexturedMesh tool = formed_plate({.size_m = {6e-3, 6e-3}}, flat);
  TexturedMesh sheets = formed_plate({.size_m = {12e-3, 12e-3}}, flat);
  TexturedMesh upper =
      formed_plate({.size_m = {12e-3, 12e-3}}, [](double, double) { return 1e-3; });
  for (std::size_t i = 0; i < upper.vertices_m.size(); ++i) {
    sheets.vertices_m.push_back(upper.vertices_m[i]);
    sheets.normals.push_back(upper.normals[i]);
  }
  for (const auto& [p, q, r] : upper.triangles) sheets.triangles.push_back({p + 4, q + 4, r + 4});
  sheets.places.assign(4, {});
  const PackedSurface a(tool);
  const PackedSurface b(sheets);
  const std::vector<std::uint32_t> of_a = all_triangles(tool);
  const std::vector<std::uint32_t> of_b = all_triangles(sheets);
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  const auto depth_m = [&](double half_height_m) {
    PackedPatch patch_a{
        .surface = a, .pose = upside_down({0.0, 0.0, -0.1e-3}), .half_height_m = half_height_m};
    PackedPatch patch_b{.surface = b, .half_height_m = half_height_m};
    if (cached.choose(patch_a, patch_b, {}).needs_triangles()) {
      patch_a.triangles = of_a;
      patch_b.triangles = std::span(of_b).first(half_height_m < 1e-3 ? 2 : 4);
    }
    return cached.evaluate(patch_a, patch_b, {})->depth_m;
  };
  for (int i = 0; i < 100; ++i) ASSERT_NEAR(depth_m(0.4e-3), 0.1e-3, 1e-9);
  const std::uint64_t kept = cached.kept_answers();
  EXPECT_NEAR(depth_m(0.5e-3), 0.1e-3, 1e-9);
  EXPECT_EQ(cached.kept_answers(), kept + 1U);
  for (int i = 0; i < 100; ++i) ASSERT_NEAR(depth_m(1.2e-3), 1.1e-3, 1e-9) << i;
  EXPECT_GT(cached.kept_answers(), kept + 30U);
  ASSERT_NEAR(depth_m(0.4e-3), 0.1e-3, 1e-9);
}

// A plate at 65° sinks, and heights from before it did do not serve; as far from n as the cosine of all, or half
// of it, it is all there or left out.
TEST(CachedPenetration, LetsFacesSinkThatLeanFurtherThanTold) {
  constexpr double kLeaning_rad = 65.0 * std::numbers::pi / 180.0;
  const TexturedMesh tool =
      formed_plate({.size_m = {20e-3, 20e-3}}, [](double, double) { return 0.0; });
  const TexturedMesh ramp = formed_plate(
      {.size_m = {20e-3, 20e-3}}, [](double x_m, double) { return std::tan(kLeaning_rad) * x_m; });
  const PackedSurface a(tool);
  const PackedSurface b(ramp);
  const std::vector<std::uint32_t> triangles = all_triangles(tool);
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  const auto found = [&](double leaning_cosine) {
    return cached.evaluate({.surface = a, .triangles = triangles, .pose = upside_down({})},
                           {.surface = b, .triangles = triangles, .leaning_cosine = leaning_cosine},
                           {});
  };
  const double cosine = std::cos(kLeaning_rad);
  EXPECT_EQ(sunk_m(cosine, cosine, 8e-3), 0.0);
  EXPECT_DOUBLE_EQ(sunk_m(cosine, cosine / 0.75, 8e-3), 4e-3);
  const double all_m = found(cosine - 1e-6)->depth_m;
  for (const double leaning_cosine : {0.5, 0.56, 0.0}) {
    const double expected_m = all_m - sunk_m(cosine, leaning_cosine, cached.grid().width_m);
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(found(leaning_cosine)->depth_m, expected_m, 20e-9);
  }
  EXPECT_GT(cached.kept_answers(), 150U);
  EXPECT_FALSE(found(2.01 * cosine).has_value());
}

// A slide over six windows' widths in which heights are sampled anew several times: nowhere is the
// force further from the one sampled anew than what reading between samples costs.
TEST(CachedPenetration, JumpsLittleWhereHeightsAreSampledAnew) {
  ContactsByChance chance(35);
  const Bodies bodies(chance, ContactKind::convex_on_flat);
  const HardMaximum law = step_of(64, 1);
  CachedPenetration cached(settings_for(64, law));
  PenetrationSampler sampler(settings_for(64, law).sampler);
  double squares_N2 = 0.0;
  double furthest_N = 0.0;
  constexpr int kTicks = 600;
  for (int tick = 0; tick < kTicks; ++tick) {
    Pose pose = bodies.contact.pose_a;
    pose.position_m.x += 2e-3 * std::sin(0.02 * tick);  // 40 µm a tick
    const ContactFrame frame{.origin_m = {0.5 * pose.position_m.x, 0.0, 0.0}};
    const auto found = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), frame);
    const auto expected = sampler.evaluate(bodies.patch_a(pose), bodies.patch_b(), frame);
    ASSERT_TRUE(found && expected);
    const glm::dvec3 force_N = contact_wrench(*expected, frame, 1000.0).force_N;
    const glm::dvec3 other_N = contact_wrench(*found, frame, 1000.0).force_N;
    squares_N2 += glm::dot(force_N, force_N);
    furthest_N = std::max(furthest_N, glm::length(other_N - force_N));
  }
  EXPECT_GT(cached.kept_answers(), 550U);
  const double relative = furthest_N / std::sqrt(squares_N2 / kTicks);
  RecordProperty("furthest_over_rms", std::to_string(relative));
  EXPECT_LT(relative, 0.25);
}

TEST(CachedPenetration, SamplesAnewWhereNothingIsKept) {
  ContactsByChance chance(36);
  const Bodies bodies(chance, ContactKind::convex_on_convex);
  const HardMaximum law = step_of(64, 1);
  CachedPenetration cached(settings_for(64, law));
  PenetrationSampler sampler(settings_for(64, law).sampler);
  Pose pose = bodies.contact.pose_a;
  for (int i = 0; i < 40; ++i) {
    pose.position_m.x += i % 2 == 0 ? 3e-3 : -3e-3;  // never where it was, before heights are there
    pose.position_m.y = 1e-3 * (i % 5 - 2);
    pose.rotation = turn_about({0, 0, 1}, 0.3) * pose.rotation;
    const auto found = cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
    const auto expected = sampler.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) continue;
    EXPECT_EQ(numbers_of(*found), numbers_of(*expected));
  }
  EXPECT_EQ(cached.kept_answers(), 0U);
  EXPECT_EQ(cached.sampled_answers(), 40U);
}

TEST(CachedPenetration, FindsNothingFromKeptHeightsUntilTheyAreComplete) {
  ContactsByChance chance(7);
  Bodies bodies(chance, ContactKind::flat);
  const HardMaximum law = step_of(64, 1);
  CachedPenetration kept(settings_for(64, law));
  CachedPenetration usual(settings_for(64, law));
  const PackedPatch a = bodies.patch_a(bodies.contact.pose_a);
  const PackedPatch b = bodies.patch_b();
  int calls = 0;
  std::optional<Penetration> found{};
  for (; !found && calls < 100; ++calls) {
    const auto choice = kept.choose(a, b, {});
    EXPECT_FALSE(choice.place && calls < 10);
    found = kept.evaluate_kept(choice, a, b, {});
    EXPECT_EQ(found.has_value(), choice.place.has_value());
  }
  EXPECT_LT(calls, 40);
  EXPECT_EQ(kept.sampled_answers(), 0U);
  std::optional<Penetration> same{};
  while (usual.kept_answers() == 0) same = usual.evaluate(a, b, {});
  ASSERT_TRUE(found && same);
  EXPECT_EQ(numbers_of(*found), numbers_of(*same));
}

// A contact may move by nearly a quarter of its window along both axes before its heights are those of another one.
TEST(CachedPenetration, KeepsHeightsUpToTheCornersOfTheirMargin) {
  ContactsByChance chance(48);
  const Bodies bodies(chance, ContactKind::flat);
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  settle(cached, bodies, bodies.contact.pose_a);
  const std::uint64_t sampled = cached.sampled_answers();
  for (const double x_m : {-2.2e-3, 2.2e-3}) {
    for (const double y_m : {-2.2e-3, 2.2e-3}) {
      cached.evaluate(bodies.patch_a(bodies.contact.pose_a), bodies.patch_b(),
                      {.origin_m = {x_m, y_m, 0.0}});
    }
  }
  EXPECT_EQ(cached.sampled_answers(), sampled);
}

TEST(CachedPenetration, AnswersTheSameCallsTheSameAfterAReset) {
  ContactsByChance chance(37);
  const Bodies bodies(chance, ContactKind::ridge);
  CachedPenetration cached(settings_for(64, step_of(64, 1)));
  const auto path = [&](int tick) {
    Pose pose = bodies.contact.pose_a;
    pose.position_m.x += 1.5e-3 * std::sin(0.05 * tick);
    return pose;
  };
  std::vector<std::array<double, 13>> first;
  for (const bool again : {false, true}) {
    cached.reset();
    for (int tick = 0; tick < 150; ++tick) {
      const auto found = cached.evaluate(bodies.patch_a(path(tick)), bodies.patch_b(), {});
      ASSERT_TRUE(found);
      if (!again) {
        first.push_back(numbers_of(*found));
      } else {
        ASSERT_EQ(numbers_of(*found), first[static_cast<std::size_t>(tick)]);
      }
    }
  }
  EXPECT_GT(cached.kept_answers(), 100U);
}

// Two contacts of the same bodies, asked for in turn, and a third that takes the place of none.
TEST(CachedPenetration, KeepsAPlaceForEachContact) {
  ContactsByChance chance(38);
  const Bodies bodies(chance, ContactKind::flat);
  CachedPenetration cached(settings_for(32, step_of(32, 1)));
  const Pose& pose = bodies.contact.pose_a;
  const auto ask = [&](double x_m) {
    cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {.origin_m = {x_m, 0.0, 0.0}});
  };
  for (int i = 0; i < 40; ++i) {
    for (const double x_m : {-5e-3, 0.0, 5e-3}) ask(x_m);
  }
  const std::uint64_t sampled = cached.sampled_answers();
  for (int i = 0; i < 20; ++i) {
    for (const double x_m : {-5e-3, 0.0, 5e-3}) ask(x_m);
  }
  EXPECT_EQ(cached.sampled_answers(), sampled);
}

TEST(CachedPenetration, FindsNothingWhereNothingIs) {
  ContactsByChance chance(39);
  const Bodies bodies(chance, ContactKind::flat);
  CachedPenetration cached(settings_for(32, step_of(32, 1)));
  settle(cached, bodies, bodies.contact.pose_a);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const glm::dvec3& aside_m : {glm::dvec3{1.0, 0.0, 0.0}, glm::dvec3{1e30, 0.0, 0.0},
                                    glm::dvec3{0.0, nan, 0.0}, glm::dvec3{0.0, 0.0, nan}}) {
    Pose pose = bodies.contact.pose_a;
    pose.position_m += aside_m;
    for (int i = 0; i < 30; ++i) {
      EXPECT_FALSE(cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {}));
    }
  }
  EXPECT_TRUE(cached.evaluate(bodies.patch_a(bodies.contact.pose_a), bodies.patch_b(), {}));
}

TEST(CachedPenetration, DoesNotTouchTheHeap) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  ContactsByChance chance(40);
  const Bodies bodies(chance, ContactKind::convex_on_flat);
  CachedPenetration cached(settings_for(32, step_of(32, 1)));
  const AllocationGuard guard;
  for (int tick = 0; tick < 60; ++tick) {
    Pose pose = bodies.contact.pose_a;
    pose.position_m.x += 30e-6 * tick;
    cached.evaluate(bodies.patch_a(pose), bodies.patch_b(), {});
  }
  cached.reset();
  EXPECT_EQ(guard.count(), 0);
}

TEST(CachedPenetration, RefusesSettingsThatKeepNothing) {
  CachedSettings settings = settings_for(64, step_of(64, 1));
  settings.most_places = 1;
  EXPECT_THROW(CachedPenetration{settings}, std::invalid_argument);
  for (const int rows : {0, -2, 5}) {
    settings = settings_for(64, step_of(64, 1));
    settings.rows_in_a_call = rows;
    EXPECT_THROW(CachedPenetration{settings}, std::invalid_argument);
  }
  EXPECT_THROW(CachedPenetration{settings_for(48, step_of(48, 1))}, std::invalid_argument);
}

}  // namespace
}  // namespace asperity
