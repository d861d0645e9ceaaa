// Mesh files: what is in them is what is read, and what is wrong is said.

#include "stimuli/meshes/mesh_file.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <sstream>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/stimuli/made_mesh.h"
#include "tests/stimuli/mesh_text.h"
#include "tests/support/refusal.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr MeshReading kMetres{.unit_m = 1.0};

ReadMesh read(const std::string& content, const std::string& name = "thing",
              const MeshReading& reading = kMetres) {
  return decode_mesh(bytes_of(content), reading, name);
}

/// The sentence with which it is refused.
std::string refusal(const std::string& content, const MeshReading& reading = kMetres) {
  return refusal_of<std::invalid_argument>([&] { read(content, "thing", reading); });
}

/// Coordinates that no float holds.
TriangleMesh precise() {
  TriangleMesh mesh = box({0.012345678901234567, 0.0234567890123456789, 0.03456789012345678});
  mesh.vertices_m[3].y += 1e-15;
  return mesh;
}

void expect_same(const TriangleMesh& found, const TriangleMesh& expected) {
  EXPECT_EQ(found.triangles, expected.triangles);
  ASSERT_EQ(found.vertices_m.size(), expected.vertices_m.size());
  for (std::size_t i = 0; i < expected.vertices_m.size(); ++i) {
    EXPECT_EQ(found.vertices_m[i], expected.vertices_m[i]) << i;
  }
}

/// Corner by corner, for STL, which has no shared vertices.
void expect_same_corners(const TriangleMesh& found, const TriangleMesh& expected) {
  ASSERT_EQ(found.triangles.size(), expected.triangles.size());
  for (std::size_t i = 0; i < expected.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(found.vertices_m[found.triangles[i][corner]],
                expected.vertices_m[expected.triangles[i][corner]]);
    }
  }
}

TEST(MeshFile, KeepsEveryDigitOfObjPlyAndOff) {
  const TriangleMesh mesh = precise();
  expect_same(read(obj_of(mesh)).mesh, mesh);
  expect_same(read(off_of(mesh)).mesh, mesh);
  expect_same(read(ply_of(mesh)).mesh, mesh);
  expect_same(read(binary_ply_of(mesh, std::endian::little)).mesh, mesh);
  expect_same(read(binary_ply_of(mesh, std::endian::big)).mesh, mesh);
}

TEST(MeshFile, KeepsEveryDigitOfStlAsText) {
  expect_same_corners(read(stl_of(precise())).mesh, precise());
}

TEST(MeshFile, KeepsTheFloatsOfBinaryStl) {
  TriangleMesh mesh = precise();
  for (glm::dvec3& vertex : mesh.vertices_m) {
    for (int axis = 0; axis < 3; ++axis) {
      vertex[axis] = static_cast<double>(static_cast<float>(vertex[axis]));
    }
  }
  expect_same_corners(read(binary_stl_of(mesh)).mesh, mesh);
}

// Why the readers are our own: those of OpenMesh go through float, into a mesh of doubles too.
TEST(MeshFile, ReadByOpenMeshWouldLoseDigits) {
  struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
  };
  const TriangleMesh mesh = precise();
  std::string off = off_of(mesh);
  off.erase(off.find('#'),
            off.find('\n', off.find('#')) - off.find('#') + 1);  // it takes no comments
  for (const auto& [content, extension] :
       {std::pair{obj_of(mesh), ".OBJ"}, std::pair{off, ".OFF"}, std::pair{ply_of(mesh), ".PLY"}}) {
    OpenMesh::TriMesh_ArrayKernelT<Traits> other{};
    std::istringstream stream(content);
    OpenMesh::IO::Options options{};
    ASSERT_TRUE(OpenMesh::IO::read_mesh(other, stream, extension, options)) << extension;
    ASSERT_EQ(other.n_vertices(), 8U) << extension;
    const double x = other.point(other.vertex_handle(1))[0];
    EXPECT_NE(x, mesh.vertices_m[1].x) << extension << " has become exact: ours may go";
    EXPECT_NEAR(x, mesh.vertices_m[1].x, 1e-6) << extension;
  }
}

TEST(MeshFile, SaysWhatItIsAndTurnsUnitsIntoMetres) {
  const TriangleMesh mesh = box({10.0, 20.0, 30.0});
  const std::pair<std::string, MeshFormat> all[] = {
      {obj_of(mesh), MeshFormat::obj},
      {off_of(mesh), MeshFormat::off},
      {ply_of(mesh), MeshFormat::ply_ascii},
      {binary_ply_of(mesh, std::endian::big), MeshFormat::ply_binary},
      {stl_of(mesh), MeshFormat::stl_ascii},
      {binary_stl_of(mesh), MeshFormat::stl_binary}};
  for (const auto& [content, format] : all) {
    const ReadMesh found = read(content, "thing", {});
    EXPECT_EQ(found.format, format) << name_of(format);
    EXPECT_NEAR(found.mesh.vertices_m[0].y, -0.020, 1e-9) << name_of(format);
    EXPECT_NEAR(volume_m3(found.mesh), 8.0 * 0.01 * 0.02 * 0.03, 1e-10) << name_of(format);
    EXPECT_TRUE(found.notes.empty());
  }
}

