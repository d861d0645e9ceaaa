// Meshes written as files, for tests of what reads them.

#pragma once

#include <bit>
#include <cstring>
#include <span>
#include <string>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity::test {

inline std::span<const std::byte> bytes_of(const std::string& content) {
  return std::as_bytes(std::span(content.data(), content.size()));
}

inline std::string line_of(const glm::dvec3& point) {
  return number_text(point.x) + ' ' + number_text(point.y) + ' ' + number_text(point.z);
}

inline std::string line_of(const std::array<std::uint32_t, 3>& triangle, std::uint32_t first) {
  return std::to_string(triangle[0] + first) + ' ' + std::to_string(triangle[1] + first) + ' ' +
         std::to_string(triangle[2] + first);
}

inline std::string obj_of(const TriangleMesh& mesh) {
  std::string text = "# a mesh\no thing\n";
  for (const glm::dvec3& vertex : mesh.vertices_m) text += "v " + line_of(vertex) + '\n';
  for (const auto& triangle : mesh.triangles) text += "f " + line_of(triangle, 1) + '\n';
  return text;
}

inline std::string off_of(const TriangleMesh& mesh) {
  std::string text = "OFF\n# a mesh\n" + std::to_string(mesh.vertices_m.size()) + ' ' +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const glm::dvec3& vertex : mesh.vertices_m) text += line_of(vertex) + '\n';
  for (const auto& triangle : mesh.triangles) text += "3 " + line_of(triangle, 0) + '\n';
  return text;
}

inline std::string ply_header(const TriangleMesh& mesh, const std::string& encoding) {
  return "ply\nformat " + encoding + " 1.0\ncomment a mesh\nelement vertex " +
         std::to_string(mesh.vertices_m.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
         "element face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ply_of(const TriangleMesh& mesh) {
  std::string text = ply_header(mesh, "ascii");
  for (const glm::dvec3& vertex : mesh.vertices_m) text += line_of(vertex) + " 255\n";
  for (const auto& triangle : mesh.triangles) text += "3 " + line_of(triangle, 0) + '\n';
  return text;
}

template <class Number>
void append(std::string& bytes, Number number, std::endian order) {
  char own[sizeof(Number)];
  std::memcpy(own, &number, sizeof(Number));
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    bytes += own[order == std::endian::native ? i : sizeof(Number) - 1 - i];
  }
}

inline std::string binary_ply_of(const TriangleMesh& mesh, std::endian order) {
  std::string bytes =
      ply_header(mesh, order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  for (const glm::dvec3& vertex : mesh.vertices_m) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, vertex[axis], order);
    bytes += '\x07';
  }
  for (const auto& triangle : mesh.triangles) {
    bytes += '\x03';
    for (const std::uint32_t corner : triangle) append(bytes, corner, order);
  }
  return bytes;
}

inline std::string stl_of(const TriangleMesh& mesh) {
  std::string text = "solid a mesh\n";
  for (const auto& triangle : mesh.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t corner : triangle) {
      text += "   vertex " + line_of(mesh.vertices_m[corner]) + '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a mesh\n";
}

inline std::string binary_stl_of(const TriangleMesh& mesh, std::string comment = "") {
  comment.resize(80, ' ');
  append(comment, static_cast<std::uint32_t>(mesh.triangles.size()), std::endian::little);
  for (const auto& triangle : mesh.triangles) {
    comment.append(12, '\0');
    for (const std::uint32_t corner : triangle) {
      for (int axis = 0; axis < 3; ++axis) {
        append(comment, static_cast<float>(mesh.vertices_m[corner][axis]), std::endian::little);
      }
    }
    comment.append(2, '\0');
  }
  return comment;
}

}  // namespace asperity::test
