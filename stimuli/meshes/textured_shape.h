// A height field on a plate, a box, a cylinder or a sphere.

#pragma once

#include <variant>

#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// A slab with the field on its upper side, which lies in the plane z = 0: x and y are the field's.
struct PlateShape {
  glm::dvec3 size_m{};
};
/// About the origin, with the field on every side; on the upper one x and y are the field's.
struct BoxShape {
  glm::dvec3 size_m{};
};
/// About the z axis, with the field around it: z is the field's y. The ends are smooth.
struct CylinderShape {
  double diameter_m = 0.0;
  double length_m = 0.0;
};
/// About the origin, with the field like a map: longitude is its x, latitude its y.
struct SphereShape {
  double diameter_m = 0.0;
};
using Shape = std::variant<PlateShape, BoxShape, CylinderShape, SphereShape>;

/// How a height field is laid on a shape.
struct ShapeRelief {
  Tiling tiling = Tiling::repeat;
  /// From an edge of the shape inward the relief rises from nothing within this distance.
  double rim_m = 0.002;
  /// Texels for the shortest wave of the field, which is two of its pitches long.
  double samples_per_wavelength = 8.0;
};

/// A closed mesh whose displaced surface is the shape plus the heights of the field, outward.
///
/// Model: where the relief is whole, the point over (x, y) of a plane side lies h(x, y) above it, and
/// that of a cylinder or sphere of radius R lies at R + h from its axis or middle, round and not in
/// facets. Around a cylinder and a sphere the field is stretched so that whole periods of it go
/// around; on a sphere the relief fades between 60° and 75° of latitude, where a map is torn.
/// Lengths along a sphere's circles of latitude shrink with their cosine. Between texels the relief is
/// linear and never outside what the field holds there: nothing stands out further than the field
/// does, whether texels and waves line up or not. Ten texels a wave take up to 2.6 % of a grating's
/// amplitude off, twenty up to 1.2 %; eight for each wave of two pitches are the default.
///
/// Errors: std::invalid_argument, naming the field: a size that is not positive or above 10 m, a rim
/// that is not positive or above a quarter of the smallest size, more than 2²⁵ texels.
TexturedMesh textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief);

/// The same refusals without the texels: cheap.
void require_textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief);

}  // namespace asperity
