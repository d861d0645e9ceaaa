// OpenMesh also reads all four formats and is not used: its readers of OBJ, PLY and OFF convert coordinates to float
// (tests/stimuli/mesh_file_test.cpp shows this); it builds half-edges while it reads, so that a face at a non-manifold
// edge is lost before it can be counted; it welds the corners of STL; it reads a binary STL whose comment begins with
// "solid" as text; and it skips the triangle strips of PLY without a message.

#include "stimuli/meshes/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/mesh_decoding.h"

namespace asperity {
namespace {

// The first word of the text outside comments.
std::string_view first_word(std::string_view start) {
  MeshText text(start, "");
  while (text.next_line()) {
    const std::string_view word = text.word();
    if (!word.empty() && word.front() != '#') return word;
  }
  return {};
}

// Whether one of the first lines begins like a line of OBJ with vertices.
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
  if (content.empty()) throw std::invalid_argument(name + " is empty; export the mesh again.");
  const std::string_view start = content.substr(0, kStart_bytes);
  const std::string_view word = first_word(start);
  if (word == "ply") return decode_ply(content, reading, name);
  // Checked before text STL, because a binary one may also begin with "solid".
  if (content.size() >= binary_stl_bytes(0) &&
      content.size() == binary_stl_bytes(binary_stl_triangles(content))) {
    return decode_stl_binary(content, reading, name);
  }
  const bool text = start.find('\0') == std::string_view::npos;
  if (text && word == "solid") return decode_stl_ascii(content, reading, name);
  if (word.size() <= 6 && word.ends_with("OFF")) return decode_off(content, reading, name);
  if (text && looks_like_obj(start)) return decode_obj(content, reading, name);
  std::string sentence = name +
                         " is in none of the formats OBJ, PLY, STL and OFF; export the mesh "
                         "in one of them.";
  if (!text && content.size() >= binary_stl_bytes(0)) {
    const std::size_t triangles = binary_stl_triangles(content);
    sentence += " If it is a binary STL, it is damaged: its header states " +
                counted(triangles, "triangle", "triangles") + ", for which the file needs " +
                std::to_string(binary_stl_bytes(triangles)) + " bytes; it has " +
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

}  // namespace asperity
