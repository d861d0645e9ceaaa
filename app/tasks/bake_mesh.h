// A mesh file becomes a simple mesh with a haptic texture.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/atomic_file.h"
#include "stimuli/meshes/mesh_file.h"
#include "stimuli/meshes/solid_body.h"
#include "stimuli/meshes/texture_baking.h"

namespace asperity {

struct BakeOrder {
  std::filesystem::path mesh{};
  std::filesystem::path out{};
  std::size_t triangles = 0;
  MeshReading reading{};
  std::optional<double> widest_hole_m{};  ///< of what is closed; a tenth of the diagonal by default
  /// What the mesh is for: it is moved so that the middle of its box lies over the origin and its
  /// highest (a surface) or lowest point (a tool) in the plane z = 0. Not given: it keeps its frame.
  std::optional<BodyRole> role{};
  unsigned jobs = 1;
  Overwrite overwrite = Overwrite::refuse;
};

struct BakeOutcome {
  std::size_t triangles_in = 0;  ///< of the file
  std::size_t triangles_out = 0;
  double diagonal_m = 0.0;  ///< of the original's bounding box
  std::size_t atlas_rows = 0;
  std::size_t atlas_columns = 0;
  double step_m = 0.0;  ///< of the displacements
  BakeReport report{};
  std::vector<std::string> findings{};  ///< what was found in the file and done about it
};

/// Reads, repairs, simplifies, bakes and writes. `progress` receives fractions of the whole.
///
/// Errors: ResultsError or std::invalid_argument, naming the file; nothing is written then.
BakeOutcome bake_mesh(const BakeOrder& order, const std::function<void(double)>& progress);

}  // namespace asperity
