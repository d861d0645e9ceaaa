// The parts of a simplification: distances from a fan of faces, which collapses are possible, and which is the best.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "stimuli/meshes/decimation/batches.h"
#include "stimuli/meshes/decimation/best_collapse.h"
#include "stimuli/meshes/decimation/closed_surface.h"
#include "stimuli/meshes/decimation/collapse_fan.h"
#include "stimuli/meshes/decimation/vertex_past.h"
#include "stimuli/meshes/surface_search.h"
#include "tests/stimuli/made_mesh.h"

namespace asperity::decimation {
namespace {

using test::box;
using test::bumpy_ball;
using test::is_closed;
using test::smooth_ball;

std::vector<std::uint32_t> neighbours_of(const ClosedSurface& surface, std::uint32_t vertex) {
  std::vector<std::uint32_t> result{};
  std::uint32_t half = surface.half_of(vertex);
  do {
    result.push_back(surface.to(half));
    half = surface.turned(half);
  } while (half != surface.half_of(vertex));
  return result;
}

TEST(CollapseFan, IsAsFarFromAPlaceAsItsNearestTriangle) {
  Random random(7);
  const auto place = [&random] {
    glm::dvec3 at{};
    for (int axis = 0; axis < 3; ++axis) at[axis] = random.uniform() - 0.5;
    return at;
  };
  CollapseFan fan{};
  for (int trial = 0; trial < 300; ++trial) {
    const glm::dvec3 apex = place();
    std::vector<glm::dvec3> ring(3 + static_cast<std::size_t>(trial % 5));
    fan.begin(apex);
    for (glm::dvec3& point : ring) {
      point = place();
      fan.add(point);
    }
    ASSERT_EQ(fan.faces(), ring.size() - 1);
    for (int sample = 0; sample < 20; ++sample) {
      const glm::dvec3 at = 2.0 * place();
      double least = std::numeric_limits<double>::infinity();
      std::vector<double> of_face{};
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const glm::dvec3 b = nearest_in_triangle({apex, ring[i], ring[i + 1]}, at);
        of_face.push_back(glm::distance(b.x * apex + b.y * ring[i] + b.z * ring[i + 1], at));
        least = std::min(least, of_face.back());
      }
      const CollapseFan::Nearest found = fan.nearest(at);
      EXPECT_NEAR(std::sqrt(found.squared_distance), least, 1e-7);
      ASSERT_LT(found.face, of_face.size());
      EXPECT_NEAR(of_face[found.face], least, 1e-7);
      const std::array<glm::dvec3, 3> corners{apex, ring[found.face], ring[found.face + 1]};
      const double nearest_m = glm::distance(at, corners[fan.nearest_corner(found.face)]);
      for (const glm::dvec3& corner : corners)
        EXPECT_LE(nearest_m, glm::distance(at, corner) + 1e-12);
    }
  }
}

TEST(ClosedSurface, RemainsClosedAsLongAsCollapsesArePossibleAndEndsAsATetrahedron) {
  const TriangleMesh mesh = smooth_ball(3, 0.02);
  ClosedSurface surface(mesh);
  EXPECT_EQ(surface.first_fault(), std::nullopt);
  std::size_t before = mesh.triangles.size();
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (std::uint32_t vertex = 0; vertex < surface.vertices(); ++vertex) {
      if (!surface.exists(vertex)) continue;
      const std::vector<std::uint32_t> neighbours = neighbours_of(surface, vertex);
      std::uint32_t half = surface.half_of(vertex);
      std::size_t tried = 0;
      while (tried < neighbours.size() && !surface.can_collapse(half, neighbours)) {
        half = surface.turned(half);
        ++tried;
      }
      if (tried == neighbours.size()) continue;
      surface.collapse(half);
      is_changed = true;
      before -= 2;
      ASSERT_EQ(surface.triangles(), before);
      const ClosedSurface::Remaining remaining = surface.remaining();
      ASSERT_EQ(remaining.mesh.triangles.size(), before);
      ASSERT_TRUE(is_closed(remaining.mesh));
      ASSERT_EQ(ClosedSurface(remaining.mesh).first_fault(), std::nullopt);
    }
  }
  EXPECT_EQ(surface.triangles(), 4U);
}

TEST(ClosedSurface, ReportsAnOpenEdgeAndTwoFansAtOneVertex) {
  TriangleMesh open = smooth_ball(1, 0.02);
  open.triangles.pop_back();
  EXPECT_TRUE(ClosedSurface(open).first_fault().has_value());
  TriangleMesh touching = box({0.01, 0.01, 0.01});
  const auto first = static_cast<std::uint32_t>(touching.vertices_m.size());
  const TriangleMesh other = box({0.01, 0.01, 0.01}, {0.02, 0.02, 0.02});
  touching.vertices_m.insert(touching.vertices_m.end(), other.vertices_m.begin(),
                             other.vertices_m.end());
  for (auto [a, b, c] : other.triangles)
    touching.triangles.push_back({a + first, b + first, c + first});
  EXPECT_EQ(ClosedSurface(touching).first_fault(), std::nullopt);
  for (auto& triangle : touching.triangles)
    std::replace(triangle.begin(), triangle.end(), first, 0U);
  EXPECT_EQ(ClosedSurface(touching).first_fault(), 0U);
}

