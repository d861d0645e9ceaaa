// A textured mesh comes back from its file as it was, or not at all.

#include "stimuli/meshes/textured_mesh_file.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/sha.h>

#include "stimuli/meshes/mesh_decimation.h"
#include "stimuli/meshes/texture_baking.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/support/refusal.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

StoredTexturedMesh made() {
  const TriangleMesh original = bumpy_ball(3, 0.02, 0.0005, 9.0);
  BakedMesh baked =
      bake_texture(original, decimate_mesh(original, 60, "thing").mesh, {.error_samples = 100}, {});
  return {std::move(baked.mesh),
          baked.report.plain,
          baked.report.textured,
          {"ball \"1\".obj", std::string(64, 'a'), 0.001, 512, {"Holes closed: 2."}, "0.0"}};
}

std::string text_of(const StoredTexturedMesh& stored) {
  const std::vector<std::byte> bytes = encode_textured_mesh(stored);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

StoredTexturedMesh read_back(const std::string& content) {
  return decode_textured_mesh(std::as_bytes(std::span(content.data(), content.size())), "thing");
}

std::string refusal_of_file(const std::string& content) {
  return refusal_of<std::invalid_argument>([&] { read_back(content); });
}

std::string refusal_of_changed(const std::function<void(StoredTexturedMesh&)>& change) {
  StoredTexturedMesh stored = made();
  change(stored);
  return refusal_of_file(text_of(stored));
}

TEST(TexturedMeshFile, GivesBackEveryBit) {
  const StoredTexturedMesh stored = made();
  const StoredTexturedMesh back = read_back(text_of(stored));
  EXPECT_TRUE(back.mesh.vertices_m == stored.mesh.vertices_m);
  EXPECT_TRUE(back.mesh.normals == stored.mesh.normals);
  EXPECT_TRUE(back.mesh.triangles == stored.mesh.triangles);
  EXPECT_TRUE(back.mesh.places == stored.mesh.places);
  EXPECT_EQ(back.mesh.atlas.rows, stored.mesh.atlas.rows);
  EXPECT_EQ(back.mesh.atlas.columns, stored.mesh.atlas.columns);
  EXPECT_EQ(back.mesh.atlas.step_m, stored.mesh.atlas.step_m);
  EXPECT_TRUE(back.mesh.atlas.values == stored.mesh.atlas.values);
  EXPECT_EQ(back.plain.rms_m, stored.plain.rms_m);
  EXPECT_EQ(back.textured.max_m, stored.textured.max_m);
  EXPECT_EQ(back.provenance.source_name, stored.provenance.source_name);
  EXPECT_EQ(back.provenance.source_unit_m, 0.001);
  EXPECT_EQ(back.provenance.source_triangles, 512U);
  EXPECT_EQ(back.provenance.findings, stored.provenance.findings);
}

TEST(TexturedMeshFile, IsTheSameForTheSameMesh) { EXPECT_EQ(text_of(made()), text_of(made())); }

TEST(TexturedMeshFile, IsRefusedWhereverItIsDamaged) {
  const std::string good = text_of(made());
  for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 400) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_THAT(refusal_of_file(damaged), testing::StartsWith("thing ")) << "byte " << at;
  }
}

TEST(TexturedMeshFile, IsRefusedWhereverItIsCutOff) {
  const std::string good = text_of(made());
  for (std::size_t length = 0; length < good.size(); length += 1 + good.size() / 200) {
    EXPECT_THAT(refusal_of_file(good.substr(0, length)), testing::StartsWith("thing ")) << length;
  }
  EXPECT_THAT(refusal_of_file(good.substr(0, good.size() - 1)), HasSubstr("truncated"));
  EXPECT_THAT(refusal_of_file(good + "x"), HasSubstr("has data after its end"));
}

TEST(TexturedMeshFile, OfAnotherKindOrVersionIsRefused) {
  EXPECT_THAT(refusal_of_file("v 0 0 0\n"), HasSubstr("not a textured mesh"));
  EXPECT_THAT(refusal_of_file("{}\n"), HasSubstr("not a textured mesh"));
  std::string newer = text_of(made());
  newer.replace(newer.find("mesh/1"), 6, "mesh/2");
  EXPECT_THAT(refusal_of_file(newer), HasSubstr("asperity.textured_mesh/2"));
}

