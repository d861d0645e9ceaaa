// Declares queries on a mesh: along a ray, and nearest to a point.

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Answers ray and nearest-point queries on one mesh.
///
/// Rays are traced in single precision about the mesh's centre: positions are accurate to about 10⁻⁷ of its size.
/// Nearest points are determined among candidates of that precision and computed in double precision. A result depends
/// only on the mesh and the query, and in its last digits on the type of processor, but never on the number of threads.
///
/// Errors: the constructor throws std::invalid_argument for a mesh without triangles, and std::runtime_error for an
/// error of the library.
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
    double distance = 0.0;  ///< in multiples of the direction's length
    std::uint32_t triangle = 0;
  };
  /// The first intersection of origin + t·direction, 0 ≤ t ≤ reach, with a triangle whose front (the side of its
  /// normal) faces `outward`: dot > 0. Other triangles are ignored.
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

  /// The nearest place within a distance on a triangle that faces a direction: its normal is inclined to `outward` by less
  /// than 120°. A zero `outward` stands for all directions.
  struct Near {
    glm::dvec3 point_m{};
    double within_m = std::numeric_limits<double>::infinity();
    glm::dvec3 outward{0.0};
  };
  std::optional<Nearest> nearest(const Near& near) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// The barycentric coordinates of the point of a triangle that is nearest to `point_m`.
glm::dvec3 nearest_in_triangle(const std::array<glm::dvec3, 3>& corners_m,
                               const glm::dvec3& point_m) noexcept;

}  // namespace asperity
