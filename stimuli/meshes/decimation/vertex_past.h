// Declares the parts of the given surface that a vertex represents during the simplification of a mesh.

#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace asperity::decimation {

/// A sum of squared distances from planes, each with a weight [Garland 1997]: pᵀ·A·p + 2·b·p + c.
class Quadric final {
 public:
  Quadric() = default;
  /// Of the plane through a point, with a unit normal.
  Quadric(const glm::dvec3& normal, const glm::dvec3& point, double weight);

  Quadric& operator+=(const Quadric& other);

  double at(const glm::dvec3& p) const {
    return p.x * (xx_ * p.x + 2.0 * (xy_ * p.y + xz_ * p.z + b_.x)) +
           p.y * (yy_ * p.y + 2.0 * (yz_ * p.z + b_.y)) + p.z * (zz_ * p.z + 2.0 * b_.z) + c_;
  }

 private:
  double xx_ = 0.0;
  double xy_ = 0.0;
  double xz_ = 0.0;
  double yy_ = 0.0;
  double yz_ = 0.0;
  double zz_ = 0.0;
  glm::dvec3 b_{0.0};
  double c_ = 0.0;
};

/// A sample of the given surface and the area that it represents.
struct Sample {
  glm::dvec3 place{};
  double area = 0.0;
};

/// The data of a vertex that persist while the mesh around it changes.
struct VertexPast {
  std::uint32_t origin = 0;  ///< the vertex of the given mesh with these coordinates
  glm::dvec3 normal{0.0};    ///< of the given mesh: of its faces, weighted by angle; of unit length
  Quadric quadric{};         ///< of the planes that were merged into it
  double deviation = 0.0;    ///< the quadric at the vertex itself
  std::vector<Sample> samples{};  ///< of the given surface around the vertex
};

/// Adds a sample to those of a vertex. Of more than 32, every second one is kept, with the area of two.
void keep_sample(VertexPast& past, const Sample& sample);

}  // namespace asperity::decimation
