// Fills holes of the mesh with a triangle or with a fan about the middle of their border.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity::mesh_repair {
namespace {

constexpr double kWidestHole = 0.1;  // of the diagonal

// Closes a hole by a triangle, or by a fan about the middle of its border.
void fill(MeshInRepair& repair, const std::vector<std::uint32_t>& hole) {
  const std::size_t count = hole.size();
  if (count == 3) {
    repair.mesh.triangles.push_back({hole[2], hole[1], hole[0]});
    return;
  }
  glm::dvec3 middle_m{0.0};
  for (const std::uint32_t vertex : hole) middle_m += repair.mesh.vertices_m[vertex];
  const auto middle = static_cast<std::uint32_t>(repair.mesh.vertices_m.size());
  repair.mesh.vertices_m.push_back(middle_m / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    repair.mesh.triangles.push_back({hole[(i + 1) % count], hole[i], middle});
  }
}

}  // namespace

void fill_holes(MeshInRepair& repair) {
  // Every vertex has one fan, so at most one border edge leaves it.
  std::vector<std::uint32_t> leaving(repair.mesh.vertices_m.size(), kNone);
  for (std::uint32_t half = 0; half < repair.partner.size(); ++half) {
    if (repair.partner[half] == kNone) leaving[repair.from(half)] = half;
  }
  const double widest_m =
      repair.limits.widest_hole_m.value_or(kWidestHole * repair.found.diagonal_m);
  struct Hole {
    std::vector<std::uint32_t> border{};
    double width_m = 0.0;
  };
  std::vector<Hole> holes{};
  for (std::uint32_t start = 0; start < leaving.size(); ++start) {
    if (leaving[start] == kNone) continue;
    Hole hole{};
    Box box{};
    for (std::uint32_t vertex = start; leaving[vertex] != kNone;) {
      hole.border.push_back(vertex);
      box.add(repair.mesh.vertices_m[vertex]);
      vertex = repair.to(std::exchange(leaving[vertex], kNone));
    }
    hole.width_m = box.diagonal_m();
    holes.push_back(std::move(hole));
  }
  for (const Hole& hole : holes) fill(repair, hole.border);
  // A sheet is not a body with a hole: closed, it has no volume, and is left out with the other flat parts.
  const Parts closed = parts_of(repair.mesh);
  std::erase_if(holes, [&closed](const Hole& hole) {
    return closed.parts[closed.of_vertex[hole.border.front()]].is_flat();
  });
  std::size_t too_wide = 0;
  for (const Hole& hole : holes) {
    repair.found.widest_hole_m = std::max(repair.found.widest_hole_m, hole.width_m);
    if (hole.width_m > widest_m) ++too_wide;
  }
  if (too_wide > 0) {
    repair.refuse("is not closed: it has " + std::to_string(holes.size()) +
                  (holes.size() == 1 ? " hole" : " holes") + ", the widest " +
                  millimetres(repair.found.widest_hole_m) + " wide, and only holes up to " +
                  millimetres(widest_m) +
                  " are closed. Close the holes in the mesh, or allow wider holes to be closed.");
  }
  repair.found.holes_filled = holes.size();
}

}  // namespace asperity::mesh_repair
