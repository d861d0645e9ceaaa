// Reads and simplifies the mesh, bakes the texture, moves it into its role, and stores the provenance.

#include "app/tasks/bake_mesh.h"

#include <span>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "analysis/numbers/number_text.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "stimuli/meshes/mesh_decimation.h"
#include "stimuli/meshes/mesh_repair.h"

namespace asperity {

namespace {

struct Original {
  TriangleMesh mesh{};
  TexturedMeshProvenance provenance{};
  double diagonal_m = 0.0;
};

Original read_original(const BakeOrder& order) {
  const std::string name = order.mesh.string();
  Original original{};
  ReadMesh read{};
  {
    const std::string content = read_file(order.mesh, kMeshFile);
    original.provenance.source_sha256 = sha256_of(content);
    read =
        decode_mesh(std::as_bytes(std::span(content.data(), content.size())), order.reading, name);
  }
  original.provenance.source_name = order.mesh.filename().string();
  original.provenance.source_unit_m = order.reading.unit_m;
  original.provenance.source_triangles = read.mesh.triangles.size();
  RepairedMesh repaired =
      repair_mesh(std::move(read.mesh), {.widest_hole_m = order.widest_hole_m}, name);
  original.mesh = std::move(repaired.mesh);
  original.diagonal_m = repaired.found.diagonal_m;
  original.provenance.findings = std::move(read.notes);
  for (std::string& sentence : sentences_of(repaired.found)) {
    original.provenance.findings.push_back(std::move(sentence));
  }
  return original;
}

void refuse_name_of_another_format(const std::filesystem::path& out) {
  for (const char* const other : {".obj", ".ply", ".stl", ".off", ".png"}) {
    if (out.extension() != other) continue;
    std::filesystem::path right = out;
    right.replace_extension(".mesh");
    throw std::invalid_argument(
        out.string() + ": the output is a textured mesh, which no other program reads; name it " +
        right.string());
  }
}

/// See BakeOrder::role. Records the movement in the provenance.
void place_for_role(TexturedMesh& mesh, BodyRole role, TexturedMeshProvenance& provenance) {
  glm::dvec3 low_m = mesh.vertices_m.front();
  glm::dvec3 high_m = low_m;
  for (const glm::dvec3& vertex : mesh.vertices_m) {
    low_m = glm::min(low_m, vertex);
    high_m = glm::max(high_m, vertex);
  }
  const bool is_tool = role == BodyRole::tool;
  const glm::dvec3 to_m{-0.5 * (low_m.x + high_m.x), -0.5 * (low_m.y + high_m.y),
                        is_tool ? -low_m.z : -high_m.z};
  for (glm::dvec3& vertex : mesh.vertices_m) vertex += to_m;
  provenance.findings.push_back(
      "The mesh was moved by " + fixed(1e3 * to_m.x, 3) + ", " + fixed(1e3 * to_m.y, 3) + ", " +
      fixed(1e3 * to_m.z, 3) + " mm: its centre lies over the origin, and its " +
      (is_tool ? "lowest" : "highest") + " point lies in the plane z = 0.");
}

}  // namespace

BakeOutcome bake_mesh(const BakeOrder& order, const std::function<void(double)>& progress) {
  refuse_name_of_another_format(order.out);
  refuse_existing({order.out}, order.overwrite);
  // Checked before the work begins.
  if (const auto folder = order.out.parent_path();
      !folder.empty() && !std::filesystem::is_directory(folder)) {
    throw ResultsError("the file " + order.out.string() +
                           " cannot be created: there is no folder " + folder.string() +
                           "; create it first",
                       order.out);
  }
  const auto part = [&progress](double from, double to) {
    return [&progress, from, to](double fraction) { progress(from + (to - from) * fraction); };
  };
  progress(0.0);
  Original original = read_original(order);
  progress(0.15);
  const SimplifiedMesh simple = decimate_mesh(original.mesh, order.triangles, order.mesh.string(),
                                              {order.jobs, part(0.15, 0.5)});
  if (const auto sentence = sentence_of(simple)) {
    original.provenance.findings.push_back(*sentence);
  }
  const TriangleMesh& simplified = simple.mesh;
  BakedMesh baked = bake_texture(original.mesh, simplified, {}, {order.jobs, part(0.5, 0.98)});
  if (auto warning = warning_of(baked.report)) {
    original.provenance.findings.push_back(std::move(*warning));
  }
  if (order.role) place_for_role(baked.mesh, *order.role, original.provenance);
  BakeOutcome outcome{original.provenance.source_triangles,
                      simplified.triangles.size(),
                      original.diagonal_m,
                      baked.mesh.atlas.rows,
                      baked.mesh.atlas.columns,
                      baked.mesh.atlas.step_m,
                      baked.report,
                      original.provenance.findings};
  save_textured_mesh(order.out,
                     {std::move(baked.mesh), baked.report.plain, baked.report.textured,
                      std::move(original.provenance)},
                     order.overwrite);
  progress(1.0);
  return outcome;
}

}  // namespace asperity
