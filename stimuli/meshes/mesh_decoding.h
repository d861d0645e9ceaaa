// Inside the readers of mesh files: a text's words, and a mesh that grows face by face.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/meshes/mesh_file.h"

namespace asperity {

/// A text, word by word, that knows its line.
class MeshText final {
 public:
  MeshText(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Goes to the next line; false at the end of the text.
  bool next_line() noexcept;
  /// The next word of this line, empty at its end.
  std::string_view word() noexcept;
  /// The next word of this line or of the next one that has any; empty at the end of the text.
  std::string_view word_of_any_line() noexcept;
  double number_in(std::string_view word) const;
  std::int64_t integer_in(std::string_view word) const;
  std::size_t rest_bytes() const noexcept { return text_.size(); }
  /// Where the text goes on, in the bytes that were given.
  const char* position() const noexcept { return text_.data(); }

  [[noreturn]] void refuse(const std::string& sentence) const;

 private:
  std::string_view text_;
  std::string_view line_{};
  std::size_t number_ = 0;
  std::string name_;
};

/// A mesh that grows.
class GrowingMesh final {
 public:
  GrowingMesh(const MeshReading& reading, std::string name);

  /// Room for so many; refuses at once more triangles than may be.
  void reserve(std::size_t vertices, std::size_t triangles);
  void add_vertex(const glm::dvec3& in_units);
  std::size_t vertices() const noexcept { return read_.mesh.vertices_m.size(); }
  /// Its corners by index; more than three become a fan, fewer are counted and left out.
  void add_face(std::span<const std::int64_t> corners);
  /// Corners one after the other, −1 between strips; every second triangle runs the other way.
  void add_strips(std::span<const std::int64_t> corners);
  /// The mesh, once every index is known to have its vertex.
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

/// What a binary STL of so many triangles is long: 80 bytes of anything, a count, 50 bytes each.
constexpr std::size_t binary_stl_bytes(std::size_t triangles) { return 84 + 50 * triangles; }
/// The count that stands in a binary STL; `content` has at least 84 bytes.
std::uint32_t binary_stl_triangles(std::string_view content);

}  // namespace asperity
