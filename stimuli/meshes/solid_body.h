// A shape as a body that touches or is touched: what it is made of, and how it lies.

#pragma once

#include <optional>
#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/textured_shape.h"

namespace asperity {

/// Where the axis of a cylinder, a disc or a sphere (through its poles) lies.
enum class BodyAxis { x, y, z };

/// What a body is for: its frame has its origin where that needs it.
enum class BodyRole {
  surface,  ///< its highest point lies in the plane z = 0
  tool,     ///< its lowest point lies in the plane z = 0: the tip of what the hand holds
};

/// Everything that has to be known to make the mesh of one body.
struct BodyDescription {
  std::string name{};                 ///< as the protocol calls it
  std::optional<std::string> mesh{};  ///< study-relative file of a textured mesh; or else
  std::optional<Shape> shape{};       ///< this, of which exactly one is there
  BodyAxis axis = BodyAxis::z;
  std::optional<std::string> texture{};       ///< the protocol's name of the relief on the shape
  std::optional<std::string> height_field{};  ///< study-relative, of that relief
};

const char* text_of(BodyAxis axis) noexcept;
const char* text_of(BodyRole role) noexcept;

/// A cylinder a tenth as long as it is wide.
CylinderShape disc_of(double diameter_m) noexcept;

/// A shape as it is made in its own frame (textured_shape.h), smooth where there is no field. The
/// rim is 2 mm, or a quarter of the smallest size where that is less.
///
/// Errors: as `textured_shape`.
TexturedMesh body_mesh(const Shape& shape, const HeightField* field);

/// Whether `body_mesh` can be made, without making it. Errors: as `body_mesh`.
void require_body_mesh(const Shape& shape, const HeightField* field);

/// Turns the z axis of a mesh to another one, and the other two with it: x → y → z → x.
TexturedMesh turned(TexturedMesh mesh, BodyAxis axis);

/// Moves a mesh along z until its corners lie as its role wants.
TexturedMesh placed(TexturedMesh mesh, BodyRole role);

}  // namespace asperity
