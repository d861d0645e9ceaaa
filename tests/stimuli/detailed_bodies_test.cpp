// The bodies of benchmarks: their sizes, and that each is a closed body.

#include "stimuli/meshes/detailed_bodies.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "stimuli/meshes/mesh_repair.h"

namespace asperity {
namespace {

TEST(DetailedBodies, AreClosedAndHaveTheOrderedNumberOfTriangles) {
  for (const DetailedBody& body : detailed_bodies()) {
    SCOPED_TRACE(body.name);
    const TriangleMesh mesh = make_detailed_body(body.name, 20'000);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 20'000.0, 2000.0);
    const RepairedMesh repaired = repair_mesh(mesh, {}, "body");
    MeshFindings found = repaired.found;
    found.parts = 1;  // balls and the teeth of a comb are several
    EXPECT_TRUE(sentences_of(found).empty());
    EXPECT_EQ(repaired.mesh.triangles.size(), mesh.triangles.size());
  }
}

// [Otaduy 2004] states 433 K, 285 K and 658 K triangles, simplified to 518, 632 and 720.
TEST(DetailedBodies, HaveThePublishedSizes) {
  const auto thousands = [](std::string_view name) {
    for (const DetailedBody& body : detailed_bodies()) {
      if (body.name != name) continue;
      const auto mesh = make_detailed_body(name, body.triangles);
      return std::lround(static_cast<double>(mesh.triangles.size()) / 1000.0);
    }
    return 0L;
  };
  EXPECT_EQ(thousands("hammer"), 433);
  EXPECT_EQ(thousands("file"), 285);
  EXPECT_EQ(thousands("part"), 658);
  const auto simplified = [](std::string_view name) -> std::size_t {
    for (const DetailedBody& body : detailed_bodies()) {
      if (body.name == name) return body.simplified;
    }
    return 0;
  };
  EXPECT_EQ(simplified("hammer"), 518U);
  EXPECT_EQ(simplified("file"), 632U);
  EXPECT_EQ(simplified("part"), 720U);
}

TEST(DetailedBodies, RefuseAnUnknownNameAndTooFewTriangles) {
  EXPECT_THROW(make_detailed_body("anvil", 20'000), std::invalid_argument);
  EXPECT_THROW(make_detailed_body("ball", 999), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
