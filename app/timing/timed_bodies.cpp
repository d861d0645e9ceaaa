// Bakes bodies on request, and keeps them in a folder under the checksum of their original.

#include "app/timing/timed_bodies.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "app/study_files/textured_mesh_files.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "stimuli/meshes/detailed_bodies.h"
#include "stimuli/meshes/mesh_decimation.h"
#include "stimuli/meshes/mesh_file.h"
#include "stimuli/meshes/mesh_repair.h"
#include "stimuli/meshes/texture_baking.h"

namespace asperity {

namespace {

constexpr std::size_t kSimplifiedFile = 700;

glm::dvec3 centre_m(const std::vector<glm::dvec3>& vertices_m) {
  glm::dvec3 low_m = vertices_m.front();
  glm::dvec3 high_m = low_m;
  for (const glm::dvec3& vertex_m : vertices_m) {
    low_m = glm::min(low_m, vertex_m);
    high_m = glm::max(high_m, vertex_m);
  }
  return 0.5 * (low_m + high_m);
}

void centre(std::vector<glm::dvec3>& vertices_m) {
  const glm::dvec3 middle_m = centre_m(vertices_m);
  for (glm::dvec3& vertex_m : vertices_m) vertex_m -= middle_m;
}

/// Of the vertices: the triangles follow from their number.
std::string sha256_of_places(const TriangleMesh& mesh) {
  const auto* const bytes = reinterpret_cast<const char*>(mesh.vertices_m.data());
  return sha256_of({bytes, mesh.vertices_m.size() * sizeof(glm::dvec3)});
}

const DetailedBody& detailed_body(std::string_view name) {
  const auto bodies = detailed_bodies();
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [name](const DetailedBody& each) { return each.name == name; });
  if (found == bodies.end()) {
    throw std::invalid_argument("there is no body \"" + std::string(name) +
                                "\"; choose one of detailed_bodies()");
  }
  return *found;
}

/// Of a body that was made before, from this original.
TimedBody kept_body(const std::filesystem::path& file, const std::string& sha256) {
  const LoadedTexturedMesh loaded = load_textured_mesh(file);
  const TexturedMeshProvenance& provenance = loaded.stored->provenance;
  if (provenance.source_sha256 != sha256) {
    throw ResultsError(file.string() +
                           ": the textured mesh was made from another original; remove the file, "
                           "or choose another folder for the bodies",
                       file);
  }
  return {.mesh = {loaded.stored, &loaded.stored->mesh},
          .original_triangles = provenance.source_triangles};
}

}  // namespace

TimedBodies::TimedBodies(TimedBodiesOrder order, TimingCourse course)
    : order_(std::move(order)), course_(std::move(course)) {}

TimedBody TimedBodies::named(std::string_view name) {
  const auto known = bodies_.find(name);
  if (known != bodies_.end()) return known->second;
  const DetailedBody& body = detailed_body(name);
  const TimedBody made_now = made(name, order_.triangles.value_or(body.triangles), body.simplified);
  return bodies_.emplace(std::string(name), made_now).first->second;
}

TimedBody TimedBodies::of_file(const std::filesystem::path& file, const MeshReading& reading) {
  const std::string name = file.string();
  if (file.extension() == ".mesh") {
    const LoadedTexturedMesh loaded = load_textured_mesh(file);
    TexturedMesh mesh = loaded.stored->mesh;
    centre(mesh.vertices_m);
    return {.mesh = std::make_shared<const TexturedMesh>(std::move(mesh)),
            .original_triangles = loaded.stored->provenance.source_triangles};
  }
  TriangleMesh original{};
  {
    const std::string content = read_file(file, kMeshFile);
    original =
        decode_mesh(std::as_bytes(std::span(content.data(), content.size())), reading, name).mesh;
  }
  original = repair_mesh(std::move(original), {}, name).mesh;
  centre(original.vertices_m);
  return baked(original, kSimplifiedFile, name);
}

void TimedBodies::follow(double fraction) const {
  if (course_.stop.stop_requested()) throw TimingStopped{};
  if (course_.progress) course_.progress(fraction);
}

TimedBody TimedBodies::baked(const TriangleMesh& original, std::size_t simplified,
                             const std::string& name) {
  const auto part = [this](double from, double to) {
    return [this, from, to](double fraction) { follow(from + (to - from) * fraction); };
  };
  if (course_.begin_step) course_.begin_step("simplifying " + name);
  follow(0.0);
  const TriangleMesh simple =
      original.triangles.size() > simplified
          ? decimate_mesh(original, simplified, name, {order_.jobs, part(0.0, 0.7)}).mesh
          : original;
  BakedMesh result = bake_texture(original, simple, {}, {order_.jobs, part(0.7, 1.0)});
  follow(1.0);
  return {.mesh = std::make_shared<const TexturedMesh>(std::move(result.mesh)),
          .original_triangles = original.triangles.size()};
}

TimedBody TimedBodies::made(std::string_view name, std::size_t triangles, std::size_t simplified) {
  const std::string title(name);
  const TriangleMesh original = repair_mesh(make_detailed_body(name, triangles), {}, title).mesh;
  if (!order_.folder) return baked(original, simplified, title);
  const std::string sha256 = sha256_of_places(original);
  const std::filesystem::path file =
      *order_.folder / (title + '-' + std::to_string(triangles) + ".mesh");
  if (std::filesystem::exists(file)) return kept_body(file, sha256);
  const TimedBody body = baked(original, simplified, title);
  save_textured_mesh(file,
                     {.mesh = *body.mesh,
                      .provenance = {.source_name = "asperity bench " + title,
                                     .source_sha256 = sha256,
                                     .source_unit_m = 1.0,
                                     .source_triangles = body.original_triangles}},
                     Overwrite::refuse);
  return body;
}

}  // namespace asperity