TEST(MeshFile, IsToldByItsContentAndNotByItsName) {
  const ReadMesh found = read(off_of(precise()), "folder.x/thing.STL");
  EXPECT_EQ(found.format, MeshFormat::off);
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_THAT(found.notes[0], AllOf(HasSubstr("stl"), HasSubstr("OFF")));
}

TEST(MeshFile, OfBinaryStlMayBeginLikeText) {
  const ReadMesh found = read(binary_stl_of(precise(), "solid made by a program"));
  EXPECT_EQ(found.format, MeshFormat::stl_binary);
  EXPECT_EQ(found.mesh.triangles.size(), 12U);
}

TEST(MeshFile, OfObjHasPolygonsAndIndicesThatCountBack) {
  const ReadMesh found = read(
      "v 0 0 0 1 0 0\nv 1 0 0\r\nv 1 1 0 # here\nv +0 1 0\nvt 0 0\nvn 0 0 1\nf -4/1/1 -3//1 -2 \\\n"
      " -1\nusemtl red\nf 1 2\nl 1 2\n");
  EXPECT_EQ(found.mesh.triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(found.mesh.vertices_m[3], (glm::dvec3{0, 1, 0}));
  EXPECT_EQ(found.notes, (std::vector<std::string>{
                             "Faces with more than three vertices, divided into triangles: 1.",
                             "Faces left out because they had fewer than three vertices: 1."}));
}

TEST(MeshFile, HasAByteOrderMarkAndAnyLineEnds) {
  const TriangleMesh mesh = precise();
  std::string with_cr = obj_of(mesh);
  std::replace(with_cr.begin(), with_cr.end(), '\n', '\r');
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string& text :
       {mark + obj_of(mesh), mark + obj_of(mesh).substr(obj_of(mesh).find("v ")), with_cr,
        mark + off_of(mesh), mark + ply_of(mesh)}) {
    expect_same(read(text).mesh, mesh);
  }
  expect_same_corners(read(mark + stl_of(mesh)).mesh, mesh);
}

// The body begins with 0x0A, a line feed: the x of the first vertex is that of a box of this size.
TEST(MeshFile, OfBinaryPlyHasAHeaderWhoseLinesEndWithCarriageReturns) {
  TriangleMesh mesh = precise();
  mesh.vertices_m[0].x = std::bit_cast<double>(0x3F8111111111110AULL);
  std::string content = binary_ply_of(mesh, std::endian::little);
  const std::size_t body = content.find("end_header\n") + 11;
  ASSERT_EQ(content[body], '\n');
  std::replace(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(body), '\n', '\r');
  expect_same(read(content).mesh, mesh);
}

