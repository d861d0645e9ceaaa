// The object on its table, as a picture: everything of the workspace that does not move.

#pragma once

#include <memory>
#include <stop_token>

#include <QtCore/QPointF>
#include <QtCore/QSize>
#include <QtGui/QColor>
#include <QtGui/QImage>
#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// What the surface of the object shows.
enum class SurfaceLook {
  relief,   ///< its own relief, in light from the upper left
  plain,    ///< nothing
  pattern,  ///< points 10 mm apart, which belong to no texture
};

// The slab of a point's workspace and a body in its place look alike.
inline constexpr double kPatternSpacing_m = 0.010;
inline constexpr double kPatternPoint_m = 0.0006;  ///< radius
inline constexpr double kShownSlope = 0.42;  ///< RMS of the slopes of a relief as they are shown

/// From where the workspace is seen: from in front, 48° above the surface, in perspective. Right in
/// the device's frame is right in the picture, for either hand.
///
/// The object is a slab as large as the patch whose upper face is the plane of the surface; it fills
/// a picture of `size` pixels with room for the tool above it. A body in its place has a patch and a
/// thickness of its own (`seen_patch_of`).
class WorkspaceCamera final {
 public:
  WorkspaceCamera(const SurfacePatch& patch, QSize size);
  WorkspaceCamera(const SurfacePatch& patch, QSize size, double thickness_m);

  QSize size() const noexcept { return size_; }
  const SurfacePatch& patch() const noexcept { return patch_; }
  /// Where a point of the device's frame (metres) stands in the picture, in pixels.
  QPointF project(const glm::dvec3& point_m) const noexcept;
  /// Pixels that a metre across the line of sight has at this point.
  double scale_at(const glm::dvec3& point_m) const noexcept;
  /// The point that stands at `pixel`, at height `z_m` above the surface, relative to the patch's
  /// centre.
  glm::dvec3 point_at(QPointF pixel, double z_m) const noexcept;
  /// Of the slab.
  double thickness_m() const noexcept;

 private:
  SurfacePatch patch_{};
  QSize size_{};
  double thickness_m_ = 0.0;
  glm::dvec3 eye_m_{};  ///< relative to the patch's centre
  double focal_px_ = 1.0;
  QPointF centre_px_{};
};

struct WorkspacePicture {
  /// Read only for `SurfaceLook::relief`; null looks plain.
  std::shared_ptr<const HeightField> relief{};
  SurfaceLook look = SurfaceLook::plain;
  QColor ground{};  ///< of the page around
  /// In the place of the slab; its own frame stands where the patch has its centre.
  std::shared_ptr<const TexturedMesh> body{};
  glm::dvec3 body_m{0.0};  ///< that centre, in the device's frame
};

/// A patch above the whole of a body: its centre in the plane of the body's highest point, its extent
/// that of the body seen from above. And how far down the body goes from there.
struct SeenPatch {
  SurfacePatch patch{};
  double thickness_m = 0.0;
};
SeenPatch seen_patch_of(const TexturedMesh& body, const SurfacePatch& patch);

/// Light on a surface whose outward normal this is, in the device's frame: 1 and a little where it
/// faces the lamp.
double workspace_light(const glm::dvec3& normal);

/// Slopes are exaggerated until they are plain to see, so that two reliefs of one shape look alike
/// whatever their amplitude. A stop gives a null image. Some 0.4 s for 1280 × 720 with a relief, a
/// quarter of that without.
QImage draw_workspace(const WorkspaceCamera& camera, const WorkspacePicture& picture,
                      const std::stop_token& stop = {});

}  // namespace asperity