TEST(TexturedMeshFile, WithTheTextureOfAnotherMeshIsRefused) {
  StoredTexturedMesh other = made();
  for (glm::dvec3& vertex : other.mesh.vertices_m) vertex *= 2.0;
  const std::string one = text_of(made());
  const std::string another = text_of(other);
  const std::string mixed =
      one.substr(0, one.find('\n') + 66) + another.substr(another.find('\n') + 66);
  EXPECT_THAT(refusal_of_file(mixed), testing::StartsWith("thing "));
  // With the right digest it still is no texture of this mesh: it has other faces.
  BakedMesh coarse = bake_texture(bumpy_ball(3, 0.02, 0.0005, 9.0),
                                  decimate_mesh(bumpy_ball(3, 0.02, 0.0005, 9.0), 40, "thing").mesh,
                                  {.error_samples = 100}, {});
  EXPECT_THAT(refusal_of_changed([&coarse](auto& stored) {
                stored.mesh.atlas = coarse.mesh.atlas;
                stored.mesh.places = coarse.mesh.places;
              }),
              HasSubstr("one place in its atlas"));
}

// With the right digest, since anybody can write one.
TEST(TexturedMeshFile, ThatSaysWhatCannotBeIsRefused) {
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.triangles[3][1] = 99999; }),
              HasSubstr("vertex that does not exist"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.places[3][1].x = 1e6; }),
              HasSubstr("outside the atlas"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.places[3][1].y = std::nan(""); }),
              HasSubstr("outside the atlas"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.vertices_m[2].z = std::nan(""); }),
              HasSubstr("vertex 2 with z = not a number;"));
  EXPECT_THAT(
      refusal_of_changed([](auto& s) { s.mesh.normals[2] *= 2.0; }),
      HasSubstr("has a normal at vertex 2 that is not of unit length. Make the mesh again"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.normals.pop_back(); }),
              HasSubstr("one normal for each vertex"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.places.pop_back(); }),
              HasSubstr("one place in its atlas"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.atlas.rows += 1; }),
              HasSubstr("rows and columns"));
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.atlas.step_m = -1.0; }), HasSubstr("step"));
  EXPECT_THAT(refusal_of_changed([](auto& s) {
                s.mesh.triangles.clear();
                s.mesh.places.clear();
              }),
              HasSubstr("no triangles"));
}

// Finite numbers that no single precision can multiply, and lengths that nothing to be felt has.
TEST(TexturedMeshFile, WithAVertexOrADisplacementFarAwayIsRefused) {
  for (const double far_m : {1e300, -1e300, 1e20, 20.001}) {
    EXPECT_THAT(refusal_of_changed([far_m](auto& s) { s.mesh.vertices_m[2].y = far_m; }),
                testing::AllOf(testing::StartsWith("thing has vertex 2 with y = "),
                               HasSubstr("between -20 m and 20 m"), HasSubstr("asperity bake")))
        << far_m;
  }
  EXPECT_THAT(refusal_of_changed([](auto& s) { s.mesh.atlas.step_m = 0.5; }),
              testing::AllOf(HasSubstr("step_m 0.5"), HasSubstr("at most 20 m"),
                             HasSubstr("asperity bake")));
  EXPECT_NO_THROW(read_back(text_of([] {
    StoredTexturedMesh far = made();
    far.mesh.vertices_m[2].y = -20.0;
    far.mesh.atlas.step_m = 20.0 / 32768.0;
    return far;
  }())));
}

std::string sha256_in_hex(const std::string& content) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(content.data()), content.size(), digest);
  std::string hex;
  for (const unsigned char byte : digest) {
    constexpr const char* kHex = "0123456789abcdef";
    hex += {kHex[byte >> 4], kHex[byte & 15]};
  }
  return hex;
}

// The header of a good file, with another number of items and its own digest.
std::string with_count(const std::string& array, const std::string& count) {
  const std::string good = text_of(made());
  std::string header = good.substr(0, good.find('\n'));
  const std::size_t at = header.find("\"count\":", header.find("\"name\":\"" + array + "\"")) + 8;
  header.replace(at, header.find(',', at) - at, count);
  const std::string payload = good.substr(good.find('\n') + 66);
  return header + '\n' + sha256_in_hex(header + payload) + '\n' + payload;
}

TEST(TexturedMeshFile, WhoseHeaderAnnouncesMoreThanItHoldsIsRefusedBeforeAnyMemoryIsTaken) {
  for (const char* array : {"vertices_m", "normals", "triangles", "places", "atlas"}) {
    for (const char* count : {"2147483648", "6442450944"}) {
      EXPECT_THAT(refusal_of_file(with_count(array, count)),
                  testing::AllOf(testing::StartsWith("thing "), HasSubstr(array),
                                 HasSubstr("number of items stated, " + std::string(count))))
          << array;
    }
  }
}

}  // namespace
}  // namespace asperity::test
