// Declares a height field on a plate, a box, a cylinder or a sphere.

#pragma once

#include <variant>

#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// A slab with the field on its upper side, which lies in the plane z = 0; x and y are those of the field.
struct PlateShape {
  glm::dvec3 size_m{};
};
/// A box about the origin, with the field on every side; on the upper one x and y are those of the field.
struct BoxShape {
  glm::dvec3 size_m{};
};
/// A cylinder about the z axis, with the field around it: z is the field's y. The ends are smooth.
struct CylinderShape {
  double diameter_m = 0.0;
  double length_m = 0.0;
};
/// A sphere about the origin, with the field like a map: longitude is its x, latitude its y.
struct SphereShape {
  double diameter_m = 0.0;
};
using Shape = std::variant<PlateShape, BoxShape, CylinderShape, SphereShape>;

/// The layout of a height field on a shape.
struct ShapeRelief {
  Tiling tiling = Tiling::repeat;
  /// From an edge of the shape inwards, the relief rises from zero within this distance.
  double rim_m = 0.002;
  /// Texels per shortest wave of the field, which is two of its pitches long.
  double samples_per_wavelength = 8.0;
};

/// Makes a closed mesh whose displaced surface is the shape plus the heights of the field, outward.
///
/// Model: where the relief has its full height, the point over (x, y) of a plane side lies h(x, y) above it, and that
/// of a cylinder or sphere of radius R lies at R + h from its axis or centre, exactly round and not in facets. Around a
/// cylinder and a sphere the field is stretched so that a whole number of periods fits; on a sphere the relief fades
/// between 60° and 75° of latitude, where a map is distorted. Lengths along a sphere's circles of latitude shrink with
/// the cosine of the latitude. Between texels the relief is linear and stays within the local range of the field: no
/// point is higher than the field, whether texels and waves are aligned or not. Ten texels per wave reduce a grating's
/// amplitude by up to 2.6 %, twenty by up to 1.2 %; the default is eight per wave of two pitches.
///
/// Errors: std::invalid_argument, naming the field: a size that is not positive or above 10 m, a rim that is not
/// positive or above a quarter of the smallest size, more than 2²⁵ texels.
TexturedMesh textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief);

/// Checks the same conditions without computing the texels.
void require_textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief);

}  // namespace asperity
