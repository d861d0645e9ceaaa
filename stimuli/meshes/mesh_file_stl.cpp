// Implements the reader of STL, as text and as binary.

#include <array>
#include <bit>
#include <cstring>

#include "stimuli/meshes/mesh_decoding.h"

namespace asperity {

namespace {

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
  return word;
}

}  // namespace

std::uint32_t binary_stl_triangles(std::string_view content) {
  return little_endian(content.data() + 80);
}

ReadMesh decode_stl_binary(std::string_view content, const MeshReading& reading,
                           const std::string& name) {
  GrowingMesh mesh(reading, name);
  const std::size_t triangles = binary_stl_triangles(content);
  mesh.reserve(3 * triangles, triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    // A record has a normal of 12 bytes, which is ignored in favour of the corners; three corners; two bytes of any
    // content.
    const char* corner = content.data() + binary_stl_bytes(i) + 12;
    std::array<std::int64_t, 3> indices{};
    for (std::int64_t& index : indices) {
      index = static_cast<std::int64_t>(mesh.vertices());
      glm::dvec3 point{};
      for (int axis = 0; axis < 3; ++axis, corner += 4) {
        point[axis] = static_cast<double>(std::bit_cast<float>(little_endian(corner)));
      }
      mesh.add_vertex(point);
    }
    mesh.add_face(indices);
  }
  return mesh.finish(MeshFormat::stl_binary);
}

ReadMesh decode_stl_ascii(std::string_view content, const MeshReading& reading,
                          const std::string& name) {
  MeshText text(content, name);
  GrowingMesh mesh(reading, name);
  std::vector<std::int64_t> corners{};
  bool in_facet = false;
  bool ended = false;
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "vertex") {
      if (!in_facet) text.refuse("a vertex is outside a facet.");
      glm::dvec3 point{};
      for (int axis = 0; axis < 3; ++axis) point[axis] = text.number_in(text.word());
      corners.push_back(static_cast<std::int64_t>(mesh.vertices()));
      mesh.add_vertex(point);
    } else if (keyword == "facet") {
      in_facet = true;
      corners.clear();
    } else if (keyword == "endfacet") {
      if (corners.size() < 3) text.refuse("a facet ends with fewer than three vertices.");
      mesh.add_face(corners);
      in_facet = false;
    } else if (keyword == "solid" || keyword == "endsolid") {
      ended = keyword == "endsolid";
    } else if (!keyword.empty() && keyword != "outer" && keyword != "endloop") {
      text.refuse('"' + std::string(keyword.substr(0, 40)) + "\" is not a keyword of STL.");
    }
  }
  if (in_facet || !ended) text.refuse("the file ends without endsolid.");
  return mesh.finish(MeshFormat::stl_ascii);
}

}  // namespace asperity
