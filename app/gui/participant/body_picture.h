// Bodies of the workspace as they are seen: textured meshes, drawn on the CPU.

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

#include "app/gui/participant/workspace_picture.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// Where a body is seen: a point p of its mesh stands at rotation·p + position in the device's frame.
struct SeenPose {
  glm::dmat3 rotation{1.0};
  glm::dvec3 position_m{0.0};
};

struct BodyBounds {
  glm::dvec3 low_m{0.0};
  glm::dvec3 high_m{0.0};
};
BodyBounds bounds_of(const TexturedMesh& mesh) noexcept;

/// A part of the picture with what is nearest to the eye in every pixel.
class BodyLayer final {
 public:
  /// `area` of the picture in its pixels, drawn `fineness` times as fine.
  BodyLayer(QRect area, int fineness);

  /// Empty pixels are transparent. In the size of the area, smoothed.
  QImage image() const;
  /// Takes away from a picture as large as the area what no body stands behind.
  void keep_covered(QImage& picture) const;

 private:
  friend class SeenBody;
  QRect area_{};
  int fineness_ = 1;
  QImage pixels_{};
  std::vector<float> nearness_{};
};

/// A mesh prepared for drawing: shaded by its normals and, where it shows its relief, by how the
/// displaced surface deviates from them, exaggerated until it is plain to see as `draw_workspace` does.
/// What makes a shape round is part of its displacements and no deviation.
class SeenBody final {
 public:
  /// Linear, from 0 to 1.
  using Colour = glm::dvec3;

  SeenBody(std::shared_ptr<const TexturedMesh> mesh, SurfaceLook look, const Colour& colour);

  const TexturedMesh& mesh() const noexcept { return *mesh_; }
  const BodyBounds& bounds() const noexcept { return bounds_; }

  /// What of it is nearer than what is in the layer already.
  void draw(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer) const;
  /// Nothing is drawn, but what lies behind it stays hidden.
  void hide_behind(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer) const;
  /// The pixels that it can touch.
  QRect area(const WorkspaceCamera& camera, const SeenPose& pose) const;

 private:
  struct Face {
    std::array<glm::dvec3, 2> along_texel_m{};  ///< a step of a column, of a row
    std::array<glm::dvec3, 2> turn{};           ///< of the normal, over the same steps
    bool is_flat = true;                        ///< no relief, or nothing to look it up with
  };
  void rasterise(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer,
                 bool colours) const;
  glm::dvec3 normal_at(std::size_t face, const glm::dvec3& weights) const;
  glm::dvec3 colour_at(std::size_t face, const glm::dvec3& weights, const glm::dmat3& turn) const;
  /// Of the displaced surface, less its smooth normal.
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

/// A body by itself for a list, seen as in the workspace; transparent around it. Some 20 ms.
QImage picture_of_body(const std::shared_ptr<const TexturedMesh>& mesh, int side_px);

/// How far a tool has to be raised so that none of its corners lies below the surface's upper side, at
/// most `most_m`: more is no contact that gives way but a tool at another side, and stays as it is.
double lift_above_m(const TexturedMesh& tool, const SeenPose& tool_pose,
                    const TexturedMesh& surface, const glm::dvec3& surface_m, double most_m);

}  // namespace asperity
