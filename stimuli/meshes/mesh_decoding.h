// What the readers of mesh files share: the words of a text, and a mesh that is built face by face.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/meshes/read_mesh.h"

namespace asperity {

/// Whether a character separates words of a line.
constexpr bool is_mesh_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The end of the sentence about a mesh file that is damaged or incomplete.
constexpr const char* kExportAgain = "Export the mesh again.";

/// Reads a text word by word, with the number of its line for errors. A byte order mark at its beginning is skipped. A
/// line ends with a line feed, a carriage return or both.
class MeshText final {
 public:
  MeshText(std::string_view text, std::string name);

  /// Advances to the next line; false at the end of the text.
  bool next_line() noexcept;
  /// The next word of this line, empty at its end.
  std::string_view word() noexcept;
  /// The next word of this line or of a following one; empty at the end of the text.
  std::string_view word_of_any_line() noexcept;
  double number_in(std::string_view word) const;
  std::int64_t integer_in(std::string_view word) const;
  std::size_t rest_bytes() const noexcept { return text_.size(); }
  /// The current position in the bytes of the text.
  const char* position() const noexcept { return text_.data(); }

  /// Throws std::invalid_argument with the name of the file and the number of the line.
  [[noreturn]] void refuse(const std::string& sentence,
                           const std::string& remedy = kExportAgain) const;

 private:
  std::string_view text_;
  std::string_view line_{};
  std::size_t number_ = 0;
  std::string name_;
  bool ends_with_cr_ = false;  ///< the first line, with a carriage return alone
};

/// Builds a mesh, and refuses invalid indices and too many triangles.
class GrowingMesh final {
 public:
  GrowingMesh(const MeshReading& reading, std::string name);

  /// Reserves memory, and refuses more triangles than permitted.
  void reserve(std::size_t vertices, std::size_t triangles);
  void add_vertex(const glm::dvec3& in_units);
  std::size_t vertices() const noexcept { return read_.mesh.vertices_m.size(); }
  /// Adds a face by the indices of its corners. A face with more than three corners is divided into a fan; one with
  /// fewer is counted and left out.
  void add_face(std::span<const std::int64_t> corners);
  /// Adds triangle strips: consecutive corners, −1 between strips. Every second triangle has the opposite orientation.
  void add_strips(std::span<const std::int64_t> corners);
  /// Checks that every index has a vertex. The mesh.
  ReadMesh finish(MeshFormat format);

 private:
  [[noreturn]] void refuse_too_many() const;
  void add_triangle(std::int64_t a, std::int64_t b, std::int64_t c);

  ReadMesh read_{};
  double unit_m_;
  std::size_t most_triangles_;
  std::string name_;
  std::size_t polygons_ = 0;
  std::size_t too_small_ = 0;
  std::size_t strips_ = 0;
};

ReadMesh decode_obj(std::string_view text, const MeshReading& reading, const std::string& name);
ReadMesh decode_ply(std::string_view content, const MeshReading& reading, const std::string& name);
ReadMesh decode_stl_ascii(std::string_view text, const MeshReading& reading,
                          const std::string& name);
ReadMesh decode_stl_binary(std::string_view content, const MeshReading& reading,
                           const std::string& name);
ReadMesh decode_off(std::string_view text, const MeshReading& reading, const std::string& name);

/// The length of a binary STL: 80 bytes of any content, a count, 50 bytes per triangle.
constexpr std::size_t binary_stl_bytes(std::size_t triangles) { return 84 + 50 * triangles; }
/// The count of triangles that a binary STL states; `content` has at least 84 bytes.
std::uint32_t binary_stl_triangles(std::string_view content);

}  // namespace asperity
