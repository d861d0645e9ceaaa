// Implements the meshes, orientation and position of bodies.

#include "stimuli/meshes/solid_body.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr double kRim_m = 0.002;

double smallest_size_m(const Shape& shape) {
  struct Smallest {
    double operator()(const PlateShape& plate) const {
      return std::min({plate.size_m.x, plate.size_m.y, plate.size_m.z});
    }
    double operator()(const BoxShape& box) const {
      return std::min({box.size_m.x, box.size_m.y, box.size_m.z});
    }
    double operator()(const CylinderShape& cylinder) const {
      return std::min(cylinder.diameter_m, cylinder.length_m);
    }
    double operator()(const SphereShape& sphere) const { return sphere.diameter_m; }
  };
  return std::visit(Smallest{}, shape);
}

ShapeRelief relief_on(const Shape& shape) {
  // A size that is not positive is rejected by the shape, not here.
  const double quarter_m = 0.25 * smallest_size_m(shape);
  ShapeRelief relief{};
  relief.rim_m = quarter_m > 0.0 ? std::min(kRim_m, quarter_m) : kRim_m;
  return relief;
}

HeightField flat() {
  return HeightField({.rows = 2, .columns = 2, .pitch_m = 0.01}, std::vector<float>(4, 0.0F));
}

}  // namespace

const char* text_of(BodyAxis axis) noexcept {
  switch (axis) {
    case BodyAxis::x:
      return "x";
    case BodyAxis::y:
      return "y";
    case BodyAxis::z:
      return "z";
  }
  return "";
}

const char* text_of(BodyRole role) noexcept {
  switch (role) {
    case BodyRole::surface:
      return "surface";
    case BodyRole::tool:
      return "tool";
  }
  return "";
}

CylinderShape disc_of(double diameter_m) noexcept {
  return {.diameter_m = diameter_m, .length_m = 0.1 * diameter_m};
}

TexturedMesh body_mesh(const Shape& shape, const HeightField* field) {
  return textured_shape(shape, field == nullptr ? flat() : *field, relief_on(shape));
}

void require_body_mesh(const Shape& shape, const HeightField* field) {
  require_textured_shape(shape, field == nullptr ? flat() : *field, relief_on(shape));
}

TexturedMesh turned(TexturedMesh mesh, BodyAxis axis) {
  const auto turn = [axis](glm::dvec3& v) {
    switch (axis) {
      case BodyAxis::x:
        v = {v.z, v.x, v.y};
        break;
      case BodyAxis::y:
        v = {v.y, v.z, v.x};
        break;
      case BodyAxis::z:
        break;
    }
  };
  for (glm::dvec3& vertex : mesh.vertices_m) turn(vertex);
  for (glm::dvec3& normal : mesh.normals) turn(normal);
  return mesh;
}

TexturedMesh placed(TexturedMesh mesh, BodyRole role) {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -lowest_m;
  for (const glm::dvec3& vertex : mesh.vertices_m) {
    lowest_m = std::min(lowest_m, vertex.z);
    highest_m = std::max(highest_m, vertex.z);
  }
  const double off_m = role == BodyRole::surface ? highest_m : lowest_m;
  for (glm::dvec3& vertex : mesh.vertices_m) vertex.z -= off_m;
  return mesh;
}

}  // namespace asperity
