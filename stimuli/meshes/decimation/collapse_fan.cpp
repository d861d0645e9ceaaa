// Implements distances from the faces around a vertex.

#include "stimuli/meshes/decimation/collapse_fan.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace asperity::decimation {

void CollapseFan::begin(const glm::dvec3& apex) {
  apex_ = apex;
  spokes_.clear();
}

void CollapseFan::add(const glm::dvec3& ring) {
  const glm::dvec3 along = ring - apex_;
  const double squared = glm::dot(along, along);
  if (!spokes_.empty()) {
    Spoke& face = spokes_.back();
    last_front_ = glm::cross(face.along, along);
    last_front_length_ = glm::length(last_front_);
    face.normal = last_front_length_ > 0.0 ? last_front_ / last_front_length_ : glm::dvec3{0.0};
    face.product = glm::dot(face.along, along);
    face.determinant = face.squared * squared - face.product * face.product;
    face.rim_squared = face.squared - 2.0 * face.product + squared;
    last_squared_sides_ = face.squared + squared + face.rim_squared;
    face.per_rim_squared = face.rim_squared > 0.0 ? 1.0 / face.rim_squared : 0.0;
  }
  Spoke& spoke = spokes_.emplace_back();
  spoke.along = along;
  spoke.squared = squared;
  spoke.per_squared = squared > 0.0 ? 1.0 / squared : 0.0;
}

CollapseFan::Nearest CollapseFan::nearest(const glm::dvec3& place) {
  const glm::dvec3 from_apex = place - apex_;
  squared_ = glm::dot(from_apex, from_apex);
  Nearest best{.squared_distance = squared_};
  const auto consider = [&best](double squared, std::size_t face) {
    if (squared < best.squared_distance) best = {squared, face};
  };
  // The nearest point is in a face, on a spoke, or on the rim; its ends are ends of spokes.
  products_.resize(spokes_.size());
  for (std::size_t i = 0; i < spokes_.size(); ++i) {
    const Spoke& spoke = spokes_[i];
    const double product = glm::dot(from_apex, spoke.along);
    products_[i] = product;
    if (product <= 0.0) continue;
    const double squared = product < spoke.squared
                               ? squared_ - product * product * spoke.per_squared
                               : squared_ - 2.0 * product + spoke.squared;
    consider(squared, i < faces() ? i : i - 1);
  }
  for (std::size_t i = 0; i < faces(); ++i) {
    const Spoke& face = spokes_[i];
    const double one = products_[i];
    const double other = products_[i + 1];
    const double height = glm::dot(from_apex, face.normal);
    if (height * height >= best.squared_distance) continue;
    const double b = spokes_[i + 1].squared * one - face.product * other;
    const double c = face.squared * other - face.product * one;
    if (face.determinant > 0.0 && b >= 0.0 && c >= 0.0 && b + c <= face.determinant) {
      consider(height * height, i);
      continue;
    }
    const double along_rim = other - one - (face.product - face.squared);
    if (along_rim <= 0.0 || along_rim >= face.rim_squared) continue;
    consider(squared_ - 2.0 * one + face.squared - along_rim * along_rim * face.per_rim_squared, i);
  }
  best.squared_distance = std::max(0.0, best.squared_distance);
  return best;
}

std::size_t CollapseFan::nearest_corner(std::size_t face) const {
  const double one = spokes_[face].squared - 2.0 * products_[face];
  const double other = spokes_[face + 1].squared - 2.0 * products_[face + 1];
  if (0.0 <= one && 0.0 <= other) return 0;
  return one <= other ? 1 : 2;
}

}  // namespace asperity::decimation
