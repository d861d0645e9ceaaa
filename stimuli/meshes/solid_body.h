// Declares a body that touches or is touched: its shape, relief and position.

#pragma once

#include <optional>
#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/textured_shape.h"

namespace asperity {

/// The direction of the axis of a cylinder, a disc or a sphere (through its poles).
enum class BodyAxis { x, y, z };

/// The role of a body, which determines the origin of its frame.
enum class BodyRole {
  surface,  ///< its highest point lies in the plane z = 0
  tool,     ///< its lowest point, the tip, lies in the plane z = 0
};

/// The complete description of the mesh of one body.
struct BodyDescription {
  std::string name{};                 ///< the name in the protocol
  std::optional<std::string> mesh{};  ///< study-relative file of a textured mesh
  std::optional<Shape> shape{};       ///< alternative to `mesh`; exactly one of the two is given
  BodyAxis axis = BodyAxis::z;
  std::optional<std::string> texture{};       ///< name of the texture with the shape's relief
  std::optional<std::string> height_field{};  ///< study-relative, of that relief
};

const char* text_of(BodyAxis axis) noexcept;
const char* text_of(BodyRole role) noexcept;

/// A cylinder whose length is a tenth of its diameter.
CylinderShape disc_of(double diameter_m) noexcept;

/// Makes a shape in its own frame (textured_shape.h), smooth if there is no field. The rim is 2 mm, or a quarter of the
/// smallest size if that is less.
///
/// Errors: those of `textured_shape`.
TexturedMesh body_mesh(const Shape& shape, const HeightField* field);

/// Checks that `body_mesh` would succeed, without making it. Errors: those of `body_mesh`.
void require_body_mesh(const Shape& shape, const HeightField* field);

/// Rotates a mesh so that its z axis becomes `axis`, by a cyclic exchange of the axes: x → y → z → x.
TexturedMesh turned(TexturedMesh mesh, BodyAxis axis);

/// Moves a mesh along z to the position that its role requires.
TexturedMesh placed(TexturedMesh mesh, BodyRole role);

}  // namespace asperity
