// Pictures of textured meshes in the workspace, drawn on the CPU.

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <QtCore/QRect>
#include <QtGui/QImage>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/gui/scene/workspace_camera.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The pose of a body: a point p of its mesh is at rotation·p + position in the device's frame.
struct SeenPose {
  glm::dmat3 rotation{1.0};
  glm::dvec3 position_m{0.0};
};

struct BodyBounds {
  glm::dvec3 low_m{0.0};
  glm::dvec3 high_m{0.0};
};
BodyBounds bounds_of(const TexturedMesh& mesh) noexcept;

/// The patch over a whole body: its centre is in the plane of the highest point, its extent is that of the body seen from
/// above. `thickness_m` is the height of the body.
struct SeenPatch {
  SurfacePatch patch{};
  double thickness_m = 0.0;
};
SeenPatch seen_patch_of(const TexturedMesh& body, const SurfacePatch& patch);

/// A part of the picture with a depth buffer.
class BodyLayer final {
 public:
  /// `area` in pixels of the picture, drawn with `fineness` times as many along each side.
  BodyLayer(QRect area, int fineness);

  /// In the size of the area, smoothed. Pixels without a body are transparent.
  QImage image() const;
  /// Makes all pixels transparent, of a picture with the size of the area, at which there is no body.
  void keep_covered(QImage& picture) const;

 private:
  friend class SeenBody;
  QRect area_{};
  int fineness_ = 1;
  QImage pixels_{};
  std::vector<float> nearness_{};
};

/// A mesh prepared for drawing: shaded by its normals and, for SurfaceLook::relief, by the deviation of the displaced
/// surface from them, scaled as in `draw_workspace`. The curvature of the shape itself is not a deviation.
class SeenBody final {
 public:
  /// Linear RGB, from 0 to 1.
  using Colour = glm::dvec3;

  SeenBody(std::shared_ptr<const TexturedMesh> mesh, SurfaceLook look, const Colour& colour);

  const TexturedMesh& mesh() const noexcept { return *mesh_; }
  const BodyBounds& bounds() const noexcept { return bounds_; }

  /// Draws the pixels that are nearer than those in the layer.
  void draw(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer) const;
  /// Draws nothing, but hides everything behind the body.
  void hide_behind(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer) const;
  /// The bounding rectangle in the picture.
  QRect area(const WorkspaceCamera& camera, const SeenPose& pose) const;

 private:
  struct Face {
    std::array<glm::dvec3, 2> along_texel_m{};  ///< ∂p over a step of a column, of a row
    std::array<glm::dvec3, 2> turn{};           ///< ∂n over the same steps
    bool is_flat = true;                        ///< without a relief, or too small to look it up
  };
  void rasterise(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer,
                 bool colours) const;
  glm::dvec3 normal_at(std::size_t face, const glm::dvec3& weights) const;
  glm::dvec3 colour_at(std::size_t face, const glm::dvec3& weights, const glm::dmat3& turn) const;
  /// The normal of the displaced surface minus the smooth normal.
  glm::dvec3 deviation_at(std::size_t face, const glm::dvec3& weights) const;
  bool bends_sharply(const std::array<std::uint32_t, 3>& corners) const;
  double displacement_m(double column, double row) const;

  std::shared_ptr<const TexturedMesh> mesh_{};
  SurfaceLook look_ = SurfaceLook::plain;
  Colour colour_{1.0};
  BodyBounds bounds_{};
  std::vector<Face> faces_{};
  double exaggeration_ = 0.0;
};

/// A body alone, as seen in the workspace, on a transparent ground. Takes some 20 ms.
QImage picture_of_body(const std::shared_ptr<const TexturedMesh>& mesh, int side_px);

/// The height by which a tool has to be raised so that none of its corners is below the upper side of the surface.
/// Corners deeper than `most_m` are ignored: they belong to a tool at another side, not to a compliant contact.
double lift_above_m(const TexturedMesh& tool, const SeenPose& tool_pose,
                    const TexturedMesh& surface, const glm::dvec3& surface_m, double most_m);

}  // namespace asperity
