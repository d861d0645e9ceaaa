// Composes one sentence for each defect that occurred.

#include "stimuli/meshes/mesh_findings.h"

#include <cmath>

#include "analysis/numbers/number_text.h"

namespace asperity {

std::string millimetres(double length_m) {
  return number_text(std::round(length_m * 1e6) / 1e3) + " mm";
}

std::vector<std::string> sentences_of(const MeshFindings& found) {
  std::vector<std::string> sentences{};
  const auto state = [&sentences](const std::string& what, std::size_t count) {
    if (count > 0) sentences.push_back(what + ": " + std::to_string(count) + '.');
  };
  state("Vertices merged with another one at the same position", found.vertices_welded);
  state("Degenerate faces left out (with two vertices at the same position)",
        found.degenerate_faces);
  state("Duplicate faces left out (with the same vertices as another face)", found.duplicate_faces);
  state("Faces reversed because their orientation differed from that of their neighbours",
        found.faces_turned);
  state("Non-manifold edges (of more than two faces), separated", found.non_manifold_edges);
  state("Vertices added at non-manifold vertices or edges", found.vertices_split);
  state("Edges divided because another edge had the same two vertices", found.edges_divided);
  state("Holes closed, up to " + millimetres(found.widest_hole_m) + " wide", found.holes_filled);
  state("Parts left out as debris, each far smaller than the whole", found.debris_parts);
  state("Parts left out because they are flat and enclose no volume", found.flat_parts);
  state("Faces left out with these parts", found.dropped_faces);
  state("Parts reversed because they were inside out", found.inside_out_parts);
  state("Cavities, which cannot be reached from outside", found.cavities);
  if (found.parts > 1) state("Separate parts", found.parts);
  return sentences;
}

}  // namespace asperity
