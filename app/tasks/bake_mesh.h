// Converts a mesh file to a simplified mesh with a haptic texture.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/files/atomic_file.h"
#include "stimuli/meshes/mesh_file.h"
#include "stimuli/meshes/solid_body.h"
#include "stimuli/meshes/texture_baking.h"

namespace asperity {

struct BakeOrder {
  std::filesystem::path mesh{};
  std::filesystem::path out{};
  std::size_t triangles = 0;
  MeshReading reading{};
  /// Of the holes to close; a tenth of the diagonal by default.
  std::optional<double> widest_hole_m{};
  /// The role of the mesh: it is moved so that the centre of its bounding box lies over the origin
  /// and its highest (a surface) or lowest point (a tool) in the plane z = 0. Absent: it keeps its
  /// frame.
  std::optional<BodyRole> role{};
  unsigned jobs = 1;
  Overwrite overwrite = Overwrite::refuse;
};

struct BakeOutcome {
  std::size_t triangles_in = 0;  ///< in the file
  std::size_t triangles_out = 0;
  double diagonal_m = 0.0;  ///< of the original's bounding box
  std::size_t atlas_rows = 0;
  std::size_t atlas_columns = 0;
  double step_m = 0.0;  ///< resolution of the displacements
  BakeReport report{};
  std::vector<std::string> findings{};  ///< defects found in the file and their repairs
};

/// Reads, repairs, simplifies, bakes and writes. `progress` receives the completed fraction.
///
/// Errors: ResultsError or std::invalid_argument, naming the file; nothing is written then.
BakeOutcome bake_mesh(const BakeOrder& order, const std::function<void(double)>& progress);

}  // namespace asperity