/// The pasts of a mesh with the planes of its faces and one sample at each vertex.
std::vector<VertexPast> pasts_of(const TriangleMesh& mesh) {
  std::vector<VertexPast> pasts(mesh.vertices_m.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 front = glm::cross(mesh.vertices_m[b] - mesh.vertices_m[a],
                                        mesh.vertices_m[c] - mesh.vertices_m[a]);
    for (const std::uint32_t corner : {a, b, c}) {
      pasts[corner].quadric +=
          Quadric(glm::normalize(front), mesh.vertices_m[a], glm::length(front));
      pasts[corner].normal += front;
    }
  }
  for (std::size_t i = 0; i < pasts.size(); ++i) {
    pasts[i].normal = glm::normalize(pasts[i].normal);
    pasts[i].deviation = pasts[i].quadric.at(mesh.vertices_m[i]);
    pasts[i].samples.push_back({.place = mesh.vertices_m[i], .area = 1.0});
  }
  return pasts;
}

// The search abandons most candidates early. Here every one is computed in full, with the formula of mesh_decimation.h.
TEST(CollapseChoice, FindsTheCheapestOfAllNeighbours) {
  TriangleMesh mesh = bumpy_ball(3, 1.0, 0.05, 9.0);
  // Without symmetries, for which two neighbours would be equally good.
  for (glm::dvec3& at : mesh.vertices_m)
    at *= 1.0 + 0.01 * std::sin(37.0 * at.x + 91.0 * at.y + 53.0 * at.z);
  const ClosedSurface surface(mesh);
  const std::vector<VertexPast> pasts = pasts_of(mesh);
  CollapseChoice choice(surface, pasts);
  const Permission all{.strictness = Strictness::flip_only, .furthest = 10.0};
  for (std::uint32_t vertex = 0; vertex < mesh.vertices_m.size(); ++vertex) {
    const std::vector<std::uint32_t> ring = neighbours_of(surface, vertex);
    const glm::dvec3 at = mesh.vertices_m[vertex];
    Collapse expected{};
    for (std::size_t kept = 0; kept < ring.size(); ++kept) {
      const glm::dvec3 to = mesh.vertices_m[ring[kept]];
      double nearest = std::numeric_limits<double>::infinity();
      bool is_flipped = false;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = (i + 1) % ring.size();
        if (i == kept || next == kept) continue;
        const glm::dvec3 one = mesh.vertices_m[ring[i]];
        const glm::dvec3 other = mesh.vertices_m[ring[next]];
        is_flipped = is_flipped || glm::dot(glm::cross(one - at, other - at),
                                            glm::cross(one - to, other - to)) <= 0.0;
        const glm::dvec3 b = nearest_in_triangle({to, one, other}, at);
        nearest = std::min(nearest, glm::distance(at, b.x * to + b.y * one + b.z * other));
      }
      if (is_flipped) continue;
      const double length = glm::distance(at, to);
      const double cost = nearest * nearest +
                          0.1 * (pasts[vertex].quadric.at(to) + pasts[ring[kept]].quadric.at(to)) +
                          1e-6 * std::pow(length, 4.0);
      if (cost < expected.cost) expected = {.cost = cost, .half = ring[kept]};
    }
    const Collapse found = choice.best_of(vertex, all);
    ASSERT_NE(found.half, kNoHalfEdge);
    EXPECT_EQ(surface.from(found.half), vertex);
    EXPECT_EQ(surface.to(found.half), expected.half);
    EXPECT_NEAR(found.cost, expected.cost, 1e-12);
  }
}

TEST(CollapseChoice, PermitsNothingThatMovesASampleTooFar) {
  const TriangleMesh mesh = smooth_ball(2, 1.0);
  const ClosedSurface surface(mesh);
  const std::vector<VertexPast> pasts = pasts_of(mesh);
  CollapseChoice choice(surface, pasts);
  EXPECT_EQ(choice.best_of(0, {Strictness::flip_only, 1e-3}).half, kNoHalfEdge);
  EXPECT_NE(choice.best_of(0, {Strictness::flip_only, 1.0}).half, kNoHalfEdge);
}

// A sample belongs to a corner of the face that is nearest to it, so hardly any vertex is nearer.
TEST(Batches, GiveTheSamplesToVerticesNearby) {
  const TriangleMesh mesh = bumpy_ball(4, 0.5, 0.02, 9.0);
  ClosedSurface surface(mesh);
  std::vector<VertexPast> pasts = pasts_of(mesh);
  Batches batches(surface, pasts, 1);
  std::size_t calls = 0;
  batches.run(300, {Strictness::turn_and_shape, 0.1}, [&calls] { ++calls; });
  EXPECT_EQ(surface.triangles(), 300U);
  EXPECT_GT(calls, 100U);
  double squared_distances = 0.0;
  double squared_least = 0.0;
  double area = 0.0;
  for (std::uint32_t vertex = 0; vertex < pasts.size(); ++vertex) {
    for (const Sample& sample : pasts[vertex].samples) {
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t other = 0; other < pasts.size(); ++other) {
        if (!surface.exists(other)) continue;
        least = std::min(least, glm::distance(surface.point(other), sample.place));
      }
      ASSERT_TRUE(surface.exists(vertex));
      squared_distances += std::pow(glm::distance(surface.point(vertex), sample.place), 2);
      squared_least += least * least;
      area += sample.area;
    }
  }
  EXPECT_EQ(area, static_cast<double>(mesh.vertices_m.size()));
  EXPECT_LT(squared_distances, 1.2 * squared_least);
}

TEST(VertexPast, HalvesItsSamplesWithoutLosingArea) {
  VertexPast past{};
  for (int i = 0; i < 100; ++i) {
    keep_sample(past, {.place = {double(i), 0.0, 0.0}, .area = 1.0});
    EXPECT_LE(past.samples.size(), 32U);
  }
  EXPECT_EQ(std::accumulate(past.samples.begin(), past.samples.end(), 0.0,
                            [](double sum, const Sample& sample) { return sum + sample.area; }),
            100.0);
}

}  // namespace
}  // namespace asperity::decimation
