// Bodies that renderers share: which one belongs to a request, how long each is kept, and that forces do not depend on it.

#include "renderers/pd_gradient/contact/prepared_bodies.h"

#include <algorithm>
#include <future>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

constexpr Grating kGrating{.amplitude_m = 0.05e-3, .wavelength_m = 1e-3};

std::shared_ptr<const TexturedMesh> plate() { return shared(grated_plate(kGrating)); }

const PackedSurface* surface_of(PreparedBodies& bodies,
                                const std::shared_ptr<const TexturedMesh>& mesh, double gain) {
  return &bodies.body(mesh, gain).surface();
}

using Prepared = std::weak_ptr<const ClusteredMesh>;

Prepared prepared(PreparedBodies& bodies, const std::shared_ptr<const TexturedMesh>& mesh,
                  double gain) {
  return bodies.body(mesh, gain).hull_clusters();
}

/// A ball of 3 mm with its lowest point at the tip, on a plate with complete parameters.
RendererInputs ball_on(const std::shared_ptr<const TexturedMesh>& surface, double gain) {
  static const auto kBall = shared(shifted(bare(ball(1.5e-3, 14, 20)), {0, 0, 1.5e-3}));
  RendererInputs inputs;
  inputs.parameters = complete_values(pd_gradient_model().declaration, {{"texture_gain", gain}});
  inputs.material = {.stiffness_N_per_m = 1000.0, .friction = 0.2};
  inputs.patch = wide_patch();
  inputs.tool = kBall;
  inputs.surface = surface;
  return inputs;
}

std::vector<double> slide_N(ForceRenderer& renderer) {
  std::vector<double> forces_N;
  ProbeState probe = probe_at({-3e-3, 0.2e-3, 0.5e-3});
  renderer.reset(probe);
  for (int i = 0; i < 200; ++i) {
    probe.velocity_m_per_s = {0.03, 0.0, i < 50 ? -0.013 : 0.0};
    probe.position_m += probe.velocity_m_per_s * kTick_s;
    const RenderedTick tick = renderer.tick(probe, kTick_s);
    for (const glm::dvec3& each : {tick.wrench.force_N, tick.wrench.torque_N_m}) {
      forces_N.insert(forces_N.end(), {each.x, each.y, each.z});
    }
  }
  return forces_N;
}

TEST(PreparedBodies, AreThoseOfTheMeshAndTheGain) {
  PreparedBodies bodies;
  const auto mesh = plate();
  const TexturedBody first = bodies.body(mesh, 2.0);
  EXPECT_EQ(surface_of(bodies, mesh, 2.0), &first.surface());
  EXPECT_EQ(first.furthest_displacement_m(), TexturedBody(*mesh, 2.0).furthest_displacement_m());
  const TexturedBody other_gain = bodies.body(mesh, 1.0);
  EXPECT_NE(&other_gain.surface(), &first.surface());
  EXPECT_EQ(other_gain.furthest_displacement_m(),
            TexturedBody(*mesh, 1.0).furthest_displacement_m());
  EXPECT_NE(surface_of(bodies, plate(), 2.0), &first.surface());  // another mesh of equal content
  EXPECT_EQ(surface_of(bodies, mesh, 2.0), &first.surface());
}

TEST(PreparedBodies, AreReleasedWithTheirMesh) {
  PreparedBodies bodies;
  auto mesh = plate();
  const Prepared first = prepared(bodies, mesh, 1.0);
  const auto other = plate();
  const Prepared second = prepared(bodies, other, 1.0);
  EXPECT_FALSE(first.expired());
  mesh.reset();
  prepared(bodies, other, 1.0);
  EXPECT_TRUE(first.expired());
  EXPECT_FALSE(second.expired());
}