TEST(MeshFile, OfObjHasLinesWithoutTriangles) {
  const ReadMesh found = read(
      "mtllib a.mtl\no thing\ng one \\\n two\nv 0 0 0\nv 1 0 0\nv 0 1 0\ncstype bezier\ndeg 3\n"
      "curv 0 1 1 2 \\\n3 1\nparm u 0 1\nend\ns off\nfo 1 2 3\n#MRGB ff\n");
  EXPECT_EQ(found.mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
}

TEST(MeshFile, OfObjHasNoUnknownLines) {
  EXPECT_EQ(
      refusal("v 0 0 0\nv 1 0 0\nvertex 0 1 0\nv 0 1 0\nf 1 2 3\n"),
      "thing:3: \"vertex\" is not a keyword of OBJ. Delete the line, or export the mesh again.");
}

TEST(MeshFile, NamesACharacterThatIsNotSeen) {
  EXPECT_EQ(
      refusal("v 0 0 0\n\xE2\x80\x8Bv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
      "thing:2: \"???v\" is not a keyword of OBJ. There is a zero-width space (U+200B); delete "
      "it.");
  EXPECT_EQ(refusal("v 0 0 \xE2\x88\x92"
                    "1\n"),
            "thing:1: \"???1\" is not a number; a number is expected here. There is a minus sign "
            "(U+2212); write a hyphen (-) instead.");
}

TEST(MeshFile, OfPlyHasStrips) {
  const ReadMesh found = read(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n");
  EXPECT_EQ(found.mesh.triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  EXPECT_EQ(found.notes, std::vector<std::string>{"Triangle strips divided into triangles: 2."});
}

TEST(MeshFile, OfPlyHasElementsThatAreNoneOfOurs) {
  const ReadMesh found = read(
      "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float f\nproperty list uchar "
      "float d\n"
      "element vertex 3\nproperty float nx\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty uchar flag\nproperty list uchar uint vertex_index\nend_header\n"
      "1.5 2 7 8\n9 0 0 0\n9 1 0 0\n9 0 1 0\n4 3 0 1 2\n");
  EXPECT_EQ(found.mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(found.mesh.vertices_m[1], (glm::dvec3{1, 0, 0}));
}

TEST(MeshFile, OfOffHasColoursAndNormals) {
  const ReadMesh found =
      read("# first\nNOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n\n0 1 0 0 0 1\n3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_EQ(found.mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
}

TEST(MeshFile, ThatIsWrongIsRefusedInASentence) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::tuple<std::string, std::string, std::vector<std::string>> all[] = {
      {"empty", "", {"empty"}},
      {"blank", "\n\n", {"in none of the formats OBJ, PLY, STL and OFF"}},
      {"prose", "It was a dark night.\n", {"in none of the formats OBJ, PLY, STL and OFF"}},
      {"zeros",
       std::string(500, '\0'),
       {"none of", "0 triangles, for which the file needs 84 bytes", "500"}},
      {"points", "v 0 0 0\nv 1 0 0\n", {"2 vertices and no faces"}},
      {"word", "v 0 0 zero\n", {"thing:1", "\"zero\"", "number"}},
      {"short line", "v 0 0\n", {"thing:1", "ends"}},
      {"no such vertex",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
       {"to vertex 4;", "the last vertex is number 3"}},
      {"vertex 0", "v 0 0 0\nf 0 1 1\n", {"thing:2", "first vertex is number 1"}},
      {"too far back", "v 0 0 0\nf -1 -2 -1\n", {"thing:2", "-2", "only 1"}},
      {"half an index", "v 0 0 0\nf 1.5 1 1\n", {"thing:2", "\"1.5\"", "whole number"}},
      {"off truncated", off, {"states 1 as the number of faces but ends after 0."}},
      {"off promises", "OFF\n99999999999 1 0\n0 0 0\n", {"thing:2", "too short"}},
      {"off of four", "4OFF\n", {"4OFF", "dimensions"}},
      {"off binary", "OFF BINARY\n", {"binary OFF"}},
      {"off negative", off + "3 0 1 -2\n", {"-2"}},
      {"ply format", "ply\nformat ebcdic 1.0\n", {"ebcdic"}},
      {"ply header", "ply\nformat ascii 1.0\nelement vertex 3\n", {"within its header"}},
      {"ply type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", {"half"}},
      {"ply truncated",
       ply + "0 0 0\n1 0 0\n0 1\n",
       {"truncated", "states 3 as the number of \"vertex\"", "contains 2."}},
      {"ply faces truncated", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n", {"truncated", "face"}},
      {"ply list", ply + "0 0 0\n1 0 0\n0 1 0\n99999 0 1\n", {"list", "face 1"}},
      {"ply fraction", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", {"face 1"}},
      {"ply promises",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
       "property float y\nproperty float z\nend_header\n",
       {"truncated", "4000000000"}},
      {"ply without z",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 "
       "0\n",
       {"x, y and z"}},
      {"stl truncated", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", {"endsolid"}},
      {"stl short facet",
       "solid x\nfacet\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n",
       {"thing:6", "three vertices"}},
      {"stl word", "solid x\nfacette\n", {"thing:2", "facette"}},
      {"stl empty", "solid x\nendsolid x\n", {"no vertices"}}};
  for (const auto& [what, content, words] : all) {
    const std::string sentence = refusal(content);
    EXPECT_THAT(sentence, testing::StartsWith("thing")) << what;
    for (const std::string& word : words) EXPECT_THAT(sentence, HasSubstr(word)) << what;
  }
}

TEST(MeshFile, IsRefusedWithMoreTrianglesThanItMayHave) {
  const MeshReading reading{.unit_m = 1.0, .most_triangles = 11};
  for (const std::string& content : {obj_of(precise()), stl_of(precise()), ply_of(precise()),
                                     off_of(precise()), binary_stl_of(precise())}) {
    EXPECT_THAT(refusal(content, reading), HasSubstr("more than 11 triangles"));
  }
}

TEST(MeshFile, NeedsAUnitThatIsALength) {
  for (const double unit_m : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(refusal(obj_of(precise()), {.unit_m = unit_m}), HasSubstr("unit"));
  }
}

// Whatever a disk or a network leaves of a file: it is read or refused, and nothing else happens.
TEST(MeshFile, ThatIsTornOrGarbledIsReadOrRefused) {
  const TriangleMesh mesh = box({0.01, 0.02, 0.03});
  std::size_t refused = 0;
  std::size_t tried = 0;
  for (const std::string& content :
       {obj_of(mesh), off_of(mesh), ply_of(mesh), binary_ply_of(mesh, std::endian::little),
        stl_of(mesh), binary_stl_of(mesh)}) {
    for (std::size_t length = 0; length < content.size(); length += 3) {
      ++tried;
      refused += refusal(content.substr(0, length)).empty() ? 0U : 1U;
    }
    for (std::size_t at = 0; at < content.size(); at += 5) {
      std::string garbled = content;
      garbled[at] = static_cast<char>(garbled[at] ^ 0x55);
      ++tried;
      refusal(garbled);
    }
  }
  EXPECT_GT(refused, tried / 4);
}

}  // namespace
}  // namespace asperity::test
