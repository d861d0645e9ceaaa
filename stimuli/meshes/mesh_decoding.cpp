// Splits a text into lines and words, and triangulates faces and strips within the limits of a reading.

#include "stimuli/meshes/mesh_decoding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/look_alikes.h"

namespace asperity {

MeshText::MeshText(std::string_view text, std::string name)
    : text_(without_byte_order_mark(text)), name_(std::move(name)) {}

bool MeshText::next_line() noexcept {
  if (text_.empty()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  line_ = text_.substr(0, end);
  const bool has_cr = end < text_.size() && text_[end] == '\r';
  text_.remove_prefix(std::min(end + 1, text_.size()));
  const bool has_both = has_cr && text_.starts_with('\n');
  if (number_ == 0) ends_with_cr_ = has_cr && !has_both;
  // Where carriage returns alone end the lines of a PLY header, a line feed after the last one is a byte of the body.
  if (has_both && !ends_with_cr_) text_.remove_prefix(1);
  ++number_;
  return true;
}

std::string_view MeshText::word() noexcept {
  while (!line_.empty() && is_mesh_space(line_.front())) line_.remove_prefix(1);
  std::size_t length = 0;
  while (length < line_.size() && !is_mesh_space(line_[length])) ++length;
  const std::string_view found = line_.substr(0, length);
  line_.remove_prefix(length);
  return found;
}

std::string_view MeshText::word_of_any_line() noexcept {
  std::string_view found = word();
  while (found.empty() && next_line()) found = word();
  return found;
}

double MeshText::number_in(std::string_view word) const {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::result_out_of_range) {
    const bool tiny =
        digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    refuse(word.empty() ? "the line ends where a number is expected."
                        : '"' + std::string(word.substr(0, 40)) +
                              "\" is not a number; a number is expected here.");
  }
  return number;
}

std::int64_t MeshText::integer_in(std::string_view word) const {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    refuse(word.empty() ? "the line ends where a whole number is expected."
                        : '"' + std::string(word.substr(0, 40)) +
                              "\" is not a whole number; a whole number is expected here.");
  }
  return number;
}

void MeshText::refuse(const std::string& sentence, const std::string& remedy) const {
  // The content of a damaged file could contain control characters of a terminal.
  std::string readable = sentence;
  std::replace_if(
      readable.begin(), readable.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  const std::optional<LookAlike> other = first_look_alike(sentence);
  throw std::invalid_argument(
      name_ + ':' + std::to_string(number_) + ": " + readable + ' ' +
      (other ? "There is " + other->character.english() + "; " + other->correction.english() + '.'
             : remedy));
}

GrowingMesh::GrowingMesh(const MeshReading& reading, std::string name)
    : unit_m_(reading.unit_m), most_triangles_(reading.most_triangles), name_(std::move(name)) {}

void GrowingMesh::reserve(std::size_t vertices, std::size_t triangles) {
  if (triangles > most_triangles_) refuse_too_many();
  read_.mesh.vertices_m.reserve(vertices);
  read_.mesh.triangles.reserve(triangles);
}

void GrowingMesh::refuse_too_many() const {
  throw std::invalid_argument(
      name_ + " has more than " + std::to_string(most_triangles_) +
      " triangles, the maximum that is read; simplify it with another program first.");
}

void GrowingMesh::add_vertex(const glm::dvec3& in_units) {
  if (vertices() >= std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(
        name_ + " has more than 4 294 967 295 vertices; simplify it with another program first.");
  }
  read_.mesh.vertices_m.push_back(in_units * unit_m_);
}

void GrowingMesh::add_triangle(std::int64_t a, std::int64_t b, std::int64_t c) {
  std::array<std::uint32_t, 3> triangle{};
  const std::int64_t corners[] = {a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] < 0 || corners[i] > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument(name_ + " refers to vertex " + std::to_string(corners[i]) +
                                  " in triangle " +
                                  std::to_string(read_.mesh.triangles.size() + 1) +
                                  "; no vertex has that number. " + kExportAgain);
    }
    triangle[i] = static_cast<std::uint32_t>(corners[i]);
  }
  if (read_.mesh.triangles.size() == most_triangles_) refuse_too_many();
  read_.mesh.triangles.push_back(triangle);
}

void GrowingMesh::add_face(std::span<const std::int64_t> corners) {
  if (corners.size() < 3) {
    ++too_small_;
    return;
  }
  if (corners.size() > 3) ++polygons_;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    add_triangle(corners[0], corners[i - 1], corners[i]);
  }
}

void GrowingMesh::add_strips(std::span<const std::int64_t> corners) {
  std::size_t in_strip = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == -1) {
      in_strip = 0;
      continue;
    }
    ++in_strip;
    if (in_strip == 3) ++strips_;
    if (in_strip < 3) continue;
    if (in_strip % 2 == 1) {
      add_triangle(corners[i - 2], corners[i - 1], corners[i]);
    } else {
      add_triangle(corners[i - 1], corners[i - 2], corners[i]);
    }
  }
}

ReadMesh GrowingMesh::finish(MeshFormat format) {
  const std::vector<std::array<std::uint32_t, 3>>& triangles = read_.mesh.triangles;
  if (vertices() == 0) throw std::invalid_argument(name_ + " has no vertices. " + kExportAgain);
  if (triangles.empty()) {
    throw std::invalid_argument(name_ + " has " + std::to_string(vertices()) +
                                (vertices() == 1 ? " vertex" : " vertices") +
                                " and no faces; points alone are not a surface. Export the mesh "
                                "with its faces.");
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t largest = *std::max_element(triangles[i].begin(), triangles[i].end());
    if (largest >= vertices()) {
      throw std::invalid_argument(name_ + " refers in triangle " + std::to_string(i + 1) +
                                  " to vertex " + std::to_string(largest + 1ULL) +
                                  "; the last vertex is number " + std::to_string(vertices()) +
                                  ". " + kExportAgain);
    }
  }
  if (polygons_ > 0) {
    read_.notes.push_back("Faces with more than three vertices, divided into triangles: " +
                          std::to_string(polygons_) + '.');
  }
  if (strips_ > 0) {
    read_.notes.push_back("Triangle strips divided into triangles: " + std::to_string(strips_) +
                          '.');
  }
  if (too_small_ > 0) {
    read_.notes.push_back("Faces left out because they had fewer than three vertices: " +
                          std::to_string(too_small_) + '.');
  }
  read_.format = format;
  return std::move(read_);
}

}  // namespace asperity
