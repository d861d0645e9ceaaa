// Contacts on many crests are sampled with finer cells, and contacts on one are not.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/contact_scenes.h"
#include "tests/renderers/unexplained_change.h"

namespace asperity {
namespace {

constexpr double kCrestStep_m = 0.1e-3;
constexpr double kFinestCell_m = 0.025e-3;
constexpr double kHalfCrestBox_m = 2e-3;
constexpr double kOnCrests_m = 0.1e-3;
constexpr int kSettledTicks = 100;  // ticks: more than new heights take
const Grating kCrests{.amplitude_m = 0.1e-3, .wavelength_m = 2e-3};

WindowSampling refining(int most_halvings = 2, int most_samples = 512) {
  return {.law = HardMaximum{.step_m = kCrestStep_m},
          .cell_m = kCrestStep_m,
          .most_samples = most_samples,
          .most_halvings = most_halvings};
}

TexturedMesh grated_box() {
  return with_grating(BoxShape{{0.008, 0.008, 2.0 * kHalfCrestBox_m}}, kCrests, 0.5e-3);
}
TexturedMesh flat_box() { return bare(box({0.008, 0.008, 2.0 * kHalfCrestBox_m})); }

// Crest on crest.
Pose on_crests(double turned_rad, const glm::dvec3& by_m = {}) {
  return {.rotation = turn_about({0, 0, 1}, turned_rad),
          .position_m = by_m + glm::dvec3{0.0, 0.0, kHalfCrestBox_m + 0.2e-3 - kOnCrests_m}};
}
// A flat box on the crests of the grating.
Pose tilted(double tilt_rad, double along_m = 0.0) {
  const double lowered_m = 0.004 * std::sin(tilt_rad);
  return {.rotation = turn_about({0, 1, 0}, tilt_rad),
          .position_m = {along_m, 0.0, kHalfCrestBox_m + 0.1e-3 + lowered_m - kOnCrests_m}};
}

// A flat box that leans on one of its corners.
Pose leaning(double part) {
  return {.rotation = turn_about(glm::normalize(glm::dvec3{1, 1, 0}), 0.04 * part),
          .position_m = {0.5e-3, 0.0, kHalfCrestBox_m + 0.1e-3 * part}};
}

double spacing_m(const TexturedContact& contact) { return contact.grid.spacing_m(); }

// The only contact that does not fade, after some ticks in one pose.
TexturedContact settled(TexturedContacts& contacts, const Pose& pose, int ticks = kSettledTicks) {
  std::span<const TexturedContact> found{};
  for (int tick = 0; tick < ticks; ++tick) found = contacts.find(pose, {}, kTick_s);
  const auto is_fading = [](const TexturedContact& contact) { return contact.is_fading; };
  const auto rendered = std::find_if_not(found.begin(), found.end(), is_fading);
  EXPECT_EQ(
      found.size() - static_cast<std::size_t>(std::count_if(found.begin(), found.end(), is_fading)),
      1U);
  return rendered == found.end() ? TexturedContact{} : *rendered;
}

// The same differences over many more samples.
Penetration truth_of(const TexturedMesh& a, const TexturedMesh& b, const Pose& pose,
                     const TexturedContact& contact) {
  constexpr int kTruthSamples = 400;
  const std::vector<std::uint32_t> all_a = all_triangles(a);
  const std::vector<std::uint32_t> all_b = all_triangles(b);
  const auto truth = reference_penetration(
      {.mesh = a, .triangles = all_a, .pose = pose}, {.mesh = b, .triangles = all_b}, contact.frame,
      {.width_m = contact.grid.width_m, .samples = kTruthSamples},
      HardMaximum{.step_m = kCrestStep_m});
  EXPECT_TRUE(truth);
  return truth.value_or(Penetration{});
}

// RMS of the errors of the levers of tilts, of depths and of slopes.
struct Errors {
  double lever_m = 0.0;
  double depth_m = 0.0;
  double slope = 0.0;
};
Errors errors_of(const TexturedMesh& tool, const std::vector<Pose>& poses, int most_halvings) {
  const TexturedMesh plate = grated_plate(kCrests);
  Errors sum;
  for (const Pose& pose : poses) {
    TexturedContacts contacts = between(tool, plate, refining(most_halvings));
    const TexturedContact found = settled(contacts, pose);
    // A quarter of the cells; half of them where more samples than permitted would be needed.
    EXPECT_LT(spacing_m(found), most_halvings == 0 ? 1.01 * kCrestStep_m : 0.51 * kCrestStep_m);
    const Penetration truth = truth_of(tool, plate, pose, found);
    const glm::dvec2 lever_m = glm::dvec2(found.penetration.lever_m - truth.lever_m);
    const glm::dvec2 slope = found.penetration.slope - truth.slope;
    sum.lever_m += glm::dot(lever_m, lever_m);
    sum.slope += glm::dot(slope, slope);
    sum.depth_m += std::pow(found.penetration.depth_m - truth.depth_m, 2.0);
  }
  const double per_pose = 1.0 / static_cast<double>(poses.size());
  return {.lever_m = std::sqrt(per_pose * sum.lever_m),
          .depth_m = std::sqrt(per_pose * sum.depth_m),
          .slope = std::sqrt(per_pose * sum.slope)};
}

TEST(ContactRefinement, MakesTheLeversOfManyCrestsAccurate) {
  const glm::dvec3 aside_m{0.5e-3, 0.0, 0.0};
  const std::vector<Pose> turned{on_crests(-0.23, aside_m), on_crests(-0.05, aside_m),
                                 on_crests(0.3, aside_m)};
  const Errors declared = errors_of(grated_box(), turned, 0);
  const Errors refined = errors_of(grated_box(), turned, 2);
  RecordProperty("declared_um", std::to_string(1e6 * declared.lever_m));
  RecordProperty("refined_um", std::to_string(1e6 * refined.lever_m));
  EXPECT_LT(refined.lever_m, 15e-6);
  EXPECT_LT(refined.lever_m, 0.4 * declared.lever_m);
  EXPECT_LT(refined.depth_m, 0.3e-6);
  EXPECT_LT(refined.slope, 0.002);
}

TEST(ContactRefinement, MakesTheSlopesUnderATiltedBoxAccurate) {
  const std::vector<Pose> along{tilted(0.01, -0.7e-3), tilted(0.01, 0.4e-3), tilted(0.01, 0.9e-3)};
  const Errors declared = errors_of(flat_box(), along, 0);
  const Errors refined = errors_of(flat_box(), along, 2);
  RecordProperty("declared", std::to_string(declared.slope));
  RecordProperty("refined", std::to_string(refined.slope));
  EXPECT_LT(refined.slope, 0.004);
  EXPECT_LT(refined.slope, 0.4 * declared.slope);
  EXPECT_LT(refined.lever_m, 0.4 * declared.lever_m);
}

TEST(ContactRefinement, LeavesAContactOnOneCrestAsItIs) {
  const TexturedMesh tool = bare(ball(3e-3, 48, 64));
  const TexturedMesh plate = grated_plate(kCrests);
  TexturedContacts contacts = between(tool, plate, refining());
  for (int tick = 0; tick < 3 * kSettledTicks; ++tick) {
    // Within a quarter of a wave of the crest.
    const Pose pose = pose_at({0.5e-3 + 0.4e-3 * std::sin(0.05 * tick), 0.0, 3e-3});
    for (const TexturedContact& contact : contacts.find(pose, {}, kTick_s)) {
      EXPECT_EQ(contact.halvings, 0) << tick;
      EXPECT_NEAR(spacing_m(contact), kCrestStep_m, 1e-9);
      EXPECT_LT(contact.penetration.spread_m, 0.4e-3);
    }
  }
}

TEST(ContactRefinement, LeavesCrestsThatTheDeclaredCellsShowAsTheyAre) {
  const TexturedMesh plate = grated_plate({.amplitude_m = 30e-6, .wavelength_m = 6e-3});
  TexturedContacts contacts = between(flat_box(), plate, refining());
  const TexturedContact found = settled(contacts, pose_at({0.0, 0.0, kHalfCrestBox_m - 0.02e-3}));
  EXPECT_GT(found.penetration.spread_m, 2e-3);
  EXPECT_NEAR(spacing_m(found), kCrestStep_m, 1e-9);
}

TEST(ContactRefinement, LeavesTheSmoothMaximumAsItIs) {
  WindowSampling smooth = refining();
  smooth.law = SmoothMaximum{.tau_m = 20e-6};
  TexturedContacts contacts = between(grated_box(), grated_plate(kCrests), smooth);
  EXPECT_NEAR(spacing_m(settled(contacts, on_crests(0.2))), kCrestStep_m, 1e-9);
}

// The declared cells are used until the heights of the finer ones are complete.
TEST(ContactRefinement, ChangesNeitherWindowNorStepAndWaitsForItsHeights) {
  TexturedContacts contacts = between(grated_box(), grated_plate(kCrests), refining());
  const double width_m = settled(contacts, on_crests(0.2), 1).grid.width_m;
  int declared = 0;
  TexturedContact found{};
  while (declared < kSettledTicks) {
    found = settled(contacts, on_crests(0.2), 1);
    if (spacing_m(found) < 0.9 * kCrestStep_m) break;
    ++declared;
  }
  EXPECT_GT(declared, 10);
  EXPECT_LT(declared, 60);
  EXPECT_NEAR(found.grid.width_m, width_m, 1e-9);
  EXPECT_NEAR(found.filter_m, kCrestStep_m, 1e-12);
}

// In a row, on crests.
TexturedMesh boxes(int count) {
  TriangleMesh all;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(all.vertices_m.size());
    const TriangleMesh one = box({0.003, 0.003, 2.0 * kHalfCrestBox_m});
    for (const glm::dvec3& vertex_m : one.vertices_m) {
      all.vertices_m.push_back(vertex_m + glm::dvec3{0.0, 6e-3 * (i - 0.5 * (count - 1)), 0.0});
    }
    for (const auto& [a, b, c] : one.triangles) {
      all.triangles.push_back({a + first, b + first, c + first});
    }
  }
  return bare(all);
}

TEST(ContactRefinement, GivesAllContactsNoMoreSamplesThanOne) {
  const TexturedMesh tool = boxes(3);
  const TexturedMesh plate = grated_plate(kCrests);
  const auto finer = [&](int most_samples) {
    TexturedContacts contacts = between(tool, plate, refining(2, most_samples));
    std::size_t most_finer = 0;
    for (int tick = 0; tick < 2 * kSettledTicks; ++tick) {
      const auto found = contacts.find(tilted(0.0, 0.5e-3), {}, kTick_s);
      EXPECT_EQ(found.size(), 3U);
      int samples = 0;
      std::size_t count = 0;
      for (const TexturedContact& contact : found) {
        samples += contact.grid.samples * contact.grid.samples;
        count += spacing_m(contact) < 0.9 * kCrestStep_m ? 1 : 0;
      }
      EXPECT_LE(samples, most_samples * most_samples) << tick;
      most_finer = std::max(most_finer, count);
    }
    return most_finer;
  };
  EXPECT_EQ(finer(128), 0U);  // three of 64²
  EXPECT_EQ(finer(192), 2U);  // two of 128²
  EXPECT_EQ(finer(256), 3U);
}

TEST(ContactRefinement, LastsSomeTimeOnOneCrest) {
  TexturedContacts contacts = between(flat_box(), grated_plate(kCrests), refining());
  settled(contacts, leaning(0.0));
  int last_many = 0;
  int fine_on_one = 0;
  for (int tick = 1; tick < 300; ++tick) {
    // From flat until one end of a crest is deeper than all others.
    const TexturedContact found = settled(contacts, leaning(std::min(1.0, tick / 100.0)), 1);
    if (found.penetration.spread_m > 0.5e-3) last_many = tick;
    EXPECT_EQ(found.halvings, tick - last_many <= 50 ? 2 : 0) << tick;
    if (tick != last_many && spacing_m(found) < 0.9 * kCrestStep_m) ++fine_on_one;
  }
  EXPECT_GT(last_many, 30);
  EXPECT_LT(last_many, 100);
  EXPECT_GT(fine_on_one, 10);
}

struct Changes {
  double whole = 0.0;  ///< the largest change of the force in a tick, relative to the force
  double unexplained =
      0.0;  ///< the largest that the motion does not explain, relative to 0.05 N or more
  int of_cells = 0;
};
Changes changes_on(const TexturedMesh& tool, const std::function<Pose(int)>& pose,
                   int most_halvings = 2) {
  TexturedContacts contacts = between(tool, grated_plate(kCrests), refining(most_halvings));
  UnexplainedChange change;
  Changes most;
  double cell_m = kCrestStep_m;
  for (int tick = 0; tick < 4 * kSettledTicks; ++tick) {
    const auto found = contacts.find(pose(tick), {}, kTick_s);
    const UnexplainedChange::Tick now = change.add(found, pose(tick));
    most.whole = std::max(most.whole, now.whole_N / now.current_N);
    most.unexplained = std::max(most.unexplained, now.part(0.05));
    if (found.empty()) continue;
    most.of_cells += std::abs(spacing_m(found.front()) - cell_m) > 1e-9 ? 1 : 0;
    cell_m = spacing_m(found.front());
  }
  return most;
}

TEST(ContactRefinement, ChangesTheForceGradually) {
  const Changes at_rest = changes_on(grated_box(), [](int) { return on_crests(0.2); });
  EXPECT_EQ(at_rest.of_cells, 1);
  EXPECT_LT(at_rest.whole, 0.005);
  // Back again, where a box leans on one crest.
  const Changes leans = changes_on(
      flat_box(), [](int tick) { return leaning(std::clamp(tick / 100.0 - 1.0, 0.0, 1.0)); });
  EXPECT_GE(leans.of_cells, 2);
  EXPECT_LT(leans.unexplained, 0.05);
  // So fast that heights are late.
  const auto slid = [](int tick) { return tilted(0.003, 4e-3 * std::sin(0.025 * tick)); };
  const Changes slides = changes_on(flat_box(), slid);
  const Changes declared = changes_on(flat_box(), slid, 0);
  EXPECT_GE(slides.of_cells, 4);
  EXPECT_LT(slides.whole, 1.2 * declared.whole);
  RecordProperty("changes_permille", std::to_string(1e3 * at_rest.whole) + " " +
                                         std::to_string(1e3 * leans.unexplained) + " " +
                                         std::to_string(1e3 * slides.whole) + " " +
                                         std::to_string(1e3 * declared.whole) + " " +
                                         std::to_string(slides.of_cells));
}

TEST(ContactRefinement, GivesTheSameForcesAfterAReset) {
  TexturedContacts contacts = between(grated_box(), grated_plate(kCrests), refining());
  const auto forces = [&] {
    std::vector<double> all;
    for (int tick = 0; tick < 150; ++tick) {
      const Pose pose = on_crests(0.1 + 1e-3 * tick, {5e-6 * tick, 0.0, 0.0});
      const Wrench wrench = wrench_about({}, contacts.find(pose, {}, kTick_s));
      all.insert(all.end(), {wrench.force_N.x, wrench.force_N.z, wrench.torque_N_m.x});
    }
    return all;
  };
  const std::vector<double> once = forces();
  contacts.reset();
  EXPECT_EQ(forces(), once);
}

TEST(ContactRefinement, IsThatOfTheReferenceOnADevice) {
  const TexturedMesh tool = grated_box();
  const TexturedMesh plate = grated_plate(kCrests);
  TexturedContacts contacts(
      TexturedBody(tool, 1.0), TexturedBody(plate, 1.0), refining(1, 256),
      instruction_sets_here().back(),
      std::make_unique<ComputedContacts>(
          *first_compute(std::chrono::minutes(10)), tool, 1.0, plate, 1.0,
          GpuRoom{.contacts = TexturedContacts::kMostComputed, .samples = 256}));
  const Pose pose = on_crests(0.2);
  EXPECT_NEAR(spacing_m(settled(contacts, pose, 1)), kCrestStep_m, 1e-9);
  const TexturedContact found = settled(contacts, pose, 1);
  EXPECT_FALSE(contacts.left_out().is_computed_here);
  EXPECT_NEAR(spacing_m(found), 0.5 * kCrestStep_m, 1e-9);
  const std::vector<std::uint32_t> all_a = all_triangles(tool);
  const std::vector<std::uint32_t> all_b = all_triangles(plate);
  const auto expected = reference_penetration({.mesh = tool, .triangles = all_a, .pose = pose},
                                              {.mesh = plate, .triangles = all_b}, found.frame,
                                              found.grid, HardMaximum{.step_m = kCrestStep_m});
  ASSERT_TRUE(expected);
  EXPECT_NEAR(found.sampled_depth_m, expected->depth_m, 1e-12);
  EXPECT_NEAR(found.penetration.spread_m, expected->spread_m, 1e-9);
  EXPECT_NEAR(found.penetration.lever_m.x, expected->lever_m.x, 1e-10);
}

TEST(ContactRefinement, IsOnByDefaultDownToAQuarterOfTheCells) {
  RendererInputs inputs;
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.0};
  inputs.patch.extent_m = {1.0, 1.0};
  inputs.tool = shared(boxes(1));
  inputs.surface = shared(grated_plate(kCrests));
  const auto cell_m = [&](const ParameterValues& values) {
    inputs.parameters = complete_values(pd_gradient_model().declaration, values);
    PdGradient renderer(inputs, instruction_sets_here().back());
    renderer.reset({.position_m = {0.0, 0.0, 0.1}});
    const Pose pose = leaning(0.0);
    for (int tick = 0; tick < kSettledTicks; ++tick) {
      renderer.tick({.position_m = pose.position_m, .orientation = glm::quat_cast(pose.rotation)},
                    kTick_s);
    }
    EXPECT_EQ(renderer.contacts().size(), 1U);
    return renderer.contacts().empty() ? 0.0 : spacing_m(renderer.contacts().front());
  };
  const ParameterValue none = std::string("none");
  EXPECT_NEAR(cell_m({{"coupling", none}}), kFinestCell_m, 1e-9);
  EXPECT_NEAR(cell_m({{"coupling", none}, {"most_halvings", 0.0}}), kCrestStep_m, 1e-9);
}

}  // namespace
}  // namespace asperity
