// Declares the textured bodies whose ticks are timed: made by formula and baked, or from a user's mesh.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "stimuli/meshes/read_mesh.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// How a long task can be followed and stopped.
struct TimingCourse {
  std::stop_token stop{};
  std::function<void(const std::string& step)> begin_step{};
  std::function<void(double)> progress{};  ///< of the step, 0 to 1
};

/// Thrown by tasks whose TimingCourse requests a stop.
struct TimingStopped {};

struct TimedBody {
  std::shared_ptr<const TexturedMesh> mesh{};
  std::size_t original_triangles = 0;  ///< before simplification
};

struct TimedBodiesOrder {
  /// Of each original; absent: as detailed_bodies.h states for each.
  std::optional<std::size_t> triangles{};
  /// A folder in which baked bodies are kept as textured meshes, NAME-TRIANGLES.mesh; created if it does not exist.
  std::optional<std::filesystem::path> folder{};
  unsigned jobs = 1;
};

/// Makes each body at its first use.
///
/// Errors: TimingStopped; ResultsError or std::invalid_argument naming the file.
class TimedBodies final {
 public:
  TimedBodies(TimedBodiesOrder order, TimingCourse course);

  /// A body of detailed_bodies.h.
  TimedBody named(std::string_view name);

  /// The body of a mesh file, centred about the origin: a textured mesh (.mesh) unchanged, any other mesh with the repairs of `bake`,
  /// at most 700 triangles and its detail as texture.
  TimedBody of_file(const std::filesystem::path& file, const MeshReading& reading);

 private:
  TimedBody made(std::string_view name, std::size_t triangles, std::size_t simplified);
  TimedBody baked(const TriangleMesh& original, std::size_t simplified, const std::string& name);
  void follow(double fraction) const;

  TimedBodiesOrder order_{};
  TimingCourse course_{};
  std::map<std::string, TimedBody, std::less<>> bodies_{};
};

}  // namespace asperity
