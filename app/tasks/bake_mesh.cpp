#include "app/tasks/bake_mesh.h"

#include <span>
#include <stdexcept>
#include <utility>

#include "app/height_field_files.h"
#include "app/textured_mesh_files.h"
#include "results_schema/sha256.h"
#include "results_schema/study.h"
#include "stimuli/mesh_decimation.h"
#include "stimuli/mesh_repair.h"

namespace asperity {

namespace {

constexpr std::uintmax_t kLargestFile_bytes = std::uintmax_t{1} << 31;

struct Original {
  TriangleMesh mesh{};
  TexturedMeshProvenance provenance{};
  double diagonal_m = 0.0;
};

Original read_original(const BakeOrder& order) {
  const std::string name = order.mesh.string();
  std::error_code error{};
  if (const std::uintmax_t size = std::filesystem::file_size(order.mesh, error);
      !error && size > kLargestFile_bytes) {
    throw std::invalid_argument(name + " has " + std::to_string(size) +
                                " bytes; mesh files of up to 2 GiB are read.");
  }
  Original original{};
  ReadMesh read{};
  {
    const std::string content = read_file(order.mesh);
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

}  // namespace

BakeOutcome bake_mesh(const BakeOrder& order, const std::function<void(double)>& progress) {
  refuse_existing({order.out}, order.overwrite);
  // Said now and not after the work.
  if (const auto folder = order.out.parent_path();
      !folder.empty() && !std::filesystem::is_directory(folder)) {
    throw ResultsError(
        "the file " + order.out.string() + " cannot be made: there is no folder " + folder.string(),
        order.out);
  }
  const auto part = [&progress](double from, double to) {
    return [&progress, from, to](double fraction) { progress(from + (to - from) * fraction); };
  };
  progress(0.0);
  Original original = read_original(order);
  progress(0.15);
  const SimplifiedMesh simple =
      decimate_mesh(original.mesh, order.triangles, order.mesh.string(), part(0.15, 0.5));
  if (const auto sentence = sentence_of(simple)) {
    original.provenance.findings.push_back(*sentence);
  }
  const TriangleMesh& simplified = simple.mesh;
  BakedMesh baked = bake_texture(original.mesh, simplified, {}, {order.jobs, part(0.5, 0.98)});
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
