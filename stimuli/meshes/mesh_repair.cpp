// Runs the steps in their order: weld, pair, turn, split, fill, sort out parts.

#include "stimuli/meshes/mesh_repair.h"

#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity {
namespace mesh_repair {

void MeshInRepair::refuse(const std::string& sentence) const {
  throw std::invalid_argument(name + ' ' + sentence);
}

void MeshInRepair::refuse_nothing_inside() const {
  refuse("is flat and encloses no volume. Use a mesh that encloses a volume.");
}

}  // namespace mesh_repair

RepairedMesh repair_mesh(TriangleMesh mesh, const MeshRepairLimits& limits,
                         const std::string& name) {
  if (const auto widest_m = limits.widest_hole_m; widest_m && !(*widest_m >= 0.0)) {
    throw std::invalid_argument("the widest hole that is closed, widest_hole_m, is " +
                                number_text(*widest_m) + "; it must be a length of at least 0.");
  }
  mesh_repair::MeshInRepair repair{.mesh = std::move(mesh), .limits = limits, .name = name};
  repair.found.triangles_in = repair.mesh.triangles.size();
  refuse_not_finite(repair);
  weld(repair);
  leave_out_bad_faces(repair);
  measure(repair);
  pair_at_edges(repair);
  turn_to_agree(repair);
  pair_at_crowded_edges(repair);
  split_vertices(repair);
  divide_double_edges(repair);
  fill_holes(repair);
  sort_out_parts(repair);
  return {std::move(repair.mesh), repair.found};
}

}  // namespace asperity
