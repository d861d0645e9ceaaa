// Implements the readers of OBJ and OFF.

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include "stimuli/meshes/mesh_decoding.h"

namespace asperity {

namespace {

glm::dvec3 next_point(MeshText& text) {
  glm::dvec3 point{};
  for (int axis = 0; axis < 3; ++axis) point[axis] = text.number_in(text.word());
  return point;
}

/// Advances to the next line with other contents than a comment and returns its first word.
std::string_view next_item(MeshText& text) {
  while (text.next_line()) {
    const std::string_view word = text.word();
    if (!word.empty() && word.front() != '#') return word;
  }
  return {};
}

std::size_t next_count(MeshText& text, std::string_view word, const char* what) {
  const std::int64_t count = text.integer_in(word);
  // An item occupies at least two bytes, a digit and the end of its line.
  if (count < 0 || static_cast<std::size_t>(count) > text.rest_bytes()) {
    text.refuse("the file states " + std::string(word) + " as the number of " + what +
                " but is too short for them.");
  }
  return static_cast<std::size_t>(count);
}

/// The keywords of OBJ that do not describe triangles: normals and texture coordinates, groups, materials, lines, points,
/// free-form curves and surfaces (Wavefront, Advanced Visualizer 3.0, appendix B1, with those that it superseded).
bool is_without_triangles(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {
      "vt",     "vn",       "vp",       "l",      "p",      "g",          "s",
      "mg",     "o",        "usemtl",   "mtllib", "usemap", "maplib",     "bevel",
      "lod",    "c_interp", "d_interp", "ctech",  "stech",  "shadow_obj", "trace_obj",
      "cstype", "deg",      "bmat",     "step",   "curv",   "curv2",      "surf",
      "parm",   "trim",     "hole",     "scrv",   "sp",     "end",        "con",
      "call",   "csh",      "bsp",      "bzp",    "cdc",    "cdp",        "res"};
  return std::find(std::begin(kKeywords), std::end(kKeywords), keyword) != std::end(kKeywords);
}

/// Skips the rest of a line, and the lines that continue it.
void skip_line(MeshText& text) {
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    if (word.ends_with('\\')) text.next_line();
  }
}

}  // namespace

ReadMesh decode_obj(std::string_view content, const MeshReading& reading, const std::string& name) {
  MeshText text(content, name);
  GrowingMesh mesh(reading, name);
  std::vector<std::int64_t> corners{};
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      mesh.add_vertex(next_point(text));
    } else if (keyword == "f" || keyword == "fo") {  // fo: a face in files before version 2.11
      corners.clear();
      for (std::string_view word = text.word(); !word.empty() && word.front() != '#';
           word = text.word()) {
        if (word == "\\") {
          text.next_line();
          continue;
        }
        const std::int64_t index = text.integer_in(word.substr(0, word.find('/')));
        if (index == 0) text.refuse("a face refers to vertex 0; the first vertex is number 1.");
        // A negative index counts backwards from the last vertex read.
        const auto before = static_cast<std::int64_t>(mesh.vertices());
        if (index < -before) {
          text.refuse("a face refers to vertex " + std::to_string(index) + ", but only " +
                      std::to_string(before) +
                      (before == 1 ? " vertex precedes it." : " vertices precede it."));
        }
        corners.push_back(index > 0 ? index - 1 : before + index);
      }
      mesh.add_face(corners);
    } else if (is_without_triangles(keyword)) {
      skip_line(text);
    } else if (!keyword.empty() && keyword.front() != '#') {
      text.refuse('"' + std::string(keyword.substr(0, 40)) + "\" is not a keyword of OBJ.",
                  "Delete the line, or export the mesh again.");
    }
  }
  return mesh.finish(MeshFormat::obj);
}

ReadMesh decode_off(std::string_view content, const MeshReading& reading, const std::string& name) {
  MeshText text(content, name);
  const std::string_view kind = next_item(text);
  if (kind.find_first_of("4n") != std::string_view::npos) {
    text.refuse("\"" + std::string(kind) + "\" has points of more than three dimensions.",
                "Export the mesh with three dimensions.");
  }
  std::string_view word = text.word();
  if (word == "BINARY") text.refuse("binary OFF is not supported.", "Export the mesh as text.");
  if (word.empty() || word.front() == '#') word = next_item(text);
  if (word.empty()) text.refuse("the file ends before it states the number of its vertices.");
  const std::size_t vertices = next_count(text, word, "vertices");
  const std::size_t faces = next_count(text, text.word(), "faces");
  GrowingMesh mesh(reading, name);
  mesh.reserve(vertices, faces);
  for (std::size_t i = 0; i < vertices; ++i) {
    word = next_item(text);
    if (word.empty()) {
      text.refuse("the file states " + std::to_string(vertices) +
                  " as the number of vertices but ends after " + std::to_string(i) + ".");
    }
    const double x = text.number_in(word);
    const double y = text.number_in(text.word());
    const double z = text.number_in(text.word());
    mesh.add_vertex({x, y, z});  // normals and colours that may follow are ignored
  }
  std::vector<std::int64_t> corners{};
  for (std::size_t i = 0; i < faces; ++i) {
    word = next_item(text);
    if (word.empty()) {
      text.refuse("the file states " + std::to_string(faces) +
                  " as the number of faces but ends after " + std::to_string(i) + ".");
    }
    const std::int64_t count = text.integer_in(word);
    corners.clear();
    for (std::int64_t corner = 0; corner < count; ++corner) {
      corners.push_back(text.integer_in(text.word()));
    }
    mesh.add_face(corners);
  }
  return mesh.finish(MeshFormat::off);
}

}  // namespace asperity
