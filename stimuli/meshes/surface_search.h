// Finding places on a mesh: along a ray, and near a point.

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Rays and nearest points on one mesh.
///
/// Rays are followed in single precision about the mesh's centre: places are right to about 10⁻⁷ of
/// its size. Nearest points are found among candidates of that precision and computed in double
/// precision. An answer depends on mesh and question only, and on the kind of processor in its last
/// digits, never on the number of threads.
///
/// Errors: the constructor throws std::invalid_argument for a mesh without triangles, and
/// std::runtime_error where the library refuses.
///
/// Threads: any number at a time after construction.
class SurfaceSearch final {
 public:
  explicit SurfaceSearch(const TriangleMesh& mesh);  ///< kept by reference
  explicit SurfaceSearch(TriangleMesh&&) = delete;
  ~SurfaceSearch();
  SurfaceSearch(const SurfaceSearch&) = delete;
  SurfaceSearch& operator=(const SurfaceSearch&) = delete;

  struct Hit {
    double distance = 0.0;  ///< in lengths of the direction
    std::uint32_t triangle = 0;
  };
  /// Where origin + t·direction with 0 ≤ t ≤ reach first meets a triangle whose front (the side that
  /// its normal points to) looks along `outward`, dot > 0. Others are passed through.
  struct Ray {
    glm::dvec3 origin_m{};
    glm::dvec3 direction{};
    glm::dvec3 outward{};
    double reach = 0.0;
  };
  std::optional<Hit> first_front(const Ray& ray) const;

  struct Nearest {
    double distance_m = 0.0;
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{};
  };
  Nearest nearest(const glm::dvec3& point_m) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// The barycentric coordinates of the point of a triangle that is nearest to `point_m`.
glm::dvec3 nearest_in_triangle(const std::array<glm::dvec3, 3>& corners_m,
                               const glm::dvec3& point_m) noexcept;

}  // namespace asperity