TEST(PreparedBodies, AreReleasedBeyondTheirMemoryTheOldestFirst) {
  const auto mesh = plate();
  const std::size_t bytes = TexturedBody(*mesh, 1.0).bytes();
  PreparedBodies bodies(2 * bytes);
  const Prepared first = prepared(bodies, mesh, 1.0);
  const Prepared second = prepared(bodies, mesh, 2.0);
  EXPECT_EQ(bodies.body(mesh, 1.0).hull_clusters(), first.lock());
  const Prepared third = prepared(bodies, mesh, 3.0);
  EXPECT_FALSE(first.expired());
  EXPECT_TRUE(second.expired());
  EXPECT_FALSE(third.expired());
  // A body that is too large by itself is not kept, and does not release others that are in use.
  PreparedBodies few(bytes - 1);
  const TexturedBody used = few.body(mesh, 1.0);
  EXPECT_TRUE(prepared(few, mesh, 2.0).expired());
  EXPECT_EQ(used.furthest_displacement_m(), TexturedBody(*mesh, 1.0).furthest_displacement_m());
}

// Texels of 16 bits are kept in pairs.
TEST(PreparedBodies, CountAtLeastTheMemoryOfTheirTexels) {
  const auto mesh = plate();
  EXPECT_GE(TexturedBody(*mesh, 1.0).bytes(), 4 * mesh->atlas.rows * mesh->atlas.columns);
}

TEST(PreparedBodies, AreNotKeptWhereTheyCannotBeMade) {
  PreparedBodies bodies;
  const auto mesh = plate();
  EXPECT_THROW(bodies.body(mesh, -1.0), std::invalid_argument);
  EXPECT_THROW(bodies.body(mesh, -1.0), std::invalid_argument);
  EXPECT_EQ(bodies.body(mesh, 1.0).triangles(), mesh->triangles.size());
}

TEST(PreparedBodies, AreSharedByThreads) {
  PreparedBodies bodies;
  const auto mesh = plate();
  std::vector<std::future<TexturedBody>> requests;
  for (int i = 0; i < 8; ++i) {
    requests.push_back(std::async(std::launch::async, [&bodies, &mesh, i] {
      return bodies.body(mesh, i % 2 == 0 ? 1.0 : 2.0);
    }));
  }
  const PackedSurface* const even = surface_of(bodies, mesh, 1.0);
  const PackedSurface* const odd = surface_of(bodies, mesh, 2.0);
  EXPECT_NE(even, odd);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    EXPECT_EQ(&requests[i].get().surface(), i % 2 == 0 ? even : odd) << i;
  }
}

TEST(PreparedBodies, AreSharedByTheRenderersOfAModelAndItsCopies) {
  const ForceModel model = pd_gradient_model();
  const ForceModel copy = model;
  const auto mesh = plate();
  const auto first = model.make(ball_on(mesh, 1.0));
  const auto second = copy.make(ball_on(mesh, 1.0));
  const auto other = model.make(ball_on(mesh, 2.0));
  const auto bodies_of = [](const ForceRenderer& renderer) -> const PdGradient& {
    return dynamic_cast<const PdGradient&>(renderer);
  };
  EXPECT_EQ(&bodies_of(*second).surface_body().surface(),
            &bodies_of(*first).surface_body().surface());
  EXPECT_EQ(&bodies_of(*second).tool_body().surface(), &bodies_of(*first).tool_body().surface());
  EXPECT_NE(&bodies_of(*other).surface_body().surface(),
            &bodies_of(*first).surface_body().surface());
  EXPECT_EQ(&bodies_of(*other).tool_body().surface(), &bodies_of(*first).tool_body().surface());
}

TEST(PreparedBodies, ExertTheSameForcesWhetherSharedOrNot) {
  const auto mesh = plate();
  const RendererInputs inputs = ball_on(mesh, 1.5);
  PdGradient own(inputs, instruction_sets_here().back());
  const std::vector<double> expected_N = slide_N(own);
  EXPECT_GT(*std::max_element(expected_N.begin(), expected_N.end()), 0.05);
  PdGradient::SharedParts shared;
  PdGradient first(inputs, instruction_sets_here().back(), nullptr, &shared);
  EXPECT_EQ(slide_N(first), expected_N);
  PdGradient second(inputs, instruction_sets_here().back(), nullptr, &shared);
  EXPECT_EQ(slide_N(second), expected_N);
  EXPECT_EQ(slide_N(first), expected_N);  // while another one has the same bodies
}

}  // namespace
}  // namespace asperity
