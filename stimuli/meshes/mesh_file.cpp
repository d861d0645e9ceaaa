// Which format it is, and what the readers share.
//
// OpenMesh reads all four formats too, and is not used for it: its readers of OBJ, PLY and OFF pass coordinates
// through float (tests/stimuli/mesh_file_test.cpp shows it); it builds half-edges while it reads, so that a face at
// a non-manifold edge is lost before anybody can count it; it welds the corners of STL by itself; it takes a binary STL
// whose comment begins with "solid" for text; and it skips the triangle strips of PLY without a word.

#include "stimuli/meshes/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "analysis/number_text.h"
#include "stimuli/meshes/mesh_decoding.h"

namespace asperity {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The first word of the text that is not in a comment.
std::string_view first_word(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    if (!line.empty() && line.front() != '#') {
      std::size_t length = 0;
      while (length < line.size() && !is_space(line[length])) ++length;
      return line.substr(0, length);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// Whether a line among the first begins as a line of OBJ with vertices does.
bool looks_like_obj(std::string_view start) {
  MeshText text(start, "");
  bool vertex = false;
  while (text.next_line()) {
    const std::string_view word = text.word();
    vertex = vertex || word == "v" || word == "vn" || word == "vt";
  }
  return vertex;
}

std::string extension_of(const std::string& name) {
  const std::size_t dot = name.find_last_of("./");
  if (dot == std::string::npos || name[dot] != '.') return {};
  std::string extension = name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

const char* extension_for(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::ply_ascii:
    case MeshFormat::ply_binary:
      return "ply";
    case MeshFormat::stl_ascii:
    case MeshFormat::stl_binary:
      return "stl";
    case MeshFormat::off:
      return "off";
  }
  return "";
}

ReadMesh decode_content(std::string_view content, const MeshReading& reading,
                        const std::string& name) {
  constexpr std::size_t kStart_bytes = 65536;
  if (content.empty()) throw std::invalid_argument(name + " is empty.");
  const std::string_view start = content.substr(0, kStart_bytes);
  const std::string_view word = first_word(start);
  if (word == "ply") return decode_ply(content, reading, name);
  // Before the text STL: a binary one may begin with "solid" too.
  if (content.size() >= binary_stl_bytes(0) &&
      content.size() == binary_stl_bytes(binary_stl_triangles(content))) {
    return decode_stl_binary(content, reading, name);
  }
  const bool text = start.find('\0') == std::string_view::npos;
  if (text && word == "solid") return decode_stl_ascii(content, reading, name);
  if (word.size() <= 6 && word.ends_with("OFF")) return decode_off(content, reading, name);
  if (text && looks_like_obj(start)) return decode_obj(content, reading, name);
  std::string sentence = name + " is in none of the formats OBJ, PLY, STL and OFF.";
  if (!text && content.size() >= binary_stl_bytes(0)) {
    const std::size_t triangles = binary_stl_triangles(content);
    sentence += " If it is a binary STL, it is damaged: its header states " +
                std::to_string(triangles) + " triangles, which take " +
                std::to_string(binary_stl_bytes(triangles)) + " bytes, and it has " +
                std::to_string(content.size()) + ".";
  }
  throw std::invalid_argument(sentence);
}

}  // namespace

const char* name_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "OBJ";
    case MeshFormat::ply_ascii:
      return "PLY";
    case MeshFormat::ply_binary:
      return "binary PLY";
    case MeshFormat::stl_ascii:
      return "STL";
    case MeshFormat::stl_binary:
      return "binary STL";
    case MeshFormat::off:
      return "OFF";
  }
  return "";
}

ReadMesh decode_mesh(std::span<const std::byte> bytes, const MeshReading& reading,
                     const std::string& name) {
  if (!(reading.unit_m > 0.0 && std::isfinite(reading.unit_m))) {
    throw std::invalid_argument("the unit of " + name + ", unit_m, is " +
                                number_text(reading.unit_m) + "; it must be a length above 0.");
  }
  ReadMesh read =
      decode_content({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, reading, name);
  const std::string extension = extension_of(name);
  constexpr const char* kKnown[] = {"obj", "ply", "stl", "off"};
  if (extension != extension_for(read.format) &&
      std::find(std::begin(kKnown), std::end(kKnown), extension) != std::end(kKnown)) {
    read.notes.push_back("The file's name ends in ." + extension + ", but its content is " +
                         name_of(read.format) + "; the content determined how it was read.");
  }
  return read;
}

bool MeshText::next_line() noexcept {
  if (text_.empty()) return false;
  const std::size_t end = std::min(text_.find('\n'), text_.size());
  line_ = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  ++number_;
  return true;
}

std::string_view MeshText::word() noexcept {
  while (!line_.empty() && is_space(line_.front())) line_.remove_prefix(1);
  std::size_t length = 0;
  while (length < line_.size() && !is_space(line_[length])) ++length;
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

void MeshText::refuse(const std::string& sentence) const {
  // What stands in a damaged file would do more to a terminal than be read.
  std::string readable = sentence;
  std::replace_if(
      readable.begin(), readable.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  throw std::invalid_argument(name_ + ':' + std::to_string(number_) + ": " + readable);
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
    throw std::invalid_argument(name_ + " has more than 4 294 967 295 vertices.");
  }
  read_.mesh.vertices_m.push_back(in_units * unit_m_);
}

void GrowingMesh::add_triangle(std::int64_t a, std::int64_t b, std::int64_t c) {
  std::array<std::uint32_t, 3> triangle{};
  const std::int64_t corners[] = {a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] < 0 || corners[i] > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument(
          name_ + " refers to vertex " + std::to_string(corners[i]) + " in triangle " +
          std::to_string(read_.mesh.triangles.size() + 1) + "; no vertex has that number.");
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
  if (vertices() == 0) throw std::invalid_argument(name_ + " has no vertices.");
  if (triangles.empty()) {
    throw std::invalid_argument(name_ + " has " + std::to_string(vertices()) +
                                (vertices() == 1 ? " vertex" : " vertices") +
                                " and no faces; points alone are not a surface.");
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t largest = *std::max_element(triangles[i].begin(), triangles[i].end());
    if (largest >= vertices()) {
      throw std::invalid_argument(name_ + " refers in triangle " + std::to_string(i + 1) +
                                  " to vertex " + std::to_string(largest + 1ULL) +
                                  " (counted from 1), but has only " + std::to_string(vertices()) +
                                  " vertices.");
    }
  }
  if (polygons_ > 0) {
    read_.notes.push_back("Faces with more than three corners, divided into triangles: " +
                          std::to_string(polygons_) + '.');
  }
  if (strips_ > 0) {
    read_.notes.push_back("Strips divided into triangles: " + std::to_string(strips_) + '.');
  }
  if (too_small_ > 0) {
    read_.notes.push_back("Faces left out because they had fewer than three corners: " +
                          std::to_string(too_small_) + '.');
  }
  read_.format = format;
  return std::move(read_);
}

}  // namespace asperity
