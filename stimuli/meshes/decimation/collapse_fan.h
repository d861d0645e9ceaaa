// Declares the faces that remain around a removed vertex, for distances from them.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace asperity::decimation {

/// The faces that a collapse leaves: a fan of triangles (apex, ringᵢ, ringᵢ₊₁) about the vertex that is kept.
///
/// Distances are computed from the products of the sides of all faces, which are computed once: many samples are
/// compared with one fan, and neighbouring faces share a side. The result has an error of 10⁻¹⁶ times the square of the
/// sides.
class CollapseFan final {
 public:
  /// Begins another fan at a vertex that is kept.
  void begin(const glm::dvec3& apex);
  /// Appends a vertex of the ring, which makes a face with the one before.
  void add(const glm::dvec3& ring);

  std::size_t faces() const { return spokes_.empty() ? 0 : spokes_.size() - 1; }
  /// Twice the area of the last face, along its normal.
  const glm::dvec3& last_front() const { return last_front_; }
  double last_front_length() const { return last_front_length_; }
  /// The sum of the squares of its sides.
  double last_squared_sides() const { return last_squared_sides_; }

  struct Nearest {
    double squared_distance = 0.0;
    std::size_t face = 0;
  };
  Nearest nearest(const glm::dvec3& place);

  /// The corner of a face that is nearest to the place for which `nearest` was called last: 0 for the apex, 1 for the
  /// first one on the ring, 2 for the other.
  std::size_t nearest_corner(std::size_t face) const;

 private:
  struct Spoke {
    glm::dvec3 along{};  ///< from the apex
    double squared = 0.0;
    double per_squared = 0.0;
    // Of the face between this spoke and the next:
    glm::dvec3 normal{0.0};  ///< zero for a face without area
    double product = 0.0;    ///< of the two spokes
    double determinant = 0.0;
    double rim_squared = 0.0;
    double per_rim_squared = 0.0;
  };

  glm::dvec3 apex_{};
  glm::dvec3 last_front_{};
  double last_front_length_ = 0.0;
  double last_squared_sides_ = 0.0;
  std::vector<Spoke> spokes_{};
  std::vector<double> products_{};  ///< of the place, from the apex, with each spoke
  double squared_ = 0.0;            ///< of the place, from the apex
};

}  // namespace asperity::decimation
