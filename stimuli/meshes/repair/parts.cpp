// Computes the volume of each connected part, drops debris, and turns parts outwards and cavities inwards.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity::mesh_repair {
namespace {

// Whether a ray from a corner of the part crosses the parts around it an odd number of times.
bool lies_within_another(const MeshInRepair& repair, std::size_t which,
                         const std::vector<Part>& parts,
                         const std::vector<std::uint32_t>& part_of) {
  const Box& box = parts[which].box;
  std::vector<char> encloses(parts.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool around = i != which && !parts[i].dropped &&
                        glm::all(glm::lessThan(parts[i].box.low_m, box.low_m)) &&
                        glm::all(glm::lessThan(box.high_m, parts[i].box.high_m));
    encloses[i] = around ? 1 : 0;
    any = any || around;
  }
  if (!any) return false;
  const glm::dvec3 origin_m =
      repair.mesh.vertices_m[repair.mesh.triangles[parts[which].first_face][0]];
  // A direction that faces and edges of an object are unlikely to have.
  const glm::dvec3 direction = glm::normalize(glm::dvec3{0.5377, 0.3319, 0.7751});
  // The point a + b·ab + c·ac of the triangle on the ray t·direction, by Cramer's rule.
  std::size_t crossings = 0;
  for (const Triangle& triangle : repair.mesh.triangles) {
    if (encloses[part_of[triangle[0]]] == 0) continue;
    const glm::dvec3 a_m = repair.mesh.vertices_m[triangle[0]] - origin_m;
    const glm::dvec3 ab_m = repair.mesh.vertices_m[triangle[1]] - origin_m - a_m;
    const glm::dvec3 ac_m = repair.mesh.vertices_m[triangle[2]] - origin_m - a_m;
    const glm::dvec3 p = glm::cross(direction, ac_m);
    const double determinant = glm::dot(ab_m, p);
    if (determinant == 0.0) continue;
    const double b = -glm::dot(a_m, p) / determinant;
    const glm::dvec3 q = glm::cross(-a_m, ab_m);
    const double c = glm::dot(direction, q) / determinant;
    if (b >= 0.0 && c >= 0.0 && b + c <= 1.0 && glm::dot(ac_m, q) / determinant > 0.0) {
      ++crossings;
    }
  }
  return crossings % 2 == 1;
}

void keep(MeshInRepair& repair, const std::vector<Part>& parts,
          const std::vector<std::uint32_t>& part_of) {
  TriangleMesh kept{};
  std::vector<std::uint32_t> renamed(repair.mesh.vertices_m.size(), kNone);
  for (Triangle triangle : repair.mesh.triangles) {
    const Part& part = parts[part_of[triangle[0]]];
    if (part.dropped) continue;
    if (part.turned) std::swap(triangle[1], triangle[2]);
    for (std::uint32_t& vertex : triangle) {
      if (renamed[vertex] == kNone) {
        renamed[vertex] = static_cast<std::uint32_t>(kept.vertices_m.size());
        kept.vertices_m.push_back(repair.mesh.vertices_m[vertex]);
      }
      vertex = renamed[vertex];
    }
    kept.triangles.push_back(triangle);
  }
  repair.mesh = std::move(kept);
}

}  // namespace

// The volume is the sum of the signed tetrahedra between a point and the faces: p₀·((p₁ − p₀) × (p₂ − p₀))/6, negative
// for a surface that faces inwards.
Parts parts_of(const TriangleMesh& mesh) {
  Sets sets(mesh.vertices_m.size());
  for (const Triangle& triangle : mesh.triangles) {
    sets.join(triangle[0], triangle[1]);
    sets.join(triangle[0], triangle[2]);
  }
  Parts made{.of_vertex = std::vector<std::uint32_t>(mesh.vertices_m.size(), kNone)};
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle& triangle = mesh.triangles[face];
    const std::uint32_t root = sets.of(triangle[0]);
    if (made.of_vertex[root] == kNone) {
      made.of_vertex[root] = static_cast<std::uint32_t>(made.parts.size());
      made.parts.emplace_back().first_face = face;
    }
    Part& part = made.parts[made.of_vertex[root]];
    const glm::dvec3& origin_m = mesh.vertices_m[mesh.triangles[part.first_face][0]];
    std::array<glm::dvec3, 3> corners_m{};
    for (std::size_t i = 0; i < 3; ++i) {
      made.of_vertex[triangle[i]] = made.of_vertex[root];
      part.box.add(mesh.vertices_m[triangle[i]]);
      corners_m[i] = mesh.vertices_m[triangle[i]] - origin_m;
    }
    const glm::dvec3 doubled = glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
    part.volume_m3 += glm::dot(corners_m[0], doubled) / 6.0;
    part.area_m2 += 0.5 * glm::length(doubled);
    ++part.faces;
  }
  return made;
}

// Leaves out debris and flat parts, and turns parts so that they face outwards, cavities inwards.
void sort_out_parts(MeshInRepair& repair) {
  auto [parts, part_of] = parts_of(repair.mesh);
  for (Part& part : parts) {
    if (part.box.diagonal_m() < repair.limits.smallest_part * repair.found.diagonal_m) {
      ++repair.found.debris_parts;
      part.dropped = true;
    } else if (part.is_flat()) {
      ++repair.found.flat_parts;
      part.dropped = true;
    }
    if (part.dropped) {
      repair.found.dropped_faces += part.faces;
    } else {
      ++repair.found.parts;
    }
  }
  if (repair.found.parts == 0) repair.refuse_nothing_inside();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    if (part.dropped) continue;
    const bool cavity = repair.found.parts > 1 && lies_within_another(repair, i, parts, part_of);
    if (cavity) ++repair.found.cavities;
    part.turned = (part.volume_m3 < 0.0) != cavity;
    if (part.turned) ++repair.found.inside_out_parts;
  }
  keep(repair, parts, part_of);
}

}  // namespace asperity::mesh_repair
